"""How far a target moved before a camera, or a camera before a target.

Use these functions through `course_lib.measuring`.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import Array, check_not_negative, check_number, check_vector
from course_lib.measuring.measured import Measured
from course_lib.measuring.plane import length_and_line
from course_lib.measuring.shares import shares
from course_lib.measuring.view import View


def target_shift(
    before: View, after: View, point: ArrayLike | None = None, scale: float = 0.0
) -> Measured:
    """Return how far a point of the target moved between two pictures of one camera at rest.

    The point is at ``R X + t`` in the camera's frame. A turn w of the pose about the camera's axes
    and a shift τ move it by ``w × (R X) + τ``. Errors of the camera's numbers and of the target
    act through both poses: they are subtracted before they are squared.

    Parameters
    ----------
    before, after : View
        Of the same target, by `view_of_target`.
    point : array_like, shape (3,), optional
        Which point, in the frame of the target; its middle unless given.
    scale : float
        Relative standard deviation of the target's lengths.

    Returns
    -------
    Measured
        The distance, with the parts ``"pose"``, ``"camera"``, ``"target"`` (its corners), and
        ``"scale"`` if it is given.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, a view has no target, or nothing moved.

    References
    ----------
    E. M. Mikhail, F. Ackermann, Observations and Least Squares, chapter 4 (propagation of
    covariances).
    """
    views = _of_target(before, after)
    X = before.target.mean(axis=0) if point is None else check_vector(point, 3, "point")
    turned = [view.R @ X for view in views]
    places = np.stack([q + view.t for q, view in zip(turned, views, strict=True)])
    value, line = length_and_line(places)
    slopes = [np.concatenate([np.cross(q, line), line]) for q in turned]
    return _measured(value, views, slopes, scale)


def cameras_apart(one: View, other: View, scale: float = 0.0) -> Measured:
    """Return how far apart the cameras of two pictures of one target stood.

    A camera's centre is ``C = -Rᵀ t`` in the frame of the target. A turn w of its pose about the
    camera's axes and a shift τ move it by ``Rᵀ (w × t - τ)``.

    Parameters
    ----------
    one, other : View
        Of the same target at the same place, by `view_of_target`; of one camera, or of two.
    scale : float
        Relative standard deviation of the target's lengths.

    Returns
    -------
    Measured
        The distance of the centres, with parts as in `target_shift`.

    Raises
    ------
    TypeError, ValueError
        If a number is not finite, a view has no target, or both centres are the same.

    References
    ----------
    E. M. Mikhail, F. Ackermann, Observations and Least Squares, chapter 4 (propagation of
    covariances).
    """
    views = _of_target(one, other)
    value, line = length_and_line(np.stack([view.centre for view in views]))
    turned = [view.R @ line for view in views]
    slopes = [np.concatenate([np.cross(v.t, n), -n]) for v, n in zip(views, turned, strict=True)]
    return _measured(value, views, slopes, scale)


def _of_target(one: View, other: View) -> tuple[View, View]:
    """Return both views; raise unless they know their target."""
    if not len(one.target) or not len(other.target):
        raise ValueError("both views must show a target: make them with view_of_target")
    return one, other


def _measured(
    value: float, views: Sequence[View], slopes: Sequence[Array], scale: float
) -> Measured:
    """Return a length that is a difference of two poses, with its parts."""
    check_not_negative(check_number(scale, "scale"), "scale")
    by_state = [
        np.concatenate([np.zeros(len(view.model.names)), sign * slope])
        for view, slope, sign in zip(views, slopes, (-1, 1), strict=True)
    ]
    parts = shares(views, by_state, np.zeros(1))
    del parts["pointing"]  # nobody points: the target does
    return Measured(value, parts | ({"scale": scale * value} if scale else {}))
