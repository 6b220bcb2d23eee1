import cv2
import numpy as np
import pytest
import skimage.data
from real_data import fetched

from course_lib import data
from course_lib.boards import Checkerboard
from course_lib.detection import detect_board

REAL = {
    "left": ([n for n in data.names("opencv_stereo") if "/left" in n], Checkerboard(9, 6, 30)),
    "right": ([n for n in data.names("opencv_stereo") if "/right" in n], Checkerboard(9, 6, 30)),
    "sony": (data.names("boofcv/Sony_DSC-HX5V_Chess"), Checkerboard(4, 6, 30)),
}


def rms(errors):
    return float(np.sqrt(np.mean(np.sum(np.square(errors), axis=1))))


def real_pictures(name):
    """The pictures of a real set, as RGB; skips where they cannot be had."""
    names, board = REAL[name]
    names = [n for n in names if n.endswith(".jpg")]
    return [cv2.imread(str(fetched(n)))[..., ::-1] for n in names], board


def drawn(columns, rows, square=20):
    """A checkerboard with so many inner corners, seen head on, with a wide border."""
    dark = np.indices((rows + 1, columns + 1)).sum(axis=0) % 2 == 0
    tiles = np.kron(np.where(dark, 20, 220), np.ones((square, square)))
    return np.pad(tiles, 2 * square, constant_values=220).astype(np.uint8)


class TestRendered:
    def test_shapes(self, rendered):
        found = detect_board(rendered.clear[0].picture, rendered.board)
        assert found.found
        assert found.good
        assert found.points.shape == (54, 2)
        np.testing.assert_array_equal(found.ids, np.arange(54))
        assert found.verdict == "All 9 × 6 corners found."

    def test_corners_are_where_projected_and_in_order(self, rendered):
        for view in rendered.clear:
            found = detect_board(view.picture, rendered.board)
            errors = found.points - view.points[found.ids]
            assert rms(errors) < 0.02
            assert np.linalg.norm(errors.mean(axis=0)) < 0.01

    def test_at_most_half_the_error_of_opencv(self, rendered):
        ours, theirs = [], []
        for view in rendered.clear:
            start = view.points + np.random.default_rng(0).uniform(-1, 1, view.points.shape)
            stop = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_COUNT, 100, 1e-4)
            refined = cv2.cornerSubPix(
                view.picture, start.astype(np.float32), (5, 5), (-1, -1), stop
            )
            theirs.append(rms(refined.reshape(-1, 2) - view.points))
            ours.append(rms(detect_board(view.picture, rendered.board).points - view.points))
        assert rms(np.array([ours])) <= 0.5 * rms(np.array([theirs]))

    @pytest.mark.parametrize("turn", range(4))
    def test_the_dark_corner_comes_first_however_the_board_is_turned(self, rendered, turn):
        view = rendered.clear[0]
        found = detect_board(np.rot90(view.picture, turn).copy(), rendered.board)
        turned = np.rot90(np.indices(view.picture.shape), turn, axes=(1, 2))
        # Where the first corner's pixel went.
        column, row = np.rint(view.points[0]).astype(int)
        place = np.argwhere((turned[0] == row) & (turned[1] == column))[0]
        np.testing.assert_allclose(found.points[0][::-1], place, atol=1)

    def test_of_a_board_that_is_alike_upside_down_rows_lead_to_the_right(self):
        picture = drawn(5, 7)
        for turn in (0, 2):
            found = detect_board(np.rot90(picture, turn).copy(), Checkerboard(5, 7, 1))
            np.testing.assert_allclose(found.points[0], (59.5, 59.5), atol=0.01)
            np.testing.assert_allclose(found.points[1], (79.5, 59.5), atol=0.01)

    @pytest.mark.parametrize("kind", ["uint16", "float", "colour"])
    def test_kinds_of_pictures(self, rendered, kind):
        view = rendered.clear[1]
        picture = {
            "uint16": view.picture.astype(np.uint16) * 257,
            "float": view.picture / 255,
            "colour": np.repeat(view.picture[..., None], 3, axis=2),
        }[kind]
        found = detect_board(picture, rendered.board)
        np.testing.assert_allclose(found.points, view.points, atol=0.06)

    def test_a_large_picture(self, rendered):
        view = rendered.clear[2]
        size = tuple(8 * s for s in view.picture.shape[::-1])
        found = detect_board(
            cv2.resize(view.picture, size, interpolation=cv2.INTER_CUBIC), rendered.board
        )
        assert found.found
        # The middle of the first of 8 × 8 pixels is 3.5 px from that of them all.
        assert rms((found.points - 3.5) / 8 - view.points) < 0.03

    def test_squares_that_are_too_small_at_first(self):
        """Made 1000 px long, this picture has squares of 6 px, too small; as it is, of 9."""
        turn = np.radians(10)
        A = 9 / 16 * np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
        A, shift = A * [1, 0.8], np.array([820.0, 75])
        board = Checkerboard(9, 6, 30)
        picture = cv2.warpAffine(
            drawn(9, 6, 16), np.c_[A, shift], (1500, 300), flags=cv2.INTER_LINEAR, borderValue=150
        )
        noise = np.random.default_rng(0).normal(0, 2, picture.shape)
        noisy = np.clip(cv2.GaussianBlur(picture, (0, 0), 0.7) + noise, 0, 255).astype(np.uint8)
        found = detect_board(noisy, board)
        assert found.good
        corners = board.points()[found.ids, :2] / 30 * 16 + 3 * 16 - 0.5
        assert rms(found.points - (corners @ A.T + shift)) < 0.1


