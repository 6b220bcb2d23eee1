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
RUNG = 1.15  # ratio of the focal lengths at which a zooming view is drawn
KEPT = 12  # views that are kept, the last ones used
View = tuple[list[Layer], Picture]


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
    zooms : bool
        Whether the focal length, or the pitch of the pixels, changes from picture to picture
        while the camera stays where it is. The scene is then drawn at focal lengths that are
        fixed, 15 % apart, and the picture is magnified or reduced from the nearest of them.

    Examples
    --------
    The camera's matrix K belongs to the lens as it is focused. As long as the camera is one of
    the last few, only the blur is made anew:

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
        zooms: bool = False,
    ) -> None:
        self.renderer = QuickRenderer(scene, subpixels)
        self.margin, self.edges, self.breathes, self.zooms = margin, edges, breathes, zooms
        self._views: dict[tuple[float, ...], View] = {}

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

        narrowing = self._narrowing(camera, lens)
        room = self._room(camera)
        layers, base = self._view(_widened(camera, narrowing, room))
        canvas = base.copy()
        inverse = np.array([np.linspace(layer.far, layer.near, 256) for layer in layers])
        with np.errstate(divide="ignore"):
            disks = lens.disks(1 / inverse, camera) / narrowing
        for layer, spots in zip(layers, disks, strict=True):
            _lay_over(canvas, layer, spots)
        columns, rows = _inside(camera, narrowing, room)
        picture = cv2.cvtColor(canvas[rows, columns], cv2.COLOR_RGBA2RGB)
        if picture.shape[1::-1] != camera.image_size:
            picture = cv2.resize(picture, camera.image_size, interpolation=cv2.INTER_CUBIC)
        return np.asarray(picture)

    def _narrowing(self, camera: Camera, lens: Lens) -> float:
        """Return the focal length of a camera by that at which the scene is drawn for it."""
        if self.zooms:
            f = float(camera.K[0, 0])
            return float(f / RUNG ** round(np.log(f) / np.log(RUNG)))
        return lens.image_distance / lens.f if self.breathes else 1.0

    def _room(self, camera: Camera) -> tuple[int, int]:
        """Return how far the scene is drawn beyond the picture's edges, across and down, px."""
        beyond = (RUNG**0.5 - 1) * self.zooms  # of the distance from the centre to the edge
        across, down = (
            self.margin + int(np.ceil(beyond * max(centre + 0.5, size - centre - 0.5)))
            for centre, size in zip(camera.K[:2, 2].tolist(), camera.image_size, strict=True)
        )
        return across, down

    def _view(self, camera: Camera) -> View:
        """Return the layers that a camera sees and what lies under them, drawn or kept."""
        key = _key(camera)
        if key not in self._views:
            found = layers(self.renderer, camera, self.edges)
            base = backing(found, camera.image_size, self.renderer.scene.background)
            self._views[key] = found, base
        view = self._views[key] = self._views.pop(key)  # now the last one
        if len(self._views) > KEPT:
            del self._views[next(iter(self._views))]
        return view


def _widened(camera: Camera, narrowing: float, room: tuple[int, int]) -> Camera:
    """Return the camera with a shorter focal length and with room around its picture, px."""
    K = camera.K.copy()
    K[:2, :2] /= narrowing
    K[:2, 2] += room
    width, height = (
        -(-(side + 2 * more) // GRID) * GRID
        for side, more in zip(camera.image_size, room, strict=True)
    )
    return Camera(K, camera.R, camera.t, (width, height))


def _inside(camera: Camera, narrowing: float, room: tuple[int, int]) -> tuple[slice, slice]:
    """Return columns and rows of the wider camera's picture that the narrower one sees."""
    sides = []
    for size, centre, more in zip(camera.image_size, camera.K[:2, 2].tolist(), room, strict=True):
        start = (centre + 0.5) * (1 - 1 / narrowing)
        first, last = round(start), round(start + size / narrowing)
        sides.append(slice(first + more, last + more))
    return sides[0], sides[1]


def _key(camera: Camera) -> tuple[float, ...]:
    """Return numbers, rounded, that two cameras share if they take the same picture."""
    numbers = np.concatenate([camera.K.ravel(), camera.R.ravel(), camera.t])
    return (*numbers.round(9).tolist(), *camera.image_size)


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
