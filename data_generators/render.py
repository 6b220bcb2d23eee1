"""Photographs of a scene: rays, light, numbers.

The stages are functions of their own: `radiance` follows rays into the scene, `irradiance` is
what a hole makes of it on the sensor, and `numbers` what the sensor writes down.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from course_lib.camera import Camera
from course_lib.checks import Array, check_positive
from data_generators.hole import Hole, Spread, through_points, with_margin
from data_generators.pyramid import levels_for
from data_generators.quick import QuickRenderer
from data_generators.raycast import SceneIndex, bilinear, on_plane, rays
from data_generators.scene import Scene

TILE = 48  # px: rays are followed in square bundles of this size
DISK_TOLERANCE = 0.25  # px: how much disks may differ and still be taken as equal


def radiance(scene: Scene, camera: Camera, samples: int = 4) -> Array:
    """Return the light that arrives along the rays of each pixel, averaged over the pixel.

    Parameters
    ----------
    scene : Scene
        What there is to see.
    camera : Camera
        The camera, in the scene's world.
    samples : int
        Rays a pixel, along each axis, on a regular grid.

    Returns
    -------
    ndarray, shape (height, width, 3)
        Radiance, RGB, 0 to 1.

    Raises
    ------
    ValueError
        If there is not at least one sample a pixel.

    References
    ----------
    M. Pharr, W. Jakob, G. Humphreys, Physically Based Rendering, 3rd ed., chapters 7 and 10.
    """
    _check_samples(samples)
    width, height = camera.image_size
    picture = np.empty((height, width, 3))
    index = SceneIndex(scene)
    for rows, columns in _tiles(width, height):
        pixels = _sample_points(rows, columns, samples)
        light = _light(index, camera, pixels, 1 / samples)
        shape = (rows.stop - rows.start, samples, columns.stop - columns.start, samples, 3)
        picture[rows, columns] = light.reshape(shape).mean(axis=(1, 3))
    return picture


def depth_map(scene: Scene, camera: Camera) -> Array:
    """Return how far away the scene is, along the optical axis.

    Parameters
    ----------
    scene : Scene
        What there is to see.
    camera : Camera
        The camera, in the scene's world.

    Returns
    -------
    ndarray, shape (height, width)
        Z in the camera frame at the centre of each pixel, m; infinite where there is nothing.
    """
    width, height = camera.image_size
    depth = np.empty((height, width))
    index = SceneIndex(scene)
    for rows, columns in _tiles(width, height):
        origins, directions = rays(camera, _sample_points(rows, columns, 1))
        forward = directions @ camera.R[2]
        distance = index.cast(origins, directions).distance * forward
        depth[rows, columns] = distance.reshape(rows.stop - rows.start, -1)
    return depth


def numbers(irradiance: Array) -> NDArray[np.uint8]:
    """Return what an 8-bit sensor with a linear response writes down.

    Parameters
    ----------
    irradiance : ndarray
        1 fills a pixel; more is clipped.

    Returns
    -------
    ndarray of uint8, the same shape
        Grey values.
    """
    return np.rint(np.clip(irradiance, 0, 1) * 255).astype(np.uint8)


def photograph(
    scene: Scene,
    camera: Camera,
    *,
    hole: Hole | None = None,
    exposure: float | None = None,
    samples: int = 4,
) -> NDArray[np.uint8]:
    """Return the photograph that a pinhole camera takes.

    Parameters
    ----------
    scene : Scene
        What there is to see.
    camera : Camera
        The camera, in the scene's world.
    hole : Hole, optional
        The hole with its size; without one, an ideal point.
    exposure : float, optional
        Factor on all brightnesses. With a hole, it is the grey level (1 is white) of a white
        surface by irradiance, so that a larger hole makes a brighter picture; without a value
        the exposure time makes up for the size of the hole.
    samples : int
        Rays a pixel, along each axis.

    Returns
    -------
    ndarray, shape (height, width, 3), uint8
        RGB, linear in light. The same arguments give the same picture.

    Raises
    ------
    TypeError, ValueError
        If the exposure is not positive or there are no samples.
    """
    gain = 1.0 if exposure is None else float(check_positive(exposure, "exposure"))
    if hole is None:
        return numbers(radiance(scene, camera, samples) * gain)
    if exposure is not None:
        gain *= hole.light
    return numbers(gain * irradiance(scene, camera, hole, samples))


def irradiance(scene: Scene, camera: Camera, hole: Hole, samples: int = 4) -> Array:
    """Return the light on the sensor behind a hole, by that behind an ideal point.

    Where near and far disks differ by more than `DISK_TOLERANCE`, the picture is the mean of
    those through many points of the hole; otherwise one disk serves for all.

    Parameters
    ----------
    scene, camera, hole, samples
        As for `photograph`.

    Returns
    -------
    ndarray, shape (height, width, 3)
        1 where a white surface is seen sharply.
    """
    wide, margin = with_margin(camera)
    depth, pitch = depth_map(scene, wide), hole.pitch(camera)
    # The background is of one colour, so its disk shows nowhere.
    disks = hole.spot(depth[np.isfinite(depth)]) if np.isfinite(depth).any() else np.zeros(1)
    if np.ptp(disks) <= DISK_TOLERANCE * pitch.min():
        spread = Spread(radiance(scene, wide, samples), margin, pitch)
        return spread.through(hole, disk=float(np.median(disks))).astype(float)
    quick = QuickRenderer(scene)
    count = int(np.clip((disks.max() / pitch.min()) ** 2, 64, 1024))
    mean = through_points(lambda point: quick.picture(point) / 255, wide, hole, count)
    return Spread(mean, margin, pitch).through(hole, disk=0.0).astype(float)


def _light(index: SceneIndex, camera: Camera, pixels: Array, size: float) -> Array:
    """Return the radiance along the rays through `pixels`, each of them `size` px wide."""
    origins, directions = rays(camera, pixels)
    hits = index.cast(origins, directions)
    light = np.empty((len(pixels), 3))
    light[hits.patch < 0] = np.array(index.scene.background) / 255
    for patch in np.unique(hits.patch[hits.patch >= 0]).tolist():
        mine = np.flatnonzero(hits.patch == patch)
        light[mine] = _texture_light(index, patch, camera, pixels[mine], size)
    return light


def _texture_light(
    index: SceneIndex, number: int, camera: Camera, pixels: Array, size: float
) -> Array:
    """Return the texture of one patch under `pixels`, at the resolution that suits each."""
    patch, pyramid = index.scene.patches[number], index.pyramids[number]
    if not pyramid.highest.any():
        return np.broadcast_to(patch.texture[0, 0] / 255, (len(pixels), 3))
    repeat = np.array(patch.repeat)
    here, right, below = (
        np.stack(on_plane(patch, *rays(camera, pixels + step))[:2], axis=1) * repeat
        for step in ((0, 0), (size, 0), (0, size))
    )
    footprint = np.maximum(np.abs(right - here), np.abs(below - here)) * pyramid.size
    levels = levels_for(footprint / np.sqrt(2), pyramid.highest)
    light = np.empty((len(pixels), 3))
    for level in np.unique(levels, axis=0).tolist():
        mine = np.flatnonzero((levels == level).all(axis=1))
        texture = pyramid.level(*level)
        columns, rows = (here[mine] * (texture.shape[1], texture.shape[0]) - 0.5).T
        light[mine] = bilinear(texture, columns, rows, bool((repeat != 1).any()))
    return light


def _tiles(width: int, height: int) -> Iterator[tuple[slice, slice]]:
    """Cut the picture into tiles: slices of rows and of columns."""
    for top in range(0, height, TILE):
        for left in range(0, width, TILE):
            yield slice(top, min(top + TILE, height)), slice(left, min(left + TILE, width))


def _sample_points(rows: slice, columns: slice, samples: int) -> Array:
    """Return a regular grid of points in a tile, row by row, shape (N, 2), px."""
    within = (np.arange(samples) + 0.5) / samples - 0.5
    u = (np.arange(columns.start, columns.stop)[:, None] + within).ravel()
    v = (np.arange(rows.start, rows.stop)[:, None] + within).ravel()
    return np.stack(np.meshgrid(u, v), axis=-1).reshape(-1, 2)


def _check_samples(samples: int) -> None:
    if not isinstance(samples, int | np.integer) or samples < 1:
        raise ValueError(f"samples must be a whole number of at least 1, got {samples!r}")
