"""Wrong answers to the exercises of chapter 08 on RANSAC and on the pose from E."""

from __future__ import annotations

from typing import Any

import numpy as np

from course_lib.epipolar import eight_point, pair_depths, sampson_error
from course_lib.exercises.epipolar.keeping import kept

# --- ransac_fundamental -----------------------------------------------------------------------


def of_sample(points1: Any, points2: Any, sample: Any, threshold: Any) -> Any:
    """Return F of a sample, and which pairs fit."""
    F = eight_point(points1[sample], points2[sample])
    return F, sampson_error(points1, points2, F) < threshold


def tried(points1: Any, points2: Any, samples: Any, threshold: Any) -> Any:
    """Return F and fits of every sample, those that fit most pairs first."""
    found = in_turn(points1, points2, samples, threshold)
    return sorted(found, key=lambda one: -one[1].sum())


@kept
def in_turn(points1: Any, points2: Any, samples: Any, threshold: Any) -> Any:
    """Return F and fits of every sample in turn."""
    return [of_sample(points1, points2, sample, threshold) for sample in samples]


@kept
def from_those(points1: Any, points2: Any, fits: Any) -> Any:
    return eight_point(points1[fits], points2[fits]), fits


def last_sample(points1, points2, samples, threshold):
    return from_those(points1, points2, in_turn(points1, points2, samples, threshold)[-1][1])


def last_sample_not_refined(points1, points2, samples, threshold):
    return in_turn(points1, points2, samples, threshold)[-1]


def first_sample(points1, points2, samples, threshold):
    return from_those(points1, points2, in_turn(points1, points2, samples, threshold)[0][1])


def smallest_sum_of_errors(points1, points2, samples, threshold):
    found = in_turn(points1, points2, samples, threshold)
    _, fits = min(found, key=lambda one: sampson_error(points1, points2, one[0]).sum())
    return from_those(points1, points2, fits)


def agreement_of_the_sample(points1, points2, samples, threshold):
    found = in_turn(points1, points2, samples, threshold)
    asked = [fits[sample].sum() for (_, fits), sample in zip(found, samples, strict=True)]
    return from_those(points1, points2, found[int(np.argmax(asked))][1])


def agreement_of_the_sample_last(points1, points2, samples, threshold):
    found = in_turn(points1, points2, samples, threshold)
    asked = [fits[sample].sum() for (_, fits), sample in zip(found, samples, strict=True)]
    return from_those(points1, points2, found[len(asked) - 1 - int(np.argmax(asked[::-1]))][1])


def fewest_fits(points1, points2, samples, threshold):
    worst = tried(points1, points2, samples, threshold)[-1]
    return from_those(points1, points2, worst[1])


def not_refined(points1, points2, samples, threshold):
    best = in_turn(points1, points2, samples, threshold)
    return max(best, key=lambda one: one[1].sum())


def last_of_the_best_not_refined(points1, points2, samples, threshold):
    best = in_turn(points1, points2, samples, threshold)
    return max(best[::-1], key=lambda one: one[1].sum())


def threshold_squared(points1, points2, samples, threshold):
    found = in_turn(points1, points2, samples, threshold)
    fitting = [sampson_error(points1, points2, F) < threshold**2 for F, _ in found]
    return from_those(points1, points2, max(fitting, key=lambda fits: fits.sum()))


def refined_with_all(points1, points2, samples, threshold):
    return eight_point(points1, points2), tried(points1, points2, samples, threshold)[0][1]


def samples_not_used(points1, points2, samples, threshold):
    return of_sample(points1, points2, slice(None), threshold)


def samples_not_used_but_refined(points1, points2, samples, threshold):
    _, fits = of_sample(points1, points2, slice(None), threshold)
    return from_those(points1, points2, fits)


def first_eight_pairs(points1, points2, samples, threshold):
    return from_those(points1, points2, of_sample(points1, points2, slice(8), threshold)[1])


def wrong_ones_marked(points1, points2, samples, threshold):
    F, fits = from_those(points1, points2, tried(points1, points2, samples, threshold)[0][1])
    return F, ~fits


def wrong_ones_counted(points1, points2, samples, threshold):
    found = in_turn(points1, points2, samples, threshold)
    _, fits = max(found, key=lambda one: (~one[1]).sum())
    return from_those(points1, points2, ~fits)


def numbers_of_the_pairs(points1, points2, samples, threshold):
    F, fits = from_those(points1, points2, tried(points1, points2, samples, threshold)[0][1])
    return F, np.flatnonzero(fits)


def fits_as_numbers(points1, points2, samples, threshold):
    F, fits = from_those(points1, points2, tried(points1, points2, samples, threshold)[0][1])
    return F, fits.astype(int)


def fits_counted(points1, points2, samples, threshold):
    F, fits = from_those(points1, points2, tried(points1, points2, samples, threshold)[0][1])
    return F, fits.sum()


