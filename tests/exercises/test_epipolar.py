"""Chapter 08 written out plainly gives what the library gives; its comparisons see what counts."""

import doctest

import numpy as np
import pytest

from course_lib import epipolar
from course_lib.exercises.epipolar import inputs, keeping, pair_inputs, plain, plain_estimation
from course_lib.exercises.epipolar.comparison import (
    LinesWithUnitNormal,
    MatrixAndFits,
    PixelMatrix,
    TheOtherWayRound,
)


@pytest.fixture(params=range(8))
def rng(request):
    return np.random.default_rng(request.param)


@pytest.mark.parametrize(
    ("draw", "name", "same"),
    [
        (inputs.any_vector, "skew", None),
        (inputs.turned_camera, "essential_from_pose", None),
        (inputs.anywhere_in_the_world, "fundamental_from_cameras", PixelMatrix()),
        (inputs.lines_of_pixels, "epipolar_lines", LinesWithUnitNormal()),
        (inputs.small_epipole, "epipole", None),
        (inputs.forward, "epipole", None),
        (inputs.pixels_and_lines, "line_distance", None),
        (pair_inputs.pairs_with_noise, "eight_point", PixelMatrix(tolerance=1e-9)),
        (inputs.errors_of_pixels, "sampson_error", None),
        (pair_inputs.published_case, "ransac_iterations", None),
        (pair_inputs.other_cases, "ransac_iterations", None),
        (pair_inputs.several_points, "pose_from_essential", None),
        (pair_inputs.one_point, "pose_from_essential", None),
    ],
)
def test_gives_what_the_library_gives(rng, draw, name, same):
    posed = getattr(drawn := draw(rng), "inputs", drawn)
    written = getattr(plain, name, None) or getattr(plain_estimation, name)
    ours, plainly = getattr(epipolar, name)(**posed), written(**posed)
    if same:
        assert same(plainly, ours) is None
    else:
        for one, other in zip(pair(ours), pair(plainly), strict=True):
            np.testing.assert_allclose(one, other, rtol=1e-8, atol=1e-9)


def pair(answer):
    """Return an answer, or each of its parts."""
    return answer if isinstance(answer, tuple) else (answer,)


def test_library_finds_the_same_right_pairs(rng):
    known = pair_inputs.noisy_but_nearly_half(rng)
    posed = known.inputs
    found = epipolar.ransac_fundamental(posed["points1"], posed["points2"], rng, 1.0)
    _, fits = plain_estimation.ransac_fundamental(**posed)
    np.testing.assert_array_equal(found.fits, fits)
    assert (
        epipolar.sampson_error(posed["points1"][fits], posed["points2"][fits], found.F).max() < 0.5
    )


def test_the_steps_find_the_pose():
    """A student's own functions, one after the other, lead from wrong pairs to the pose."""
    rng = np.random.default_rng(5)
    p = inputs.pair(rng, 40)
    two = p.pixels2.copy()
    two[:8] += rng.uniform(30, 60, (8, 2))
    count = plain_estimation.ransac_iterations(0.999, 8, 0.2)
    samples = np.array([rng.choice(40, 8, replace=False) for _ in range(count)])
    F, fits = plain_estimation.ransac_fundamental(p.pixels1, two, samples, 1.0)
    np.testing.assert_array_equal(fits, np.arange(40) >= 8)
    assert plain_estimation.sampson_error(p.pixels1[fits], two[fits], F).max() < 1e-6
    lines = plain.epipolar_lines(p.pixels1, F)
    assert plain.line_distance(p.pixels2, lines).max() < 1e-6
    P1 = p.K1 @ np.eye(3, 4)
    known = plain.fundamental_from_cameras(P1, p.K2 @ np.column_stack([p.R, p.t]))
    np.testing.assert_allclose(plain.epipole(F), plain.epipole(known), rtol=1e-6)
    R, t = plain_estimation.pose_from_essential(p.K2.T @ F @ p.K1, p.near1, p.near2)
    np.testing.assert_allclose(R, p.R, atol=1e-6)
    np.testing.assert_allclose(t, p.t / np.linalg.norm(p.t), atol=1e-6)


