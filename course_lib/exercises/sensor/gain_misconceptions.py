"""Wrong answers to the exercise of chapter 04 that measures a camera's gain."""

from __future__ import annotations

from typing import Any

import numpy as np


def slope(mean: Any, variance: Any, good: Any) -> Any:
    """Fit the line through the origin, as all variants below do."""
    return mean[good] @ variance[good] / (mean[good] @ mean[good])


def transfer(first: Any, second: Any, dark_first: Any, dark_second: Any, white: Any) -> Any:
    """Return mean, variance and what is not saturated, rightly."""
    first, second = first.astype(float), second.astype(float)
    mean = ((first + second) / 2).mean(axis=(1, 2)) - (dark_first.mean() + dark_second.mean()) / 2
    dark = (dark_first.astype(float) - dark_second).var() / 2
    variance = (first - second).var(axis=(1, 2)) / 2 - dark
    return mean, variance, ((first >= white).mean(axis=(1, 2)) < 0.001)


def line(mean: Any, variance: Any, good: Any) -> Any:
    """Fit a line with an intercept, as `np.polyfit` does."""
    return np.polyfit(mean[good], variance[good], 1)[0]


def difference_not_halved(first, second, dark_first, dark_second, white):
    mean, variance, good = transfer(first, second, dark_first, dark_second, white)
    return slope(mean, 2 * variance, good)


def dark_not_subtracted(first, second, dark_first, dark_second, white):
    mean, variance, good = transfer(first, second, dark_first, dark_second, white)
    return slope(mean + dark_first.mean(), variance, good)


def dark_noise_not_subtracted(first, second, dark_first, dark_second, white):
    mean, variance, good = transfer(first, second, dark_first, dark_second, white)
    dark = (dark_first.astype(float) - dark_second).var() / 2
    return slope(mean, variance + dark, good)


def saturated_pairs_kept(first, second, dark_first, dark_second, white):
    mean, variance, good = transfer(first, second, dark_first, dark_second, white)
    return slope(mean, variance, np.ones_like(good))


def line_through_saturated_pairs(first, second, dark_first, dark_second, white):
    mean, variance, good = transfer(first, second, dark_first, dark_second, white)
    return line(mean, variance, np.ones_like(good))


def partly_saturated_kept(first, second, dark_first, dark_second, white):
    mean, variance, _ = transfer(first, second, dark_first, dark_second, white)
    return slope(mean, variance, first.mean(axis=(1, 2)) < 0.999 * white)


def line_through_partly_saturated(first, second, dark_first, dark_second, white):
    mean, variance, _ = transfer(first, second, dark_first, dark_second, white)
    return line(mean, variance, first.mean(axis=(1, 2)) < 0.999 * white)


def one_picture_alone(first, second, dark_first, dark_second, white):
    mean, _, good = transfer(first, second, dark_first, dark_second, white)
    return slope(mean, first.var(axis=(1, 2)) - dark_first.var(), good)


def line_through_single_pictures(first, second, dark_first, dark_second, white):
    mean, _, good = transfer(first, second, dark_first, dark_second, white)
    return line(mean, first.var(axis=(1, 2)), good)


def electrons_per_number(first, second, dark_first, dark_second, white):
    return 1 / slope(*transfer(first, second, dark_first, dark_second, white))


def deviation_for_variance(first, second, dark_first, dark_second, white):
    mean, variance, good = transfer(first, second, dark_first, dark_second, white)
    return slope(mean, np.sqrt(np.maximum(variance, 0)), good)


def line_through_deviations(first, second, dark_first, dark_second, white):
    mean, variance, good = transfer(first, second, dark_first, dark_second, white)
    return line(mean, np.sqrt(np.maximum(variance, 0)), good)


def wraps_around(first, second, dark_first, dark_second, white):
    mean, _, good = transfer(first, second, dark_first, dark_second, white)
    return slope(mean, (first - second).var(axis=(1, 2)) / 2, good)


def wraps_around_whole(first, second, dark_first, dark_second, white):
    """Neither halved nor fitted through the origin."""
    mean, _, good = transfer(first, second, dark_first, dark_second, white)
    variance = (first - second).var(axis=(1, 2)) - (dark_first - dark_second).var()
    return line(mean, variance, good)
