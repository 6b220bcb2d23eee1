"""Pixels of the quick renderer: who is seen where, and in which colour. OpenCV does the work."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from course_lib.checks import Array
from data_generators.clipping import Polygons
from data_generators.scene import Texture

Picture = NDArray[np.uint8]
Box = tuple[int, int, int, int]

SHIFT = 4  # binary digits of a subpixel in OpenCV's polygons


def fill_owners(polygons: Polygons, image_size: tuple[int, int], n: int) -> NDArray[Any]:
    """Paint polygons, from back to front, into a map of who is seen where.

    Parameters
    ----------
    polygons : Polygons
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
    count = len(polygons.starts)
    owners = np.zeros((height * n, width * n), np.uint8 if count < 255 else np.uint16)
    # On the subpixel grid, whose first centre is at -0.5 + 0.5 / n px.
    grid = (polygons.corners + 0.5) * n - 0.5
    fixed = np.rint(grid * 2**SHIFT).astype(np.int32)
    bounds = zip(polygons.starts.tolist(), polygons.ends.tolist(), strict=True)
    for number, (start, end) in enumerate(bounds, 1):
        cv2.fillConvexPoly(owners, fixed[start:end], number, shift=SHIFT)
    return owners


def coloured(owners: NDArray[Any], colours: Picture, n: int) -> Picture:
    """Return the picture in which every piece has one colour.

    Parameters
    ----------
    owners : ndarray, shape (height n, width n)
        Who is seen where.
    colours : ndarray, shape (count + 1, 3), uint8
        Colour of nobody and of each piece; black for those that are added later.
    n : int
        Subpixels a pixel, both ways.

    Returns
    -------
    ndarray, shape (height, width, 3), uint8
        The mean over the subpixels of each pixel.
    """
    import cv2

    if owners.dtype == np.uint8:
        table = np.pad(colours, ((0, 256 - len(colours)), (0, 0)))
        picture = cv2.applyColorMap(owners, table[:, None])
    else:
        picture = colours[owners]
    while picture.shape[0] * n > owners.shape[0]:
        half = (picture.shape[1] // 2, picture.shape[0] // 2)
        picture = cv2.resize(picture, half, interpolation=cv2.INTER_AREA)
    return np.asarray(picture, np.uint8)


def bounding_boxes(polygons: Polygons, image_size: tuple[int, int]) -> list[Box]:
    """Return left, top, right, bottom (the last two excluded) of polygons in the picture, px."""
    low = np.clip(np.floor(polygons.low()) - 1, 0, image_size).astype(int)
    high = np.clip(np.ceil(polygons.high()) + 2, 0, image_size).astype(int)
    return [(*first, *last) for first, last in zip(low.tolist(), high.tolist(), strict=True)]


def share_of(
    owners: NDArray[Any], number: int, box: Box, n: int
) -> tuple[Picture, Box] | tuple[None, None]:
    """Return the share of each pixel that a piece owns, 0 to 255, and the box where it does.

    Parameters
    ----------
    owners : ndarray, shape (height n, width n)
        Who is seen where.
    number : int
        The piece.
    box : tuple of int
        Where to look: left, top, right, bottom, px.
    n : int
        Subpixels a pixel, both ways.

    Returns
    -------
    share : ndarray, shape (h, w, 3), uint8, or None
        The same in all three colours; None if it is seen nowhere.
    box : tuple of int, or None
        The part of `box` where the share is not 0.
    """
    import cv2

    left, top, right, bottom = box
    if right <= left or bottom <= top:
        return None, None
    share = cv2.compare(owners[top * n : bottom * n, left * n : right * n], number, cv2.CMP_EQ)
    while share.shape[0] > bottom - top:  # halving twice is seven times as fast as a quarter
        half = (share.shape[1] // 2, share.shape[0] // 2)
        share = cv2.resize(share, half, interpolation=cv2.INTER_AREA)
    x, y, width, height = cv2.boundingRect(share)
    if width == 0:
        return None, None
    share = share[y : y + height, x : x + width]
    box = (left + x, top + y, left + x + width, top + y + height)
    return np.asarray(cv2.cvtColor(share, cv2.COLOR_GRAY2RGB)), box  # merging takes twice as long


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
    texture : ndarray, shape (m, n, 4), uint8
        At the resolution of the picture; the fourth channel is not looked at.
    texel_from_pixel : ndarray, shape (3, 3)
        Homography from pixels of the picture to those of the texture.
    wrap : bool
        Whether the texture repeats.
    """
    import cv2

    left, top, right, bottom = box
    texel_from_box = texel_from_pixel.copy()
    texel_from_box[:, 2] = texel_from_pixel @ (left, top, 1)
    warped = cv2.warpPerspective(
        texture,
        texel_from_box,
        (right - left, bottom - top),
        flags=cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP,
        borderMode=cv2.BORDER_WRAP if wrap else cv2.BORDER_REPLICATE,
    )
    colours = cv2.cvtColor(warped, cv2.COLOR_RGBA2RGB)
    region = picture[top:bottom, left:right]
    cv2.add(region, cv2.multiply(colours, share, scale=1 / 255, dst=colours), dst=region)
