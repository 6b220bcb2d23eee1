"""Photographs of a scene: rays, light, numbers.

The stages are functions of their own: `radiance` follows rays into the scene, `irradiance` is
what a hole makes of it on the sensor. What a real camera has instead of a hole (a lens, a shutter,
a sensor with noise) is in its `Shot`.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from course_lib.camera import Camera
from course_lib.checks import Array, check_positive
from data_generators.aim import Aim, aim_at
from data_generators.hole import Hole, Spread, through_points, with_margin
from data_generators.pyramid import levels_for
from data_generators.quick import QuickRenderer
from data_generators.raycast import SceneIndex, at_rest, bilinear, on_plane, rays
from data_generators.scene import Scene
from data_generators.shot import Shot, numbers

__all__ = ["depth_map", "irradiance", "numbers", "photograph", "radiance"]

TILE = 48  # px: rays are followed in square bundles of this size
DISK_TOLERANCE = 0.25  # px: how much disks may differ and still be taken as equal


def radiance(scene: Scene, camera: Camera, samples: int = 4, shot: Shot | None = None) -> Array:
    """Return the light that arrives along the rays of each pixel, averaged over the pixel.

    Parameters
    ----------
    scene : Scene
        What there is to see.
    camera : Camera
        The camera, in the scene's world.
    samples : int
        Rays a pixel, along each axis, on a regular grid.
    shot : Shot, optional
        Its lens, shutter and motion spread the rays of a pixel over the lens and over time.

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
    index, shot = SceneIndex(scene), shot or Shot()
    for rows, columns in _tiles(width, height):
        pixels = _sample_points(rows, columns, samples)
        aim = aim_at(camera, pixels, samples, shot.lens, shot.shutter, shot.motion, shot.distortion)
        light = _light(index, aim, pixels, 1 / samples)
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


def photograph(
    scene: Scene,
    camera: Camera,
    *,
    hole: Hole | None = None,
    shot: Shot | None = None,
    exposure: float | None = None,
    samples: int = 4,
    rng: np.random.Generator | None = None,
) -> NDArray[np.unsignedinteger]:
    """Return the photograph that a camera takes: a pinhole, or one with all that is in `shot`.

    Parameters
    ----------
    scene : Scene
        What there is to see.
    camera : Camera
        The camera, in the scene's world.
    hole : Hole, optional
        The hole with its size; without one, an ideal point.
    shot : Shot, optional
        Lens, shutter, motion, vignetting, sensor and mosaic, instead of a hole.
    exposure : float, optional
        Factor on all brightnesses. With a hole, it is the grey level (1 is white) of a white
        surface by irradiance, so that a larger hole makes a brighter picture; without a value
        the exposure time makes up for the size of the hole.
    samples : int
        Rays a pixel, along each axis. A lens or a motion that blurs by some px wants as many.
    rng : numpy.random.Generator, optional
        For the noise of the sensor of `shot`; needed only with one.

    Returns
    -------
    ndarray, shape (height, width, 3) or (height, width) as a mosaic, uint8 or uint16
        RGB, linear in light; DN of the sensor, or 0 to 255 without one. The same arguments (and
        the same state of `rng`) give the same picture.

    Raises
    ------
    TypeError, ValueError
        If the exposure is not positive, there are no samples, there is a hole as well as a shot,
        or a sensor without `rng`.
    """
    gain = 1.0 if exposure is None else float(check_positive(exposure, "exposure"))
    if hole is None:
        shot = shot or Shot()
        light = shot.on_sensor(radiance(scene, camera, samples, shot), camera)
        return shot.written(light * gain, rng)
    if shot is not None:
        raise ValueError("a camera has a hole or a lens: give hole or shot, not both")
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


def _light(index: SceneIndex, aim: Aim, pixels: Array, size: float) -> Array:
    """Return the radiance along the rays through `pixels`, each of them `size` px wide."""
    origins, directions = aim.rays(pixels)
    hits = index.cast(origins, directions, aim.times)
    # One of the rays that share a disk stands for this part of it, too.
    forward = np.maximum(directions @ aim.camera.R[2], 1e-9)
    sizes = size * np.hypot(1, aim.disks(hits.distance * forward) / 2)
    light = np.empty((len(pixels), 3))
    light[hits.patch < 0] = np.array(index.scene.background) / 255
    for patch in np.unique(hits.patch[hits.patch >= 0]).tolist():
        mine = np.flatnonzero(hits.patch == patch)
        light[mine] = _texture_light(index, patch, aim.among(mine), pixels[mine], sizes[mine])
    return light


def _texture_light(index: SceneIndex, number: int, aim: Aim, pixels: Array, sizes: Array) -> Array:
    """Return the texture of one patch under `pixels`, at the resolution that suits each."""
    patch, pyramid = index.scene.patches[number], index.pyramids[number]
    if not pyramid.highest.any():
        return np.broadcast_to(patch.texture[0, 0] / 255, (len(pixels), 3))
    repeat = np.array(patch.repeat)
    here, right, below = (
        np.stack(on_plane(patch, *at_rest(patch, *aim.rays(at), aim.times))[:2], axis=1) * repeat
        for at in (pixels, *(pixels + sizes[:, None] * step for step in np.eye(2)))
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
