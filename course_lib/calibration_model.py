"""What calibration changes, and how every pixel answers: parameters, residuals, derivatives.

The camera is a vector of seventeen numbers, ``fx fy s cx cy`` and the twelve coefficients of the
distortion; each view has six more: three of a small turn, three of its translation. Use these
functions through `course_lib.calibration`.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from course_lib.calibration_views import Views
from course_lib.checks import Array
from course_lib.distortion_model import (
    COUNTS,
    distorted_columns,
    distorted_columns_and_slopes,
)

COEFFICIENTS = ("k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6", "s1", "s2", "s3", "s4")
NAMES = ("fx", "fy", "s", "cx", "cy", *COEFFICIENTS)
#: So many numbers of the derivatives fit into the processor's own memory, which is faster.
BLOCK = 300_000


@dataclass(frozen=True)
class CameraModel:
    """Which numbers of a camera a calibration estimates; the others keep their start.

    Attributes
    ----------
    focal : bool
        Whether fx and fy are estimated.
    square_pixels : bool
        Whether fy follows fx, in the ratio of the start (1 unless a start is given).
    skew : bool
        Whether s is estimated; otherwise it is 0, as sensors are made.
    principal_point : bool
        Whether cx and cy are estimated; otherwise they stay at the start, the middle of the picture
        unless one is given.
    coefficients : tuple of str
        Names of the coefficients of distortion that are estimated, of ``k1 k2 p1 p2 k3 k4 k5 k6 s1
        s2 s3 s4``.

    Raises
    ------
    ValueError
        If a name is none of these, or there twice.

    Examples
    --------
    >>> CameraModel(skew=True, coefficients=("k1", "k2")).names
    ('fx', 'fy', 's', 'cx', 'cy', 'k1', 'k2')
    """

    focal: bool = True
    square_pixels: bool = False
    skew: bool = False
    principal_point: bool = True
    coefficients: tuple[str, ...] = ("k1", "k2", "p1", "p2", "k3")

    def __post_init__(self) -> None:
        given = tuple(self.coefficients)
        if len(set(given) & set(COEFFICIENTS)) < len(given):
            raise ValueError(
                f"coefficients must be some of {' '.join(COEFFICIENTS)}, each once, got {given}"
            )
        object.__setattr__(self, "coefficients", given)

    @cached_property
    def names(self) -> tuple[str, ...]:
        """The names of what is estimated, in the order of a covariance's rows."""
        chosen = set(self.coefficients)
        chosen |= {"fx"} if self.focal else set()
        chosen |= {"fy"} if self.focal and not self.square_pixels else set()
        chosen |= {"s"} if self.skew else set()
        chosen |= {"cx", "cy"} if self.principal_point else set()
        return tuple(name for name in NAMES if name in chosen)

    def moved(self, camera: Array, step: Array) -> Array:
        """Return the camera's seventeen numbers after a step of the free ones."""
        camera = camera.copy()
        aspect = camera[1] / camera[0]
        camera[[NAMES.index(name) for name in self.names]] += step
        if self.square_pixels:
            camera[1] = aspect * camera[0]
        return camera


@dataclass(frozen=True, eq=False)
class State:
    """A camera and where it stood: what the refinement moves.

    Attributes
    ----------
    camera : ndarray, shape (17,)
        ``fx fy s cx cy k1 … s4``.
    R, t : ndarray, shape (V, 3, 3) and (V, 3)
        Pose of each view, board to camera.
    """

    camera: Array
    R: Array
    t: Array

    @property
    def K(self) -> Array:
        """The intrinsics, shape (3, 3)."""
        fx, fy, s, cx, cy = self.camera[:5]
        return np.array([[fx, s, cx], [0, fy, cy], [0, 0, 1]])

    def coefficients(self, model: CameraModel) -> Array:
        """Return the coefficients of distortion: up to the last that is free or not zero."""
        free = [COEFFICIENTS.index(name) for name in model.coefficients]
        last = max([0, *free, *np.flatnonzero(self.camera[5:]).tolist()])
        return self.camera[5 : 5 + next(count for count in COUNTS if count > last)].copy()

    @property
    def is_camera(self) -> bool:
        """Whether the focal lengths are positive; a step can lead too far."""
        return bool(self.camera[:2].min() > 0)

    def moved(self, model: CameraModel, camera_step: Array, pose_steps: Array) -> State:
        """Return the state after a step; turns are about the camera's axes, through the board."""
        turns = rotations_from_vectors(pose_steps[:, :3])
        camera = model.moved(self.camera, camera_step)
        return State(camera, turns @ self.R, self.t + pose_steps[:, 3:])


def residuals(state: State, views: Views) -> Array:
    """Return projected minus observed pixels, (V, 2, N), whatever the points weigh."""
    X = state.R @ views.points + state.t[..., None]
    x_d, y_d = distorted_columns(X[:, 0] / X[:, 2], X[:, 1] / X[:, 2], state.camera[5:])
    pixels = np.empty_like(views.pixels)
    _to_pixels(pixels, state.camera, x_d, y_d)
    return np.asarray(pixels + state.camera[3:5, None] - views.pixels)


def derivative_blocks(state: State, views: Views, model: CameraModel) -> Iterator[Array]:
    """Yield the derivatives of the pixels and the residuals, for a few views at a time.

    Parameters
    ----------
    state : State
        Where the derivatives are taken.
    views : Views
        What was measured.
    model : CameraModel
        What is free; n numbers.

    Yields
    ------
    ndarray, shape (v, n + 7, 2, N)
        For each view the rows of the free numbers, of the turn and the translation of the view,
        and last the residuals, each for u and v of N points. Points that weigh nothing are zero.

    References
    ----------
    B. Triggs et al., "Bundle adjustment: a modern synthesis" (2000), section 4.
    """
    rows = len(model.names) + 7
    step = max(1, BLOCK // (rows * 2 * views.pixels.shape[-1]))
    memory = np.empty((min(step, len(state.R)), rows, 2, views.pixels.shape[-1]))
    for first in range(0, len(state.R), step):
        some = slice(first, first + step)
        block = memory[: len(state.R[some])]
        points = views.points if len(views.points) == 1 else views.points[some]
        q = state.R[some] @ points  # turned, not yet moved
        _fill(block, state.camera, q, state.t[some], model)
        block[:, -1] -= views.pixels[some]
        if views.weights is not None:
            block *= np.sqrt(views.weights[some])[:, None, None]
        yield block


def _fill(block: Array, camera: Array, q: Array, t: Array, model: CameraModel) -> None:
    """Write the derivatives by camera and poses, and the pixels themselves, into a block."""
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


def rotations_from_vectors(vectors: Array) -> Array:
    """Return ``exp([w]ₓ)`` for rows w, shape (V, 3, 3): `rotation_from_vector` for many."""
    angle = np.sqrt((vectors**2).sum(axis=1))[:, None, None]
    k = np.zeros((len(vectors), 3, 3))
    k[:, 2, 1], k[:, 0, 2], k[:, 1, 0] = vectors.T
    k -= k.transpose(0, 2, 1)
    # sin(a) / a, and (1 - cos a) / a² without its cancellation.
    half = np.sinc(angle / (2 * np.pi))
    return np.asarray(np.eye(3) + np.sinc(angle / np.pi) * k + 0.5 * half**2 * (k @ k))
