"""Pictures of blocks with known truth: a vase on a turntable, and terrain flown in strips.

What `data_generators.blocks` makes of numbers, as pictures: tie points must be found in them.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.bundle import Observations
from course_lib.camera import Camera, camera_at
from course_lib.checks import (
    Array,
    check_count,
    check_generator,
    check_length,
    check_not_negative,
    check_points,
)
from course_lib.sensor import srgb_encode
from data_generators.blocks import nadir_poses, with_oblique
from data_generators.quick import QuickRenderer
from data_generators.raycast import SceneIndex, rays
from data_generators.scene import Scene
from data_generators.terrain import CELL, terrain
from data_generators.vase import vase

Picture = NDArray[np.uint8]

SIZE = 640, 480
#: A mark is seen if a ray to it ends no farther from it than this share of its length.
SAME = 1e-4


@dataclass(frozen=True, eq=False)
class BlockPictures:
    """Pictures of one thing from many sides, and the truth about them.

    Attributes
    ----------
    pictures : tuple of ndarray, shape (480, 640, 3), uint8
        RGB as a screen shows them, without distortion.
    cameras : tuple of Camera
        One for each; all have the same intrinsics.
    scene : Scene
        What was photographed, m.
    marks : ndarray, shape (n, 3)
        Survey marks on it, m: white discs with two black quarters.
    control, check : ndarray of int
        Numbers of the marks that orient the block, and of those that judge it.
    """

    pictures: tuple[Picture, ...]
    cameras: tuple[Camera, ...]
    scene: Scene
    marks: Array
    control: NDArray[np.intp]
    check: NDArray[np.intp]

    @property
    def K(self) -> Array:
        """The intrinsics of all cameras, px, shape (3, 3)."""
        return self.cameras[0].K

    @property
    def centres(self) -> Array:
        """Where the cameras stood, m, shape (v, 3)."""
        return np.array([camera.centre for camera in self.cameras])

    @cached_property
    def _index(self) -> SceneIndex:
        return SceneIndex(self.scene)

    def surface(self, number: int, pixels: ArrayLike) -> Array:
        """Return which points of the surface a picture shows.

        Parameters
        ----------
        number : int
            Of the picture, from 0.
        pixels : array_like, shape (N, 2) or (2,)
            Where, px.

        Returns
        -------
        ndarray, shape (N, 3) or (3,)
            Places, m; a row of NaN where there is only background.

        Raises
        ------
        TypeError, ValueError
            If the pixels are no pixels.
        """
        wanted = check_points(pixels, 2, "pixels")
        origins, directions = rays(self.cameras[number], wanted.reshape(-1, 2))
        distance = self._index.cast(origins, directions).distance
        distance = np.where(np.isfinite(distance), distance, np.nan)
        return (origins + distance[:, None] * directions).reshape(*wanted.shape[:-1], 3)

    def transferred(self, number: int, pixels: ArrayLike, other: int) -> Array:
        """Return where another picture shows (or hides) what one shows.

        Parameters
        ----------
        number, other : int
            Of the pictures, from 0.
        pixels : array_like, shape (N, 2)
            Where in the first, px.

        Returns
        -------
        ndarray, shape (N, 2)
            Where in the other, px; a row of NaN for background.
        """
        points = self.surface(number, pixels)
        seen = np.full((len(points), 2), np.nan)
        there = np.isfinite(points[:, 0])
        seen[there] = self.cameras[other].project(points[there])
        return seen

    def observed_marks(self, rng: np.random.Generator, sigma: float = 0.3) -> Observations:
        """Return where somebody who clicks on the survey marks in all pictures sees them.

        Parameters
        ----------
        rng : numpy.random.Generator
            Draws the errors.
        sigma : float
            Standard deviation of a coordinate, px.

        Returns
        -------
        Observations
            Cameras, numbers of the marks, pixels.
        """
        rng, sigma = check_generator(rng), float(check_not_negative(sigma, "sigma"))
        cameras, numbers, pixels = [], [], []
        for number, camera in enumerate(self.cameras):
            seen = camera.project(self.marks)
            inside = ((seen > 3) & (seen < np.array(camera.image_size) - 4)).all(axis=1)
            mine = np.flatnonzero(inside)
            away = np.linalg.norm(self.surface(number, seen[mine]) - self.marks[mine], axis=1)
            far = np.linalg.norm(self.marks[mine] - camera.centre, axis=1)
            mine = mine[away < SAME * far]
            cameras.append(np.full(len(mine), number))
            numbers.append(mine)
            pixels.append(seen[mine] + sigma * rng.standard_normal((len(mine), 2)))
        where = np.concatenate(cameras), np.concatenate(numbers), np.concatenate(pixels)
        return Observations(*where, sigma if sigma > 0 else 1.0)


def turntable_pictures(
    rng: np.random.Generator,
    pictures: int = 24,
    height: float = 0.45,
    arc: float = 2 * np.pi,
    noise: float = 1.5,
) -> BlockPictures:
    """Return pictures of a vase, 0.3 m high, from all around, as on a turntable.

    Parameters
    ----------
    rng : numpy.random.Generator
        For the pattern on the vase, and the noise.
    pictures : int
        How many.
    height : float
        Of the cameras above the plate, m; they are 1 m from the axis.
    arc : float
        How far around they stand, rad; a whole circle if not given.
    noise : float
        Standard deviation, grey levels.

    Returns
    -------
    BlockPictures
        Pictures and truth. Twelve marks: eight on the vase, four on the plate.

    Raises
    ------
    TypeError, ValueError
        If a number is not what is said above.
    """
    pictures, noise = check_count(pictures, "pictures", 2), check_noise(noise)
    arc, height = check_length(arc, "arc"), check_length(height, "height")
    scene, marks = vase(check_generator(rng))
    K = np.array([[1150.0, 0, 319.5], [0, 1150, 239.5], [0, 0, 1]])
    angles = arc * np.arange(pictures) / pictures
    eyes = [(np.cos(a), np.sin(a), height) for a in angles]
    cameras = tuple(camera_at(eye, (0, 0, 0.135), K, SIZE) for eye in eyes)
    control = np.array([0, 2, 5, 7, 8, 10])
    return _photographed(rng, scene, cameras, marks, control, noise)


def flight_pictures(
    rng: np.random.Generator,
    strips: int = 3,
    pictures: int = 5,
    overlap: tuple[float, float] = (0.75, 0.5),
    relief: float = 12.0,
    oblique: int = 0,
    noise: float = 1.5,
) -> BlockPictures:
    """Return pictures of hilly ground from 100 m above it, in parallel strips flown to and fro.

    Parameters
    ----------
    rng : numpy.random.Generator
        For the ground, the wind and the noise.
    strips, pictures : int
        Strips, and pictures in each.
    overlap : tuple of float
        Along a strip and between strips, as shares of the picture.
    relief : float
        Height of the hills above the valleys, m.
    oblique : int
        Pictures from around the area that look at its middle, in addition.
    noise : float
        Standard deviation, grey levels.

    Returns
    -------
    BlockPictures
        Pictures and truth. Twelve marks, in three rows of four: those at the corners and two
        in the middle are control.

    Raises
    ------
    TypeError, ValueError
        If a number is not what is said above.
    """
    strips, pictures = check_count(strips, "strips"), check_count(pictures, "pictures", 2)
    noise, rng = check_noise(noise), check_generator(rng)
    if not all(0 <= share < 1 for share in overlap):
        raise ValueError(f"overlap must be shares from 0 to less than 1, got {overlap}")
    K = np.array([[600.0, 0, 319.5], [0, 600, 239.5], [0, 0, 1]])
    sides = np.array(SIZE) * 100.0 / 600
    step, apart = (1 - np.array(overlap)) * sides
    R, C = with_oblique(*nadir_poses(rng, strips, pictures, step, apart, 100.0), oblique)
    margin = 0.75 * sides + (30.0 if oblique else 0.0)
    reach = np.array([step * (pictures - 1), apart * (strips - 1)])
    cells = np.ceil((reach + 2 * margin) / CELL).astype(int)
    spots = np.array([[x, y] for y in (0, 0.5, 1) for x in (0, 1 / 3, 2 / 3, 1)])
    marks = margin + reach / 2 + 1.24 * (spots - 0.5) * np.maximum(reach, 0.6 * sides)
    ground = terrain(rng, (int(cells[0]), int(cells[1])), relief, marks)
    C += np.array([*margin, relief / 2])
    cameras = tuple(Camera(K, r, -r @ c, SIZE) for r, c in zip(R, C, strict=True))
    control = np.array([0, 3, 5, 6, 8, 11])
    return _photographed(rng, ground.scene, cameras, ground.marks, control, noise)


def check_noise(noise: float) -> float:
    """Return a standard deviation in grey levels."""
    return float(check_not_negative(noise, "noise"))


def _photographed(
    rng: np.random.Generator,
    scene: Scene,
    cameras: tuple[Camera, ...],
    marks: Array,
    control: NDArray[np.intp],
    noise: float,
) -> BlockPictures:
    """Return what the cameras see."""
    renderer = QuickRenderer(scene)
    encoded = np.rint(255 * srgb_encode(np.arange(256) / 255)).astype(np.float32)
    pictures = []
    for camera in cameras:
        picture = encoded[renderer.picture(camera)]
        # Brightness varies from pixel to pixel; colour does not.
        picture += np.float32(noise) * rng.standard_normal((*picture.shape[:2], 1), np.float32)
        pictures.append(np.clip(np.rint(picture), 0, 255).astype(np.uint8))
    check = np.setdiff1d(np.arange(len(marks)), control)
    return BlockPictures(tuple(pictures), cameras, scene, marks, control, check)