class TestVerdicts:
    def test_blurred(self, rendered):
        found = detect_board(rendered.blurred.picture, rendered.board)
        assert found.found
        assert not found.good
        assert found.problem == "blurred"
        assert "Hold the camera still" in found.verdict
        assert found.blur == pytest.approx(0.0055 * 480, rel=0.1)

    def test_glare(self, rendered):
        assert detect_board(rendered.glare.picture, rendered.board).problem == "glare"

    def test_cut_off(self, rendered):
        found = detect_board(rendered.cut_off.picture, rendered.board)
        assert found.problem == "cut off"
        assert "instead of 9 × 6" in found.verdict

    @pytest.mark.parametrize("counts", [(8, 6), (9, 5), (10, 7), (7, 7)])
    def test_wrong_size(self, counts):
        found = detect_board(drawn(9, 6), Checkerboard(*counts, 30))
        assert found.problem == "wrong size"
        assert not found.found
        assert "9 × 6 corners" in found.verdict

    @pytest.mark.parametrize("counts", [(6, 5), (5, 4), (4, 4)])
    def test_a_piece_of_a_larger_board_is_not_the_board(self, counts):
        """OpenCV finds such a piece, some by jumping over every other column."""
        for picture in (drawn(9, 6), *real_pictures("left")[0][:7:2]):
            found = detect_board(picture, Checkerboard(*counts, 30))
            assert found.problem == "wrong size"
            assert sorted(found.seen) == [6, 9]

    @pytest.mark.parametrize("level", [0, 128, 255])
    def test_no_board(self, level):
        found = detect_board(np.full((120, 160), level, np.uint8), Checkerboard(9, 6, 30))
        assert found.problem == "no board"
        assert found.points.shape == (0, 2)

    @pytest.mark.parametrize("name", ["brick", "gravel", "text"])
    @pytest.mark.parametrize("counts", [(9, 6), (3, 3)])
    def test_things_that_look_a_little_like_one(self, name, counts):
        found = detect_board(getattr(skimage.data, name)(), Checkerboard(*counts, 30))
        assert not found.found
        assert found.problem == "no board"

    def test_noise_is_no_board(self):
        picture = np.random.default_rng(0).integers(0, 256, (120, 160)).astype(np.uint8)
        assert detect_board(picture, Checkerboard(9, 6, 30)).problem == "no board"


class TestErrors:
    @pytest.mark.parametrize(
        ("image", "said"),
        [
            ("left01.jpg", "must be uint8"),
            (np.zeros((4, 4), int), "must be uint8"),
            (np.zeros((4, 4, 2), np.uint8), "3 or 4 channels"),
            (np.zeros((0, 4), np.uint8), "must be uint8"),
            (np.full((40, 40), np.nan), "must be finite"),
        ],
    )
    def test_no_picture(self, image, said):
        with pytest.raises((TypeError, ValueError), match=said):
            detect_board(image, Checkerboard(9, 6, 30))

    def test_no_board(self):
        with pytest.raises(TypeError, match="board must be a Checkerboard"):
            detect_board(np.zeros((40, 40), np.uint8), (9, 6))


@pytest.mark.parametrize("name", ["left", "right", "sony"])
def test_finds_every_real_board(name):
    pictures, board = real_pictures(name)
    found = [detect_board(picture, board) for picture in pictures]
    assert len(found) == 13
    assert all(f.good and len(f.points) == len(board.points()) for f in found)


def test_the_real_left_camera_is_that_of_bouguet():
    pictures, board = real_pictures("left")
    found = [detect_board(picture, board) for picture in pictures]
    objects = [board.points()[f.ids].astype(np.float32) for f in found]
    images = [f.points.astype(np.float32) for f in found]
    rms_error, K, *_ = cv2.calibrateCamera(objects, images, (640, 480), None, None)
    # With windows of 11 px OpenCV leaves 0.41 px and f = 536; with 5 px 0.195 px and 532.8.
    assert rms_error < 0.165
    np.testing.assert_allclose(K[[0, 1], [0, 1]], (533.523, 533.527), atol=0.3)


def test_both_cameras_see_the_same_corner_first():
    lefts, board = real_pictures("left")
    rights, _ = real_pictures("right")
    for left, right in zip(lefts, rights, strict=True):
        apart = detect_board(left, board).points - detect_board(right, board).points
        # The cameras look the same way from 10 cm apart.
        assert (apart[:, 0] > 0).all()
        assert (np.abs(apart[:, 1]) < 30).all()
