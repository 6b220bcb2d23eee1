"""Wrong answers to the exercises of chapter 11 on overlap."""

from __future__ import annotations

import numpy as np

# --- overlap ----------------------------------------------------------------------------------


def per_cent(base, footprint):
    return 100 * (1 - base / footprint)


def new_ground(base, footprint):
    return base / footprint


def upside_down(base, footprint):
    return 1 - footprint / base


def quotient_upside_down(base, footprint):
    return footprint / base


def sign_turned(base, footprint):
    return base / footprint - 1


def length_in_common(base, footprint):
    return footprint - base


def brackets_forgotten(base, footprint):
    return footprint - base / footprint


def brackets_misplaced(base, footprint):
    return (1 - base) / footprint


def gap_is_zero(base, footprint):
    return np.maximum(1 - base / footprint, 0)


def gap_is_positive(base, footprint):
    return np.abs(1 - base / footprint)


def whole_numbers(base, footprint):
    return 1 - base // footprint


def share_of_both(base, footprint):
    return (footprint - base) / (footprint + base)


def half_a_footprint(base, footprint):
    return 1 - 2 * base / footprint


def base_shared(base, footprint):
    return 1 - base / (2 * footprint)


def largest_base(base, footprint):
    return 1 - np.max(base) / footprint


# --- base_for_overlap -------------------------------------------------------------------------


def overlap_itself(share, footprint):
    return share * footprint


def share_in_per_cent(share, footprint):
    return (1 - share / 100) * footprint


def hundred_less(share, footprint):
    return (100 - share) * footprint


def hundred_less_per_cent(share, footprint):
    return (100 - share) / 100 * footprint


def footprint_below(share, footprint):
    return (1 - share) / footprint


def share_of_a_footprint(share, footprint):
    return share / footprint


def share_below(share, footprint):
    return footprint / (1 - share)


def rest_of_the_share(share, footprint):
    return footprint / share


def brackets_left_out(share, footprint):
    return 1 - share * footprint


def whole_metres(share, footprint):
    return ((1 - share) * footprint) // 1


def nearest_metres(share, footprint):
    return np.rint((1 - share) * footprint)


def share_taken_off(share, footprint):
    return footprint - share


def sides_exchanged(share, footprint):
    return (share - 1) * footprint


def half_the_rest(share, footprint):
    return (1 - share) / 2 * footprint


def always_two_thirds(share, footprint):
    return footprint / 3 + 0 * share


def always_eighty_per_cent(share, footprint):
    return 0.2 * footprint + 0 * share


def footprint_left_out(share, footprint):
    return 1 - share
