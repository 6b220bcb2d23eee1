"""Wrong answers to the exercise of chapter 10 on the adjustment."""

from __future__ import annotations

from typing import Any

import numpy as np

from course_lib import bundle


def diagonal_larger(block: Any, damping: float) -> Any:
    return block * (1 + damping * np.eye(block.shape[-1]))


def damped(blocks: Any, damping: float) -> Any:
    U, W, V, g_c, g_p = blocks
    return diagonal_larger(U, damping), W, diagonal_larger(V, damping), g_c, g_p


def stepped(
    block: Any, damp: Any = damped, cameras: float = 1, points: float = 1
) -> tuple[Any, Any, bool]:
    """Return where we were, where the step leads, and whether it helps."""
    K, R, t, X, pixels, damping = block
    blocks, error = start_of(*block[:5])
    step, moves = bundle.solve_normal_block(*damp(blocks, damping))
    there = bundle.move_block(R, t, X, cameras * step, points * moves)
    return (R, t, X), there, bundle.squared_error(K, *there, pixels) < error


#: A judge tries all wrong answers on the same block: where it starts is computed once.
STARTS: dict[bytes, Any] = {}


def start_of(*place: Any) -> Any:
    """Return the blocks and the error where a block is."""
    key = b"".join(part.tobytes() for part in place)
    if key not in STARTS:
        if len(STARTS) > 8:
            STARTS.clear()
        STARTS[key] = bundle.normal_blocks(*place), bundle.squared_error(*place)
    return STARTS[key]


def ended(stepped: Any, damping: float) -> Any:
    """Return what is right after a step."""
    here, there, helps = stepped
    return (*there, damping / 10) if helps else (*here, damping * 10)


def not_damped(K, R, t, points, pixels, damping):
    block = K, R, t, points, pixels, damping
    return ended(stepped(block, lambda blocks, _: blocks), damping)


def only_cameras_damped(K, R, t, points, pixels, damping):
    def damp(blocks: Any, damping: float) -> Any:
        return diagonal_larger(blocks[0], damping), *blocks[1:]

    return ended(stepped((K, R, t, points, pixels, damping), damp), damping)


def only_points_damped(K, R, t, points, pixels, damping):
    def damp(blocks: Any, damping: float) -> Any:
        U, W, V, *gradients = blocks
        return U, W, diagonal_larger(V, damping), *gradients

    return ended(stepped((K, R, t, points, pixels, damping), damp), damping)


def the_whole_blocks_damped(K, R, t, points, pixels, damping):
    def damp(blocks: Any, damping: float) -> Any:
        U, W, V, *gradients = blocks
        return (1 + damping) * U, W, (1 + damping) * V, *gradients

    return ended(stepped((K, R, t, points, pixels, damping), damp), damping)


def W_damped_too(K, R, t, points, pixels, damping):
    def damp(blocks: Any, damping: float) -> Any:
        U, W, V, *gradients = damped(blocks, damping)
        return U, (1 + damping) * W, V, *gradients

    return ended(stepped((K, R, t, points, pixels, damping), damp), damping)


def ones_on_the_diagonal(K, R, t, points, pixels, damping):
    def damp(blocks: Any, damping: float) -> Any:
        U, W, V, *gradients = blocks
        return U + damping * np.eye(len(U)), W, V + damping * np.eye(3), *gradients

    return ended(stepped((K, R, t, points, pixels, damping), damp), damping)


def one_left_out(K, R, t, points, pixels, damping):
    def damp(blocks: Any, damping: float) -> Any:
        return damped(blocks, damping - 1)

    return ended(stepped((K, R, t, points, pixels, damping), damp), damping)


def step_subtracted(K, R, t, points, pixels, damping):
    block = K, R, t, points, pixels, damping
    return ended(stepped(block, cameras=-1, points=-1), damping)


def only_cameras_moved(K, R, t, points, pixels, damping):
    return ended(stepped((K, R, t, points, pixels, damping), points=0), damping)


def only_points_moved(K, R, t, points, pixels, damping):
    return ended(stepped((K, R, t, points, pixels, damping), cameras=0), damping)


def every_step_kept(K, R, t, points, pixels, damping):
    _, there, _ = stepped((K, R, t, points, pixels, damping))
    return *there, damping / 10


def larger_errors_kept(K, R, t, points, pixels, damping):
    here, there, helps = stepped((K, R, t, points, pixels, damping))
    return ended((here, there, not helps), damping)


def damping_stays(K, R, t, points, pixels, damping):
    here, there, helps = stepped((K, R, t, points, pixels, damping))
    return *(there if helps else here), damping


def damping_never_raised(K, R, t, points, pixels, damping):
    here, there, helps = stepped((K, R, t, points, pixels, damping))
    return *(there if helps else here), damping / 10 if helps else damping


def damping_never_lowered(K, R, t, points, pixels, damping):
    here, there, helps = stepped((K, R, t, points, pixels, damping))
    return *(there if helps else here), damping if helps else damping * 10


def damping_the_wrong_way(K, R, t, points, pixels, damping):
    here, there, helps = stepped((K, R, t, points, pixels, damping))
    return *(there if helps else here), damping * 10 if helps else damping / 10


def damping_left_out_of_the_answer(K, R, t, points, pixels, damping):
    return ended(stepped((K, R, t, points, pixels, damping)), damping)[:3]


def the_step_returned(K, R, t, points, pixels, damping):
    blocks = damped(bundle.normal_blocks(K, R, t, points, pixels), damping)
    return bundle.solve_normal_block(*blocks)
