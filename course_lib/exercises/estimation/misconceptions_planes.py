"""Wrong answers to the exercises of chapter 06 on homographies."""

from __future__ import annotations

from typing import Any

import numpy as np

from course_lib.exercises.estimation.misconceptions_points import normalised

# --- homography_dlt ---------------------------------------------------------------------------


def _design(points: Any, targets: Any, sign: int = -1) -> Any:
    p = np.column_stack([points, np.ones(len(points))])
    A = np.zeros((len(points), 2, 9))
    A[:, 0, :3] = A[:, 1, 3:6] = p
    A[:, :, 6:] = sign * targets[:, :, None] * p[:, None]
    return A.reshape(-1, 9)


def _vectors(points: Any, targets: Any) -> Any:
    return np.linalg.svd(_design(points, targets))[2]


def _scaled(H: Any) -> Any:
    return H / H[2, 2]


def numbers_as_they_come(points, targets):
    return _scaled(_vectors(points, targets)[-1].reshape(3, 3))


def only_the_targets_normalised(points, targets):
    q, T = normalised(targets)
    return _scaled(np.linalg.inv(T) @ _vectors(points, q)[-1].reshape(3, 3))


def only_the_points_normalised(points, targets):
    p, T = normalised(points)
    return _scaled(_vectors(p, targets)[-1].reshape(3, 3) @ T)


def still_normalised(points, targets):
    return _scaled(_vectors(normalised(points)[0], normalised(targets)[0])[-1].reshape(3, 3))


def _between(points: Any, targets: Any) -> Any:
    (p, T_points), (q, T_targets) = normalised(points), normalised(targets)
    return T_points, _vectors(p, q)[-1].reshape(3, 3), T_targets


def undone_in_the_wrong_order(points, targets):
    T_points, H, T_targets = _between(points, targets)
    return _scaled(T_points @ H @ np.linalg.inv(T_targets))


def undone_on_the_wrong_side(points, targets):
    T_points, H, T_targets = _between(points, targets)
    return _scaled(np.linalg.inv(T_points) @ H @ T_targets)


def done_once_more(points, targets):
    T_points, H, T_targets = _between(points, targets)
    return _scaled(T_targets @ H @ np.linalg.inv(T_points))


def undone_with_one_matrix(points, targets):
    T_points, H, _ = _between(points, targets)
    return _scaled(np.linalg.inv(T_points) @ H @ T_points)


def both_from_the_left(points, targets):
    T_points, H, T_targets = _between(points, targets)
    return _scaled(T_points @ H @ T_targets)


def targets_done_once_more(points, targets):
    T_points, H, T_targets = _between(points, targets)
    return _scaled(T_targets @ H @ T_points)


def both_undone(points, targets):
    T_points, H, T_targets = _between(points, targets)
    return _scaled(np.linalg.inv(T_targets) @ H @ np.linalg.inv(T_points))


def multiplied_entry_by_entry(points, targets):
    T_points, H, T_targets = _between(points, targets)
    return _scaled(np.linalg.inv(T_targets) @ H * T_points)


def nothing_but_zeros(points, targets):
    return np.zeros((3, 3))


def points_left_normalised(points, targets):
    _, H, T_targets = _between(points, targets)
    return _scaled(np.linalg.inv(T_targets) @ H)


def targets_left_normalised(points, targets):
    T_points, H, _ = _between(points, targets)
    return _scaled(H @ T_points)


def transposed_for_inverted(points, targets):
    T_points, H, T_targets = _between(points, targets)
    return _scaled(T_targets.T @ H @ T_points)


def _solved_by(pick: Any, points: Any, targets: Any) -> Any:
    (p, T_points), (q, T_targets) = normalised(points), normalised(targets)
    return _scaled(np.linalg.inv(T_targets) @ pick(_design(p, q)).reshape(3, 3) @ T_points)


def _undone(A: Any, points: Any, targets: Any) -> Any:
    H = np.linalg.svd(A)[2][-1].reshape(3, 3)
    return _scaled(np.linalg.inv(normalised(targets)[1]) @ H @ normalised(points)[1])


