"""Wrong answers to the homography of chapter 06 that come from single entries of its rows."""

from __future__ import annotations

from typing import Any

import numpy as np

from course_lib.exercises.estimation.misconceptions_points import normalised, only_one_row


def _rows(points: Any, targets: Any) -> Any:
    """Return the rows of x and those of y, shape (2, N, 9), of numbers that are normalised."""
    (u, v), (x, y) = normalised(points)[0].T, normalised(targets)[0].T
    one, zero = np.ones_like(u), np.zeros_like(u)
    rows_x = np.column_stack([u, v, one, zero, zero, zero, -x * u, -x * v, -x])
    rows_y = np.column_stack([zero, zero, zero, u, v, one, -y * u, -y * v, -y])
    return np.stack([rows_x, rows_y])


def _solved(rows: Any, points: Any, targets: Any) -> Any:
    H = np.linalg.svd(np.concatenate(list(rows)))[2][-1].reshape(3, 3)
    return np.linalg.inv(normalised(targets)[1]) @ H @ normalised(points)[1]


def _turned(points: Any, targets: Any, which: Any, columns: Any) -> Any:
    """Turn the signs in some columns of some rows."""
    rows = _rows(points, targets)
    for k in which:
        rows[k][:, columns] *= -1
    return _solved(rows, points, targets)


def plus_at_the_end(points, targets):
    return _turned(points, targets, (0, 1), [8])


def plus_at_the_end_for_y(points, targets):
    return _turned(points, targets, (1,), [8])


def plus_at_the_end_for_x(points, targets):
    return _turned(points, targets, (0,), [8])


def plus_in_the_rows_of_y(points, targets):
    return _turned(points, targets, (1,), [6, 7, 8])


def plus_in_the_rows_of_x(points, targets):
    return _turned(points, targets, (0,), [6, 7, 8])


def plus_before_yu(points, targets):
    return _turned(points, targets, (1,), [6])


def plus_before_yv(points, targets):
    return _turned(points, targets, (1,), [7])


def plus_before_u(points, targets):
    return _turned(points, targets, (0, 1), [6])


def plus_before_v(points, targets):
    return _turned(points, targets, (0, 1), [7])


def one_for_y(points, targets):
    rows = _rows(points, targets)
    rows[1][:, 8] = -1
    return _solved(rows, points, targets)


def _exchanged(points: Any, targets: Any, which: int, columns: Any) -> Any:
    """Take some entries of one kind of rows from the other kind."""
    rows = _rows(points, targets)
    rows[which][:, columns] = rows[1 - which][:, columns]
    return _solved(rows, points, targets)


def y_in_the_rows_of_x(points, targets):
    return _exchanged(points, targets, 0, [7])


def x_in_the_rows_of_y(points, targets):
    return _exchanged(points, targets, 1, [6])


def all_x_in_the_rows_of_y(points, targets):
    return _exchanged(points, targets, 1, [6, 7, 8])


def x_at_the_end_of_y(points, targets):
    return _exchanged(points, targets, 1, [8])


def y_where_x_begins(points, targets):
    return _exchanged(points, targets, 1, range(6))


def only_rows_of_x(points, targets):
    return _solved(_rows(points, targets)[:1], points, targets)


def only_rows_of_y(points, targets):
    return _solved(_rows(points, targets)[1:], points, targets)


def one_row_alone(case: Any, given: Any) -> bool:
    """Whether an answer is what the rows of one coordinate leave: the other row of H, alone."""
    return only_one_row(given, (3, 3), case.inputs["targets"])


def _factors(points: Any, targets: Any) -> Any:
    H = np.linalg.svd(np.concatenate(list(_rows(points, targets))))[2][-1].reshape(3, 3)
    return np.linalg.inv(normalised(targets)[1]), H, normalised(points)[1]


def all_entry_by_entry(points, targets):
    back, H, T = _factors(points, targets)
    return back * H * T


def inverse_entry_by_entry(points, targets):
    back, H, T = _factors(points, targets)
    return back * H @ T


def points_entry_by_entry(points, targets):
    back, H, T = _factors(points, targets)
    return back @ (H * T)
