"""Wrong answers to the exercise of chapter 10 on the adjustment."""

from __future__ import annotations

from typing import Any

import numpy as np

from course_lib import bundle
from course_lib.exercises.bundle.remembering import once


def diagonal_larger(block: Any, damping: float) -> Any:
    return block * (1 + damping * np.eye(block.shape[-1]))


def damped(blocks: Any, damping: float) -> Any:
    U, W, V, g_c, g_p = blocks
    return diagonal_larger(U, damping), W, diagonal_larger(V, damping), g_c, g_p


def start_of(*place: Any) -> Any:
    """Return the blocks and the error where a block is."""
    return bundle.normal_blocks(*place), bundle.squared_error(*place)


def stepped(
    block: Any, damp: Any = damped, cameras: float = 1, points: float = 1
) -> tuple[Any, Any, bool]:
    """Return where we were, where the step leads, and whether it helps."""
    _, R, t, X, _, damping = block
    blocks, error = once(start_of, *block[:5])
    there, reached = once(moved_by, *damp(blocks, damping), cameras, points, *block[:5])
    return (R, t, X), there, reached < error


def moved_by(U, W, V, g_c, g_p, cameras, points, K, R, t, X, pixels):
    """Return where the step of some blocks leads, some share of it, and the error there."""
    step, moves = bundle.solve_normal_block(U, W, V, g_c, g_p)
    there = bundle.move_block(R, t, X, cameras * step, points * moves)
    return there, bundle.squared_error(K, *there, pixels)


def rightly_stepped(*block: Any) -> Any:
    """Return what `stepped` does for the right step."""
    return stepped(block)


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


def ones_on_U(K, R, t, points, pixels, damping):
    def damp(blocks: Any, damping: float) -> Any:
        U, W, V, *gradients = blocks
        return U + damping * np.eye(len(U)), W, diagonal_larger(V, damping), *gradients

    return ended(stepped((K, R, t, points, pixels, damping), damp), damping)


def ones_on_U_only(K, R, t, points, pixels, damping):
    def damp(blocks: Any, damping: float) -> Any:
        return blocks[0] + damping * np.eye(len(blocks[0])), *blocks[1:]

    return ended(stepped((K, R, t, points, pixels, damping), damp), damping)


def ones_on_V(K, R, t, points, pixels, damping):
    def damp(blocks: Any, damping: float) -> Any:
        U, W, V, *gradients = blocks
        return diagonal_larger(U, damping), W, V + damping * np.eye(3), *gradients

    return ended(stepped((K, R, t, points, pixels, damping), damp), damping)


def six_rows_for_U(K, R, t, points, pixels, damping):
    """Damp all of U with six rows, which NumPy refuses."""
    U, *_ = once(start_of, K, R, t, points, pixels)[0]
    return U * (1 + damping * np.eye(6))


def as_many_rows_as_points(K, R, t, points, pixels, damping):
    """Damp a block with as many rows as there are points, which NumPy refuses."""
    V = once(start_of, K, R, t, points, pixels)[0][2]
    return V * (1 + damping * np.eye(len(V)))


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


def only_the_diagonal_left(K, R, t, points, pixels, damping):
    def damp(blocks: Any, damping: float) -> Any:
        U, W, V, *gradients = blocks
        return (1 + damping) * U * np.eye(len(U)), W, (1 + damping) * V * np.eye(3), *gradients

    return ended(stepped((K, R, t, points, pixels, damping), damp), damping)


def overwritten(K, R, t, points, pixels, damping):
    _, there, helps = rightly_stepped(K, R, t, points, pixels, damping)
    return *there, damping / 10 if helps else damping * 10


def compared_with_itself(K, R, t, points, pixels, damping):
    _, there, _ = rightly_stepped(K, R, t, points, pixels, damping)
    return *there, damping * 10


def compared_with_a_mixture(K, R, t, points, pixels, damping):
    here, there, _ = rightly_stepped(K, R, t, points, pixels, damping)
    reached = bundle.squared_error(K, there[0], there[1], there[2], pixels)
    mixed = bundle.squared_error(K, there[0], t, points, pixels)
    return ended((here, there, reached < mixed), damping)


def damping_by_a_hundred(K, R, t, points, pixels, damping):
    here, there, helps = rightly_stepped(K, R, t, points, pixels, damping)
    return *(there if helps else here), damping / 100 if helps else damping * 100


def damping_lowered_by_a_hundred(K, R, t, points, pixels, damping):
    here, there, helps = rightly_stepped(K, R, t, points, pixels, damping)
    return *(there if helps else here), damping / 100 if helps else damping * 10


def damping_halved(K, R, t, points, pixels, damping):
    here, there, helps = rightly_stepped(K, R, t, points, pixels, damping)
    return *(there if helps else here), damping / 2 if helps else damping * 2


def nothing_after_a_refusal(K, R, t, points, pixels, damping):
    _, there, helps = rightly_stepped(K, R, t, points, pixels, damping)
    return (*there, damping / 10) if helps else None


def every_step_kept(K, R, t, points, pixels, damping):
    _, there, _ = rightly_stepped(K, R, t, points, pixels, damping)
    return *there, damping / 10


def larger_errors_kept(K, R, t, points, pixels, damping):
    here, there, helps = rightly_stepped(K, R, t, points, pixels, damping)
    return ended((here, there, not helps), damping)


def damping_stays(K, R, t, points, pixels, damping):
    here, there, helps = rightly_stepped(K, R, t, points, pixels, damping)
    return *(there if helps else here), damping


def damping_never_raised(K, R, t, points, pixels, damping):
    here, there, helps = rightly_stepped(K, R, t, points, pixels, damping)
    return *(there if helps else here), damping / 10 if helps else damping


def damping_never_lowered(K, R, t, points, pixels, damping):
    here, there, helps = rightly_stepped(K, R, t, points, pixels, damping)
    return *(there if helps else here), damping if helps else damping * 10


def damping_the_wrong_way(K, R, t, points, pixels, damping):
    here, there, helps = rightly_stepped(K, R, t, points, pixels, damping)
    return *(there if helps else here), damping * 10 if helps else damping / 10


def damping_left_out_of_the_answer(K, R, t, points, pixels, damping):
    return ended(rightly_stepped(K, R, t, points, pixels, damping), damping)[:3]


def the_step_returned(K, R, t, points, pixels, damping):
    blocks = damped(bundle.normal_blocks(K, R, t, points, pixels), damping)
    return bundle.solve_normal_block(*blocks)
