"""Which two pictures to begin with: many points in common, seen at a wide enough angle."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from course_lib.bundle.block import Indices
from course_lib.checks import Array, DegenerateConfigurationError
from course_lib.epipolar import ransac_pose
from course_lib.triangulation import triangulate

#: So many points must two pictures have in common, and agree.
LEAST_COMMON = 20
#: So wide must the angle at half of their points be.
WIDE = np.deg2rad(4.0)
#: So many pairs of pictures are looked at, those with the most points in common.
LOOKED_AT = 40


class Pair(NamedTuple):
    """Two pictures that a block can begin with.

    Attributes
    ----------
    pictures : tuple of int
        Which.
    R, t : ndarray, shape (3, 3) and (3,)
        Relative pose, the first to the second; t has length 1.
    common : ndarray of int
        Points that both show.
    agreed : ndarray of int
        Those that fit the pose.
    doubt : str
        Why the pose may be the wrong one; empty if nothing says so.
    """

    pictures: tuple[int, int]
    R: Array
    t: Array
    common: Indices
    agreed: Indices
    doubt: str


def start_pairs(
    pixels: Array, K: Array, rng: np.random.Generator, threshold: float
) -> Iterator[Pair]:
    """Yield pairs of pictures to begin with, the best first.

    Parameters
    ----------
    pixels : ndarray, shape (v, n, 2)
        Where each picture shows each point; NaN where it does not.
    K : ndarray, shape (3, 3)
        Intrinsics, px.
    rng : numpy.random.Generator
        Draws samples.
    threshold : float
        Largest Sampson error of a point that agrees, px.

    Yields
    ------
    Pair
        Two pictures. Last come those whose pose may be the wrong one: they show a plane only, or
        another pose fits them nearly as well.

    Raises
    ------
    DegenerateConfigurationError
        If there is none: what was best, and what it lacks.
    """
    doubtful, lacking = [], []
    candidates = _with_most_in_common(pixels)
    for pictures in candidates:
        found = _looked_at(pixels, pictures, K, rng, threshold)
        if isinstance(found, str):
            lacking.append(found)
        elif found.doubt:
            doubtful.append(found)
        else:
            yield found
    yield from doubtful
    if len(lacking) == len(candidates):
        raise DegenerateConfigurationError(
            f"there are no two pictures to begin with: {lacking[0]}. Move the camera farther "
            "between pictures"
        )


def _with_most_in_common(pixels: Array) -> list[tuple[int, int]]:
    """Return pairs of pictures that have enough points in common, those with the most first."""
    seen = ~np.isnan(pixels[..., 0])
    common = np.triu(seen.astype(np.int32) @ seen.T.astype(np.int32), 1)
    order = np.argsort(-common, axis=None, kind="stable")[:LOOKED_AT]
    i, j = np.unravel_index(order, common.shape)
    if common[i[0], j[0]] < LEAST_COMMON:
        raise DegenerateConfigurationError(
            f"no two pictures have {LEAST_COMMON} points in common; pictures {i[0]} and {j[0]} "
            f"have the most, {common[i[0], j[0]]}: find more tie points, or take pictures that "
            "overlap more"
        )
    enough = common[i, j] >= LEAST_COMMON
    return list(zip(i[enough].tolist(), j[enough].tolist(), strict=True))


def _looked_at(
    pixels: Array, pictures: tuple[int, int], K: Array, rng: np.random.Generator, threshold: float
) -> Pair | str:
    """Return a pair, or what it lacks."""
    one, other = pixels[list(pictures)]
    common = np.flatnonzero(~np.isnan(one[:, 0] + other[:, 0]))
    named = f"pictures {pictures[0]} and {pictures[1]}"
    try:
        pose = ransac_pose(one[common], other[common], K, K, rng, threshold)
    except DegenerateConfigurationError as error:
        return f"{named} have no baseline ({error})"
    agreed = common[pose.fits]
    if len(agreed) < LEAST_COMMON:
        return f"only {len(agreed)} of {len(common)} points of {named} agree on a pose"
    angle = float(np.median(_angles(one[agreed], other[agreed], K, pose.R, pose.t)))
    if angle < WIDE:
        return (
            f"{named} see their points at {np.degrees(angle):.1f} degrees, and "
            f"{np.degrees(WIDE):.0f} are needed"
        )
    return Pair(pictures, pose.R, pose.t, common, agreed, pose.doubt)


def _angles(one: Array, other: Array, K: Array, R: Array, t: Array) -> Array:
    """Return the angles at which two cameras see points, rad."""
    back = np.linalg.inv(K)
    rays1 = np.insert(one, 2, 1.0, axis=1) @ back.T
    rays2 = np.insert(other, 2, 1.0, axis=1) @ back.T @ R
    return angles_between(rays1, rays2)


def angles_between(rays1: Array, rays2: Array) -> Array:
    """Return the angles between directions of any length, (..., 3), rad."""
    sine = np.linalg.norm(np.cross(rays1, rays2), axis=-1)
    return np.asarray(np.arctan2(sine, (rays1 * rays2).sum(axis=-1)))


def first_points(pixels: Array, pair: Pair, K: Array) -> Array:
    """Return the points of a pair that agree, in the frame of its first camera, (k, 3)."""
    one, other = pixels[list(pair.pictures)][:, pair.agreed]
    return triangulate(one, other, K @ np.eye(3, 4), K @ np.column_stack([pair.R, pair.t]))
