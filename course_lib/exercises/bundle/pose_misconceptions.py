"""Wrong answers to the exercise of chapter 10 on the pose of a camera."""

from __future__ import annotations

from typing import Any

import numpy as np

from course_lib import resection
from course_lib.exercises.bundle.remembering import once


def camera_of(points: Any, pixels: Any) -> Any:
    return once(resection.camera_dlt, points, pixels).copy()


def parts_of(M: Any) -> Any:
    """Return what is right for a right K⁻¹ P: U, S, Vᵀ and the last column."""
    return *np.linalg.svd(M[:, :3]), M[:, 3]


def pose_of(M: Any) -> Any:
    U, S, Vt, last = parts_of(M)
    return U @ Vt, last / S.mean()


def without_K(points: Any, pixels: Any, K: Any) -> Any:
    return np.linalg.inv(K) @ camera_of(points, pixels)


def K_left_out(points, pixels, K):
    return pose_of(camera_of(points, pixels))


def K_not_inverted(points, pixels, K):
    return pose_of(K @ camera_of(points, pixels))


def K_from_the_right(points, pixels, K):
    P = camera_of(points, pixels)
    M = np.column_stack([P[:, :3] @ np.linalg.inv(K), np.linalg.inv(K) @ P[:, 3]])
    return pose_of(M)


def K_for_the_rotation_only(points, pixels, K):
    P = camera_of(points, pixels)
    U, S, Vt = np.linalg.svd(np.linalg.inv(K) @ P[:, :3])
    return U @ Vt, P[:, 3] / S.mean()


def not_made_a_rotation(points, pixels, K):
    M = without_K(points, pixels, K)
    return M[:, :3], M[:, 3]


def divided_but_no_rotation(points, pixels, K):
    M = without_K(points, pixels, K)
    scale = parts_of(M)[1].mean()
    return M[:, :3] / scale, M[:, 3] / scale


def lengths_put_back(points, pixels, K):
    U, S, Vt, last = parts_of(without_K(points, pixels, K))
    return U @ np.diag(S) @ Vt, last / S.mean()


def not_divided(points, pixels, K):
    U, _, Vt, last = parts_of(without_K(points, pixels, K))
    return U @ Vt, last


def divided_by_the_first(points, pixels, K):
    U, S, Vt, last = parts_of(without_K(points, pixels, K))
    return U @ Vt, last / S[0]


def divided_by_the_sum(points, pixels, K):
    U, S, Vt, last = parts_of(without_K(points, pixels, K))
    return U @ Vt, last / S.sum()


def divided_to_length_one(points, pixels, K):
    U, _, Vt, last = parts_of(without_K(points, pixels, K))
    return U @ Vt, last / np.linalg.norm(last)


def V_not_transposed(points, pixels, K):
    U, S, Vt, last = parts_of(without_K(points, pixels, K))
    return U @ Vt.T, last / S.mean()


def camera_to_world(points, pixels, K):
    R, t = pose_of(without_K(points, pixels, K))
    return R.T, t


def inverse_pose(points, pixels, K):
    R, t = pose_of(without_K(points, pixels, K))
    return R.T, -R.T @ t


def centre_for_translation(points, pixels, K):
    R, t = pose_of(without_K(points, pixels, K))
    return R, -R.T @ t


def translation_first(points, pixels, K):
    R, t = pose_of(without_K(points, pixels, K))
    return t, R


def one_matrix(points, pixels, K):
    R, t = pose_of(without_K(points, pixels, K))
    return np.column_stack([R, t])


def rotation_by_qr(points, pixels, K):
    M = without_K(points, pixels, K)
    _, S, _, last = parts_of(M)
    Q, upper = np.linalg.qr(M[:, :3])
    return Q * np.sign(np.diag(upper)), last / S.mean()


def rotation_with_K_in_it(points, pixels, K):
    U, _, Vt = np.linalg.svd(camera_of(points, pixels)[:, :3])
    _, S, _, last = parts_of(without_K(points, pixels, K))
    return U @ Vt, last / S.mean()


def svd_of_all_four(points, pixels, K):
    M = without_K(points, pixels, K)
    U, S, Vt = np.linalg.svd(M)
    return U @ Vt[:3, :3], M[:, 3] / S.mean()


def factors_swapped(points, pixels, K):
    U, S, Vt, last = parts_of(without_K(points, pixels, K))
    return Vt @ U, last / S.mean()


def columns_made_length_one(points, pixels, K):
    M = without_K(points, pixels, K)
    return M[:, :3] / np.linalg.norm(M[:, :3], axis=0), M[:, 3] / parts_of(M)[1].mean()


def columns_made_length_one_only(points, pixels, K):
    M = without_K(points, pixels, K)
    return M[:, :3] / np.linalg.norm(M[:, :3], axis=0), M[:, 3]


def made_length_one_and_divided_by_the_first(points, pixels, K):
    M = without_K(points, pixels, K)
    lengths = np.linalg.norm(M[:, :3], axis=0)
    return M[:, :3] / lengths, M[:, 3] / lengths[0]


def made_length_one_and_divided_by_the_mean(points, pixels, K):
    M = without_K(points, pixels, K)
    lengths = np.linalg.norm(M[:, :3], axis=0)
    return M[:, :3] / lengths, M[:, 3] / lengths.mean()


def divided_by_the_length_of_the_first(points, pixels, K):
    M = without_K(points, pixels, K)
    M = M / np.linalg.norm(M[:, 0])
    return M[:, :3], M[:, 3]


def entries_multiplied(points, pixels, K):
    U, S, Vt, last = parts_of(without_K(points, pixels, K))
    return U * Vt, last / S.mean()


def svd_of_all_four_unfitting(points, pixels, K):
    M = without_K(points, pixels, K)
    U, S, Vt = np.linalg.svd(M)
    return U @ Vt, M[:, 3] / S.mean()


def svd_of_all_four_cut(points, pixels, K):
    M = without_K(points, pixels, K)
    U, S, Vt = np.linalg.svd(M, full_matrices=False)
    return U @ Vt, M[:, 3] / S.mean()


def multiplied_instead(points, pixels, K):
    U, S, Vt, last = parts_of(without_K(points, pixels, K))
    return U @ Vt, last * S.mean()


def divided_by_the_determinant(points, pixels, K):
    M = without_K(points, pixels, K)
    U, _, Vt, last = parts_of(M)
    return U @ Vt, last / np.cbrt(np.linalg.det(M[:, :3]))


def divided_one_by_one(points, pixels, K):
    U, S, Vt, last = parts_of(without_K(points, pixels, K))
    return U @ Vt, last / S


def translation_as_a_column(points, pixels, K):
    R, t = pose_of(without_K(points, pixels, K))
    return R, t[:, None]


def row_for_column(points, pixels, K):
    M = without_K(points, pixels, K)
    return pose_of(M)[0], M[2] / parts_of(M)[1].mean()


def rotation_and_scale_with_K_in_them(points, pixels, K):
    U, S, Vt = np.linalg.svd(camera_of(points, pixels)[:, :3])
    return U @ Vt, without_K(points, pixels, K)[:, 3] / S.mean()
