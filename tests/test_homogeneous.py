import numpy as np
import pytest

from course_lib.checks import DegenerateConfigurationError
from course_lib.homogeneous import (
    LINE_AT_INFINITY,
    apply_homography,
    cross_ratio,
    from_homogeneous,
    line_through,
    map_lines,
    meet,
    to_homogeneous,
)

RNG = np.random.default_rng(0)
POINTS = RNG.uniform(-9, 9, (6, 2))
#: A projective, an affine and a Euclidean transformation of the plane.
PROJECTIVE = np.array([[1.1, 0.2, 3], [-0.3, 0.9, 2], [0.02, 0.03, 1]])
AFFINE = np.array([[1.1, 0.2, 3], [-0.3, 0.9, 2], [0, 0, 1]])
EUCLIDEAN = np.array([[0.8, -0.6, 3], [0.6, 0.8, 2], [0, 0, 1]])


def lengths(points):
    return np.linalg.norm(np.diff(points, axis=0), axis=1)


def parallel(l, m):  # noqa: E741
    return meet(l, m)[2] == pytest.approx(0, abs=1e-12)


class TestCoordinates:
    def test_shapes(self):
        assert to_homogeneous((1, 2)).shape == (3,)
        assert to_homogeneous(np.ones((5, 3))).shape == (5, 4)
        assert to_homogeneous(np.ones((0, 2))).shape == (0, 3)
        assert from_homogeneous((1, 2, 3)).shape == (2,)
        assert from_homogeneous(np.ones((5, 4))).shape == (5, 3)
        assert from_homogeneous([[2, 4, 2]]).dtype == np.float64

    @pytest.mark.parametrize("function", [to_homogeneous, from_homogeneous])
    @pytest.mark.parametrize(
        ("points", "words"),
        [
            (3.0, r"points must be rows of . or more numbers, got shape \(\)"),
            (np.ones((2, 3, 4)), "points are rows"),
            ([], "or more numbers"),
            ([1, np.nan, 1], "points must be finite"),
            ([1e80, 1, 1], "beyond 1e\\+75"),
        ],
    )
    def test_errors(self, function, points, words):
        with pytest.raises(ValueError, match=words):
            function(points)

    def test_errors_of_lengths(self):
        with pytest.raises(ValueError, match="rows of 2 or more numbers"):
            from_homogeneous([5.0])
        with pytest.raises(TypeError, match="points must be real numbers"):
            to_homogeneous(["a", "b"])

    def test_round_trip(self):
        for points in (POINTS, POINTS[0], RNG.normal(size=(4, 3))):
            np.testing.assert_array_equal(from_homogeneous(to_homogeneous(points)), points)

    def test_accuracy(self):
        w = np.array([[-3.0], [0.5], [1], [2], [10], [-0.1]])
        np.testing.assert_allclose(from_homogeneous(w * to_homogeneous(POINTS)), POINTS)

    def test_degenerate(self):
        np.testing.assert_array_equal(
            from_homogeneous([[1, 2, 0], [1, 2, -2], [0, 0, 0]]),
            [[np.nan, np.nan], [-0.5, -1], [np.nan, np.nan]],
        )

    def test_inputs_stay_as_they_are(self):
        points = np.array([[1.0, 2, 0], [1, 2, 3]])
        from_homogeneous(points)
        np.testing.assert_array_equal(points, [[1, 2, 0], [1, 2, 3]])


class TestJoinAndMeet:
    @pytest.mark.parametrize("function", [line_through, meet])
    def test_shapes(self, function):
        rows = to_homogeneous(POINTS)
        assert function(rows[0], rows[1]).shape == (3,)
        assert function(rows[:3], rows[3:]).shape == (3, 3)
        assert function(rows[0], rows[3:]).shape == (3, 3)

    @pytest.mark.parametrize("function", [line_through, meet])
    @pytest.mark.parametrize(
        ("first", "second", "words"),
        [
            ((1, 2), (1, 2, 3), r"must have shape \(N, 3\) or \(3,\), got \(2,\)"),
            ((1, 2, 3), (0, 0, 0), "zero vector"),
            (np.ones((2, 3)), np.ones((4, 3)), "must be as many"),
        ],
    )
    def test_errors(self, function, first, second, words):
        with pytest.raises(ValueError, match=words):
            function(first, second)

    def test_accuracy(self):
        # Both points are on the line; both lines go through the point.
        p, q = 3 * to_homogeneous(POINTS[:3]), -2 * to_homogeneous(POINTS[3:])
        lines = line_through(p, q)
        for on_it in (p, q):
            np.testing.assert_allclose((lines * on_it).sum(axis=1), 0, atol=1e-12)
        middle = to_homogeneous((POINTS[:3] + POINTS[3:]) / 2)
        np.testing.assert_allclose((lines * middle).sum(axis=1), 0, atol=1e-12)

    def test_round_trip(self):
        # Three points, three lines, the same three points.
        a, b, c = to_homogeneous(POINTS[:3])
        corner = meet(line_through(a, b), line_through(a, c))
        np.testing.assert_allclose(from_homogeneous(corner), POINTS[0])

    def test_parallel_lines_meet_at_infinity(self):
        x, y, w = meet((3, -4, 10), (-6, 8, 1))
        assert w == 0
        assert 3 * x - 4 * y == 0  # in the direction of both
        assert meet((3, -4, 10), (-6, 8, 1)) @ LINE_AT_INFINITY == 0

    def test_lines_through_a_point_at_infinity(self):
        line = line_through((2, 3, 1), (1, 1, 0))
        np.testing.assert_allclose(line / line[0], (1, -1, 1))
        np.testing.assert_array_equal(
            np.cross(line_through((1, 0, 0), (1, 1, 0)), LINE_AT_INFINITY), (0, 0, 0)
        )

    def test_degenerate(self):
        with pytest.raises(DegenerateConfigurationError, match="points p and q are the same"):
            line_through((1, 2, 3), (-2, -4, -6))
        with pytest.raises(DegenerateConfigurationError, match="lines l and m are the same"):
            meet([(1, 0, 0), (1, 2, 3)], [(0, 1, 0), (1e-40, 2e-40, 3e-40)])


