"""Pixels of the quick renderer: who is seen where, and in which colour. OpenCV does the work."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from course_lib.checks import Array
from data_generators.scene import Colour, Texture

Picture = NDArray[np.uint8]
Box = tuple[int, int, int, int]

SHIFT = 4  # binary digits of a subpixel in OpenCV's polygons


def fill_owners(polygons: Sequence[Array], image_size: tuple[int, int], n: int) -> NDArray[Any]:
    """Paint polygons, from back to front, into a map of who is seen where.

    Parameters
    ----------
    polygons : sequence of ndarray, shape (M, 2)
        Convex outlines, px.
    image_size : tuple of int
        Width and height, px.
    n : int
        Subpixels a pixel, both ways.

    Returns
    -------
    ndarray, shape (height n, width n)
        Index of the polygon plus 1, or 0 where there is none.
    """
    import cv2

    width, height = image_size
    owners = np.zeros((height * n, width * n), np.uint8 if len(polygons) < 255 else np.uint16)
    for number, polygon in enumerate(polygons, 1):
        # On the subpixel grid, whose first centre is at -0.5 + 0.5 / n px.
        grid = (polygon + 0.5) * n - 0.5
        cv2.fillConvexPoly(owners, np.rint(grid * 2**SHIFT).astype(np.int32), number, shift=SHIFT)
    return owners


def bounding_box(polygon: Array, image_size: tuple[int, int]) -> Box:
    """Return left, top, right, bottom (the last two excluded) of a polygon in the picture, px."""
    width, height = image_size
    (left, top), (right, bottom) = polygon.min(axis=0), polygon.max(axis=0)
    return (
        min(max(int(left) - 1, 0), width),
        min(max(int(top) - 1, 0), height),
        max(min(int(right) + 3, width), 0),
        max(min(int(bottom) + 3, height), 0),
    )


def share_of(owners: NDArray[Any], number: int, box: Box, n: int) -> Picture | None:
    """Return the share of each pixel of `box` that a piece owns, 0 to 255, or None for nothing."""
    import cv2

    left, top, right, bottom = box
    if right <= left or bottom <= top:
        return None
    mask = cv2.compare(owners[top * n : bottom * n, left * n : right * n], number, cv2.CMP_EQ)
    if not cv2.hasNonZero(mask):
        return None
    share = mask
    while share.shape[0] > bottom - top:  # halving twice is seven times as fast as a quarter
        half = (share.shape[1] // 2, share.shape[0] // 2)
        share = cv2.resize(share, half, interpolation=cv2.INTER_AREA)
    return np.asarray(cv2.merge([share, share, share]))


def add_colour(picture: Picture, share: Picture, box: Box, colour: Colour) -> None:
    """Add one colour, weighted by `share`, to the picture."""
    import cv2

    region = picture[box[1] : box[3], box[0] : box[2]]
    cv2.add(region, cv2.multiply(share, tuple(map(float, colour)), scale=1 / 255), dst=region)


def add_texture(
    picture: Picture,
    share: Picture,
    box: Box,
    texture: Texture,
    texel_from_pixel: Array,
    wrap: bool,
) -> None:
    """Add a warped texture, weighted by `share`, to the picture.

    Parameters
    ----------
    picture : ndarray, shape (height, width, 3), uint8
        Changed in place.
    share : ndarray, shape (h, w, 3), uint8
        Weight of each pixel of the box, 0 to 255.
    box : tuple of int
        Left, top, right, bottom, px.
    texture : ndarray, shape (m, n, 3), uint8
        At the resolution of the picture.
    texel_from_pixel : ndarray, shape (3, 3)
        Homography from pixels of the picture to those of the texture.
    wrap : bool
        Whether the texture repeats.
    """
    import cv2

    left, top, right, bottom = box
    picture_from_box = np.array([[1.0, 0.0, left], [0.0, 1.0, top], [0.0, 0.0, 1.0]])
    warped = cv2.warpPerspective(
        texture,
        texel_from_pixel @ picture_from_box,
        (right - left, bottom - top),
        flags=cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP,
        borderMode=cv2.BORDER_WRAP if wrap else cv2.BORDER_REPLICATE,
    )
    region = picture[top:bottom, left:right]
    cv2.add(region, cv2.multiply(warped, share, scale=1 / 255), dst=region)
