"""How every pixel answers when camera or board move: residuals and their derivatives.

Coordinates are in rows, ``(V, …, N)``, so that NumPy handles long rows of one kind. Use these
functions through `course_lib.calibration`.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from course_lib.calibration.model import CameraModel, State
from course_lib.calibration.views import Views
from course_lib.checks import Array
from course_lib.distortion.model import distorted_columns, distorted_columns_and_slopes

#: So many numbers of the derivatives fit into the processor's own memory, which is faster.
BLOCK = 300_000


def residuals(state: State, views: Views) -> Array:
    """Return projected minus observed pixels, (V, 2, N), whatever the points weigh."""
    X = state.R @ views.points + state.t[..., None]
    x_d, y_d = distorted_columns(X[:, 0] / X[:, 2], X[:, 1] / X[:, 2], state.camera[5:])
    pixels = np.empty_like(views.pixels)
    _to_pixels(pixels, state.camera, x_d, y_d)
    return np.asarray(pixels + state.camera[3:5, None] - views.pixels)


def derivative_blocks(state: State, views: Views) -> Iterator[Array]:
    """Yield the derivatives of the pixels and the residuals, for a few views at a time.

    Parameters
    ----------
    state : State
        Where the derivatives are taken.
    views : Views
        What was measured.

    Yields
    ------
    ndarray, shape (v, n + 7, 2, N)
        For each view the rows of the n free numbers of the camera, of its turn and translation,
        and last the residuals, each for u and v of N points. Points that weigh nothing are zero.

    References
    ----------
    B. Triggs et al., "Bundle adjustment: a modern synthesis" (2000), section 4.
    """
    rows = len(state.model.names) + 7
    step = max(1, BLOCK // (rows * 2 * views.pixels.shape[-1]))
    memory = np.empty((min(step, len(state.R)), rows, 2, views.pixels.shape[-1]))
    for first in range(0, len(state.R), step):
        some = slice(first, first + step)
        block = memory[: len(state.R[some])]
        points = views.points if len(views.points) == 1 else views.points[some]
        q = state.R[some] @ points  # turned, not yet moved
        _fill(block, state, q, state.t[some])
        block[:, -1] -= views.pixels[some]
        if views.weights is not None:
            block *= np.sqrt(views.weights[some])[:, None, None]
        yield block


def _fill(block: Array, state: State, q: Array, t: Array) -> None:
    """Write the derivatives by camera and poses, and the pixels themselves, into a block."""
    camera, model = state.camera, state.model
    depth = q[:, 2] + t[:, 2, None]
    if not depth.min() > 0:
        depth = np.where(depth > 0, depth, np.nan)  # such a camera is none: the cost gets NaN
    per_depth = 1 / depth
    x, y = ((q[:, i] + t[:, i, None]) * per_depth for i in (0, 1))
    x_d, y_d, xx, xy, yx, yy = distorted_columns_and_slopes(x, y, camera[5:])
    pixels, turn, g = block[:, -1], block[:, -7:-4], block[:, -4:-1]
    _to_pixels(pixels, camera, x_d, y_d)
    _fill_camera(block, x_d, y_d, camera[1] / camera[0], model)
    _fill_coefficients(block, camera, x, y, model)
    pixels += camera[3:5, None]
    # g, by the point in the camera's frame: x = X/Z, so that dx = (dX - x dZ) / Z.
    _to_pixels(g[:, 0], camera, xx * per_depth, yx * per_depth)
    _to_pixels(g[:, 1], camera, xy * per_depth, yy * per_depth)
    g[:, 2] = x[:, None] * g[:, 0] + y[:, None] * g[:, 1]
    g[:, 2] *= -1
    # A turn w moves the point by w × q: the pixel by g · (w × q) = w · (q × g).
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        np.multiply(q[:, j, None], g[:, k], out=turn[:, i])
        turn[:, i] -= q[:, k, None] * g[:, j]


def _to_pixels(out: Array, camera: Array, x: Array, y: Array) -> None:
    """Write what x and y in normalised coordinates are in px, counted from the principal point."""
    fx, fy, s = camera[:3]
    np.multiply(fx, x, out=out[:, 0])
    np.multiply(fy, y, out=out[:, 1])
    if s:
        out[:, 0] += s * y


def _fill_camera(block: Array, x_d: Array, y_d: Array, aspect: float, model: CameraModel) -> None:
    """Write the derivatives by the free numbers of K."""
    for out, name in zip(block.swapaxes(0, 1), model.names, strict=False):
        if name in ("fx", "fy", "s", "cx", "cy"):
            out[:] = 0
        if name == "fx":
            out[:, 0] = x_d
            if model.square_pixels:
                out[:, 1] = aspect * y_d
        elif name == "fy":
            out[:, 1] = y_d
        elif name == "s":
            out[:, 0] = y_d
        elif name in ("cx", "cy"):
            out[:, int(name == "cy")] = 1


def _fill_coefficients(block: Array, camera: Array, x: Array, y: Array, model: CameraModel) -> None:
    """Write the derivatives by the free coefficients of distortion."""
    r2 = x * x + y * y
    powers = {"1": r2, "2": r2 * r2}
    powers["3"], none = powers["2"] * r2, np.zeros(1)
    radial = _radial_slopes(r2, powers, camera[5:], model)
    along = np.empty((len(x), 2, x.shape[-1]))
    _to_pixels(along, camera, x, y)
    for out, name in zip(block.swapaxes(0, 1), model.names, strict=False):
        if name in radial:
            np.multiply(along, radial[name][:, None], out=out)
        elif name == "p1":
            _to_pixels(out, camera, 2 * x * y, r2 + 2 * y * y)
        elif name == "p2":
            _to_pixels(out, camera, r2 + 2 * x * x, 2 * x * y)
        elif name in ("s1", "s2"):
            _to_pixels(out, camera, powers[name[1]], none)
        elif name in ("s3", "s4"):
            _to_pixels(out, camera, none, powers["1" if name == "s3" else "2"])


def _radial_slopes(
    r2: Array, powers: dict[str, Array], k: Array, model: CameraModel
) -> dict[str, Array]:
    """Return the derivatives of ``g = above / below`` by k1 … k6."""
    if not (k[5:8].any() or {"k4", "k5", "k6"} & set(model.coefficients)):
        return {f"k{n}": power for n, power in powers.items()}
    above = 1 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]))
    below = 1 + r2 * (k[5] + r2 * (k[6] + r2 * k[7]))
    slopes = {f"k{n}": power / below for n, power in powers.items()}
    over = -above / below
    return slopes | {f"k{int(n) + 3}": over * slopes[f"k{n}"] for n in powers}