class TestTransformations:
    """What each kind of transformation keeps: projective, then affine, then Euclidean ones."""

    def test_shapes(self):
        assert apply_homography((1, 2), PROJECTIVE).shape == (2,)
        assert apply_homography(POINTS, PROJECTIVE).shape == POINTS.shape
        assert map_lines((1, 2, 3), PROJECTIVE).shape == (3,)
        assert map_lines(np.ones((4, 3)), PROJECTIVE).shape == (4, 3)
        assert isinstance(cross_ratio([[0, 0], [1, 1], [2, 2], [3, 3]]), float)

    def test_errors(self):
        with pytest.raises(ValueError, match=r"points must have shape \(N, 2\) or \(2,\)"):
            apply_homography((1, 2, 3), PROJECTIVE)
        with pytest.raises(ValueError, match=r"H must have shape \(3, 3\)"):
            apply_homography(POINTS, np.eye(2))
        with pytest.raises(ValueError, match=r"points must have shape \(4, 2\) or \(4, 3\)"):
            cross_ratio(POINTS)
        with pytest.raises(ValueError, match="points must be finite"):
            cross_ratio(np.full((4, 2), np.nan))
        with pytest.raises(ValueError, match="lines holds a zero vector"):
            map_lines((0, 0, 0), PROJECTIVE)

    def test_round_trip(self):
        there = apply_homography(POINTS, PROJECTIVE)
        np.testing.assert_allclose(apply_homography(there, np.linalg.inv(PROJECTIVE)), POINTS)

    def test_accuracy(self):
        # Points on a line stay on it: the line through the images is the image of the line.
        p, q = to_homogeneous(POINTS[0]), to_homogeneous(POINTS[1])
        images = to_homogeneous(apply_homography(POINTS[:2], PROJECTIVE))
        mapped = map_lines(line_through(p, q), PROJECTIVE)
        np.testing.assert_allclose(np.cross(line_through(*images), mapped), 0, atol=1e-10)

    def test_projective_keeps_the_cross_ratio_alone(self):
        line = np.array([[0.0, 1], [1, 3], [2, 5], [4, 9]])
        for H in (PROJECTIVE, AFFINE, EUCLIDEAN):
            assert cross_ratio(apply_homography(line, H)) == pytest.approx(cross_ratio(line))
        assert cross_ratio(line) == pytest.approx((2 * 3) / (1 * 4))
        before, after = lengths(line), lengths(apply_homography(line, PROJECTIVE))
        assert abs(after[2] / after[0] - before[2] / before[0]) > 0.1

    def test_affine_keeps_parallels_and_ratios_on_a_line(self):
        l, m = np.array([[1.0, 2, 3], [1, 2, 7]])  # noqa: E741
        assert parallel(*map_lines([l, m], AFFINE))
        assert not parallel(*map_lines([l, m], PROJECTIVE))
        line = np.array([[0.0, 1], [1, 3], [4, 9]])
        after = lengths(apply_homography(line, AFFINE))
        assert after[1] / after[0] == pytest.approx(3)
        np.testing.assert_allclose(map_lines(LINE_AT_INFINITY, AFFINE), LINE_AT_INFINITY)

    def test_euclidean_keeps_lengths(self):
        np.testing.assert_allclose(lengths(apply_homography(POINTS, EUCLIDEAN)), lengths(POINTS))
        assert np.abs(lengths(apply_homography(POINTS, AFFINE)) - lengths(POINTS)).max() > 0.1

    def test_degenerate(self):
        with pytest.raises(DegenerateConfigurationError, match="H is singular"):
            apply_homography(POINTS, np.ones((3, 3)))
        with pytest.raises(DegenerateConfigurationError, match="not on one line"):
            cross_ratio(POINTS[:4])
        with pytest.raises(DegenerateConfigurationError, match="coincide"):
            cross_ratio([[0, 0], [1, 1], [1, 1], [3, 3]])
        # A point on the line that goes to infinity has no image.
        to_infinity = np.array([[1, 0, 0], [0, 1, 0], [1, 0, -2.0]])
        np.testing.assert_array_equal(
            np.isnan(apply_homography([[2, 5], [3, 5]], to_infinity)),
            [[True, True], [False, False]],
        )
