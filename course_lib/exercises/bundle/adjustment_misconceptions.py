"""Wrong answers to the exercise of chapter 10 on the adjustment."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np

from course_lib import bundle


def diagonal_larger(block: Any, damping: float) -> Any:
    return block * (1 + damping * np.eye(block.shape[-1]))


def damped(blocks: Any, damping: float) -> Any:
    U, W, V, g_c, g_p = blocks
    return diagonal_larger(U, damping), W, diagonal_larger(V, damping), g_c, g_p


def search(
    K: Any,
    R: Any,
    t: Any,
    points: Any,
    pixels: Any,
    steps: int,
    damp: Any = damped,
    sign: float = 1,
    moves_cameras: float = 1,
    moves_points: float = 1,
    judge: Any = lambda there, here, start: there < here,
    lower: float = 10,
    higher: float = 10,
    begin: float = 1e-3,
) -> Any:
    """Adjust a block rightly, but for what is chosen otherwise."""
    damping, start = begin, bundle.squared_error(K, R, t, points, pixels)
    here = start
    for _ in range(steps):
        blocks = damp(bundle.normal_blocks(K, R, t, points, pixels), damping)
        cameras, moves = bundle.solve_normal_block(*blocks)
        cameras, moves = sign * moves_cameras * cameras, sign * moves_points * moves
        there = bundle.move_block(R, t, points, cameras, moves)
        error = bundle.squared_error(K, *there, pixels)
        if judge(error, here, start):
            (R, t, points), here, damping = there, error, damping / lower
        else:
            damping = damping * higher
    return R, t, points


def not_damped(K, R, t, points, pixels, steps):
    return search(K, R, t, points, pixels, steps, damp=lambda blocks, damping: blocks)


def only_cameras_damped(K, R, t, points, pixels, steps):
    def damp(blocks: Any, damping: float) -> Any:
        return diagonal_larger(blocks[0], damping), *blocks[1:]

    return search(K, R, t, points, pixels, steps, damp)


def only_points_damped(K, R, t, points, pixels, steps):
    def damp(blocks: Any, damping: float) -> Any:
        U, W, V, *gradients = blocks
        return U, W, diagonal_larger(V, damping), *gradients

    return search(K, R, t, points, pixels, steps, damp)


def the_whole_blocks_damped(K, R, t, points, pixels, steps):
    def damp(blocks: Any, damping: float) -> Any:
        U, W, V, *gradients = blocks
        return (1 + damping) * U, W, (1 + damping) * V, *gradients

    return search(K, R, t, points, pixels, steps, damp)


def W_damped_too(K, R, t, points, pixels, steps):
    def damp(blocks: Any, damping: float) -> Any:
        U, W, V, *gradients = damped(blocks, damping)
        return U, (1 + damping) * W, V, *gradients

    return search(K, R, t, points, pixels, steps, damp)


def ones_on_the_diagonal(K, R, t, points, pixels, steps):
    def damp(blocks: Any, damping: float) -> Any:
        U, W, V, *gradients = blocks
        return U + damping * np.eye(len(U)), W, V + damping * np.eye(3), *gradients

    return search(K, R, t, points, pixels, steps, damp)


def one_left_out(K, R, t, points, pixels, steps):
    def damp(blocks: Any, damping: float) -> Any:
        U, W, V, *gradients = blocks
        return diagonal_larger(U, damping - 1), W, diagonal_larger(V, damping - 1), *gradients

    return search(K, R, t, points, pixels, steps, damp)


def step_subtracted(K, R, t, points, pixels, steps):
    return search(K, R, t, points, pixels, steps, sign=-1)


def only_cameras_moved(K, R, t, points, pixels, steps):
    return search(K, R, t, points, pixels, steps, moves_points=0)


def only_points_moved(K, R, t, points, pixels, steps):
    return search(K, R, t, points, pixels, steps, moves_cameras=0)


def every_step_kept(K, R, t, points, pixels, steps):
    return search(K, R, t, points, pixels, steps, judge=lambda there, here, start: True)


def every_step_kept_and_undamped(K, R, t, points, pixels, steps):
    def always(there: float, here: float, start: float) -> bool:
        return True

    return search(K, R, t, points, pixels, steps, judge=always, lower=1)


def larger_errors_kept(K, R, t, points, pixels, steps):
    return search(K, R, t, points, pixels, steps, judge=lambda there, here, start: there > here)


def damping_stays(K, R, t, points, pixels, steps):
    return search(K, R, t, points, pixels, steps, lower=1, higher=1)


def damping_never_raised(K, R, t, points, pixels, steps):
    return search(K, R, t, points, pixels, steps, higher=1)


def damping_never_lowered(K, R, t, points, pixels, steps):
    return search(K, R, t, points, pixels, steps, lower=1)


def damping_the_wrong_way(K, R, t, points, pixels, steps):
    return search(K, R, t, points, pixels, steps, lower=0.1, higher=0.1)


def another_first_damping(K, R, t, points, pixels, steps):
    return search(K, R, t, points, pixels, steps, begin=1)


def one_step_only(K, R, t, points, pixels, steps):
    return search(K, R, t, points, pixels, 1)


def one_step_more(K, R, t, points, pixels, steps):
    return search(K, R, t, points, pixels, steps + 1)


def until_one_is_refused(K, R, t, points, pixels, steps):
    """Return what was tried last, or stop as soon as a step does not help."""
    tried = [search(K, R, t, points, pixels, count) for count in range(steps + 1)]
    for before, after in pairwise(tried):
        if (before[2] == after[2]).all():
            return before
    return tried[-1]


def what_was_tried_last(K, R, t, points, pixels, steps):
    """Return the last trial, though it may have been refused."""
    last: Any = None

    def judge(there: float, here: float, start: float) -> bool:
        return there < here

    damping = 1e-3
    for _ in range(steps):
        blocks = damped(bundle.normal_blocks(K, R, t, points, pixels), damping)
        last = bundle.move_block(R, t, points, *bundle.solve_normal_block(*blocks))
        here = bundle.squared_error(K, R, t, points, pixels)
        if judge(bundle.squared_error(K, *last, pixels), here, here):
            (R, t, points), damping = last, damping / 10
        else:
            damping = damping * 10
    return last


def blocks_of_the_start(K, R, t, points, pixels, steps):
    blocks = bundle.normal_blocks(K, R, t, points, pixels)
    return search(K, R, t, points, pixels, steps, damp=lambda _, damping: damped(blocks, damping))


def points_only_returned(K, R, t, points, pixels, steps):
    return search(K, R, t, points, pixels, steps)[2]


def blocks_damped_again(K, R, t, points, pixels, steps):
    """Keep the damped blocks of a refused step, and damp them once more."""
    kept: dict[str, Any] = {}

    def damp(blocks: Any, damping: float) -> Any:
        before = kept.get("gradients")
        if before is not None and (before == blocks[3]).all():
            kept["blocks"] = damped(kept["blocks"], damping)
        else:
            kept["blocks"] = damped(blocks, damping)
        kept["gradients"] = blocks[3]
        return kept["blocks"]

    return search(K, R, t, points, pixels, steps, damp)
