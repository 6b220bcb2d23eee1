"""Rendered pictures of boards with all that calibration wants to find out: the truth is known.

The world is the board's own frame, in the board's unit of length: x along its rows, y down its
columns, z away from the viewer.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.boards import Board, Checkerboard
from course_lib.camera import Camera
from course_lib.checks import Array, check_numbers
from course_lib.distortion import distort_pixels
from course_lib.transforms import look_at
from data_generators.board_scenes import board_scene, on_board
from data_generators.flaws import FLAWS, Flaw, Flaws, flawed
from data_generators.render import radiance
from data_generators.shot import Shot, numbers

#: The camera of `calibration_set` for a picture of 640 × 480 px.
FOCAL, CENTRE, SIZE = (560.0, 558.0), (322.4, 241.7), (640, 480)
COEFFICIENTS = (-0.28, 0.1, 0.0005, -0.0003, 0.0)
BACKGROUND = (110, 110, 110)
#: Tilts of the board in views, and its distance by that from which it fills the picture.
TILT, NEAREST, FARTHEST = np.radians(40), 1.1, 1.9
MARGIN = 0.02  # of the picture's width that stays free around the points


@dataclass(frozen=True, eq=False)
class RenderedView:
    """A picture of a board, and where everything was.

    Attributes
    ----------
    picture : ndarray, shape (height, width), uint8
        Grey levels, linear in light.
    R, t : ndarray, shape (3, 3) and (3,)
        Pose of the board: ``X_camera = R X_board + t``.
    points : ndarray, shape (N, 2)
        Where the board's points are in the picture, px; also those outside of it.
    flaw : str
        What is wrong with it: ``""``, ``"blurred"``, ``"glare"``, ``"cut off"`` or ``"bent"``.
    """

    picture: NDArray[np.uint8]
    R: Array
    t: Array
    points: Array
    flaw: str = ""


@dataclass(frozen=True, eq=False)
class CalibrationSet:
    """Pictures of one board by one camera.

    Attributes
    ----------
    board : Checkerboard, DotGrid, Charuco or SquareGrid
        What is in the pictures.
    K : ndarray, shape (3, 3)
        Intrinsics, px.
    coefficients : ndarray
        Distortion as in `course_lib.distortion.distort`.
    image_size : tuple of int
        Width and height, px.
    views : tuple of RenderedView
        The pictures.
    """

    board: Board
    K: Array
    coefficients: Array
    image_size: tuple[int, int]
    views: tuple[RenderedView, ...] = field(default_factory=tuple)


def calibration_set(
    count: int = 10,
    *,
    rng: np.random.Generator,
    board: Board | None = None,
    image_size: tuple[int, int] = SIZE,
    coefficients: ArrayLike = COEFFICIENTS,
    flaws: Mapping[int, Flaw] | None = None,
    noise: float = 2.0,
    blur: float = 0.7,
    samples: int = 2,
) -> CalibrationSet:
    """Return pictures of a board, near and far, tilted all ways, in all parts of the picture.

    Parameters
    ----------
    count : int
        How many.
    rng : numpy.random.Generator
        Decides on poses and noise.
    board : Checkerboard, DotGrid, Charuco or SquareGrid, optional
        9 × 6 corners of 30 mm by default.
    image_size : tuple of int
        Width and height, px; the field of view is 60° whatever they are.
    coefficients : array_like
        Distortion as in `course_lib.distortion.distort`.
    flaws : mapping of int to str, optional
        What is wrong with which view: ``{3: "blurred"}``. ``"blurred"``, ``"glare"``,
        ``"cut off"`` or ``"bent"``.
    noise, blur, samples
        As for `rendered_view`.

    Returns
    -------
    CalibrationSet
        The same arguments (and the same state of `rng`) give the same pictures.

    Raises
    ------
    TypeError, ValueError
        If a flaw is not one of these, or a view that has one is not among them.
    """
    flaws = dict(flaws or {})
    wrong = {number: flaw for number, flaw in flaws.items() if flaw not in FLAWS or number >= count}
    if wrong:
        raise ValueError(f"flaws must be {FLAWS} of views 0 to {count - 1}, got {wrong}")
    board = board or Checkerboard(9, 6, 30.0)
    scale = image_size[0] / SIZE[0]
    K = np.array([[FOCAL[0], 0, CENTRE[0]], [0, FOCAL[1], CENTRE[1]], [0, 0, 1]])
    K[:2, :2] *= scale
    # The upper left corner of the picture is at -0.5.
    K[:2, 2] = scale * (K[:2, 2] + 0.5) - 0.5
    k = check_numbers(coefficients, "coefficients")
    views = []
    for number in range(count):
        flaw = flaws.get(number, "")
        camera = _camera(board, K, k, image_size, rng, cut=flaw == "cut off")
        settings = Flaws(flaw, blur * scale, noise)
        views.append(rendered_view(board, camera, k, settings, rng=rng, samples=samples))
    return CalibrationSet(board, K, k, image_size, tuple(views))


def rendered_view(
    board: Board,
    camera: Camera,
    coefficients: ArrayLike,
    flaws: Flaws | None = None,
    *,
    rng: np.random.Generator,
    samples: int = 2,
) -> RenderedView:
    """Return one picture of a board.

    Parameters
    ----------
    board : Checkerboard, DotGrid, Charuco or SquareGrid
        What is in the picture.
    camera : Camera
        Its world is the board's frame.
    coefficients : array_like
        Distortion as in `course_lib.distortion.distort`.
    flaws : Flaws, optional
        Blur, noise, and what is wrong.
    rng : numpy.random.Generator
        For the noise, and where the glare is.
    samples : int
        Rays a pixel, along each axis.

    Returns
    -------
    RenderedView
        The picture and its truth.

    Raises
    ------
    TypeError, ValueError
        As `course_lib.distortion.distort` and `data_generators.render.radiance`.
    """
    flaws = flaws or Flaws()
    k = check_numbers(coefficients, "coefficients")
    scene = board_scene(board, BACKGROUND, flaws.bend(board))
    light = radiance(scene, camera, samples, Shot(distortion=k))[..., 1]
    points = image_points(camera, k, on_board(board, flaws.bend(board)))
    light = flawed(light, flaws, points, rng)
    return RenderedView(numbers(light), camera.R, camera.t, points, flaws.flaw)


def image_points(camera: Camera, coefficients: Array, points: Array) -> Array:
    """Return where points of the board are in the picture, shape (N, 2), px."""
    return distort_pixels(camera.project(points), camera.K, coefficients)


def _camera(
    board: Board,
    K: Array,
    k: Array,
    size: tuple[int, int],
    rng: np.random.Generator,
    cut: bool,
    tries: int = 500,
) -> Camera:
    """Return a camera that sees the whole board, or if it is to be cut off, most of it."""
    points = board.points()
    middle, extent = points.mean(axis=0), np.ptp(points, axis=0)
    fills = max(extent[0] * K[0, 0] / size[0], extent[1] * K[1, 1] / size[1])
    for _ in range(tries):
        tilt, way = TILT * np.sqrt(rng.uniform()), rng.uniform(0, 2 * np.pi)
        away = np.array([np.sin(tilt) * np.cos(way), np.sin(tilt) * np.sin(way), -np.cos(tilt)])
        eye = middle + away * fills * rng.uniform(NEAREST, FARTHEST)
        turn = rng.uniform(-0.5, 0.5)
        R, t = look_at(eye, middle, (np.sin(turn), -np.cos(turn), 0))
        camera = Camera(K, R, t, size)
        shift = (rng.uniform(0.05, 0.95, 2) * size - np.array(size) / 2) / K[[0, 1], [0, 1]]
        camera = Camera(K, R, t + t[2] * np.array([*shift, 0]), size)
        pixels = image_points(camera, k, points)
        if _as_wanted(pixels, size, cut):
            return camera
    raise ValueError(f"no view of {board.name} was found in {tries} tries: make the picture larger")


def _as_wanted(pixels: Array, size: Sequence[int], cut: bool) -> bool:
    """Return whether all points are in the picture, or of a board cut off, two thirds or more."""
    margin = MARGIN * size[0]
    inside = ((pixels > margin) & (pixels < np.array(size) - 1 - margin)).all(axis=1)
    return bool(0.65 < inside.mean() < 0.9) if cut else bool(inside.all())


__all__ = [
    "CalibrationSet",
    "Flaw",
    "Flaws",
    "Literal",
    "RenderedView",
    "calibration_set",
    "image_points",
    "rendered_view",
]
