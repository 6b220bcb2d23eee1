"""Wrong answers to the exercises of chapter 06 on correction tables."""

from __future__ import annotations

from typing import Any

import numpy as np

# --- correction_table -------------------------------------------------------------------------


def _cells(pixels: Any, image_size: Any, shape: Any, edge: float = 0.5) -> Any:
    width, height = image_size
    rows, columns = shape
    column = np.floor((pixels[:, 0] + edge) / width * columns).astype(int)
    row = np.floor((pixels[:, 1] + edge) / height * rows).astype(int)
    return row.clip(0, rows - 1), column.clip(0, columns - 1)


def _table(cells: Any, residuals: Any, shape: Any, reduce: Any) -> Any:
    row, column = cells
    table = np.zeros((*shape, residuals.shape[1]))
    for r, c in np.ndindex(*shape):
        inside = residuals[(row == r) & (column == c)]
        if len(inside):
            table[r, c] = reduce(inside)
    return table


def _mean(inside: Any) -> Any:
    return inside.mean(axis=0)


def edge_at_zero(pixels, residuals, image_size, shape):
    return _table(_cells(pixels, image_size, shape, 0), residuals, shape, _mean)


def last_edge_left_out(pixels, residuals, image_size, shape):
    (width, height), (rows, columns) = image_size, shape
    column = np.floor((pixels[:, 0] + 0.5) / width * columns).astype(int)
    row = np.floor((pixels[:, 1] + 0.5) / height * rows).astype(int)
    return _table((row, column), residuals, shape, _mean)


def one_cell_too_few(pixels, residuals, image_size, shape):
    rows, columns = shape
    column = ((pixels[:, 0] + 0.5) / image_size[0] * (columns - 1)).astype(int)
    row = ((pixels[:, 1] + 0.5) / image_size[1] * (rows - 1)).astype(int)
    return _table((row, column), residuals, shape, _mean)


def comparison_with_fractions(pixels, residuals, image_size, shape):
    return np.zeros((*shape, 2))


def height_before_width(pixels, residuals, image_size, shape):
    return _table(_cells(pixels, image_size[::-1], shape), residuals, shape, _mean)


def height_before_width_unclipped(pixels, residuals, image_size, shape):
    width, height = image_size
    rows, columns = shape
    column = np.floor((pixels[:, 0] + 0.5) / height * columns).astype(int)
    row = np.floor((pixels[:, 1] + 0.5) / width * rows).astype(int)
    return _table((row, column), residuals, shape, _mean)


def cells_rounded(pixels, residuals, image_size, shape):
    rows, columns = shape
    column = np.round((pixels[:, 0] + 0.5) / image_size[0] * columns).astype(int)
    row = np.round((pixels[:, 1] + 0.5) / image_size[1] * rows).astype(int)
    return _table((row, column), residuals, shape, _mean)


def sum_for_mean(pixels, residuals, image_size, shape):
    cells = _cells(pixels, image_size, shape)
    return _table(cells, residuals, shape, lambda inside: inside.sum(axis=0))


def median_for_mean(pixels, residuals, image_size, shape):
    cells = _cells(pixels, image_size, shape)
    return _table(cells, residuals, shape, lambda inside: np.median(inside, axis=0))


def sizes_of_residuals(pixels, residuals, image_size, shape):
    return _table(_cells(pixels, image_size, shape), np.abs(residuals), shape, _mean)


def lengths_of_residuals(pixels, residuals, image_size, shape):
    cells = _cells(pixels, image_size, shape)
    return _table(cells, residuals, shape, lambda inside: np.linalg.norm(inside, axis=1).mean())


def last_one_stays(pixels, residuals, image_size, shape):
    return _table(_cells(pixels, image_size, shape), residuals, shape, lambda inside: inside[-1])


def one_mean_for_u_and_v(pixels, residuals, image_size, shape):
    return _table(_cells(pixels, image_size, shape), residuals, shape, np.mean)


def nan_where_nothing_was_seen(pixels, residuals, image_size, shape):
    row, column = _cells(pixels, image_size, shape)
    table = _table((row, column), residuals, shape, _mean)
    for r, c in np.ndindex(*shape):
        if not ((row == r) & (column == c)).any():
            table[r, c] = np.nan
    return table


def minus_the_mean(pixels, residuals, image_size, shape):
    return -_table(_cells(pixels, image_size, shape), residuals, shape, _mean)


def columns_before_rows(pixels, residuals, image_size, shape):
    table = _table(_cells(pixels, image_size, shape), residuals, shape, _mean)
    return table.transpose(1, 0, 2)


def indices_exchanged(pixels, residuals, image_size, shape):
    row, column = _cells(pixels, image_size, shape)
    table = np.zeros((*shape, 2))
    for r, c in np.ndindex(*shape):
        inside = residuals[(row == r) & (column == c)]
        if len(inside):
            table[c, r] = inside.mean(axis=0)
    return table


def shape_read_the_other_way(pixels, residuals, image_size, shape):
    return _table(_cells(pixels, image_size, shape[::-1]), residuals, shape[::-1], _mean)


def u_down_and_v_across_by_own_sides(pixels, residuals, image_size, shape):
    width, height = image_size
    rows, columns = shape
    column = np.floor((pixels[:, 1] + 0.5) / width * columns).astype(int)
    row = np.floor((pixels[:, 0] + 0.5) / height * rows).astype(int)
    return _table((row, column), residuals, shape, _mean)


def u_down_and_v_across(pixels, residuals, image_size, shape):
    turned = pixels[:, ::-1] * np.divide(image_size, image_size[::-1])
    return _table(_cells(turned, image_size, shape), residuals, shape, _mean)


def rows_from_the_bottom(pixels, residuals, image_size, shape):
    return _table(_cells(pixels, image_size, shape), residuals, shape, _mean)[::-1]


def divided_by_all_points(pixels, residuals, image_size, shape):
    cells = _cells(pixels, image_size, shape)
    return _table(cells, residuals, shape, lambda inside: inside.sum(axis=0) / len(residuals))


def cells_rounded_unclipped(pixels, residuals, image_size, shape):
    row, column = np.round((pixels + 0.5) / image_size * shape[::-1]).T[::-1]
    return _table((row, column), residuals, shape, _mean)


def _begun(table: Any, count: int) -> Any:
    """Leave only so many cells of a table, row by row."""
    left = np.zeros_like(table)
    left.reshape(-1, 2)[:count] = table.reshape(-1, 2)[:count]
    return left


def returned_after_one_cell(pixels, residuals, image_size, shape):
    return _begun(_table(_cells(pixels, image_size, shape), residuals, shape, _mean), 1)


def returned_after_one_row(pixels, residuals, image_size, shape):
    return _begun(_table(_cells(pixels, image_size, shape), residuals, shape, _mean), shape[1])


def returned_after_one_filled_cell(pixels, residuals, image_size, shape):
    row, column = _cells(pixels, image_size, shape)
    table = _table((row, column), residuals, shape, _mean)
    return _begun(table, int((row * shape[1] + column).min()) + 1)
