"""Residuals of a block and their derivatives.

With ``q = R (X - C)``, a camera that turns by a small w and moves by c, and a point that moves by
p, ``dq = w × q + R (p - c)``: the derivatives by the centre are those by the point, negative.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from course_lib.bundle.block import Block, Observations
from course_lib.calibration_model import rotations_from_vectors
from course_lib.checks import (
    Array,
    DegenerateConfigurationError,
    check_intrinsics,
    check_points,
    check_rotation,
    check_vector,
)


@dataclass(frozen=True, eq=False)
class Position:
    """Where all cameras and points are: what the adjustment moves.

    Attributes
    ----------
    K, R, C : ndarray, shape (v, 3, 3), (v, 3, 3) and (v, 3)
        Intrinsics, rotations and centres.
    X : ndarray, shape (n, 3)
        Points.
    """

    K: Array
    R: Array
    C: Array
    X: Array

    @classmethod
    def of(cls, block: Block) -> Position:
        """Return where a block is."""
        return cls(block.K, block.R, block.centres, block.points)

    @property
    def block(self) -> Block:
        """The block that is there."""
        return Block(self.K, self.R, -np.einsum("vij,vj->vi", self.R, self.C), self.X)

    def moved(self, cameras: Array, points: Array) -> Position:
        """Return where all is after turns and moves, (v, 6), and moves of the points, (n, 3)."""
        turns = rotations_from_vectors(cameras[:, :3])
        return Position(self.K, turns @ self.R, self.C + cameras[:, 3:], self.X + points)

    def rays(self, seen: Observations) -> tuple[Array, Array, Array]:
        """Return ``x = X/Z``, ``y = Y/Z`` and Z of all observations, each (m,); NaN behind."""
        d = np.take(self.X, seen.points, axis=0) - np.take(self.C, seen.cameras, axis=0)
        R = np.take(self.R.reshape(-1, 9), seen.cameras, axis=0).T
        d0, d1, d2 = d.T.copy()
        z = R[6] * d0 + R[7] * d1 + R[8] * d2
        depth = np.where(z > 0, z, np.nan)
        x = (R[0] * d0 + R[1] * d1 + R[2] * d2) / depth
        return x, (R[3] * d0 + R[4] * d1 + R[5] * d2) / depth, depth

    def residuals(self, seen: Observations) -> Array:
        """Return seen minus measured by their standard deviation, shape (2, m)."""
        x, y, _ = self.rays(seen)
        return self._residuals(seen, x, y)

    def _residuals(self, seen: Observations, x: Array, y: Array) -> Array:
        K = self.K.reshape(-1, 9)[seen.cameras].T
        u = K[0] * x + K[1] * y + K[2] - seen.pixels[:, 0]
        v = K[4] * y + K[5] - seen.pixels[:, 1]
        return np.stack([u, v]) / seen.sigma

    def derivatives(self, seen: Observations) -> tuple[Array, Array, Array]:
        """Return derivatives of the residuals, and the residuals.

        Parameters
        ----------
        seen : Observations
            What was measured.

        Returns
        -------
        turns, moves, residuals : ndarray, shape (2, 3, m), (2, 3, m) and (2, m)
            By the turn of the camera; by the move of the point (by that of the centre: negative).
        """
        x, y, z = self.rays(seen)
        k = self.K.reshape(-1, 9)[seen.cameras].T / seen.sigma
        fx, s, fy = k[0], k[1], k[4]
        along = fx * x + s * y
        turns = np.empty((2, 3, len(x)))
        turns[0] = -s - along * y, fx + along * x, s * x - fx * y
        turns[1] = -fy - fy * y * y, fy * x * y, fy * x
        R = np.take(self.R.reshape(-1, 9), seen.cameras, axis=0).T.reshape(3, 3, -1)
        moves = np.empty((2, 3, len(x)))
        moves[0] = (fx / z) * R[0] + (s / z) * R[1] - (along / z) * R[2]
        moves[1] = (fy / z) * R[1] - (fy * y / z) * R[2]
        return turns, moves, self._residuals(seen, x, y)


def reprojection_jacobian(
    point: ArrayLike, K: ArrayLike, R: ArrayLike, t: ArrayLike
) -> tuple[Array, Array]:
    """Return how the pixel of a point changes with the pose of the camera and with the point.

    Parameters
    ----------
    point : array_like, shape (3,)
        The point in the world.
    K : array_like, shape (3, 3)
        Intrinsics, px.
    R, t : array_like, shape (3, 3) and (3,)
        Pose, world to camera.

    Returns
    -------
    by_pose : ndarray, shape (2, 6)
        Three columns for a small turn w about the camera's axes, ``R → exp([w]ₓ) R`` about the
        centre, px/rad; three for a move of the centre, px per unit of length.
    by_point : ndarray, shape (2, 3)
        For a move of the point, px per unit of length: the last three of the other, negative.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or `K` or `R` is none.
    DegenerateConfigurationError
        If the point is not in front of the camera: it has no image.

    References
    ----------
    B. Triggs et al., "Bundle adjustment: a modern synthesis" (2000), section 4.

    Examples
    --------
    Ahead at distance 2, seen with f = 100 px, a point that moves to the right by 1 moves 50 px:

    >>> reprojection_jacobian([0, 0, 2], np.diag([100, 100, 1]), np.eye(3), [0, 0, 0])[1] + 0.0
    array([[50.,  0.,  0.],
           [ 0., 50.,  0.]])
    """
    K, R, t = check_intrinsics(K), check_rotation(R), check_vector(t, 3, "t")
    X = check_points(check_vector(point, 3, "point"), 3, "point")
    one = Position(K[None], R[None], (-R.T @ t)[None], X[None])
    seen = Observations(np.array([0]), np.array([0]), np.zeros((1, 2)))
    turns, moves, _ = one.derivatives(seen)
    if not np.isfinite(moves).all():
        raise DegenerateConfigurationError(
            "the point is not in front of the camera: it has no image that could change"
        )
    return np.concatenate([turns, -moves], axis=1)[..., 0], moves[..., 0]