def errors_for_fits(points1, points2, samples, threshold):
    F, _ = from_those(points1, points2, tried(points1, points2, samples, threshold)[0][1])
    return F, sampson_error(points1, points2, F)


def only_F(points1, points2, samples, threshold):
    return from_those(points1, points2, tried(points1, points2, samples, threshold)[0][1])[0]


def only_fits(points1, points2, samples, threshold):
    return tried(points1, points2, samples, threshold)[0][1]


def fits_before_F(points1, points2, samples, threshold):
    return from_those(points1, points2, tried(points1, points2, samples, threshold)[0][1])[::-1]


def sample_marked(points1, points2, samples, threshold):
    found = in_turn(points1, points2, samples, threshold)
    best = samples[int(np.argmax([fits.sum() for _, fits in found]))]
    marked = np.isin(np.arange(len(points1)), best)
    return eight_point(points1[best], points2[best]), marked


# --- pose_from_essential ----------------------------------------------------------------------

W = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1]])
depths = kept(pair_depths)


@kept
def turns(E: Any) -> Any:
    """Return both rotations, and the direction of t."""
    U, _, Vt = np.linalg.svd(E)
    both = [U @ W @ Vt, U @ W.T @ Vt]
    return [R * np.linalg.det(R) for R in both], U[:, 2]


def first_that(accepts: Any, found: Any, points1: Any, points2: Any) -> Any:
    """Return the first pose whose depths are accepted, of what `turns` finds."""
    rotations, t = found
    for R in rotations:
        for signed in (t, -t):
            if accepts(*depths(R, signed, points1, points2)):
                return R, signed
    return None


def in_front(Z1: Any, Z2: Any) -> Any:
    return (Z1 > 0).all() and (Z2 > 0).all()


def right(E: Any, points1: Any, points2: Any) -> Any:
    return first_that(in_front, turns(E), points1, points2)


def points_not_asked(E, points1, points2):
    (R, _), t = turns(E)
    return R, t


def mirrored(E, points1, points2):
    U, _, Vt = np.linalg.svd(E)
    return first_that(in_front, ((U @ W @ Vt, U @ W.T @ Vt), U[:, 2]), points1, points2)


def one_turn_only(E, points1, points2):
    (R, _), t = turns(E)
    return first_that(in_front, ([R], t), points1, points2)


def one_sign_only(E, points1, points2):
    rotations, t = turns(E)
    for R in rotations:
        if in_front(*depths(R, t, points1, points2)):
            return R, t
    return None


def one_sign_and_the_other_turn_else(E, points1, points2):
    (R, other), t = turns(E)
    return (R if in_front(*depths(R, t, points1, points2)) else other), t


def behind_the_cameras(E, points1, points2):
    return first_that(lambda Z1, Z2: in_front(-Z1, -Z2), turns(E), points1, points2)


def before_camera_1_only(E, points1, points2):
    return first_that(lambda Z1, Z2: (Z1 > 0).all(), turns(E), points1, points2)


def before_camera_2_only(E, points1, points2):
    return first_that(lambda Z1, Z2: (Z2 > 0).all(), turns(E), points1, points2)


def before_one_of_both(E, points1, points2):
    either = lambda Z1, Z2: (Z1 > 0).all() or (Z2 > 0).all()  # noqa: E731
    return first_that(either, turns(E), points1, points2)


def camera_2_to_camera_1(E, points1, points2):
    R, t = right(E, points1, points2)
    return R.T, -R.T @ t


def centre_for_t(E, points1, points2):
    R, t = right(E, points1, points2)
    return R, -R.T @ t


def rotation_transposed(E, points1, points2):
    R, t = right(E, points1, points2)
    return R.T, t


def t_of_the_other_null_space(E, points1, points2):
    rotations, _ = turns(E)
    return first_that(in_front, (rotations, np.linalg.svd(E)[2][2]), points1, points2)


def t_from_a_row(E, points1, points2):
    rotations, _ = turns(E)
    return first_that(in_front, (rotations, np.linalg.svd(E)[0][2]), points1, points2)


def last_factor_transposed_again(E, points1, points2):
    U, _, Vt = np.linalg.svd(E)
    rotations = [R * np.linalg.det(R) for R in (U @ W @ Vt.T, U @ W.T @ Vt.T)]
    return first_that(in_front, (rotations, U[:, 2]), points1, points2)


def without_W(E, points1, points2):
    U, _, Vt = np.linalg.svd(E)
    R = U @ Vt * np.linalg.det(U @ Vt)
    return first_that(in_front, ([R], U[:, 2]), points1, points2)


def t_of_the_length_of_E(E, points1, points2):
    R, t = right(E, points1, points2)
    return R, t * np.linalg.svd(E)[1][0]


def t_before_R(E, points1, points2):
    return right(E, points1, points2)[::-1]


def only_R(E, points1, points2):
    return right(E, points1, points2)[0]
