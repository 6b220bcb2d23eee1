"""Residuals of a block and their derivatives.

With ``q = R (X - C)``, an R that is followed by a small turn w of all that the camera sees (itself
it turns by -w), a centre that moves by c, and a point that moves by p, ``dq = w × q + R (p - c)``:
the derivatives by the centre are those by the point, negative.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from course_lib.bundle.block import Block, Observations
from course_lib.calibration.model import rotations_from_vectors
from course_lib.checks import (
    Array,
    DegenerateConfigurationError,
    check_intrinsics,
    check_points,
    check_rotation,
    check_vector,
)

#: Derivatives by turns and by moves, (2, 3, m), and residuals, (2, m).
Weighted = tuple[Array, Array, Array]
#: How much of the curvature along a far residual is taken out; all would leave a point loose.
BENT = 0.95


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

    def image(self, seen: Observations) -> Image:
        """Return what the cameras see of the points that were observed."""
        X, C = np.take(self.X.T, seen.points, axis=1), np.take(self.C.T, seen.cameras, axis=1)
        d0, d1, d2 = X - C
        R = np.take(self.R.reshape(-1, 9).T, seen.cameras, axis=1)
        K = np.take(self.K.reshape(-1, 9).T, seen.cameras, axis=1)
        z = R[6] * d0 + R[7] * d1 + R[8] * d2
        z[~(z > 0)] = np.nan
        x = (R[0] * d0 + R[1] * d1 + R[2] * d2) / z
        y = (R[3] * d0 + R[4] * d1 + R[5] * d2) / z
        u = K[0] * x + K[1] * y + K[2] - seen.pixels[:, 0]
        v = K[4] * y + K[5] - seen.pixels[:, 1]
        return Image(K, R, x, y, z, 1 / np.asarray(seen.sigma), np.stack([u, v]) / seen.sigma)


@dataclass(frozen=True, eq=False)
class Image:
    """What the cameras see of the points that were observed.

    Attributes
    ----------
    K, R : ndarray, shape (9, m)
        Intrinsics and rotation of each observation's camera.
    x, y, z : ndarray, shape (m,)
        ``X/Z``, ``Y/Z`` and Z in the camera's frame; NaN behind it.
    precision : ndarray, shape (m,)
        ``1 / σ``, 1/px.
    residuals : ndarray, shape (2, m)
        Seen minus measured, by their standard deviation.
    """

    K: Array
    R: Array
    x: Array
    y: Array
    z: Array
    precision: Array
    residuals: Array

    def derivatives(self, scale: Array) -> tuple[Array, Array]:
        """Return the derivatives of the residuals, each observation's times a scale, (m,).

        Returns
        -------
        turns, moves : ndarray, shape (2, 3, m)
            By the turn of the camera; by the move of the point (by that of the centre: negative).
        """
        x, y, weight = self.x, self.y, self.precision * scale
        fx, s, fy = self.K[0] * weight, self.K[1] * weight, self.K[4] * weight
        along, down = fx * x + s * y, fy * y
        turns, moves = np.empty((2, 3, len(x))), np.empty((2, 3, len(x)))
        turns[0, 0], turns[0, 1], turns[0, 2] = -s - along * y, fx + along * x, s * x - fx * y
        turns[1, 0], turns[1, 1], turns[1, 2] = -fy - down * y, down * x, fy * x
        R, near = self.R.reshape(3, 3, -1), 1 / self.z
        np.multiply(fx * near, R[0], out=moves[0])
        if s.any():
            moves[0] += (s * near) * R[1]
        moves[0] -= (along * near) * R[2]
        np.multiply(fy * near, R[1], out=moves[1])
        moves[1] -= (down * near) * R[2]
        return turns, moves

    def weighted(self, scale: Array, bent: bool = False) -> Weighted:
        """Return derivatives and residuals, each observation's times a scale, (m,).

        The cost of a far residual grows with its length, not with the square. Along itself it is
        not curved at all; `bent` takes that out of the products of derivatives, and leaves the
        gradients as they are: the steps get longer, and fewer.

        References
        ----------
        B. Triggs et al., "Bundle adjustment: a modern synthesis" (2000), section 4.3.
        """
        turns, moves = self.derivatives(scale)
        residuals = self.residuals * scale
        far = np.flatnonzero(scale < 1) if bent else np.zeros(0, np.intp)
        if len(far):
            r = residuals[:, far]
            r = r / np.sqrt((r * r).sum(axis=0))
            for slopes in (turns, moves):
                part = slopes[:, :, far]
                slopes[:, :, far] = part - BENT * r[:, None] * (r[:, None] * part).sum(axis=0)
            residuals[:, far] /= 1 - BENT
        return turns, moves, residuals


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
    turns, moves = one.image(seen).derivatives(np.ones(1))
    if not np.isfinite(moves).all():
        raise DegenerateConfigurationError(
            "the point is not in front of the camera: it has no image that could change"
        )
    return np.concatenate([turns, -moves], axis=1)[..., 0], moves[..., 0]
