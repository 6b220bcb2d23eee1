from functools import partial

import numpy as np
import pytest

from course_lib.resection import (
    correction_from_polynomial,
    correction_from_table,
    correction_table,
    hold_out,
    polynomial_correction,
)

SIZE = (640, 480)


def bent(pixels):
    """Return what a camera model may leave over: a smooth field of half a pixel."""
    u, v = ((np.asarray(pixels) + 0.5) / SIZE * 2 - 1).T
    return 0.5 * np.stack([u**3 - 0.3 * v, u * v], axis=1)


def measured(seed=0, count=700, noise=0.05, signal=1.0):
    rng = np.random.default_rng(seed)
    pixels = rng.uniform((-0.5, -0.5), (639.5, 479.5), (count, 2))
    return pixels, signal * bent(pixels) + noise * rng.normal(size=(count, 2))


def by_table(shape, pixels, residuals, others):
    return correction_from_table(others, correction_table(pixels, residuals, SIZE, shape), SIZE)


def by_polynomial(degree, pixels, residuals, others):
    learned = polynomial_correction(pixels, residuals, SIZE, degree)
    return correction_from_polynomial(others, learned, SIZE)


CORRECTORS = ["table", "polynomial"]


class TestTable:
    def test_cells_and_their_means(self):
        pixels, residuals = measured()
        table = correction_table(pixels, residuals, SIZE, (3, 4))
        assert table.shape == (3, 4, 2)
        inside = (np.abs(pixels - [239.5, 239.5]) <= [80, 80]).all(axis=1)
        np.testing.assert_allclose(table[1, 1], residuals[inside].mean(axis=0))

    def test_the_picture_begins_half_a_pixel_early(self):
        edges = [[-0.5, -0.5], [319.4, 0], [319.6, 0], [639.5, 479.5]]
        table = correction_table(edges, np.outer([1, 2, 4, 8], [1, 1]), SIZE, (1, 2))
        np.testing.assert_allclose(table[0, :, 0], [1.5, 6])

    def test_a_cell_without_points_corrects_nothing(self):
        table = correction_table([[5, 5]], [[1, 1]], SIZE, (2, 2))
        np.testing.assert_array_equal(table[1], 0)
        np.testing.assert_array_equal(table[0, 1], 0)

    def test_errors(self):
        pair = [[5, 5]], [[1, 1]]
        with pytest.raises(ValueError, match="must be in the picture"):
            correction_table([[640, 5]], pair[1], SIZE, (2, 2))
        with pytest.raises(ValueError, match="one row and one column or more"):
            correction_table(*pair, SIZE, (0, 2))
        with pytest.raises(TypeError, match="two whole numbers"):
            correction_table(*pair, SIZE, (1.5, 2))
        with pytest.raises(ValueError, match="row by row"):
            correction_table(pair[0], [[1, 1], [2, 2]], SIZE, (2, 2))


class TestFromTable:
    def test_the_middles_have_the_cells_values(self):
        table = np.random.default_rng(1).normal(size=(3, 4, 2))
        u, v = np.meshgrid(np.arange(4) * 160 + 79.5, np.arange(3) * 160 + 79.5)
        middles = np.stack([u.ravel(), v.ravel()], axis=1)
        np.testing.assert_allclose(
            correction_from_table(middles, table, SIZE), table.reshape(-1, 2), atol=1e-12
        )

    def test_bilinear_between_constant_outside(self):
        u, v = np.meshgrid(np.arange(4), np.arange(3))
        table = np.stack([2 * u + 5 * v, u * 0 + 1], axis=-1)
        pixels = np.random.default_rng(2).uniform((79.5, 79.5), (559.5, 399.5), (50, 2))
        x, y = ((pixels - 79.5) / 160).T
        seen = correction_from_table(pixels, table, SIZE)
        np.testing.assert_allclose(seen, np.stack([2 * x + 5 * y, x * 0 + 1], axis=1), atol=1e-12)
        np.testing.assert_allclose(correction_from_table((-0.5, 900), table, SIZE), [10, 1])

    def test_one_cell(self):
        np.testing.assert_array_equal(correction_from_table((9, 9), [[[3, 4]]], SIZE), [3, 4])

    def test_errors(self):
        with pytest.raises(ValueError, match=r"shape \(rows, columns, 2\)"):
            correction_from_table((9, 9), [[3, 4]], SIZE)


class TestPolynomial:
    @pytest.mark.parametrize("degree", [3, 5])
    def test_a_polynomial_comes_back(self, degree):
        pixels, residuals = measured(noise=0)
        learned = polynomial_correction(pixels[:100], residuals[:100], SIZE, degree)
        assert learned.shape == ((degree + 1) * (degree + 2) // 2, 2)
        np.testing.assert_allclose(
            correction_from_polynomial(pixels, learned, SIZE), residuals, atol=1e-10
        )
        assert correction_from_polynomial(pixels[0], learned, SIZE).shape == (2,)

    def test_errors(self):
        pixels, residuals = measured(count=5)
        with pytest.raises(ValueError, match="6 unknowns need as many equations or more, got 5"):
            polynomial_correction(pixels, residuals, SIZE, 2)
        with pytest.raises(ValueError, match="whole number from 0 to 12"):
            polynomial_correction(pixels, residuals, SIZE, -1)
        with pytest.raises(ValueError, match=r"1, 3, 6, 10 … rows, got \(5, 2\)"):
            correction_from_polynomial(pixels, residuals, SIZE)


class TestHoldOut:
    @pytest.mark.parametrize(
        "correct",
        [partial(by_table, (6, 8)), partial(by_polynomial, 4)],
        ids=["table", "polynomial"],
    )
    def test_it_helps_where_residuals_agree(self, correct):
        judged = hold_out(correct, *measured(), 5, np.random.default_rng(1))
        assert judged.before > 0.25
        assert judged.held_out < 0.11  # the noise alone is 0.05 √2 = 0.07
        assert judged.learned < judged.held_out

    @pytest.mark.parametrize(
        "correct",
        [partial(by_table, (6, 8)), partial(by_polynomial, 8)],
        ids=["table", "polynomial"],
    )
    def test_it_harms_where_there_is_only_noise(self, correct):
        judged = hold_out(correct, *measured(signal=0, count=200), 5, np.random.default_rng(1))
        assert judged.learned < judged.before < judged.held_out

    def test_a_finer_table_learns_ever_more_noise(self):
        judged = [
            hold_out(partial(by_table, (n, n)), *measured(), 5, np.random.default_rng(1))
            for n in (2, 6, 24)
        ]
        learned, unseen = ([getattr(j, name) for j in judged] for name in ("learned", "held_out"))
        assert learned[1] < learned[0]
        assert unseen[1] < unseen[0]
        assert unseen[2] > unseen[1]

    def test_held_out_points_are_not_learned_from(self):
        """A corrector that knows by heart what it has seen, and nothing else, gains nothing."""

        def by_heart(pixels, residuals, others):
            known = dict(zip(map(tuple, pixels), residuals, strict=True))
            return np.array([known.get(tuple(pixel), (0, 0)) for pixel in others])

        judged = hold_out(by_heart, *measured(count=40), 4, np.random.default_rng(1))
        assert judged.learned == 0
        assert judged.held_out == pytest.approx(judged.before)

    def test_errors(self):
        with pytest.raises(ValueError, match="parts must be from 2 to 5"):
            hold_out(partial(by_table, (2, 2)), *measured(count=5), 6, np.random.default_rng(1))
