"""Wrong answers to the exercises of chapter 09 on depth from disparity and its uncertainty."""

from __future__ import annotations

from typing import Any

import numpy as np

# --- depth_from_disparity ---------------------------------------------------------------------


def refused(sums: Any) -> Any:
    """Return the sums, unless one of them has no depth."""
    if (sums <= 0).any():
        raise ValueError
    return sums


def offset_left_out(disparity, f, baseline, offset):
    return f * baseline / refused(disparity)


def offset_subtracted(disparity, f, baseline, offset):
    return f * baseline / refused(disparity - offset)


def offset_added_to_the_depth(disparity, f, baseline, offset):
    return f * baseline / refused(disparity) + offset


def disparity_the_other_way(disparity, f, baseline, offset):
    return f * baseline / (offset - disparity)


def depth_turned_around(disparity, f, baseline, offset):
    return -f * baseline / (disparity + offset)


def turned_around_with_refusal(disparity, f, baseline, offset):
    return -f * baseline / refused(disparity + offset)


def upside_down(disparity, f, baseline, offset):
    return refused(disparity + offset) / (f * baseline)


def far_is_large(disparity, f, baseline, offset):
    return f * baseline * refused(disparity + offset)


def baseline_left_out(disparity, f, baseline, offset):
    return f / refused(disparity + offset)


def f_left_out(disparity, f, baseline, offset):
    return baseline / refused(disparity + offset)


def brackets_forgotten(disparity, f, baseline, offset):
    refused(disparity + offset)
    return f * baseline / disparity + offset


def metres_returned(disparity, f, baseline, offset):
    return f * baseline / refused(disparity + offset) / 1000


def nothing_refused(disparity, f, baseline, offset):
    return f * baseline / (disparity + offset)


def nan_for_refused(disparity, f, baseline, offset):
    apart = disparity + offset
    return np.where(apart > 0, f * baseline / apart, np.nan)


def infinite_for_refused(disparity, f, baseline, offset):
    apart = disparity + offset
    return np.where(apart > 0, f * baseline / apart, np.inf)


def zero_for_refused(disparity, f, baseline, offset):
    apart = disparity + offset
    return np.where(apart > 0, f * baseline / apart, 0)


def left_out_for_refused(disparity, f, baseline, offset):
    apart = disparity + offset
    return f * baseline / apart[apart > 0]


def none_for_refused(disparity, f, baseline, offset):
    apart = disparity + offset
    return f * baseline / apart if (apart > 0).all() else None


def sign_lost(disparity, f, baseline, offset):
    return f * baseline / np.abs(disparity + offset)


def zero_let_pass(disparity, f, baseline, offset):
    if (disparity + offset < 0).any():
        raise ValueError
    return f * baseline / (disparity + offset)


def only_zero_refused(disparity, f, baseline, offset):
    if (disparity + offset == 0).any():
        raise ValueError
    return f * baseline / (disparity + offset)


def refused_without_offset(disparity, f, baseline, offset):
    refused(disparity)
    return f * baseline / (disparity + offset)


def array_in_an_if(disparity, f, baseline, offset):
    if disparity + offset <= 0:
        raise ValueError
    return f * baseline / (disparity + offset)


def asked_whether_any_is_small(disparity, f, baseline, offset):
    if (disparity + offset).any() <= 0:
        raise ValueError
    return f * baseline / (disparity + offset)


def refused_if_all(disparity, f, baseline, offset):
    if (disparity + offset <= 0).all():
        raise ValueError
    return f * baseline / (disparity + offset)


def error_returned(disparity, f, baseline, offset):
    sums = disparity + offset
    return ValueError() if (sums <= 0).any() else f * baseline / sums


def kind_of_error_returned(disparity, f, baseline, offset):
    sums = disparity + offset
    return ValueError if (sums <= 0).any() else f * baseline / sums


def name_of_the_error_returned(disparity, f, baseline, offset):
    sums = disparity + offset
    return "ValueError" if (sums <= 0).any() else f * baseline / sums


def other_error(disparity, f, baseline, offset):
    sums = disparity + offset
    if (sums <= 0).any():
        raise Exception
    return f * baseline / sums


# --- depth_uncertainty ------------------------------------------------------------------------


def linear_in_depth(Z, f, baseline, sigma):
    return Z * sigma / (f * baseline)


def linear_without_baseline(Z, f, baseline, sigma):
    return Z * sigma / f


def linear_without_f(Z, f, baseline, sigma):
    return Z * sigma / baseline


def twice_for_squared(Z, f, baseline, sigma):
    return Z * 2 * sigma / (f * baseline)


def divided_by_sigma(Z, f, baseline, sigma):
    return Z**2 / (f * baseline * sigma)


def linear_alone(Z, f, baseline, sigma):
    return Z * sigma


def sigma_put_into_the_depth(Z, f, baseline, sigma):
    disparity = f * baseline / Z
    return Z - f * baseline / (disparity + sigma)


def sigma_taken_off_in_the_depth(Z, f, baseline, sigma):
    disparity = f * baseline / Z
    return f * baseline / (disparity - sigma) - Z


def difference_of_both_depths(Z, f, baseline, sigma):
    disparity = f * baseline / Z
    return f * baseline / (disparity - sigma) - f * baseline / (disparity + sigma)


def half_the_difference_of_both_depths(Z, f, baseline, sigma):
    disparity = f * baseline / Z
    return (f * baseline / (disparity - sigma) - f * baseline / (disparity + sigma)) / 2


def cubed(Z, f, baseline, sigma):
    return Z**3 * sigma / (f * baseline)


def variance(Z, f, baseline, sigma):
    return (Z**2 * sigma / (f * baseline)) ** 2


def sigma_squared(Z, f, baseline, sigma):
    return Z**2 * sigma**2 / (f * baseline)


def sigma_left_out(Z, f, baseline, sigma):
    return Z**2 / (f * baseline)


def baseline_forgotten(Z, f, baseline, sigma):
    return Z**2 * sigma / f


def f_forgotten(Z, f, baseline, sigma):
    return Z**2 * sigma / baseline


def times_baseline(Z, f, baseline, sigma):
    return Z**2 * sigma / f * baseline


def times_f(Z, f, baseline, sigma):
    return Z**2 * sigma * f / baseline


def times_both(Z, f, baseline, sigma):
    return Z**2 * sigma * f * baseline


def turned_over(Z, f, baseline, sigma):
    return f * baseline * sigma / Z**2


def turned_over_wholly(Z, f, baseline, sigma):
    return f * baseline / (Z**2 * sigma)


def sign_of_the_derivative(Z, f, baseline, sigma):
    return -(Z**2) * sigma / (f * baseline)


def two_pictures_counted(Z, f, baseline, sigma):
    return np.sqrt(2) * Z**2 * sigma / (f * baseline)


def twice_counted(Z, f, baseline, sigma):
    return 2 * Z**2 * sigma / (f * baseline)


def divisor_squared(Z, f, baseline, sigma):
    return Z**2 * sigma / (f * baseline) ** 2
