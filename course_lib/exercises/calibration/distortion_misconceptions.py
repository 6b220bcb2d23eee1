"""Wrong answers to the exercise of chapter 07 on the first k1 and k2."""

from __future__ import annotations

from typing import Any

import numpy as np


def design(
    ideal: Any, K: Any, first: Any = 2, second: Any = 4, centre: Any = None, focal: Any = None
) -> Any:
    """Return the two columns of the equations, with powers of r to choose."""
    centre = K[:2, 2] if centre is None else centre
    focal = np.array([K[0, 0], K[1, 1]]) if focal is None else focal
    offset = ideal - centre
    r = np.hypot(*(offset / focal).T)[:, None]
    return np.stack([offset * r**first, offset * r**second], axis=-1)


def solved(A: Any, b: Any) -> Any:
    return np.linalg.lstsq(A.reshape(-1, 2), b.ravel(), rcond=None)[0]


def correction_for_distortion(ideal, observed, K):
    return solved(design(ideal, K), ideal - observed)


def powers_of_r(ideal, observed, K):
    return solved(design(ideal, K, 1, 2), observed - ideal)


def powers_squared(ideal, observed, K):
    return solved(design(ideal, K, 4, 8), observed - ideal)


def doubled_for_squared(ideal, observed, K):
    offset = ideal - K[:2, 2]
    r2 = ((offset / [K[0, 0], K[1, 1]]) ** 2).sum(axis=1, keepdims=True)
    A = np.stack([offset * r2, offset * r2 * 2], axis=-1)
    return solved(A, observed - ideal)


def powers_alone(ideal, observed, K):
    r = np.hypot(*((ideal - K[:2, 2]) / [K[0, 0], K[1, 1]]).T)[:, None] * np.ones(2)
    return solved(np.stack([r**2, r**4], axis=-1), observed - ideal)


def pixels_for_offsets(ideal, observed, K):
    r = np.hypot(*((ideal - K[:2, 2]) / [K[0, 0], K[1, 1]]).T)[:, None]
    return solved(np.stack([ideal * r**2, ideal * r**4], axis=-1), observed - ideal)


def powers_two_and_three(ideal, observed, K):
    return solved(design(ideal, K, 2, 3), observed - ideal)


def k2_before_k1(ideal, observed, K):
    return solved(design(ideal, K, 4, 2), observed - ideal)


def fx_for_both(ideal, observed, K):
    return solved(design(ideal, K, focal=K[0, 0]), observed - ideal)


def observed_for_moved(ideal, observed, K):
    return solved(design(ideal, K), observed)


def radius_in_pixels(ideal, observed, K):
    return solved(design(ideal, K, focal=1.0), observed - ideal)


def not_from_the_principal_point(ideal, observed, K):
    return solved(design(ideal, K, centre=0.0), observed - ideal)


def normalised_on_one_side(ideal, observed, K):
    A = design(ideal, K) / np.array([K[0, 0], K[1, 1]])[:, None]
    return solved(A, observed - ideal)


def normalised_on_the_other_side(ideal, observed, K):
    return solved(design(ideal, K), (observed - ideal) / np.array([K[0, 0], K[1, 1]]))


def equations_of_u_only(ideal, observed, K):
    return np.linalg.lstsq(design(ideal, K)[:, 0], (observed - ideal)[:, 0], rcond=None)[0]


def radius_of_the_observed(ideal, observed, K):
    focal = np.array([K[0, 0], K[1, 1]])
    r = np.hypot(*((observed - K[:2, 2]) / focal).T)[:, None]
    offset = ideal - K[:2, 2]
    return solved(np.stack([offset * r**2, offset * r**4], axis=-1), observed - ideal)


def k1_only(ideal, observed, K):
    A = design(ideal, K)[..., 0].ravel()
    return np.array([A @ (observed - ideal).ravel() / (A @ A), 0])


def everything_from_the_observed(ideal, observed, K):
    return solved(design(observed, K), observed - ideal)


def u_then_v(A: Any) -> Any:
    """Return the same rows, first all of u and then all of v."""
    return np.concatenate([A[:, 0], A[:, 1]])


def right_side_point_by_point(ideal, observed, K):
    A = u_then_v(design(ideal, K))
    return np.linalg.lstsq(A, (observed - ideal).ravel(), rcond=None)[0]


def left_side_point_by_point(ideal, observed, K):
    return solved(design(ideal, K), u_then_v(observed - ideal))


def four_columns(ideal, observed, K):
    A = design(ideal, K)
    return np.linalg.lstsq(np.hstack([A[..., 0], A[..., 1]]), observed - ideal, rcond=None)[0]


def all_that_lstsq_gives(ideal, observed, K):
    A = design(ideal, K).reshape(-1, 2)
    return np.linalg.lstsq(A, (observed - ideal).ravel(), rcond=None)


def normalised_on_both_sides(ideal, observed, K):
    focal = np.array([K[0, 0], K[1, 1]])
    return solved(design(ideal, K) / focal[:, None], (observed - ideal) / focal)
