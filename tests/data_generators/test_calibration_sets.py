import numpy as np
import pytest

from course_lib.boards import Charuco, Checkerboard, DotGrid, SquareGrid
from course_lib.camera import Camera
from course_lib.distortion import distort_pixels
from data_generators.board_scenes import board_texture, on_board
from data_generators.calibration_sets import calibration_set, rendered_view
from data_generators.flaws import Flaws
from data_generators.markers import marker_cells
from data_generators.render import photograph
from data_generators.scene import Patch, Scene
from data_generators.shot import Shot

BOARD = Checkerboard(5, 4, 30.0)
SMALL = {"board": BOARD, "image_size": (160, 120), "samples": 1}


class TestSets:
    def test_shapes(self):
        pictures = calibration_set(3, rng=np.random.default_rng(0), **SMALL)
        assert len(pictures.views) == 3
        for view in pictures.views:
            assert view.picture.shape == (120, 160)
            assert view.picture.dtype == np.uint8
            assert view.points.shape == (20, 2)

    def test_same_seed_same_pictures(self):
        one, two = (calibration_set(2, rng=np.random.default_rng(5), **SMALL) for _ in range(2))
        for a, b in zip(one.views, two.views, strict=True):
            np.testing.assert_array_equal(a.picture, b.picture)

    def test_points_are_projected_and_distorted(self):
        pictures = calibration_set(1, rng=np.random.default_rng(1), **SMALL)
        view = pictures.views[0]
        camera = Camera(pictures.K, view.R, view.t, pictures.image_size)
        ideal = camera.project(BOARD.points())
        expected = distort_pixels(ideal, pictures.K, pictures.coefficients)
        np.testing.assert_allclose(view.points, expected)
        assert np.abs(expected - ideal).max() > 0.3

    def test_whole_boards_are_inside_and_cut_ones_are_not(self):
        pictures = calibration_set(4, rng=np.random.default_rng(2), flaws={2: "cut off"}, **SMALL)
        for number, view in enumerate(pictures.views):
            inside = ((view.points > 0) & (view.points < (159, 119))).all(axis=1).mean()
            assert inside < 0.9 if number == 2 else inside == 1

    def test_the_field_of_view_does_not_depend_on_the_size(self):
        small = calibration_set(1, rng=np.random.default_rng(1), **SMALL)
        large = calibration_set(
            1, rng=np.random.default_rng(1), board=BOARD, image_size=(320, 240), samples=1
        )
        np.testing.assert_allclose(large.K[:2, :2], 2 * small.K[:2, :2])
        np.testing.assert_allclose(large.views[0].points + 0.5, 2 * (small.views[0].points + 0.5))

    def test_wrong_flaw(self):
        for flaws in ({0: "torn"}, {7: "glare"}):
            with pytest.raises(ValueError, match="flaws must be"):
                calibration_set(2, rng=np.random.default_rng(0), flaws=flaws)


def head_on(size=(160, 120)):
    K = np.array([[160.0, 0, 79.5], [0, 160, 59.5], [0, 0, 1]])
    return Camera(K, np.eye(3), np.array([-60.0, -45, 300]), size)


class TestFlaws:
    def view(self, flaw, **settings):
        flaws = Flaws(flaw, **settings)
        return rendered_view(BOARD, head_on(), [0], flaws, rng=np.random.default_rng(0))

    def test_blurred_is_less_steep(self):
        sharp, blurred = self.view("", blur=0.2), self.view("blurred")
        steepest = [np.abs(np.diff(v.picture.astype(int), axis=1)).max() for v in (sharp, blurred)]
        assert steepest[1] < 0.75 * steepest[0]

    def test_glare_is_white_on_the_board(self):
        sharp, glare = self.view(""), self.view("glare")
        white = (glare.picture == 255) & (sharp.picture < 255)
        v, u = np.argwhere(white).mean(axis=0)
        assert white.sum() > 200
        assert np.linalg.norm(glare.points - (u, v), axis=1).min() < 2

    def test_noise(self):
        quiet, loud = self.view("", noise=0.0), self.view("", noise=5.0)
        apart = loud.picture.astype(int) - quiet.picture
        assert apart[:20].std() == pytest.approx(5, rel=0.05)

    def test_bent_board_moves_the_middle_only(self):
        flat, bent = self.view(""), self.view("bent")
        moved = np.linalg.norm(bent.points - flat.points, axis=1).reshape(4, 5)
        np.testing.assert_allclose(moved[:, [0, 4]], 0, atol=1e-9)
        assert moved[0, 1] > 0.1
        depth = on_board(BOARD, 3.0)[:, 2].reshape(4, 5)
        np.testing.assert_allclose(depth[:, 2], -3)

    def test_negative_numbers(self):
        with pytest.raises(ValueError, match="blur must not be negative"):
            Flaws(blur=-1)


class TestTextures:
    @pytest.mark.parametrize(
        "board",
        [
            BOARD,
            Charuco(5, 4, 30, 20),
            DotGrid(5, 4, 30, 16),
            SquareGrid(5, 4, 18, 30),
        ],
    )
    def test_points_are_where_they_should_be(self, board):
        texture, origin, pixel = board_texture(board)
        points = (board.points()[:, :2] - origin) / pixel
        assert (points > 20).all()
        assert (points < np.array(texture.shape)[::-1] - 20).all()
        for u, v in points.round().astype(int):
            if isinstance(board, DotGrid):
                assert texture[v, u] == 20
                continue
            around = texture[[v - 3, v - 3, v + 2, v + 2], [u - 3, u + 2, u + 2, u - 3]]
            dark = 1 if isinstance(board, SquareGrid) else 2
            assert sorted(around) == [20] * dark + [235] * (4 - dark)

    def test_markers_have_a_dark_frame(self):
        cells = marker_cells("DICT_5X5_1000", 7)
        assert cells.shape == (7, 7)
        assert cells[[0, -1]].all()
        assert cells[:, [0, -1]].all()
        assert not cells.all()

    def test_unknown_marker(self):
        with pytest.raises(ValueError, match="markers 0 to 49"):
            marker_cells("DICT_4X4_50", 50)
        with pytest.raises(ValueError, match="no markers 'ARUCO'"):
            marker_cells("ARUCO", 0)


class TestDistortedRays:
    K = np.array([[50.0, 0, 31.5], [0, 50, 23.5], [0, 0, 1]])

    def test_nothing_changes_without(self):
        wall = Patch((-5, -5, 3), (10, 0, 0), (0, 10, 0), np.arange(64).reshape(8, 8) * 3)
        camera = Camera(self.K, np.eye(3), np.zeros(3), (64, 48))
        plain = photograph(Scene((wall,)), camera, samples=1)
        none = photograph(Scene((wall,)), camera, samples=1, shot=Shot(distortion=[0.0]))
        np.testing.assert_array_equal(plain, none)

    def test_a_lens_that_folds_is_refused(self):
        camera = Camera(self.K, np.eye(3), np.zeros(3), (64, 48))
        with pytest.raises(ValueError, match="no ray for some pixels"):
            photograph(Scene(()), camera, shot=Shot(distortion=[-2.0]), samples=1)
