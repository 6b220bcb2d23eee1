import numpy as np
import pytest

from course_lib.checks import DegenerateConfigurationError
from course_lib.distortion import (
    distort_pixels,
    distortion_from_lines,
    straightness,
    undistort_pixels,
)

K = np.array([[600.0, 0, 325], [0, 600, 245], [0, 0, 1]])
TRUTH = [-0.25, 0.1]


def pictures_of_lines(rng, count=12, noise=0.0, k=TRUTH):
    """Return points on the pictures of straight lines that run across the picture anyhow."""
    lines = []
    for _ in range(count):
        turn, offset = rng.uniform(0, np.pi), rng.uniform(-220, 220)
        along, across = np.array([np.cos(turn), np.sin(turn)]), [-np.sin(turn), np.cos(turn)]
        ideal = K[:2, 2] + np.outer(np.linspace(-280, 280, 60), along) + offset * np.array(across)
        lines.append(distort_pixels(ideal, K, k) + noise * rng.normal(size=(60, 2)))
    return lines


class TestStraightness:
    @pytest.mark.parametrize("turn", [0, 0.3, np.pi / 2, 2])
    def test_does_not_depend_on_the_direction(self, turn):
        zigzag = np.array([[0, 1], [1, -1], [2, -1], [3, 1]])  # its best line is the axis
        R = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
        assert straightness(zigzag @ R.T + [100, -50]) == pytest.approx(1)

    def test_straight(self):
        assert straightness([[1, 5], [1, 7], [1, 6], [1, -3]]) < 1e-12
        assert straightness([[2, 2], [2, 2], [2, 2]]) == 0

    def test_scatter(self):
        rng = np.random.default_rng(1)
        x = np.linspace(0, 100, 20_000)
        points = np.stack([x, 0.5 * x], axis=1) + rng.normal(scale=0.3, size=(20_000, 2))
        assert straightness(points) == pytest.approx(0.3, rel=0.02)

    def test_errors(self):
        with pytest.raises(ValueError, match="two are always straight"):
            straightness([[0, 0], [1, 1]])
        with pytest.raises(ValueError, match="three or more points in rows"):
            straightness([0, 0])


class TestFromLines:
    def test_accuracy(self):
        found = distortion_from_lines(pictures_of_lines(np.random.default_rng(2)), K)
        np.testing.assert_allclose(found.coefficients, TRUTH, atol=1e-7)
        assert found.rms < 1e-6
        assert found.rms_before > 1

    def test_one_term(self):
        lines = pictures_of_lines(np.random.default_rng(2), k=[0.3])
        found = distortion_from_lines(lines, K, terms=1)
        np.testing.assert_allclose(found.coefficients, [0.3], atol=1e-7)
        assert found.sigma.shape == (1,)

    def test_noise_and_its_sigma(self):
        trials = [
            distortion_from_lines(pictures_of_lines(np.random.default_rng(seed), noise=0.1), K)
            for seed in range(40)
        ]
        errors = np.array([(t.coefficients - TRUTH) / t.sigma for t in trials])
        assert np.abs(errors.mean(axis=0)).max() < 0.55  # 3.5 standard deviations of a mean of 40
        np.testing.assert_allclose(errors.std(axis=0), 1, atol=0.35)
        # Each line takes two unknowns, the lens two more; only the part across it counts.
        expected = 0.1 * np.sqrt(1 - (2 * 12 + 2) / 720)
        assert np.mean([t.rms for t in trials]) == pytest.approx(expected, rel=0.02)

    def test_judges_by_the_real_picture(self):
        # Shrinking everything makes any line straighter, in ideal pixels.
        lines = pictures_of_lines(np.random.default_rng(3), noise=1.0, k=[0, 0])
        found = distortion_from_lines(lines, K)
        assert np.abs(found.coefficients / found.sigma).max() < 4
        assert found.rms == pytest.approx(1, rel=0.1)

    def test_another_focal_length_straightens_as_well(self):
        lines = pictures_of_lines(np.random.default_rng(4))
        other = K * [[2, 1, 1], [1, 2, 1], [1, 1, 1]]
        found = distortion_from_lines(lines, other)
        np.testing.assert_allclose(found.coefficients, np.multiply(TRUTH, [4, 16]), rtol=1e-5)
        straight = [undistort_pixels(line, other, found.coefficients) for line in lines]
        assert max(map(straightness, straight)) < 1e-6

    @pytest.mark.parametrize("k", [[-0.5, 0.2], [0.4, 0.3], [-0.45, 0]])
    def test_strong_lenses(self, k):
        found = distortion_from_lines(pictures_of_lines(np.random.default_rng(5), k=k), K)
        np.testing.assert_allclose(found.coefficients, k, atol=1e-5)

    def test_inputs_stay_as_they_are(self):
        lines = pictures_of_lines(np.random.default_rng(6))
        before = [line.copy() for line in lines]
        distortion_from_lines(lines, K)
        for line, copy in zip(lines, before, strict=True):
            np.testing.assert_array_equal(line, copy)

    def test_degenerate(self):
        rays = [
            K[:2, 2] + np.outer(np.linspace(-200, 200, 30), [np.cos(a), np.sin(a)])
            for a in (0, 1, 2)
        ]
        with pytest.raises(DegenerateConfigurationError, match="do not determine"):
            distortion_from_lines(rays, K)

    def test_errors(self):
        lines = pictures_of_lines(np.random.default_rng(7))
        with pytest.raises(ValueError, match="terms must be 1"):
            distortion_from_lines(lines, K, terms=3)
        with pytest.raises(ValueError, match="two are always straight"):
            distortion_from_lines([*lines, lines[0][:2]], K)
        with pytest.raises(ValueError, match="2 coefficients and 1 lines need more than 4 points"):
            distortion_from_lines([lines[0][:3]], K)
        with pytest.raises(ValueError, match="one or more lines"):
            distortion_from_lines([], K)
