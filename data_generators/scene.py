"""What stands before the camera: flat, textured patches, and things made of them.

The world has z up and is measured in metres. A texture holds radiances as `uint8` RGB, linear in
light. Its columns run along ``edge_u`` and its rows along ``edge_v``: seen from the front, u runs
to the right and v downwards.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.checks import Array, DegenerateConfigurationError, check_points, check_vector
from data_generators.motion import Motion

Texture = NDArray[np.uint8]
Colour = tuple[int, int, int]

UNIT_SQUARE = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])


def check_texture(texture: ArrayLike) -> Texture:
    """Return `texture` as a `uint8` RGB picture, grey ones and single colours spread out.

    Parameters
    ----------
    texture : array_like, shape (h, w, 3), (h, w) or (3,), uint8
        RGB, grey, or one colour.

    Returns
    -------
    ndarray, shape (h, w, 3), uint8
        The picture.

    Raises
    ------
    TypeError, ValueError
        If the numbers are not whole and from 0 to 255, or the shape is none of these.
    """
    array = np.asarray(texture)
    if array.dtype.kind not in "iu":
        raise TypeError(f"a texture must be made of whole numbers 0...255, got {array.dtype}")
    if array.size == 0 or array.min() < 0 or array.max() > 255:
        raise ValueError("a texture must hold numbers from 0 to 255 and at least one pixel")
    if array.ndim == 2:
        array = np.repeat(array[..., None], 3, axis=2)
    if array.shape == (3,):
        array = array[None, None]
    if array.ndim != 3 or array.shape[2] != 3:
        raise ValueError(f"a texture must have shape (h, w, 3), (h, w) or (3,), got {array.shape}")
    return np.ascontiguousarray(array, dtype=np.uint8)


@dataclass(frozen=True, eq=False)
class Patch:
    """A flat piece of the world with a texture on it.

    A point of it is ``origin + a edge_u + b edge_v`` with (a, b) inside `outline`.

    Attributes
    ----------
    origin, edge_u, edge_v : ndarray, shape (3,)
        The texture's top-left corner and its edges to the right and down, m, world frame.
    texture : ndarray, shape (h, w, 3), uint8
        Radiance; a grey picture or one colour is accepted.
    outline : ndarray, shape (M, 2)
        Convex outline in (a, b), in order around; the unit square by default.
    repeat : tuple of float
        How many times the texture fits along u and v.
    one_sided : bool
        Whether the patch is invisible from behind, as the face of a closed body.
    motion : Motion, optional
        How it moves while the picture is taken. `data_generators.quick` shows time 0.

    Raises
    ------
    TypeError, ValueError
        If a shape or texture is wrong.
    DegenerateConfigurationError
        If the edges are parallel or zero.
    """

    origin: Array
    edge_u: Array
    edge_v: Array
    texture: Texture
    outline: Array = field(default_factory=UNIT_SQUARE.copy)
    repeat: tuple[float, float] = (1.0, 1.0)
    one_sided: bool = False
    motion: Motion | None = None

    def __post_init__(self) -> None:
        for name in ("origin", "edge_u", "edge_v"):
            object.__setattr__(self, name, check_vector(getattr(self, name), 3, name))
        object.__setattr__(self, "texture", check_texture(self.texture))
        object.__setattr__(self, "outline", check_points(self.outline, 2, "outline"))
        if self.outline.ndim != 2 or len(self.outline) < 3:
            raise ValueError(f"outline must have three corners or more, got {self.outline.shape}")
        area = np.linalg.norm(np.cross(self.edge_u, self.edge_v))
        if area <= 1e-12 * np.linalg.norm(self.edge_u) * np.linalg.norm(self.edge_v):
            raise DegenerateConfigurationError("the edges of the patch are parallel or zero")

    @property
    def corners(self) -> Array:
        """Corners of the outline in the world, shape (M, 3), m."""
        return self.origin + self.outline @ np.stack([self.edge_u, self.edge_v])

    @property
    def normal(self) -> Array:
        """Unit normal on the side from which the patch is seen, shape (3,)."""
        normal = np.cross(self.edge_v, self.edge_u)
        return np.asarray(normal / np.linalg.norm(normal))


@dataclass(frozen=True, eq=False)
class Scene:
    """Patches, and the colour where there are none.

    Attributes
    ----------
    patches : tuple of Patch
        They may touch but not cut through each other.
    background : tuple of int
        RGB radiance, 0 to 255.
    """

    patches: tuple[Patch, ...]
    background: Colour = (205, 225, 245)

    def __post_init__(self) -> None:
        object.__setattr__(self, "patches", tuple(self.patches))
        if not all(isinstance(patch, Patch) for patch in self.patches):
            raise TypeError("a scene is made of Patch objects; put lists of them together with +")


def moving(patches: Iterable[Patch], motion: Motion) -> list[Patch]:
    """Return the same patches, in motion."""
    return [replace(patch, motion=motion) for patch in patches]


def polygon(corners: ArrayLike, colour: ArrayLike, one_sided: bool = False) -> Patch:
    """Return a patch of one colour from its corners.

    Parameters
    ----------
    corners : array_like, shape (M, 3)
        Convex and flat, m; clockwise as seen from the front.
    colour : array_like, shape (3,)
        RGB radiance, 0 to 255.
    one_sided : bool
        Whether it is invisible from behind.

    Returns
    -------
    Patch
        The patch.

    Raises
    ------
    ValueError
        If there are fewer than three corners or they are not in one plane.
    """
    corners = check_points(corners, 3, "corners")
    if corners.ndim != 2 or len(corners) < 3:
        raise ValueError(f"a polygon needs three corners or more, got shape {corners.shape}")
    origin, edge_u, edge_v = corners[0], corners[1] - corners[0], corners[-1] - corners[0]
    basis = np.stack([edge_u, edge_v])
    outline = (corners - origin) @ np.linalg.pinv(basis)
    if np.abs(origin + outline @ basis - corners).max() > 1e-6 * np.abs(basis).max():
        raise ValueError("the corners of a polygon must lie in one plane")
    return Patch(origin, edge_u, edge_v, np.asarray(colour), outline, one_sided=one_sided)


def shaded(texture: ArrayLike, normal: ArrayLike, sun: ArrayLike = (-0.5, -0.6, 0.8)) -> Texture:
    """Return a texture as the sun lights it: by the cosine of its angle, plus light of the sky.

    Parameters
    ----------
    texture : array_like
        As for `Patch`.
    normal : array_like, shape (3,)
        Unit normal of the surface.
    sun : array_like, shape (3,)
        Direction to the sun, of any length.

    Returns
    -------
    ndarray, shape (h, w, 3), uint8
        The darkened texture.
    """
    sun = np.asarray(sun, float)
    cosine = max(0.0, float(np.asarray(normal) @ sun / np.linalg.norm(sun)))
    light = np.array([0.40, 0.42, 0.47]) + np.array([0.60, 0.58, 0.53]) * cosine
    return np.rint(check_texture(texture) * light).astype(np.uint8)


def box(
    corner: ArrayLike,
    size: ArrayLike,
    sides: Texture | Sequence[Texture],
    top: Texture,
    turn: float = 0.0,
) -> list[Patch]:
    """Return the five visible faces of an upright box, shaded by the sun.

    Parameters
    ----------
    corner : array_like, shape (3,)
        The lower corner with the smallest x and y before turning, m.
    size : array_like, shape (3,)
        Along x, y and z, m.
    sides : texture or sequence of four
        Of the faces to the south (-y), east (+x), north and west; arrays, or a list of them.
    top : texture
        Of the top, u along x, seen from above.
    turn : float
        Rotation about the vertical through `corner`, rad.

    Returns
    -------
    list of Patch
        South, east, north, west, top; visible from outside.

    Raises
    ------
    TypeError, ValueError
        If a size or texture is wrong, or there are not four sides.
    """
    x, y, z = check_vector(size, 3, "size")
    c, s = np.cos(turn), np.sin(turn)
    along, across, up = x * np.array([c, s, 0]), y * np.array([-s, c, 0]), np.array([0, 0, z])
    base = check_vector(corner, 3, "corner")
    four = list(sides) if isinstance(sides, list | tuple) else [sides] * 4
    if len(four) != 4:
        raise ValueError(f"sides must be one texture or a list of four, got {len(four)}")
    faces = [
        (base + up, along, -up, four[0]),
        (base + along + up, across, -up, four[1]),
        (base + along + across + up, -along, -up, four[2]),
        (base + across + up, -across, -up, four[3]),
        (base + across + up, along, -across, top),
    ]
    return [lit_patch(origin, u, v, texture) for origin, u, v, texture in faces]


def lit_patch(origin: Array, edge_u: Array, edge_v: Array, texture: ArrayLike) -> Patch:
    """Return a one-sided patch whose texture is shaded by the sun."""
    normal = np.cross(edge_v, edge_u)
    texture = shaded(texture, normal / np.linalg.norm(normal))
    return Patch(origin, edge_u, edge_v, texture, one_sided=True)
