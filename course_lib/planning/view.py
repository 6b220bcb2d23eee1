"""What a camera sees of a box: whether all of it is in the picture, and how fine.

Lengths are metres. Use these functions through `course_lib.planning`.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from course_lib.camera import Camera
from course_lib.checks import (
    Array,
    DegenerateConfigurationError,
    check_direction,
    check_not_negative,
    check_number,
    check_numbers,
    check_positive,
    check_rotation,
    check_vector,
)
from course_lib.distortion import distort_pixels, normalised_from_pixels, valid_radius

ALONG = np.linspace(0, 1, 33)[:, None]  # of an edge: distortion bends it between its ends


@dataclass(frozen=True, eq=False, init=False)
class Box:
    """A box around what is to be measured.

    Attributes
    ----------
    size : ndarray, shape (3,)
        Lengths of its edges, m.
    centre : ndarray, shape (3,)
        Its middle in the world, m; the origin unless given.
    R : ndarray, shape (3, 3)
        Its columns are the directions of the edges in the world; those of the axes unless given.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, an edge has no length or `R` is not a rotation.
    """

    size: Array
    centre: Array
    R: Array

    def __init__(
        self, size: ArrayLike, centre: ArrayLike = (0, 0, 0), R: ArrayLike | None = None
    ) -> None:
        checked = check_positive(check_vector(size, 3, "size"), "size")
        object.__setattr__(self, "size", checked)
        object.__setattr__(self, "centre", check_vector(centre, 3, "centre"))
        object.__setattr__(self, "R", check_rotation(np.eye(3) if R is None else R))

    @property
    def corners(self) -> Array:
        """The eight corners in the world, shape (8, 3), m."""
        signs = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
        return self.centre + (signs * self.size / 2) @ self.R.T

    @property
    def edges(self) -> Array:
        """The two ends of each of the twelve edges in the world, shape (12, 2, 3), m."""
        # The binary digits of a corner's number are its sides; along an edge one digit changes.
        ends = [(n, n + step) for step in (4, 2, 1) for n in range(8) if not n & step]
        return np.asarray(self.corners[np.array(ends)])

    @property
    def outline(self) -> Array:
        """Points along the twelve edges in the world, shape (396, 3), m."""
        start, end = self.edges.swapaxes(0, 1)[:, :, None]
        return np.asarray((start + ALONG * (end - start)).reshape(-1, 3))

    def with_motion(self, motion: ArrayLike) -> Box:
        """Return the box that holds this one wherever it moves.

        Parameters
        ----------
        motion : float or array_like, shape (3,)
            How far it moves to both sides, along each edge, m; not negative.
        """
        moved = np.broadcast_to(check_not_negative(motion, "motion"), 3)
        return Box(self.size + 2 * moved, self.centre, self.R)


@dataclass(frozen=True, eq=False)
class BoxInView:
    """Whether a box is in a picture, and how much room it leaves.

    Attributes
    ----------
    inside : bool
        True if all of it is in the picture.
    margins : ndarray, shape (4,)
        Room left between the box and the picture's left, right, top and bottom edge, px; negative
        where the box is cut off, -inf if a part of it has no image.
    pixels : ndarray, shape (8, 2)
        Images of the corners; a row of NaN has none.
    reason : str
        In a sentence.
    """

    inside: bool
    margins: Array
    pixels: Array
    reason: str


def box_in_view(box: Box, camera: Camera, coefficients: ArrayLike = ()) -> BoxInView:
    """Return whether a whole box is in a camera's picture.

    Parameters
    ----------
    box : Box
        What is to be seen; with `Box.with_motion` wherever it moves.
    camera : Camera
        Where it stands and what it is; lengths in m.
    coefficients : array_like
        Distortion of its lens, in OpenCV's order.

    Returns
    -------
    BoxInView
        The answer, the room left, and why.

    Raises
    ------
    TypeError, ValueError
        If the coefficients are not a distortion model's.

    Notes
    -----
    Without distortion the corners decide, because a straight edge lies between its ends. With it
    edges are bent, so that points along them are looked at too. A ray outside of the model's valid
    radius has no image.

    Examples
    --------
    >>> from course_lib.camera import camera_at
    >>> K = np.array([[1000, 0, 319.5], [0, 1000, 239.5], [0, 0, 1]])
    >>> camera = camera_at([0, -2, 0], [0, 0, 0], K, (640, 480))
    >>> print(box_in_view(Box([1, 0.5, 0.5]), camera).reason)
    In the picture; the smallest room is 34 px, on the left.
    """
    points = box.outline
    pixels = image_of(np.vstack([box.corners, points]), camera, coefficients)
    seen, corners = pixels, pixels[:8]
    if np.isnan(seen).any():
        missing = int(np.isnan(corners).any(axis=1).sum())
        what = f"{missing} of 8 corners have" if missing else "A part of an edge has"
        reason = f"{what} no image: behind the camera, or outside of what its lens model describes."
        return BoxInView(False, np.full(4, -np.inf), corners, reason)
    width, height = camera.image_size
    left, top = seen.min(axis=0) + 0.5
    right, bottom = np.array([width, height]) - 0.5 - seen.max(axis=0)
    margins = np.array([left, right, top, bottom])
    side = ("on the left", "on the right", "at the top", "at the bottom")[int(margins.argmin())]
    least = float(margins.min())
    if least >= 0:
        reason = f"In the picture; the smallest room is {least:.0f} px, {side}."
    else:
        reason = f"Cut off by {-least:.0f} px {side}."
    return BoxInView(least >= 0, margins, corners, reason)


def image_of(points: Array, camera: Camera, coefficients: ArrayLike) -> Array:
    """Return the pixels of world points through a lens with distortion; NaN rows have no image."""
    pixels = camera.project(points)
    k = check_numbers(coefficients, "coefficients")
    if not k.size or not k.any():
        return pixels
    found = ~np.isnan(pixels).any(axis=1)
    radius = np.linalg.norm(normalised_from_pixels(pixels[found], camera.K), axis=1)
    bent = np.full_like(pixels, np.nan)
    bent[found] = distort_pixels(pixels[found], camera.K, k)
    bent[np.flatnonzero(found)[radius >= valid_radius(k)]] = np.nan
    return bent


def depth_range(box: Box, camera: Camera) -> tuple[float, float]:
    """Return how near and how far a box reaches along a camera's axis.

    Parameters
    ----------
    box : Box
        The box.
    camera : Camera
        Where it is seen from; lengths in m.

    Returns
    -------
    near, far : float
        Least and largest Z of its corners in the camera's frame, m. A negative one is behind it.
    """
    Z = (box.corners @ camera.R.T + camera.t)[:, 2]
    return float(Z.min()), float(Z.max())


def object_resolution(point: ArrayLike, normal: ArrayLike, camera: Camera) -> tuple[float, float]:
    """Return what one pixel covers on a surface: along its finest and its coarsest direction.

    Parameters
    ----------
    point : array_like, shape (3,)
        Where on the surface, in the world, m.
    normal : array_like, shape (3,)
        Direction across the surface there; its length and sign do not matter.
    camera : Camera
        The camera; lengths in m.

    Returns
    -------
    finest, coarsest : float
        m/px. On a surface that faces the camera both are ``Z pitch / f``; tilted by an angle, the
        coarsest is larger by about one over the cosine.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, the normal has no direction or the point is not in front of the camera.
    DegenerateConfigurationError
        If the surface is seen edge-on.

    References
    ----------
    T. Luhmann et al., Close-Range Photogrammetry and 3D Imaging, 4th ed., chapter 3 (image scale);
    the derivative of the pixel by the point, restricted to the surface.

    Examples
    --------
    >>> from course_lib.camera import camera_at
    >>> K = np.array([[1000, 0, 319.5], [0, 1000, 239.5], [0, 0, 1]])
    >>> camera = camera_at([0, -2, 0], [0, 0, 0], K, (640, 480))
    >>> [round(1000 * size, 3) for size in object_resolution([0, 0, 0], [0, -1, 0], camera)]
    [2.0, 2.0]
    """
    X = check_vector(point, 3, "point")
    n = check_direction(normal, "normal")
    x, y, w = camera.P @ np.append(X, 1)
    if check_number(w, "depth") <= 0:
        raise ValueError("point must be in front of the camera, got one behind it or in its plane")
    derivative = (camera.P[:2, :3] - np.outer([x / w, y / w], camera.P[2, :3])) / w  # px/m
    on_surface = derivative @ np.linalg.svd(n[None])[2][1:].T
    most, least = np.linalg.svd(on_surface, compute_uv=False)  # px/m
    if least <= 1e-9 * most:
        raise DegenerateConfigurationError(
            "the surface is seen edge-on: its points fall on a line; look at it from another side"
        )
    return float(1 / most), float(1 / least)
