"""Photographs through a lens in a few milliseconds, for pictures that follow a slider.

The scene is drawn in layers (`data_generators.layers`); each is blurred by the disks of its
distances, and laid over those behind it. `data_generators.render` makes the same picture from
rays through all of the lens; a test compares the two.
"""

from __future__ import annotations

import numpy as np

from course_lib.camera import Camera
from course_lib.checks import Array
from data_generators.disks import GRID, WIDEST, kernel, reduction
from data_generators.layers import EDGES, Layer, layers
from data_generators.lens import Lens
from data_generators.paint import Box, Picture
from data_generators.quick import QuickRenderer
from data_generators.scene import Colour, Scene

STEP = 0.35  # of ln(1 + D / 2): how much the diameters D of neighbouring blurs differ
OPAQUE = 250  # of 255: what counts as opaque after some rounding
ALIKE = 0.5  # px: diameters that differ less need not be told apart


class DefocusedView:
    """One scene through lenses and cameras that change.

    Parameters
    ----------
    scene : Scene
        What to draw.
    subpixels : int
        As for `QuickRenderer`.
    margin : int
        How far beyond the edge of the picture the surroundings are drawn, px; their light
        reaches into the picture. Farther out, the margin's edge goes on.
    edges : tuple of float
        Distances at which the scene is cut into layers, m.
    breathes : bool
        Whether the view narrows as the lens focuses nearer, as K of `Lens.intrinsics` says. The
        scene is then drawn once, as focused at infinity, and magnified: to within a thousandth.

    Examples
    --------
    The camera's matrix K belongs to the lens as it is focused. As long as the camera stays the
    same, only the blur is made anew:

    >>> from data_generators.places import street
    >>> from course_lib.camera import camera_at
    >>> view, lens = DefocusedView(street()), Lens(f=50, N=2, focus_distance=4000)
    >>> K = lens.intrinsics(pitch=0.225, image_size=(160, 120))
    >>> camera = camera_at((0, -2, 1.5), (0, 10, 1.5), K, (160, 120))
    >>> view.picture(camera, lens).shape
    (120, 160, 3)
    """

    def __init__(
        self,
        scene: Scene,
        subpixels: int = 2,
        margin: int = 16,
        edges: tuple[float, ...] = EDGES,
        breathes: bool = True,
    ) -> None:
        self.renderer = QuickRenderer(scene, subpixels)
        self.margin, self.edges, self.breathes = margin, edges, breathes
        self._camera: Camera | None = None
        self._layers: list[Layer] = []
        self._base: Picture = np.empty((0, 0, 4), np.uint8)

    def picture(self, camera: Camera, lens: Lens) -> Picture:
        """Return what a camera with a lens sees.

        Parameters
        ----------
        camera : Camera
            The camera, in the scene's world; K as of `Lens.intrinsics`.
        lens : Lens
            Its lens.

        Returns
        -------
        ndarray, shape (height, width, 3), uint8
            RGB, linear in light.
        """
        import cv2

        narrowing = lens.image_distance / lens.f if self.breathes else 1.0
        reference = _widened(camera, narrowing)
        self._prepare(reference)
        canvas = self._base.copy()
        for layer in self._layers:
            inverse = np.linspace(layer.far, layer.near, 256)
            with np.errstate(divide="ignore"):
                disks = lens.disks(1 / inverse, camera) / narrowing
            _lay_over(canvas, layer, disks)
        columns, rows = _inside(camera, narrowing, self.margin)
        picture = cv2.cvtColor(canvas[rows, columns], cv2.COLOR_RGBA2RGB)
        if picture.shape[1::-1] != camera.image_size:
            picture = cv2.resize(picture, camera.image_size, interpolation=cv2.INTER_CUBIC)
        return np.asarray(picture)

    def _prepare(self, camera: Camera) -> None:
        """Draw the layers that a camera sees, unless they are those of the last picture."""
        if self._camera is None or not _same(self._camera, camera):
            size = (-(-(side + 2 * self.margin) // GRID) * GRID for side in camera.image_size)
            K = camera.K.copy()
            K[:2, 2] += self.margin
            wide = Camera(K, camera.R, camera.t, (next(size), next(size)))
            self._layers = layers(self.renderer, wide, self.edges)
            self._base = backing(self._layers, wide.image_size, self.renderer.scene.background)
            self._camera = camera


def _widened(camera: Camera, narrowing: float) -> Camera:
    """Return the camera with a shorter focal length."""
    K = camera.K.copy()
    K[:2, :2] /= narrowing
    return Camera(K, camera.R, camera.t, camera.image_size)


def _inside(camera: Camera, narrowing: float, margin: int) -> tuple[slice, slice]:
    """Return columns and rows of the wider camera's picture that the narrower one sees."""
    sides = []
    for size, centre in zip(camera.image_size, camera.K[:2, 2].tolist(), strict=True):
        start = (centre + 0.5) * (1 - 1 / narrowing)
        first, last = round(start), round(start + size / narrowing)
        sides.append(slice(first + margin, last + margin))
    return sides[0], sides[1]


def _same(one: Camera, other: Camera) -> bool:
    """Return whether two cameras take the same picture."""
    arrays = zip((one.K, one.R, one.t), (other.K, other.R, other.t), strict=True)
    alike = all(np.allclose(a, b, rtol=1e-12, atol=0) for a, b in arrays)
    return alike and one.image_size == other.image_size


def _lay_over(canvas: Picture, layer: Layer, disks: Array) -> None:
    """Blur a layer by disks, px, one for each of 256 steps of nearness; lay it over the canvas."""
    import cv2

    diameters = levels(float(disks.min()), float(disks.max()))
    found = (
        _spread(layer, diameter, shares, canvas.shape[:2])
        for diameter, shares in zip(diameters.tolist(), _shares(disks, diameters), strict=True)
    )
    parts = [each for each in found if each is not None]
    if len(parts) == 1:
        _compose(canvas, *parts[0])
    elif parts:
        boxes = np.array([box for _, box in parts])
        left, top = boxes[:, :2].min(axis=0).tolist()
        right, bottom = boxes[:, 2:].max(axis=0).tolist()
        total = np.zeros((bottom - top, right - left, 4), np.uint8)
        for part, (start, first, end, last) in parts:
            region = total[first - top : last - top, start - left : end - left]
            cv2.add(region, part, dst=region)
        _compose(canvas, total, (left, top, right, bottom))


def _compose(canvas: Picture, part: Picture, box: Box) -> None:
    """Lay premultiplied RGBA over the canvas."""
    import cv2

    left, top, right, bottom = box
    region = canvas[top:bottom, left:right]
    behind = cv2.merge([cv2.bitwise_not(cv2.extractChannel(part, 3))] * 4)
    cv2.add(cv2.multiply(region, behind, scale=1 / 255), part, dst=region)


def backing(scene_layers: list[Layer], size: tuple[int, int], background: Colour) -> Picture:
    """Return what is laid under all layers: the background, or a coarse picture of them.

    Two layers that meet fade into each other, and what lies under both shines through the seam.
    Where the scene is closed, this must be its own colour. The picture is RGBA, opaque.
    """
    import cv2

    times = len(WIDEST)
    small = np.zeros((size[1] >> times, size[0] >> times, 4), np.uint8)
    covered = np.zeros(small.shape[:2], np.uint8)
    for layer in scene_layers:
        rgba, _ = layer.reduced(times)
        left, top = layer.left >> times, layer.top >> times
        right, bottom = left + rgba.shape[1], top + rgba.shape[0]
        _compose(small, rgba, (left, top, right, bottom))
        region = covered[top:bottom, left:right]
        cv2.add(region, cv2.extractChannel(rgba, 3), dst=region)
    closed = cv2.erode(cv2.compare(covered, OPAQUE, cv2.CMP_GE), np.ones((3, 3), np.uint8)) > 0
    opacity = np.maximum(small[..., 3:], 1) / 255
    small = np.where(closed[..., None], small / opacity, (*background, 255))
    small = np.rint(np.minimum(small, 255)).astype(np.uint8)
    return np.asarray(cv2.resize(small, size, interpolation=cv2.INTER_LINEAR), np.uint8)


def levels(least: float, most: float) -> Array:
    """Return diameters of disks from the least to the most, near enough to mix neighbours, px."""
    if most - least < max(ALIKE, 0.1 * most):
        return np.array([(least + most) / 2])
    low, high = np.log1p(np.array([least, most]) / 2)
    return 2 * np.expm1(np.linspace(low, high, 1 + int(np.ceil((high - low) / STEP))))


def _shares(disks: Array, diameters: Array) -> Picture:
    """Return how much of what is spread over `disks` goes to each diameter, of 255.

    Two neighbours share a disk between them so that the second moment is right.
    """
    places = np.arange(len(diameters))
    place = np.rint(255 * np.interp(disks**2, diameters**2, places))
    shares = np.clip(255 - np.abs(place - 255 * places[:, None]), 0, 255)
    return np.asarray(shares, np.uint8)


def _spread(
    layer: Layer, diameter: float, shares: Picture, shape: tuple[int, ...]
) -> tuple[Picture, Box] | None:
    """Return a share of a layer, spread over disks, and its box in a picture of this shape."""
    import cv2

    times = reduction(diameter)
    r, weights = 2**times, kernel(diameter)
    rgba, x, y = _share_of(*layer.reduced(times), shares)
    height, width = rgba.shape[:2]
    if width == 0:
        return None
    # Room for the disk on each side, as far as there is picture.
    room = 0 if weights is None else weights.shape[0] // 2 + (r > 1)
    left, top = layer.left // r + x, layer.top // r + y
    right, bottom = shape[1] // r - left - width, shape[0] // r - top - height
    above, below, before, after = (min(room, side) for side in (top, bottom, left, right))
    part = cv2.copyMakeBorder(rgba, above, below, before, after, cv2.BORDER_CONSTANT, value=0)
    if weights is not None:
        part = cv2.filter2D(part, -1, weights, borderType=cv2.BORDER_REPLICATE)
    left, top = (left - before) * r, (top - above) * r
    height, width = part.shape[0] * r, part.shape[1] * r
    if r > 1:
        part = cv2.resize(part, (width, height), interpolation=cv2.INTER_LINEAR)
    return np.asarray(part, np.uint8), (left, top, left + width, top + height)


def _share_of(rgba: Picture, nearness: Picture, shares: Picture) -> tuple[Picture, int, int]:
    """Return RGBA weighted by its nearness, cut to where that is not 0; and where this begins."""
    import cv2

    if shares.min() == 255:
        return rgba, 0, 0
    share = cv2.LUT(nearness, shares)
    x, y, width, height = cv2.boundingRect(share)
    crop = slice(y, y + height), slice(x, x + width)
    if width:
        rgba = np.asarray(
            cv2.multiply(rgba[crop], cv2.merge([share[crop]] * 4), scale=1 / 255), np.uint8
        )
    return rgba if width else rgba[:0, :0], x, y