class TestPixelMatrix:
    F = np.array([[1e-6, 2e-6, -1e-3], [3e-6, -1e-6, 2e-3], [-2e-3, 1e-3, 0.9]])

    def test_scale_and_sign_do_not_count(self):
        assert PixelMatrix()(-700 * self.F, self.F) is None

    def test_small_numbers_count_as_much_as_the_large_one(self):
        """Zeros instead of the four small numbers: lost in the tenth digit of the length."""
        without = self.F.copy()
        without[:2, :2] = 0
        assert np.linalg.norm(without - self.F) < 1e-5 * np.linalg.norm(self.F)
        assert PixelMatrix()(without, self.F).kind == "values"

    @pytest.mark.parametrize("wrong", [None, "F", np.eye(4), np.zeros((3, 3)), [1, 2, 3]])
    def test_what_is_no_matrix(self, wrong):
        assert PixelMatrix()(wrong, self.F) is not None

    def test_nan(self):
        assert PixelMatrix()(self.F * np.nan, self.F).kind == "values"


class TestLines:
    lines = np.array([[0.6, 0.8, -300.0], [1.0, 0, 40]])

    def test_either_sign_of_each_line(self):
        assert LinesWithUnitNormal()(self.lines * [[-1], [1]], self.lines) is None

    def test_scale_counts(self):
        assert "scale" in LinesWithUnitNormal()(2 * self.lines, self.lines).message

    def test_another_line(self):
        assert LinesWithUnitNormal()(self.lines[::-1], self.lines).kind == "values"
        assert LinesWithUnitNormal()(self.lines.T, self.lines).kind == "shape"


class TestMatrixAndFits:
    right = TestPixelMatrix.F, np.array([True, False, True])

    def test_lists_will_do(self):
        F, fits = self.right
        assert MatrixAndFits()([(2 * F).tolist(), fits.tolist()], self.right) is None

    def test_says_which_of_both_is_wrong(self):
        F, fits = self.right
        assert "`F`" in MatrixAndFits()((F.T, fits), self.right).message
        assert "`fits`" in MatrixAndFits()((F, ~fits), self.right).message
        assert "`fits`" in MatrixAndFits()((F, [0, 2]), self.right).message

    @pytest.mark.parametrize("wrong", [None, TestPixelMatrix.F, [], (1, 2, 3)])
    def test_other_than_two_values(self, wrong):
        assert MatrixAndFits()(wrong, self.right).kind == "type"

    def test_the_other_way_round(self):
        swapped = self.right[::-1]
        compare = TheOtherWayRound(MatrixAndFits())
        assert compare((swapped[0], 3 * swapped[1]), swapped) is None
        assert compare(self.right, swapped) is not None
        assert compare(None, swapped).kind == "type"


@pytest.mark.parametrize("module", [plain, plain_estimation])
def test_examples(module):
    results = doctest.testmod(module)
    assert results.attempted >= 9
    assert results.failed == 0


@pytest.mark.parametrize("draw", [inputs.small_lines, inputs.small_errors])
def test_whole_numbers_have_a_line_for_every_point(draw):
    """By chance a line of small whole numbers would be the one at infinity."""
    for seed in range(300):
        posed = draw(np.random.default_rng(seed))
        points = posed.get("points", posed.get("points1"))
        assert np.isfinite(plain.epipolar_lines(points, posed["F"])).all()


def test_kept_results_belong_to_their_numbers_and_shapes(monkeypatch):
    asked = []

    @keeping.kept
    def total(array, factor):
        asked.append(factor)
        return array.sum(axis=0) * factor

    flat = np.arange(6.0)
    assert total(flat, 2) == total(flat.copy(), 2) == 30
    assert asked == [2]
    assert total(flat.reshape(3, 2), 2).shape == (2,)
    assert total(flat, 3) == 45
    assert asked == [2, 2, 3]
    monkeypatch.setattr(keeping, "MOST", 1)
    total(flat, 4)
    assert total(flat, 4) == 60
    assert len(asked) == 4
