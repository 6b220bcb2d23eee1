"""What a calibration is worth: residuals, coverage, other views; and what does not belong to it."""

import numpy as np
import pytest

from course_lib.calibration import (
    CameraModel,
    board_points,
    board_tilts,
    calibrate,
    calibrate_robustly,
    coverage,
    held_out_rms,
    refine_calibration,
    reject_views,
    reprojection_residuals,
    rms_error,
    view_residuals,
)
from course_lib.checks import DegenerateConfigurationError
from course_lib.transforms import rotation_from_vector
from data_generators.board_observations import observe_board

SIZE = (640, 480)
K = np.array([[700.0, 0, 330], [0, 720, 250], [0, 0, 1]])
k = np.array([-0.25, 0.1, 0.001, -0.0008, 0.02])
BOARD = board_points(8, 6, 30)


def observe(seed=0, views=10, noise=0.2, **how):
    rng = np.random.default_rng(seed)
    return observe_board(rng, BOARD, K, k, SIZE, views, noise, **how)


class TestResiduals:
    def test_behind_the_camera(self):
        left = reprojection_residuals(
            [[0, 0, 1], [0, 0, -1]], np.zeros((2, 2)), K, np.eye(3), [0, 0, 0], [0]
        )
        np.testing.assert_array_equal(left, [[330, 250], [np.nan, np.nan]])

    def test_rms_counts_points(self):
        rng = np.random.default_rng(0)
        assert rms_error(rng.normal(0, 0.5, (100_000, 2))) == pytest.approx(
            0.5 * np.sqrt(2), rel=0.01
        )

    def test_errors(self):
        with pytest.raises(ValueError, match="no point to judge by"):
            rms_error(np.empty((0, 2)))
        with pytest.raises(ValueError, match="as many rows"):
            reprojection_residuals(BOARD, np.zeros((3, 2)), K, np.eye(3), [0, 0, 5], [0])
        with pytest.raises(ValueError, match="no views to choose from"):
            reject_views([])
        with pytest.raises(ValueError, match="limit must be 1 or more"):
            reject_views([[[0, 1]]], 0.5)
        with pytest.raises(DegenerateConfigurationError, match="do not determine"):
            refine_calibration([1, 2], [1, 1], [[1, 1], [1, 1]], 0)
        with pytest.raises(ValueError, match="J must have shape"):
            refine_calibration([1, 2], [1, 1, 1], [[1, 1], [1, 1]], 0)


class TestCoverage:
    def test_a_corner_is_half_a_pixel_outside_of_the_last_centre(self):
        found = coverage([[[-0.5, -0.5], [639.49, 479.49], [319.5, 239.5]]], SIZE, (2, 2))
        np.testing.assert_array_equal(found.counts, [[1, 0], [0, 2]])
        assert found.share == 0.5
        assert found.reach == pytest.approx(1, abs=2e-3)

    def test_middle_only(self):
        found = coverage([[[300, 230], [340, 250]]], SIZE)
        assert found.share <= 2 / 48
        assert found.reach < 0.1

    def test_tilts(self):
        turned = [([a * np.cos(d), a * np.sin(d), 0], a) for a, d in ((0.3, 1), (0.6, -2), (0, 0))]
        held = [(rotation_from_vector(vector), [0, 0, 500]) for vector, _ in turned]
        tilts, directions = board_tilts(held)
        np.testing.assert_allclose(tilts, [0.3, 0.6, 0], atol=1e-9)
        for (R, t), direction in zip(held[:2], directions, strict=False):
            aside = np.array([np.cos(direction), np.sin(direction), 0])
            # The edge on that side of the picture is nearer than that on the other side.
            edges = np.array([R @ (R.T @ (s * aside) * [1, 1, 0]) + t for s in (100, -100)])
            assert edges[0, 2] < edges[1, 2]

    def test_upside_down_is_the_same_tilt(self):
        R = rotation_from_vector([np.pi, 0, 0])
        assert board_tilts([(R, [0, 0, 5])])[0] == pytest.approx(0, abs=1e-9)


class TestOtherViews:
    def test_views_that_were_not_used(self):
        seen = observe(views=20)
        found = calibrate(BOARD, seen.pixels[:10], SIZE)
        left = view_residuals(found, BOARD, seen.pixels[10:])
        assert len(left) == 10
        # Six numbers of 96 are fitted to each view.
        assert rms_error(np.concatenate(left)) == pytest.approx(0.2 * np.sqrt(2 * 90 / 96), rel=0.1)

    def test_own_views_come_back(self):
        seen = observe(views=4)
        found = calibrate(BOARD, seen.pixels, SIZE)
        for own, again in zip(
            found.residuals, view_residuals(found, BOARD, seen.pixels), strict=True
        ):
            np.testing.assert_allclose(own, again, atol=1e-5)

    def test_too_large_a_model_is_found_out(self):
        seen, large = (
            observe(views=5, noise=0.5, seed=2),
            CameraModel(
                skew=True, coefficients=("k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6", "s1", "s2")
            ),
        )
        small = CameraModel(coefficients=("k1", "k2", "p1", "p2"))
        on_own = [calibrate(BOARD, seen.pixels, SIZE, m).rms for m in (small, large)]
        on_others = [np.mean(held_out_rms(BOARD, seen.pixels, SIZE, m)) for m in (small, large)]
        assert on_own[1] < on_own[0]
        assert on_others[1] > on_others[0]

    def test_errors(self):
        seen = observe(views=4)
        with pytest.raises(ValueError, match="folds must be from 2 to the 4 views"):
            held_out_rms(BOARD, seen.pixels, SIZE, folds=5)
        found = calibrate(BOARD, seen.pixels, SIZE)
        with pytest.raises(DegenerateConfigurationError, match="no picture of this board"):
            view_residuals(found, BOARD, [np.random.default_rng(0).permutation(seen.pixels[0])])


