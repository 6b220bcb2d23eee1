"""Wrong answers to the exercise of chapter 06 that finds a camera matrix."""

from __future__ import annotations

from typing import Any

import numpy as np

from course_lib.exercises.estimation.misconceptions_points import normalised, only_one_row


def _design(points: Any, pixels: Any, sign: int = -1) -> Any:
    X = np.column_stack([points, np.ones(len(points))])
    A = np.zeros((len(points), 2, 12))
    A[:, 0, :4] = A[:, 1, 4:8] = X
    A[:, :, 8:] = sign * pixels[:, :, None] * X[:, None]
    return A.reshape(-1, 12)


def _between(points: Any, pixels: Any, pick: Any = None, sign: int = -1) -> Any:
    p, T_points = normalised(points)
    q, T_pixels = normalised(pixels)
    A = _design(p, q, sign)
    P = pick(A) if pick else np.linalg.svd(A)[2][-1].reshape(3, 4)
    return T_pixels, P, T_points


def _undone(T_pixels: Any, P: Any, T_points: Any) -> Any:
    return np.linalg.inv(T_pixels) @ P @ T_points


def _shortest(A: Any) -> Any:
    return np.linalg.svd(A)[2][-1].reshape(3, 4)


def numbers_as_they_come(points, pixels):
    return _shortest(_design(points, pixels))


def last_number_is_one(points, pixels):
    A = _design(points, pixels)
    return np.append(np.linalg.lstsq(A[:, :11], -A[:, 11])[0], 1).reshape(3, 4)


def only_the_pixels_normalised(points, pixels):
    q, T_pixels = normalised(pixels)
    return np.linalg.inv(T_pixels) @ _shortest(_design(points, q))


def _undone_all(A: Any, points: Any, pixels: Any) -> Any:
    return _undone(normalised(pixels)[1], _shortest(A), normalised(points)[1])


def rows_of_the_numbers_as_they_come(points, pixels):
    return _undone_all(_design(points, pixels), points, pixels)


def rows_of_the_points_as_they_come(points, pixels):
    return _undone_all(_design(points, normalised(pixels)[0]), points, pixels)


def rows_of_the_pixels_as_they_come(points, pixels):
    return _undone_all(_design(normalised(points)[0], pixels), points, pixels)


def one_not_appended(points, pixels):
    return np.linalg.svd(_without_one(points, pixels))[2][-1].reshape(3, 4)


def one_not_appended_for_nine(points, pixels):
    P = np.linalg.svd(_without_one(points, pixels))[2][-1].reshape(3, 3)
    return _undone(normalised(pixels)[1], P, normalised(points)[1])


def _without_one(points: Any, pixels: Any) -> Any:
    return np.delete(_design(normalised(points)[0], normalised(pixels)[0]), [3, 7, 11], axis=1)


def camera_of_normalised_points(points, pixels):
    return _between(points, pixels)[1]


def pixels_left_normalised(points, pixels):
    _, P, T_points = _between(points, pixels)
    return P @ T_points


def points_left_normalised(points, pixels):
    T_pixels, P, _ = _between(points, pixels)
    return np.linalg.inv(T_pixels) @ P


def normalised_once_more(points, pixels):
    T_pixels, P, T_points = _between(points, pixels)
    return T_pixels @ P @ np.linalg.inv(T_points)


def pixels_normalised_once_more(points, pixels):
    T_pixels, P, T_points = _between(points, pixels)
    return T_pixels @ P @ T_points


def both_undone(points, pixels):
    T_pixels, P, T_points = _between(points, pixels)
    return np.linalg.inv(T_pixels) @ P @ np.linalg.inv(T_points)


def longest_of_twelve(points, pixels):
    return _undone(*_between(points, pixels, lambda A: np.linalg.svd(A)[2][0].reshape(3, 4)))


def last_column_of_twelve(points, pixels):
    return _undone(*_between(points, pixels, lambda A: np.linalg.svd(A)[2][:, -1].reshape(3, 4)))


def last_column_with_rows_in_blocks(points, pixels):
    def pick(A: Any) -> Any:
        return np.linalg.svd(np.concatenate([A[::2], A[1::2]]))[2][:, -1].reshape(3, 4)

    return _undone(*_between(points, pixels, pick))


def u_for_v(points, pixels):
    return _undone(*_between_as(points, pixels, [0, 0]))


def v_for_u_in_the_rows(points, pixels):
    return _undone(*_between_as(points, pixels, [1, 1]))


def exchanged_in_the_rows(points, pixels):
    return _undone(*_between_as(points, pixels, [1, 0]))


def _between_as(points: Any, pixels: Any, columns: Any) -> Any:
    """Write the rows with these columns of the normalised pixels."""
    p, T_points = normalised(points)
    q, T_pixels = normalised(pixels)
    return T_pixels, np.linalg.svd(_design(p, q[:, columns]))[2][-1].reshape(3, 4), T_points


def filled_column_by_column(points, pixels):
    return _undone(*_between(points, pixels, lambda A: np.linalg.svd(A)[2][-1].reshape(4, 3).T))


def sign_of_the_last_four(points, pixels):
    return _undone(*_between(points, pixels, sign=1))


def v_for_u(points, pixels):
    return _undone(*_between(points, pixels[:, ::-1]))


def last_row_of_a_parallel_camera(points, pixels):
    X = np.column_stack([points, np.ones(len(points))])
    return np.vstack([np.linalg.lstsq(X, pixels)[0].T, [0, 0, 0, 1]])


def only_the_points_normalised(points, pixels):
    p, T_points = normalised(points)
    return _shortest(_design(p, pixels)) @ T_points


def _with_rows(points: Any, pixels: Any, change: Any) -> Any:
    """Change the rows of v, here every second one, before solving."""
    A = _design(normalised(points)[0], normalised(pixels)[0])
    return _undone_all(change(A), points, pixels)


def plus_in_the_rows_of_v(points, pixels):
    def change(A: Any) -> Any:
        A[1::2, 8:] *= -1
        return A

    return _with_rows(points, pixels, change)


def plus_in_the_rows_of_u(points, pixels):
    def change(A: Any) -> Any:
        A[::2, 8:] *= -1
        return A

    return _with_rows(points, pixels, change)


def v_where_u_begins(points, pixels):
    def change(A: Any) -> Any:
        A[1::2, :8] = A[::2, :8]
        return np.concatenate([A[::2], A[1::2]])

    return _with_rows(points, pixels, change)


def only_rows_of_u(points, pixels):
    return _with_rows(points, pixels, lambda A: A[::2])


def only_rows_of_v(points, pixels):
    return _with_rows(points, pixels, lambda A: A[1::2])


def one_row_alone(case: Any, given: Any) -> bool:
    """Whether an answer is what the rows of one coordinate leave: the other row of P, alone."""
    return only_one_row(given, (3, 4), case.inputs["pixels"])