def rows_as_they_come_but_undone(points, targets):
    return _undone(_design(points, targets), points, targets)


def rows_of_points_as_they_come(points, targets):
    return _undone(_design(points, normalised(targets)[0]), points, targets)


def rows_of_targets_as_they_come(points, targets):
    return _undone(_design(normalised(points)[0], targets), points, targets)


def _last_is_one(A: Any) -> Any:
    return np.append(np.linalg.lstsq(A[:, :8], -A[:, 8])[0], 1).reshape(3, 3)


def last_number_is_one(points, targets):
    return _last_is_one(_design(points, targets))


def last_number_is_one_for_normalised(points, targets):
    return _solved_by(_last_is_one, points, targets)


def eight_vectors_of_nine(points, targets):
    return _solved_by(lambda A: np.linalg.svd(A, full_matrices=False)[2][-1], points, targets)


def u_and_v_exchanged_in_the_rows(points, targets):
    p, q = normalised(points)[0], normalised(targets)[0]
    return _undone(_design(p, q[:, ::-1]), points, targets)


def points_exchanged_in_the_rows(points, targets):
    p, q = normalised(points)[0], normalised(targets)[0]
    return _undone(_design(p[:, ::-1], q), points, targets)


def targets_exchanged(points, targets):
    return from_exchanged(points, targets[:, ::-1])


def points_exchanged(points, targets):
    return from_exchanged(points[:, ::-1], targets)


def from_exchanged(points: Any, targets: Any) -> Any:
    T_points, H, T_targets = _between(points, targets)
    return _scaled(np.linalg.inv(T_targets) @ H @ T_points)


def longest_for_shortest(points, targets):
    return _solved_by(lambda A: np.linalg.svd(A)[2][0], points, targets)


def last_column_of_the_transposed(points, targets):
    return _solved_by(lambda A: np.linalg.svd(A)[2][:, -1], points, targets)


def _in_blocks(A: Any) -> Any:
    """Return the rows of all first coordinates, then those of all second ones."""
    return np.concatenate([A[::2], A[1::2]])


def last_column_with_rows_in_blocks(points, targets):
    return _solved_by(lambda A: np.linalg.svd(_in_blocks(A))[2][:, -1], points, targets)


def row_of_eigenvectors(points, targets):
    return _solved_by(lambda A: np.linalg.eigh(A.T @ A)[1][0], points, targets)


def row_of_eigenvectors_from_blocks(points, targets):
    return _solved_by(
        lambda A: np.linalg.eigh(_in_blocks(A).T @ _in_blocks(A))[1][0], points, targets
    )


def read_column_by_column(points, targets):
    return _solved_by(
        lambda A: np.linalg.svd(A)[2][-1].reshape(3, 3).T,
        points,
        targets,
    )


def wrong_sign_in_the_rows(points, targets):
    (p, T_points), (q, T_targets) = normalised(points), normalised(targets)
    H = np.linalg.svd(_design(p, q, sign=1))[2][-1].reshape(3, 3)
    return _scaled(np.linalg.inv(T_targets) @ H @ T_points)


def one_for_the_target(points, targets):
    def without_target(A: Any) -> Any:
        A = A.copy()
        A[:, 8] = -1
        return np.linalg.svd(A)[2][-1]

    return _solved_by(without_target, points, targets)


def from_targets_to_points_inside(points, targets):
    T_points, H, T_targets = _between(targets, points)
    return _scaled(np.linalg.inv(T_points) @ H @ T_targets)


def from_targets_to_points(points, targets):
    T_points, H, T_targets = _between(targets, points)
    return _scaled(np.linalg.inv(T_targets) @ H @ T_points)


def only_affine(points, targets):
    X = np.column_stack([points, np.ones(len(points))])
    return np.vstack([np.linalg.lstsq(X, targets)[0].T, [0, 0, 1]])


def first_four_points(points, targets):
    T_points, H, T_targets = _between(points[:4], targets[:4])
    return _scaled(np.linalg.inv(T_targets) @ H @ T_points)