class TestRobust:
    def test_good_data_stay(self):
        seen = observe(views=12)
        found = calibrate_robustly(BOARD, seen.pixels, SIZE)
        assert found.reasons == ()
        assert found.kept_views.all()
        assert all(points.all() for points in found.kept_points)
        np.testing.assert_allclose(
            found.calibration.K, calibrate(BOARD, seen.pixels, SIZE).K, rtol=1e-6
        )

    @pytest.mark.parametrize("slip", [2.5, 25])
    def test_a_slipped_corner(self, slip):
        seen = observe()
        good = calibrate(BOARD, seen.pixels, SIZE)
        seen.pixels[3][20] += [slip, 0.1 * slip]
        found = calibrate_robustly(BOARD, seen.pixels, SIZE)
        assert [(~points).sum() for points in found.kept_points] == [0, 0, 0, 1, *[0] * 6]
        assert not found.kept_points[3][20]
        (reason,) = found.reasons
        assert reason.startswith("view 3: 1 of 48 points left out, up to ")
        assert np.abs(found.calibration.K - good.K).max() < 0.3 * good.sigma["fx"]
        assert found.calibration.rms == pytest.approx(good.rms, rel=0.01)
        assert np.linalg.norm(found.calibration.residuals[3][20]) == pytest.approx(slip, rel=0.3)

    def test_what_is_off_by_a_hair_is_not_wrong(self):
        """In pictures without noise, 0.06 px would be many standard deviations."""
        seen = observe(noise=0.001)
        seen.pixels[3][20] += [0.06, 0]
        assert calibrate_robustly(BOARD, seen.pixels, SIZE).reasons == ()

    def test_bad_views(self):
        seen, rng = observe(), np.random.default_rng(1)
        good = calibrate(BOARD, seen.pixels, SIZE)
        seen.pixels[2] += rng.normal(0, 2, (48, 2))
        seen.pixels[5] = rng.permutation(seen.pixels[5])
        found = calibrate_robustly(BOARD, seen.pixels, SIZE)
        np.testing.assert_array_equal(np.flatnonzero(~found.kept_views), [2, 5])
        assert [reason[:6] for reason in found.reasons] == ["view 2", "view 5"]
        assert "times the usual one" in found.reasons[0]
        assert "no picture of this board" in found.reasons[1]
        assert len(found.calibration.poses) == 8
        assert not found.kept_points[2].any()
        assert np.abs(found.calibration.K - good.K).max() < 3 * good.sigma["fx"]

    def test_one_point_in_thirty_is_wrong(self):
        seen, rng = observe(views=12), np.random.default_rng(5)
        wrong = [rng.random(48) < 1 / 30 for _ in seen.pixels]
        for pixels, which in zip(seen.pixels, wrong, strict=True):
            pixels[which] += rng.uniform(4, 15, (which.sum(), 2))
        found = calibrate_robustly(BOARD, seen.pixels, SIZE)
        for points, which in zip(found.kept_points, wrong, strict=True):
            np.testing.assert_array_equal(points, ~which)
        assert abs(found.calibration.K[0, 0] - 700) < 4 * found.calibration.sigma["fx"]

    def test_views_with_different_points(self):
        seen = observe()
        boards = [BOARD[i:] for i in range(10)]
        ragged = [pixels[i:] for i, pixels in enumerate(seen.pixels)]
        ragged[4][7] += 12
        found = calibrate_robustly(boards, ragged, SIZE)
        assert [len(points) for points in found.kept_points] == list(range(48, 38, -1))
        assert np.flatnonzero(~np.concatenate(found.kept_points)) == 48 + 47 + 46 + 45 + 7

    def test_views_of_too_few_points(self):
        """As a board with numbered corners gives them, of which a part was seen."""
        seen = observe()
        boards, pixels = [BOARD] * 10, list(seen.pixels)
        for view, some in ((1, slice(0, 3)), (4, slice(0, 8)), (6, slice(0, 0))):
            boards[view], pixels[view] = BOARD[some], pixels[view][some]
        found = calibrate_robustly(boards, pixels, SIZE)
        np.testing.assert_array_equal(np.flatnonzero(~found.kept_views), [1, 4, 6])
        begins = [reason.partition(":")[0] for reason in found.reasons]
        assert begins == [f"view {n} was left out" for n in (1, 4, 6)]
        assert "lie on one line" in found.reasons[1]
        assert [len(points) for points in found.kept_points] == [
            48,
            3,
            48,
            48,
            8,
            48,
            0,
            48,
            48,
            48,
        ]
        assert len(found.calibration.poses) == 7
        others = [view for i, view in enumerate(seen.pixels) if i not in (1, 4, 6)]
        np.testing.assert_allclose(found.calibration.K, calibrate(BOARD, others, SIZE).K, rtol=1e-6)

    def test_nothing_fits(self):
        rng = np.random.default_rng(0)
        noise = [rng.uniform((0, 0), SIZE, (48, 2)) for _ in range(5)]
        with pytest.raises(DegenerateConfigurationError):
            calibrate_robustly(BOARD, noise, SIZE)
