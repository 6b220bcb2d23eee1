"""Points in rows and columns: put loose ones in order, and say where the next ones would be.

A grid here is an array of shape (rows, columns, 2) of pixels; its neighbours may be bent by a lens
and drawn together by perspective, but change only little from one to the next.
"""

from __future__ import annotations

import numpy as np

from course_lib.checks import Array

#: How far a point may lie from where its row leads, by the length of the step.
ASTRAY = 0.35
#: How many times larger than its neighbour something may be.
ALIKE = 2.0
SIDES = ((0, 1), (1, 0), (0, -1), (-1, 0))

Places = dict[tuple[int, int], int]


def grid_of_loose_points(points: Array, sizes: Array | None = None) -> Places:
    """Return which points form the largest grid.

    From a point in the middle and the steps to its neighbours, the grid grows over every place
    that can be foretold from two points next to each other.

    Parameters
    ----------
    points : ndarray, shape (N, 2)
        Points in px; some may not belong to the grid.
    sizes : ndarray, shape (N,), optional
        Of what is at the points; neighbours are similar.

    Returns
    -------
    dict
        Number of the point at each place (row, column) of the grid, counted from (0, 0).
    """
    best: Places = {}
    if len(points) < 4:
        return best
    sizes = np.ones(len(points)) if sizes is None else sizes
    middle = np.linalg.norm(points - np.median(points, axis=0), axis=1)
    for seed in np.argsort(middle)[:12].tolist():
        steps = _first_steps(points, seed)
        if steps is not None:
            grown = _without_stragglers(_grown(points, sizes, seed, *steps))
            best = max(best, grown, key=len)
    low = [min((place[k] for place in best), default=0) for k in (0, 1)]
    return {(row - low[0], column - low[1]): point for (row, column), point in best.items()}


def _first_steps(points: Array, seed: int) -> tuple[Array, Array] | None:
    """Return the steps from a point along its row and its column, or None if it has no such."""
    ways = points - points[seed]
    near = np.argsort(np.linalg.norm(ways, axis=1))[1:9]
    along = ways[near[0]]
    for other in ways[near[1:]]:
        length = np.linalg.norm(other) * np.linalg.norm(along)
        across = along[0] * other[1] - along[1] * other[0]
        # Steps to both sides, or across two corners, are not a row and a column.
        if abs(across) > 0.6 * length:
            return (along, other) if across > 0 else (along, -other)
    return None


def _grown(points: Array, sizes: Array, seed: int, along: Array, down: Array) -> Places:
    """Return the grid that grows from a point with the steps to its neighbours."""
    places: Places = {(0, 0): seed}
    steps = {seed: {(0, 1): along, (1, 0): down}}
    waiting, used = [(0, 0)], {seed}
    while waiting:
        place = waiting.pop(0)
        point = places[place]
        for side in SIDES:
            new = place[0] + side[0], place[1] + side[1]
            axis = abs(side[0]), abs(side[1])
            sign = side[0] + side[1]
            if new in places:
                continue
            step = sign * steps[point][axis]
            away = np.linalg.norm(points - points[point] - step, axis=1)
            found = int(np.argmin(away))
            astray = away[found] > ASTRAY * np.linalg.norm(step)
            if found in used or astray or not 1 / ALIKE < sizes[found] / sizes[point] < ALIKE:
                continue
            places[new] = found
            used.add(found)
            steps[found] = {**steps[point], axis: sign * (points[found] - points[point])}
            waiting.append(new)
    return places


def _without_stragglers(places: Places) -> Places:
    """Return places without outer rows and columns of which less than half are taken."""
    while places:
        for axis in (0, 1):
            lines = [place[axis] for place in places]
            usual = np.median([lines.count(line) for line in set(lines)])
            loose = [e for e in (min(lines), max(lines)) if lines.count(e) < usual / 2]
            if loose:
                places = {p: n for p, n in places.items() if p[axis] != loose[0]}
                break
        else:
            return places
    return places


def turned(grid: Array, columns: int, rows: int) -> Array:
    """Return a grid with rows and columns in the order of its board, seen from its front.

    Parameters
    ----------
    grid : ndarray, shape (rows, columns, …) or (columns, rows, …)
        Points in px in the first two entries of the last axis; NaN where there is none.
    columns, rows : int
        Of the board.

    Returns
    -------
    ndarray, shape (rows, columns, …)
        The way from a row to the next is a right turn from the way along the row. Of the turns
        that are left, the one is taken whose rows lead most to the right.

    Raises
    ------
    ValueError
        If the grid has not as many rows and columns.
    """
    candidates = [np.rot90(grid, k) for k in range(4)]
    candidates += [np.rot90(grid.swapaxes(0, 1), k) for k in range(4)]
    fitting = [g for g in candidates if g.shape[:2] == (rows, columns) and not mirrored(g)]
    if not fitting:
        raise ValueError(f"the grid must have {columns} × {rows} points, got {grid.shape}")
    return max(fitting, key=lambda g: float(np.nansum(g[:, -1, 0] - g[:, 0, 0])))


def mirrored(grid: Array) -> bool:
    """Return whether a grid is seen from behind: columns lead to the left of the rows."""
    along = np.diff(grid[:-1, :, :2], axis=1)
    down = np.diff(grid[:, :-1, :2], axis=0)
    turn = along[..., 0] * down[..., 1] - along[..., 1] * down[..., 0]
    return bool(np.nansum(turn) < 0)


def next_row(grid: Array) -> Array:
    """Return where the row after the last would be, shape (columns, 2).

    The last step, changed once more as it changed before.
    """
    if len(grid) == 2:
        return np.asarray(2 * grid[-1] - grid[-2])
    return np.asarray(3 * grid[-1] - 3 * grid[-2] + grid[-3])


def cell_middles(grid: Array) -> Array:
    """Return the middles between four neighbours, shape (rows - 1, columns - 1, 2)."""
    return np.asarray((grid[:-1, :-1] + grid[1:, :-1] + grid[:-1, 1:] + grid[1:, 1:]) / 4)
