"""How well an adjusted block is known: the inverse of the normal equations, block by block."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from course_lib.bundle.block import Indices
from course_lib.bundle.derivatives import Position
from course_lib.bundle.gauge import gauge_directions
from course_lib.bundle.normals import Eliminated, Normals, backward, forward
from course_lib.bundle.structure import Structure
from course_lib.checks import Array, DegenerateConfigurationError


@dataclass(frozen=True, eq=False)
class Precision:
    """Covariances of an adjusted block.

    Attributes
    ----------
    cameras : ndarray, shape (v, 6, 6)
        Of each camera's turn about its own axes, rad, and of its centre in the world.
    points : ndarray, shape (n, 3, 3)
        Of each point.
    """

    cameras: Array
    points: Array

    @property
    def turn_sigma(self) -> Array:
        """Standard deviations of the cameras' turns about their axes, rad, shape (v, 3)."""
        return self._sigma(self.cameras)[:, :3]

    @property
    def centre_sigma(self) -> Array:
        """Standard deviations of the centres, shape (v, 3)."""
        return self._sigma(self.cameras)[:, 3:]

    @property
    def point_sigma(self) -> Array:
        """Standard deviations of the points, shape (n, 3)."""
        return self._sigma(self.points)

    @staticmethod
    def _sigma(blocks: Array) -> Array:
        return np.asarray(np.sqrt(np.einsum("vii->vi", blocks).clip(0)))


def precision(
    normals: Normals,
    position: Position,
    structure: Structure,
    free: Indices,
    inner: bool,
    variance: float,
) -> Precision:
    """Return the covariances of a block from its normal equations.

    Parameters
    ----------
    normals : Normals
        At the minimum.
    position : Position
        The minimum.
    structure : Structure
        What was seen.
    free : ndarray of int
        Which numbers of the cameras are free; with them the equations are regular.
    inner : bool
        Whether the covariance is that of inner constraints on the points; the free numbers are then
        only a means.
    variance : float
        What the inverse is multiplied with.

    Returns
    -------
    Precision
        The covariances.

    Raises
    ------
    DegenerateConfigurationError
        If the equations are singular.

    References
    ----------
    B. Triggs et al., "Bundle adjustment: a modern synthesis" (2000), sections 8 and 9;
    W. Baarda, "S-transformations and criterion matrices" (1973).
    """
    rest = normals.eliminated(structure)
    inverse = np.zeros_like(rest.S)
    try:
        inverse[np.ix_(free, free)] = np.linalg.inv(rest.S[np.ix_(free, free)])
    except np.linalg.LinAlgError as error:
        raise DegenerateConfigurationError(
            "the equations of the cameras are singular: nothing determines a camera, or the gauge"
        ) from error
    v = structure.cameras
    blocks = inverse.reshape(v, 6, v, 6)
    cameras = np.einsum("vivj->vij", blocks).copy()
    points = _point_blocks(rest, blocks, structure)
    if inner:
        to_cameras, to_points = _inner(rest, inverse, position, structure)
        cameras += to_cameras
        points += to_points
    return Precision(variance * cameras, variance * points)


def _point_blocks(rest: Eliminated, inverse: Array, structure: Structure) -> Array:
    """Return ``V⁻¹ + L⁻ᵀ Yᵀ S⁻¹ Y L⁻¹`` of each point, (n, 3, 3)."""
    points, Y = structure.seen.points, rest.Y
    sums = np.zeros((3, 3, structure.points)) + np.eye(3)[:, :, None]
    for i, (first, last) in enumerate(pairwise(structure.bounds)):
        own = Y[first:last]
        _add(sums, points[first:last], (own @ inverse[i, :, i]) @ own.transpose(0, 2, 1))
    for i, j, first, last in structure.pairs:
        left, right = Y[structure.left[first:last]], Y[structure.right[first:last]]
        tied = (left @ inverse[i, :, j]) @ right.transpose(0, 2, 1)
        _add(sums, points[structure.left[first:last]], tied + tied.transpose(0, 2, 1))
    half = backward(rest.L, sums)
    return np.asarray(backward(rest.L, half.transpose(1, 0, 2).copy()).transpose(2, 0, 1))


def _add(sums: Array, points: Indices, blocks: Array) -> None:
    """Add blocks, (k, 3, 3), to those of points; each point is named once."""
    sums[:, :, points] += blocks.transpose(1, 2, 0)


def _inner(
    rest: Eliminated, inverse: Array, position: Position, structure: Structure
) -> tuple[Array, Array]:
    """Return what inner constraints on the points add to the covariances of another gauge.

    With G the directions in which the block moves as a whole, and H those of the points alone, the
    S-transformation is ``T = I - G (Hᵀ G)⁻¹ Hᵀ``, and the covariance C becomes ``T C Tᵀ``.
    """
    G_c, G_p = gauge_directions(position)
    onto = np.linalg.inv(np.einsum("nik,nil->kl", G_p, G_p))
    # Q = C H (Hᵀ G)⁻¹: the equations solved for seven right-hand sides.
    Q_c, Q_p = _solved(rest, inverse, structure, G_p @ onto)
    among = onto @ np.einsum("nik,nil->kl", G_p, Q_p)
    G_c = G_c.reshape(-1, 6, 7)
    added = []
    for G, Q in ((G_c, Q_c.reshape(-1, 6, 7)), (G_p, Q_p)):
        mixed = Q @ G.transpose(0, 2, 1)
        added.append(G @ among @ G.transpose(0, 2, 1) - mixed - mixed.transpose(0, 2, 1))
    return added[0], added[1]


def _solved(
    rest: Eliminated, inverse: Array, structure: Structure, right: Array
) -> tuple[Array, Array]:
    """Return the inverse times columns that are zero for the cameras, (n, 3, k) for the points."""
    h = forward(rest.L, right.transpose(1, 2, 0).copy())  # (3, k, n)
    columns = []
    for column in h.transpose(1, 0, 2):
        seen = np.einsum("km,mkj->jm", column[:, structure.seen.points], rest.Y)
        by_camera = [seen[:, a:b].sum(axis=1) for a, b in pairwise(structure.bounds)]
        cameras = -inverse @ np.concatenate(by_camera)
        one = Eliminated(rest.S, rest.right, rest.L, rest.Y, -column)
        columns.append((cameras, one.followed(structure, cameras.reshape(-1, 6))))
    return np.stack([c for c, _ in columns], axis=1), np.stack([p for _, p in columns], axis=2)
