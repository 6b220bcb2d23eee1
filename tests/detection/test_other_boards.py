from functools import cache

import cv2
import numpy as np
import pytest
from real_data import fetched

from course_lib import data
from course_lib.boards import Charuco, Checkerboard, DotGrid, SquareGrid
from course_lib.detection import detect_board
from course_lib.detection.circles import circle_bias
from data_generators.board_scenes import board_texture
from data_generators.calibration_sets import calibration_set

DOTS = DotGrid(10, 8, 25, 15)
CHARUCO = Charuco(6, 4, 30, 22)
SQUARES = SquareGrid(6, 5, 20, 34)


@cache
def rendered(board):
    """Two pictures of a board without distortion."""
    return calibration_set(
        2, rng=np.random.default_rng(4), board=board, coefficients=[0], image_size=(480, 360)
    )


def rms(errors):
    return float(np.sqrt(np.mean(np.sum(np.square(errors), axis=1))))


def photograph(name):
    return cv2.imread(str(fetched(name)))


class TestDots:
    def test_centroids_are_off_by_the_bias_of_perspective(self):
        pictures = rendered(DOTS)
        for view in pictures.views:
            found = detect_board(view.picture, DOTS)
            assert found.good
            assert found.verdict == "All 10 × 8 dots found."
            errors = found.points - view.points[found.ids]
            bias = circle_bias(DOTS.points(), DOTS.diameter / 2, pictures.K, view.R, view.t)
            assert rms(errors) > 3 * rms(errors - bias)
            assert rms(errors - bias) < 0.03

    def test_finds_every_real_grid(self):
        names = [n for n in data.names("boofcv/Sony_DSC-HX5V_Circle") if n.endswith(".jpg")]
        found = [detect_board(photograph(name), DOTS) for name in names]
        assert len(found) == 6
        assert all(f.good and len(f.ids) == 80 for f in found)

    def test_hidden_dots_are_left_out(self):
        view = rendered(DOTS).views[0]
        picture = view.picture.copy()
        hidden = [22, 23]
        for u, v in view.points[hidden]:
            cv2.circle(picture, (round(u), round(v)), 16, 235, -1)
        found = detect_board(picture, DOTS)
        assert found.found
        assert sorted(set(range(80)) - set(found.ids)) == hidden
        assert "78 of 80" in found.verdict

    @pytest.mark.parametrize(
        ("cut", "problem"), [((slice(None), slice(None, 250)), "cut off"), ((0, 0), "no board")]
    )
    def test_verdicts(self, cut, problem):
        texture = board_texture(DOTS)[0]
        picture = cv2.resize(texture, (400, 330), interpolation=cv2.INTER_AREA)
        picture = np.full((60, 60), 99, np.uint8) if cut == (0, 0) else picture[cut]
        found = detect_board(picture, DOTS)
        assert not found.found
        assert found.problem == problem

    @pytest.mark.parametrize("board", [DOTS, SQUARES])
    def test_a_checkerboard_instead(self, board):
        picture = cv2.resize(board_texture(Checkerboard(8, 5, 25))[0], (400, 280))
        found = detect_board(picture, board)
        assert not found.found
        assert found.problem == "other kind"
        assert "looks like a checkerboard of 8 × 5 corners, not" in found.verdict

    def test_wrong_size(self):
        picture = cv2.resize(board_texture(DOTS)[0], (400, 330), interpolation=cv2.INTER_AREA)
        found = detect_board(picture, DotGrid(11, 9, 25, 15))
        assert found.problem == "wrong size"
        assert "10 × 8" in found.verdict or "8 × 10" in found.verdict

    def test_blurred(self):
        picture = cv2.resize(board_texture(DOTS)[0], (400, 330), interpolation=cv2.INTER_AREA)
        found = detect_board(cv2.GaussianBlur(picture, (0, 0), 4), DOTS)
        assert found.problem == "blurred"
        assert found.blur == pytest.approx(4, rel=0.35)


class TestCharuco:
    def test_corners_have_their_numbers(self):
        for view in rendered(CHARUCO).views:
            found = detect_board(view.picture, CHARUCO)
            assert found.good
            assert len(found.ids) >= 20
            assert rms(found.points - view.points[found.ids]) < 0.05

    @pytest.mark.parametrize("turn", range(4))
    def test_any_part_in_any_turn(self, turn):
        texture, origin, pixel = board_texture(CHARUCO)
        part = texture[: len(texture) * 2 // 3]
        found = detect_board(np.rot90(part, turn).copy(), CHARUCO)
        assert 6 <= len(found.ids) < 24
        # Where each pixel of the turned picture was before.
        rows, columns = np.rot90(np.indices(part.shape), turn, axes=(1, 2))
        u, v = np.rint(found.points).astype(int).T
        points = np.stack([columns[v, u], rows[v, u]], axis=1) * pixel + origin
        np.testing.assert_allclose(points, CHARUCO.points()[found.ids, :2], atol=1.5 * pixel)

    def test_other_markers(self):
        other = Charuco(6, 4, 30, 22, "DICT_4X4_50")
        found = detect_board(rendered(CHARUCO).views[0].picture, other)
        assert found.problem == "no board"
        assert "DICT_4X4_50" in found.verdict

    def test_unknown_dictionary(self):
        with pytest.raises(ValueError, match="no markers 'DICT_9X9'"):
            detect_board(np.zeros((60, 60), np.uint8), Charuco(6, 4, 30, 22, "DICT_9X9"))


class TestSquares:
    def test_corners(self):
        for view in rendered(SQUARES).views:
            found = detect_board(view.picture, SQUARES)
            assert found.good
            assert len(found.ids) == 120
            assert rms(found.points - view.points[found.ids]) < 0.15

    def test_zhangs_pictures(self):
        board, apart = SquareGrid(8, 8, 0.5, 8 / 9), []
        for number in range(1, 6):
            found = detect_board(photograph(f"zhang/CalibIm{number}.png"), board)
            assert found.good
            assert len(found.ids) == 256
            name = fetched(f"zhang/data{number}.txt")
            his = np.loadtxt(name).reshape(-1, 2)
            away = np.linalg.norm(his[:, None] - found.points, axis=2)
            assert len(set(away.argmin(axis=1))) == 256
            apart.append(np.median(away.min(axis=1)))
        # Three of the five were digitised with torn lines.
        assert np.sort(apart)[1] < 0.2
        assert max(apart) < 0.7
