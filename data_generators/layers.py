"""A scene cut into layers by distance, each drawn as if nothing stood before it.

What a near thing hides is there in the layer behind it, so that a lens can look past its edge.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from course_lib.camera import Camera
from course_lib.checks import Array
from data_generators.clipping import FORWARD, Polygons, clip
from data_generators.disks import GRID, WIDEST
from data_generators.paint import Picture
from data_generators.quick import QuickRenderer

EDGES = (0.35, 0.7, 1.4, 2.8, 5.6, 11.2, 30.0)  # m: where layers meet
FLAT = 1.02  # farthest by nearest distance of what counts as facing the camera
MOST = 8  # groups between two edges; where there would be more, all are drawn together
OVERLAP = 1.25  # a surface goes on before the edge of its layer, to a distance smaller by this


@dataclass(frozen=True, eq=False)
class Layer:
    """Part of a picture that lies between two distances.

    Attributes
    ----------
    left, top : int
        Where it lies in the picture, px.
    rgba : ndarray, shape (h, w, 4), uint8
        Colour times opacity, and opacity.
    nearness : ndarray, shape (h, w), uint8
        1 / Z, from `far` at 0 to `near` at 255.
    far, near : float
        Least and greatest 1 / Z, 1 / m.
    """

    left: int
    top: int
    rgba: Picture
    nearness: Picture
    far: float
    near: float

    def reduced(self, times: int) -> tuple[Picture, Picture]:
        """Return `rgba` and `nearness`, halved a number of times; both are kept."""
        return self._halved[times]

    @cached_property
    def _halved(self) -> list[tuple[Picture, Picture]]:
        import cv2

        both = [(self.rgba, self.nearness)]
        for _ in WIDEST:
            height, width = both[-1][1].shape
            size = (width // 2, height // 2)
            rgba, nearness = (
                cv2.resize(each, size, interpolation=cv2.INTER_AREA) for each in both[-1]
            )
            both.append((np.asarray(rgba, np.uint8), np.asarray(nearness, np.uint8)))
        return both


def layers(
    renderer: QuickRenderer, camera: Camera, edges: tuple[float, ...] = EDGES
) -> list[Layer]:
    """Return what a camera sees, in layers from back to front.

    Parameters
    ----------
    renderer : QuickRenderer
        Draws the scene.
    camera : Camera
        The camera; its width and height in multiples of 16 px.
    edges : tuple of float
        Distances along the axis at which the scene is cut, increasing, m.

    Returns
    -------
    list of Layer
        Those in which something is seen.
    """
    patches, parts = renderer.pieces(camera)
    if not patches:
        return []
    found: list[Layer | None] = []
    reach = _reach(patches, parts)
    for near, far in reversed(list(pairwise([0.0, *edges, np.inf]))):
        owners, cut = _between(near, far, patches, parts, reach)
        for group in _groups(cut):
            members = [owners[i] for i in group], [cut[i] for i in group]
            found.append(_layer(renderer, camera, *members))
    return [layer for layer in found if layer]


def _reach(patches: list[int], parts: list[Array]) -> Array:
    """Return the least and greatest Z of each piece, and of all pieces of its patch, (4, N), m."""
    together, each = Polygons.of(parts), np.array(patches)
    low, high = together.low()[:, 2], together.high()[:, 2]
    nearest, farthest = np.full(each.max() + 1, np.inf), np.zeros(each.max() + 1)
    np.minimum.at(nearest, each, low)
    np.maximum.at(farthest, each, high)
    return np.stack([low, high, nearest[each], farthest[each]])


def _between(
    near: float, far: float, patches: list[int], parts: list[Array], reach: Array
) -> tuple[list[int], list[Array]]:
    """Return the pieces, cut, between two distances, and the patch that each is part of.

    A patch that goes on before the near edge keeps a strip of it.
    """
    low, high, nearest, farthest = reach
    crosses = (nearest < near) & (near < farthest)
    starts = np.where(crosses, near / OVERLAP, near)
    owners, cut = [], []
    for i in np.flatnonzero((high > starts) & (low < far)).tolist():
        polygon = clip(parts[i], FORWARD, starts[i]) if low[i] < starts[i] else parts[i]
        polygon = clip(polygon, -FORWARD, -far) if high[i] > far else polygon
        if len(polygon) > 2:
            owners.append(patches[i])
            cut.append(polygon)
    return owners, cut


def _groups(parts: list[Array]) -> list[list[int]]:
    """Return which pieces are drawn together: neighbours that both face the camera at one Z.

    A card and the floor it stands on are not of one depth, and need blurs of their own. Pieces
    that are slanted stay together, so that no seam is seen where they meet.
    """
    groups: list[list[int]] = []
    last: tuple[float, float] | None = None
    for i, part in enumerate(parts):
        low, high = float(part[:, 2].min()), float(part[:, 2].max())
        flat = (low, high) if high < FLAT * low else None
        together = last is None and flat is None
        if last and flat:
            together = max(last[1], high) < FLAT * min(last[0], low)
        if groups and together:
            groups[-1].append(i)
        else:
            groups.append([i])
        last = flat
    return groups if len(groups) <= MOST else [list(range(len(parts)))]


def _layer(
    renderer: QuickRenderer, camera: Camera, patches: list[int], parts: list[Array]
) -> Layer | None:
    """Return one layer from its pieces, or None if they are outside the picture."""
    import cv2

    box = _box(parts, camera)
    if box is None:
        return None
    left, top, right, bottom = box
    K = camera.K.copy()
    K[:2, 2] -= left, top
    crop = Camera(K, camera.R, camera.t, (right - left, bottom - top))
    picture, owners = renderer.painted(patches, parts, crop, (0, 0, 0))
    alpha = cv2.compare(owners, 0, cv2.CMP_NE)
    while alpha.shape[0] > bottom - top:
        half = (alpha.shape[1] // 2, alpha.shape[0] // 2)
        alpha = cv2.resize(alpha, half, interpolation=cv2.INTER_AREA)
    rgba = np.asarray(cv2.merge([*cv2.split(picture), alpha]), np.uint8)
    inverse = np.concatenate([1 / part[:, 2] for part in parts])
    span = float(inverse.min()), float(inverse.max())
    if span[1] < span[0] * FLAT:
        return Layer(left, top, rgba, np.zeros_like(alpha), *span)
    # A pixel belongs to the frontmost piece that any of its corners shows.
    n, slopes = renderer.subpixels, _nearness_slopes(renderer, crop, patches)
    owner = np.maximum.reduce([owners[i::n, j::n] for i in {0, n - 1} for j in {0, n - 1}])
    return Layer(left, top, rgba, _nearness(owner, slopes, span), *span)


def _box(parts: list[Array], camera: Camera) -> tuple[int, int, int, int] | None:
    """Return left, top, right, bottom of pieces on the grid, or None outside the picture."""
    seen = Polygons.of(parts).seen_through(camera.K)
    low = np.floor(seen.low().min(axis=0) / GRID).astype(int) * GRID
    high = np.ceil((seen.high().max(axis=0) + 1) / GRID).astype(int) * GRID
    left, top = np.maximum(low, 0).tolist()
    right, bottom = np.minimum(high, camera.image_size).tolist()
    return (left, top, right, bottom) if right > left and bottom > top else None


def _nearness_slopes(renderer: QuickRenderer, camera: Camera, patches: list[int]) -> Array:
    """Return (3, N): 1 / Z at a pixel (u, v) of each piece is the product with (u, v, 1)."""
    normals = renderer.normals[patches] @ camera.R.T
    origins = renderer.origins[patches] @ camera.R.T + camera.t
    # Z n·(K⁻¹ u) = n·X for a point X of the plane.
    distance = np.sum(normals * origins, axis=1)
    return np.asarray((normals @ np.linalg.inv(camera.K) / distance[:, None]).T)


def _nearness(owner: NDArray[Any], slopes: Array, span: tuple[float, float]) -> NDArray[np.uint8]:
    """Return 1 / Z of the owner of each pixel, the span spread over 0 to 255."""
    import cv2

    (far, near), (height, width) = span, owner.shape
    scale = 255 / max(near - far, 1e-9)
    values = np.pad(slopes * scale, ((0, 0), (1, 0))).astype(np.float32)
    values[2, 1:] -= np.float32(far * scale)
    if owner.dtype == np.uint8:
        tables = np.pad(values, ((0, 0), (0, 256 - values.shape[1])))
        du, dv, start = (cv2.LUT(np.ascontiguousarray(owner), table) for table in tables)
    else:
        du, dv, start = values[:, owner]
    du *= np.arange(width, dtype=np.float32)
    dv *= np.arange(height, dtype=np.float32)[:, None]
    start += du
    start += dv
    return np.asarray(cv2.convertScaleAbs(np.maximum(start, 0, out=start)))
