"""What control points do to a flight: expected errors of its points, for any choice of them.

A block without control is known up to a gauge: its points X + G a, with C the covariance of X and
seven open numbers a. Some of the points are surveyed; what is then known of all is generalised
least squares, in closed form, so that a choice takes well under a millisecond.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache

import numpy as np

from course_lib.bundle import Block, Observations
from course_lib.bundle.derivatives import Position
from course_lib.bundle.gauge import gauge_directions
from course_lib.drawing.bundle.flights import SURVEY, WRONG_K1, bent_by
from course_lib.drawing.diagrams import Floats
from course_lib.transforms import rotation_from_omega_phi_kappa

#: Columns and rows of the grid of points on the ground, and metres between two of them.
COLUMNS, ROWS, STEP = 15, 11, 12.0
#: Strips, pictures in each, metres between strips and pictures, height of the flight.
STRIPS, PICTURES, APART, BASE, HEIGHT = 3, 6, 33.0, 24.0, 100.0
#: Standard deviation of a pixel, px.
PIXEL = 0.5
#: Control points whose plan is narrower lie on one line, m.
NARROW = 1.0


@dataclass(frozen=True, eq=False)
class FreeBlock:
    """A flight without control.

    Attributes
    ----------
    block : Block
        Cameras, and the points of the grid, row after row.
    covariance : ndarray, shape (3n, 3n)
        Of the points, in one gauge, m².
    gauge : ndarray, shape (3n, 7)
        How the points move when the whole block does.
    dome : ndarray, shape (3n,)
        By how much a lens that is off by `WRONG_K1` puts the points wrong, in that gauge, m.
    """

    block: Block
    covariance: Floats
    gauge: Floats
    dome: Floats


@cache
def free_block() -> FreeBlock:
    """Return three strips of six pictures over gentle hills, all tie points on a grid."""
    x, y = np.meshgrid(STEP * np.arange(COLUMNS), STEP * np.arange(ROWS))
    ground = np.column_stack([x.ravel(), y.ravel(), 3 * np.sin(x / 30 + y / 50).ravel()])
    middle = ground[:, :2].mean(axis=0)
    across = APART * (np.arange(STRIPS) - (STRIPS - 1) / 2) + middle[1]
    along = BASE * (np.arange(PICTURES) - (PICTURES - 1) / 2) + middle[0]
    C = np.array([[a, b, HEIGHT] for b in across for a in along])
    R = np.repeat(rotation_from_omega_phi_kappa(0, 0, 0)[None], len(C), axis=0)
    K = np.array([[3600.0, 0, 1999.5], [0, 3600, 1499.5], [0, 0, 1]])
    block = Block(K, R, -np.einsum("vij,vj->vi", R, C), ground)
    seen = _all_seen(block)
    return _without_control(block, seen)


def _all_seen(block: Block) -> Observations:
    """Return the exact pixels of all points in all pictures that they are in."""
    v, n = len(block.R), len(block.points)
    cameras, points = np.repeat(np.arange(v), n), np.tile(np.arange(n), v)
    pixels = block.project(cameras, points)
    inside = ((pixels > -0.5) & (pixels < [3999.5, 2999.5])).all(axis=1)
    return Observations(cameras[inside], points[inside], pixels[inside], PIXEL)


def _without_control(block: Block, seen: Observations) -> FreeBlock:
    """Return the covariance, the gauge and the dome of a block."""
    position, v, m = Position.of(block), len(block.R), len(seen)
    turns, moves = position.image(seen).derivatives(np.ones(m))
    J: Floats = np.zeros((m, 2, 6 * v + block.points.size))
    rows = np.arange(m)[:, None]
    of_camera = 6 * seen.cameras[:, None] + np.arange(3)
    J[rows, :, of_camera] = turns.transpose(2, 1, 0)
    J[rows, :, of_camera + 3] = -moves.transpose(2, 1, 0)
    J[rows, :, 6 * v + 3 * seen.points[:, None] + np.arange(3)] = moves.transpose(2, 1, 0)
    bent = position.image(bent_by(seen, block.K[0], WRONG_K1)).residuals
    J = np.reshape(J, (2 * m, -1))
    cameras, points = gauge_directions(position)
    G = np.concatenate([cameras, points.reshape(-1, 7)])
    N = J.T @ J
    C = np.linalg.inv(N + np.trace(N) / len(N) * G @ G.T)
    dome = -C @ (J.T @ bent.T.ravel())
    first = 6 * v
    return FreeBlock(block, C[first:, first:], G[first:], dome[first:])


def height_errors(control: tuple[int, ...], dome: bool) -> Floats | None:
    """Return the errors to be expected of the heights of all points.

    Parameters
    ----------
    control : tuple of int
        Numbers of the points that are surveyed.
    dome : bool
        Whether the lens is off.

    Returns
    -------
    ndarray, shape (n,), or None
        Root of variance plus squared bias, m; None where they do not fix the block.
    """
    free, chosen = free_block(), sorted(set(control))
    plan = free.block.points[chosen, :2]
    if len(chosen) < 3 or np.linalg.svd(plan - plan.mean(axis=0), compute_uv=False)[1] < NARROW:
        return None
    S = (3 * np.array(chosen)[:, None] + np.arange(3)).ravel()
    C, G = free.covariance, free.gauge
    M = np.linalg.inv(C[np.ix_(S, S)] + SURVEY**2 * np.eye(len(S)))
    A = G[S].T @ M @ G[S]
    heights = slice(2, None, 3)
    by_nearness = C[heights, S] @ M
    left = G[heights] - by_nearness @ G[S]
    weights = by_nearness + left @ np.linalg.solve(A, G[S].T @ M)
    variance = np.diag(C)[heights] - (by_nearness * C[heights, S]).sum(axis=1)
    variance = variance + (left @ np.linalg.inv(A) * left).sum(axis=1)
    bias = free.dome[heights] - weights @ free.dome[S] if dome else 0.0
    return np.asarray(np.sqrt(variance.clip(0) + bias**2))


def check_error(control: tuple[int, ...], dome: bool) -> float:
    """Return the root mean square of `height_errors` over all points; infinite if open."""
    errors = height_errors(control, dome)
    return np.inf if errors is None else float(np.sqrt((errors**2).mean()))


@cache
def best_control(count: int, dome: bool) -> tuple[int, ...]:
    """Return the best choice found: points are exchanged one by one while that helps.

    Parameters
    ----------
    count : int
        How many points, 3 to 9.
    dome : bool
        Whether the lens is off.

    Returns
    -------
    tuple of int
        Their numbers.
    """
    last = ROWS * COLUMNS - 1
    corners = [
        0,
        last,
        COLUMNS - 1,
        last - COLUMNS + 1,
        last // 2,
        COLUMNS // 2,
        last - COLUMNS // 2,
    ]
    chosen = ([*corners, ROWS // 2 * COLUMNS, ROWS // 2 * COLUMNS + COLUMNS - 1])[:count]
    error, before = check_error(tuple(chosen), dome), np.inf
    while error < before:
        before = error
        for place in range(count):
            others = chosen[:place] + chosen[place + 1 :]
            tried = [
                check_error((*others, n), dome) if n not in others else np.inf
                for n in range(last + 1)
            ]
            chosen[place], error = int(np.argmin(tried)), min(tried)
    return tuple(sorted(chosen))
