import cv2
import numpy as np
import pytest

from course_lib.detection.corner_fit import fit_corners, refine_corners, window_radii

FINE = 8  # samples of a pixel along each axis


def crossing(corner, turns, blur=0.9, noise=0.0, size=41, seed=0, levels=(30, 210)):
    """A picture of two edges that cross, each pixel the mean over its area."""
    s = (np.arange(size * FINE) + 0.5) / FINE - 0.5
    x, y = np.meshgrid(s - corner[0], s - corner[1])
    # Samples that an edge passes through are partly on one side.
    sides = [np.clip(2 * FINE * (y * np.cos(t) - x * np.sin(t)), -1, 1) for t in turns]
    picture = np.mean(levels) - np.ptp(levels) / 2 * sides[0] * sides[1]
    picture = cv2.GaussianBlur(picture, (0, 0), blur * FINE) if blur else picture
    picture = picture.reshape(size, FINE, size, FINE).mean(axis=(1, 3))
    return picture + noise * np.random.default_rng(seed).normal(size=picture.shape)


class TestAccuracy:
    @pytest.mark.parametrize("corner", [(20, 20), (20.5, 19.7), (19.9, 20.35)])
    @pytest.mark.parametrize("turns", [(0, np.pi / 2), (0.2, 1.4), (-0.5, 0.4), (1, 2.9)])
    @pytest.mark.parametrize("blur", [0.5, 1, 2])
    def test_without_noise(self, corner, turns, blur):
        found = refine_corners(crossing(corner, turns, blur), [(20.8, 19.4)])
        # Widely blurred, edges that are not perpendicular fill the sharp angle between them.
        np.testing.assert_allclose(found[0], corner, atol=0.02 if blur < 2 else 0.08)

    def test_half_the_error_of_opencv(self):
        rng, ours, theirs = np.random.default_rng(1), [], []
        stop = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_COUNT, 100, 1e-4)
        for seed in range(60):
            corner, turn = rng.uniform(19.5, 20.5, 2), rng.uniform(0, np.pi)
            picture = crossing(corner, (turn, turn + rng.uniform(1, 2)), 0.8, 3, seed=seed)
            start = corner + rng.uniform(-1, 1, 2)
            ours.append(refine_corners(picture, start)[0] - corner)
            grey = np.clip(np.rint(picture), 0, 255).astype(np.uint8)
            refined = cv2.cornerSubPix(grey, start.astype(np.float32)[None], (5, 5), (-1, -1), stop)
            theirs.append(refined.reshape(2) - corner)
        assert np.sqrt(np.mean(np.square(ours))) <= 0.5 * np.sqrt(np.mean(np.square(theirs)))

    def test_reported_sigma_is_the_scatter(self):
        fits = [
            fit_corners(crossing((20.3, 19.8), (0.3, 1.6), 1, 4, seed=seed), [(20, 20)])
            for seed in range(100)
        ]
        scatter = np.std([fit.points[0] for fit in fits], axis=0).mean()
        assert np.mean([fit.sigma[0] for fit in fits]) == pytest.approx(scatter, rel=0.15)

    def test_what_the_fit_tells(self):
        fit = fit_corners(crossing((20.3, 19.8), (0.3, 1.6), 1.5, 4), [(20, 20)])
        assert fit.good.all()
        assert fit.blur[0] == pytest.approx(1.5, rel=0.05)
        assert fit.contrast[0] == pytest.approx(180, rel=0.05)
        assert fit.noise[0] == pytest.approx(4, rel=0.15)

    def test_uneven_light(self):
        picture = crossing((20.3, 19.8), (0.3, 1.6)) + 2 * np.arange(41)
        np.testing.assert_allclose(refine_corners(picture, [(20, 20)])[0], (20.3, 19.8), atol=0.02)


class TestWindows:
    def test_shrinks_where_corners_are_close(self):
        corners = np.array([(50, 50), (60, 50), (200, 50)])
        np.testing.assert_array_equal(window_radii(corners, (100, 300)), (5, 5, 10))

    def test_shrinks_at_the_border(self):
        radii = window_radii(np.array([(6.0, 50), (1, 90)]), (100, 300))
        np.testing.assert_array_equal(radii, (5, 0))

    def test_close_corners_do_not_disturb_each_other(self):
        tiles = np.kron(np.indices((8, 8)).sum(axis=0) % 2, np.ones((8, 8))) * 200.0
        picture = cv2.GaussianBlur(tiles, (0, 0), 0.8)
        truth = 7.5 + 8 * np.indices((7, 7)).reshape(2, -1).T[:, ::-1]
        found = refine_corners(picture, truth + 0.6)
        np.testing.assert_allclose(found, truth, atol=0.02)


class TestNoCorner:
    @pytest.mark.parametrize(
        "picture",
        [
            np.full((41, 41), 7.0),
            np.tile(np.arange(41) > 20, (41, 1)) * 200.0,
            np.hypot(*(np.indices((41, 41)) - 20)) * 3,
        ],
        ids=["plain", "edge", "cone"],
    )
    def test_stays_and_says_so(self, picture):
        fit = fit_corners(picture, [(20.2, 19.9)])
        assert not fit.good[0]
        np.testing.assert_array_equal(fit.points[0], (20.2, 19.9))

    @pytest.mark.parametrize("seed", range(3))
    def test_noise_breaks_nothing(self, seed):
        rng = np.random.default_rng(seed)
        picture = rng.integers(0, 2, (60, 80)).astype(float) * 255
        places = rng.uniform((0, 0), (80, 60), (300, 2))
        fit = fit_corners(picture, places)
        assert np.isfinite(fit.points).all()

    def test_beyond_the_border(self):
        fit = fit_corners(crossing((20, 20), (0, 1.5)), [(-3, 20), (20, 20), (60, 60)])
        np.testing.assert_array_equal(fit.good, (False, True, False))

    def test_no_corners(self):
        assert fit_corners(np.zeros((9, 9)), np.empty((0, 2))).points.shape == (0, 2)


class TestErrors:
    def test_colour(self):
        with pytest.raises(ValueError, match="image must be grey"):
            refine_corners(np.zeros((9, 9, 3)), [(4, 4)])

    def test_text(self):
        with pytest.raises(TypeError, match="real numbers"):
            refine_corners(np.array([["a"]]), [(4, 4)])

    def test_nan_in_the_window(self):
        picture = crossing((20, 20), (0, 1.5))
        picture[18, 22] = np.nan
        with pytest.raises(ValueError, match="image must be finite"):
            refine_corners(picture, [(20, 20)])

    def test_input_is_not_modified(self):
        picture, corners = crossing((20, 20), (0, 1.5)), np.array([(20.5, 20.0)])
        copies = picture.copy(), corners.copy()
        refine_corners(picture, corners)
        np.testing.assert_array_equal(picture, copies[0])
        np.testing.assert_array_equal(corners, copies[1])
