"""Rays and what they hit: the inverse model of the camera, followed into the scene.

`rays` is the only function here that knows a camera. A camera with a lens, or one whose rows are
exposed one after the other, is a different bundle of rays (`data_generators.aim`) and changes
nothing else.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from course_lib.camera import Camera
from course_lib.checks import Array
from data_generators.pyramid import TexturePyramid
from data_generators.scene import Patch, Scene

GRAZING = 1e-12  # a ray at a smaller sine to a plane runs along it


@dataclass(frozen=True)
class Hits:
    """What rays hit first.

    Attributes
    ----------
    patch : ndarray, shape (N,), int
        Index of the patch, or -1 for the background.
    distance : ndarray, shape (N,)
        Along the ray, in lengths of its direction; infinite for the background.
    """

    patch: NDArray[np.intp]
    distance: Array


def rays(camera: Camera, pixels: Array) -> tuple[Array, Array]:
    """Return the rays that reach pixels.

    Parameters
    ----------
    camera : Camera
        The camera.
    pixels : ndarray, shape (N, 2)
        Where on the picture, px.

    Returns
    -------
    origins, directions : ndarray, shape (N, 3)
        In the world, m; the directions are unit vectors.
    """
    directions = camera.pixel_ray(pixels)
    return np.broadcast_to(camera.centre, directions.shape), directions


class SceneIndex:
    """A scene made ready for rays.

    Parameters
    ----------
    scene : Scene
        What the rays may hit.
    """

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        pyramids: dict[int, TexturePyramid] = {}
        for patch in scene.patches:
            pyramids.setdefault(id(patch.texture), TexturePyramid(patch.texture))
        self.pyramids = [pyramids[id(patch.texture)] for patch in scene.patches]
        corners = [patch.corners for patch in scene.patches]
        self.centres = np.array([c.mean(axis=0) for c in corners]).reshape(-1, 3)
        self.radii = np.array([np.linalg.norm(c - c.mean(axis=0), axis=1).max() for c in corners])
        self.moving = np.array([patch.motion is not None for patch in scene.patches], bool)

    def candidates(self, origins: Array, directions: Array) -> list[int]:
        """Return the patches whose bounding sphere meets the cone around a bundle of rays."""
        axis = directions.mean(axis=0)
        axis /= np.linalg.norm(axis)
        half_angle = np.arccos(np.clip((directions @ axis).min(), -1, 1))
        eye = origins.mean(axis=0)
        radii = self.radii + np.linalg.norm(origins - eye, axis=1).max()
        offset = self.centres - eye
        distance = np.linalg.norm(offset, axis=1)
        away = np.arccos(np.clip(offset @ axis / np.maximum(distance, 1e-12), -1, 1))
        reach = np.arcsin(np.clip(radii / np.maximum(distance, 1e-12), 0, 1))
        near = (distance <= radii) | (away <= half_angle + reach)
        return np.flatnonzero(near | self.moving).tolist()

    def cast(self, origins: Array, directions: Array, times: Array | None = None) -> Hits:
        """Return the first hit of each ray.

        Parameters
        ----------
        origins, directions : ndarray, shape (N, 3)
            Rays in the world; neighbours, as those of a tile of the picture.
        times : ndarray, shape (N,), optional
            When each ray is followed, s; at time 0 without them.

        Returns
        -------
        Hits
            What they hit.
        """
        nearest = np.full(len(origins), np.inf)
        owner = np.full(len(origins), -1)
        for index in self.candidates(origins, directions):
            patch = self.scene.patches[index]
            start, towards = at_rest(patch, origins, directions, times)
            a, b, distance = on_plane(patch, start, towards)
            seen = (distance > 0) & (distance < nearest) & _inside(patch.outline, a, b)
            if patch.one_sided:
                seen &= towards @ patch.normal < 0
            nearest[seen], owner[seen] = distance[seen], index
        return Hits(owner, nearest)


def at_rest(
    patch: Patch, origins: Array, directions: Array, times: Array | None
) -> tuple[Array, Array]:
    """Return rays as a patch sees them that may move; arguments as of `SceneIndex.cast`."""
    if patch.motion is None or times is None:
        return origins, directions
    return patch.motion.bring_back(origins, directions, times)


def on_plane(patch: Patch, origins: Array, directions: Array) -> tuple[Array, Array, Array]:
    """Return where rays meet the plane of a patch.

    Parameters
    ----------
    patch : Patch
        Its outline plays no role here.
    origins, directions : ndarray, shape (N, 3)
        Rays in the world.

    Returns
    -------
    a, b : ndarray, shape (N,)
        Coordinates on the patch, along its edges.
    distance : ndarray, shape (N,)
        Along the ray; negative behind its origin, NaN where it runs along the plane.
    """
    # origin + distance direction = patch.origin + a u + b v, a linear system.
    world_from_patch = np.stack([patch.edge_u, patch.edge_v, patch.normal], axis=1)
    to_patch = np.linalg.inv(world_from_patch).T
    start, step = (origins - patch.origin) @ to_patch, directions @ to_patch
    slope = np.where(np.abs(step[:, 2]) > GRAZING, step[:, 2], np.nan)
    distance = -start[:, 2] / slope
    return start[:, 0] + distance * step[:, 0], start[:, 1] + distance * step[:, 1], distance


def _inside(outline: Array, a: Array, b: Array) -> NDArray[np.bool_]:
    """Return which points lie in a convex outline, whichever way round it is given."""
    after = np.roll(outline, -1, axis=0)
    edge_a, edge_b = (after - outline).T
    twice_area = np.sum(outline[:, 0] * after[:, 1] - outline[:, 1] * after[:, 0])
    inside = np.ones(a.shape, bool)
    for (start_a, start_b), along_a, along_b in zip(outline, edge_a, edge_b, strict=True):
        side = along_a * (b - start_b) - along_b * (a - start_a)
        inside &= side * twice_area >= 0
    return inside


def bilinear(texture: NDArray[np.uint8], columns: Array, rows: Array, wrap: bool) -> Array:
    """Return a texture between its pixels.

    Parameters
    ----------
    texture : ndarray, shape (h, w, 3), uint8
        The texture.
    columns, rows : ndarray, shape (N,)
        Where, in pixels of the texture; ``(0, 0)`` is the centre of the first.
    wrap : bool
        Whether the texture repeats; otherwise its border continues.

    Returns
    -------
    ndarray, shape (N, 3)
        Radiance, 0 to 1.
    """
    height, width = texture.shape[:2]
    left, top = np.floor(columns).astype(int), np.floor(rows).astype(int)
    right_share, bottom_share = (columns - left)[:, None], (rows - top)[:, None]

    def pixel(column: NDArray[np.intp], row: NDArray[np.intp]) -> Array:
        if wrap:
            return np.asarray(texture[row % height, column % width], float)
        return np.asarray(
            texture[np.clip(row, 0, height - 1), np.clip(column, 0, width - 1)], float
        )

    upper = pixel(left, top) * (1 - right_share) + pixel(left + 1, top) * right_share
    lower = pixel(left, top + 1) * (1 - right_share) + pixel(left + 1, top + 1) * right_share
    return np.asarray((upper * (1 - bottom_share) + lower * bottom_share) / 255)
