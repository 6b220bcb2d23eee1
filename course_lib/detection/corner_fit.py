"""Where two edges of a board cross, to a hundredth of a pixel: a picture of the crossing is fitted.

The corner of a checkerboard is where two straight edges cross and dark and light change places.
Blurred by the lens, the brightness around it is ``b + g · x + a S(u) S(v)``, with u and v the
distances to the two edges and S a step as wide as the blur. All its numbers are found by least
squares from the pixels of a round window that does not reach the next edge.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.checks import Array, check_numbers, check_points

#: Radius of a window, px: with less there is nothing to fit, with more the edges are curved.
LEAST, MOST = 3.0, 10.0
#: Part of the way to the next corner that a window may cover; the next edge can be nearer.
SHARE = 0.55
#: The narrowest step, px. Pixels blur by half of it; a still narrower one would follow their grid.
NARROWEST = 0.6
#: Standard deviation of the blur by the width of the step ``tanh(u / width)``.
BLUR = 0.8
#: Keeps what a window does not tell, such as the angle of two edges in one line, from running off.
LEAST_DAMPING = 1e-7
STEPS = 25
#: A step that moves no corner by more ends the search, px.
STILL = 1e-4


@dataclass(frozen=True, eq=False)
class CornerFit:
    """Corners, and what their surroundings tell.

    Attributes
    ----------
    points : ndarray, shape (N, 2)
        The corners in px; where there is none, the place that was asked for.
    good : ndarray, shape (N,), bool
        Whether two edges cross there.
    blur : ndarray, shape (N,)
        Standard deviation of the blur, px.
    contrast : ndarray, shape (N,)
        Light minus dark, in the picture's numbers.
    noise : ndarray, shape (N,)
        Root mean square of what the fit leaves, in the picture's numbers.
    sigma : ndarray, shape (N,)
        Standard deviation of a coordinate that follows from the noise, px.
    """

    points: Array
    good: NDArray[np.bool_]
    blur: Array
    contrast: Array
    noise: Array
    sigma: Array


def refine_corners(
    image: ArrayLike, corners: ArrayLike, reach: float = MOST, share: float = SHARE
) -> Array:
    """Return the corners of a checkerboard to a fraction of a pixel.

    Parameters
    ----------
    image : array_like, shape (height, width)
        A grey picture.
    corners : array_like, shape (N, 2)
        Where they are to about 2 px, in px.
    reach : float
        Largest radius of the window, px. It is smaller where corners are close together.
    share : float
        Largest radius by the distance to the next corner.

    Returns
    -------
    ndarray, shape (N, 2)
        The corners, px. One where no two edges cross stays where it was.

    Raises
    ------
    TypeError, ValueError
        If `image` is not grey or a shape is wrong.

    Examples
    --------
    >>> board = np.kron([[0, 1], [1, 0]], np.ones((8, 8)))
    >>> refine_corners(board, [[8.4, 7.1]]).round(2)
    array([[7.5, 7.5]])
    """
    return fit_corners(image, corners, reach, share).points


def fit_corners(
    image: ArrayLike, corners: ArrayLike, reach: float = MOST, share: float = SHARE
) -> CornerFit:
    """Return the corners of a checkerboard with their blur, contrast and uncertainty.

    Parameters
    ----------
    image, corners, reach, share
        As for `refine_corners`.

    Returns
    -------
    CornerFit
        One entry for each corner.

    Raises
    ------
    TypeError, ValueError
        As `refine_corners`.
    """
    image = np.asarray(image)
    if image.dtype.kind not in "iuf":
        raise TypeError(f"image must be made of real numbers, got {image.dtype}")
    if image.ndim != 2 or image.size == 0:
        raise ValueError(f"image must be grey, shape (height, width), got {image.shape}")
    corners = check_points(corners, 2, "corners").reshape(-1, 2)
    radii = window_radii(corners, image.shape, reach, share)
    table = np.zeros((len(corners), 7))
    table[:, :2] = corners
    for radius in np.unique(radii[radii >= LEAST]).tolist():
        mine = np.flatnonzero(radii == radius)
        table[mine] = _fitted(image, corners[mine], int(radius))
    points, score, blur, contrast, noise, sigma = np.split(table, [2, 3, 4, 5, 6], axis=1)
    moved = np.linalg.norm(points - corners, axis=1) > np.maximum(radii, LEAST)
    good = (score[:, 0] > 0) & ~moved
    points = np.where(good[:, None], points, corners)
    return CornerFit(points, good, blur[:, 0], contrast[:, 0], noise[:, 0], sigma[:, 0])


def window_radii(
    corners: Array, shape: tuple[int, ...], reach: float = MOST, share: float = SHARE
) -> Array:
    """Return how far a window around each corner may reach.

    Parameters
    ----------
    corners : ndarray, shape (N, 2)
        All corners of the picture, px.
    shape : tuple of int
        Height and width of the picture.
    reach, share : float
        As for `refine_corners`.

    Returns
    -------
    ndarray, shape (N,)
        Whole radii in px; less than `LEAST` where the border is too near.
    """
    spacing = np.full(len(corners), np.inf)
    for i in range(0, len(corners), 256):  # a few rows at a time, to save memory
        apart = np.linalg.norm(corners[i : i + 256, None] - corners, axis=2)
        apart[apart == 0] = np.inf
        spacing[i : i + 256] = apart.min(axis=1)
    inside = np.minimum(corners, np.array(shape)[::-1] - 1 - corners).min(axis=1)
    radii = np.clip(share * spacing, LEAST, max(reach, LEAST))
    return np.asarray(np.floor(np.minimum(radii, inside - 1)))


def _fitted(image: NDArray[Any], corners: Array, radius: int) -> Array:
    """Return x, y, good, blur, contrast, noise and sigma of corners with windows of one size."""
    down, right = np.indices((2 * radius + 1,) * 2) - radius
    inside = np.hypot(right, down) <= radius + 0.5
    right, down = right[inside], down[inside]
    x, y = right.astype(float), down.astype(float)
    limit = np.array(image.shape)[::-1] - 1 - radius
    for turn in range(2):  # the second time with the windows where the corners are
        middle = np.clip(np.rint(corners), radius, limit).astype(int)
        pixels = image[middle[:, 1, None] + down, middle[:, 0, None] + right]
        values = check_numbers(pixels, "image")
        numbers, crossing = _start(values, x, y, corners - middle)
        numbers, left, normal = _least_squares(numbers, values, x, y)
        found = middle + numbers[:, :2]
        crossing &= np.hypot(*numbers[:, :2].T) < radius
        corners = np.where(crossing[:, None], found, corners) if turn == 0 else found
    noise = np.sqrt(left / max(len(x) - 9, 1))
    spread = np.linalg.pinv(normal, hermitian=True)[:, [0, 1], [0, 1]].mean(axis=1)
    width = np.exp(numbers[:, 4])
    crossing &= width < radius
    told = [crossing, BLUR * width, 2 * np.abs(numbers[:, 8]), noise, noise * np.sqrt(spread)]
    return np.column_stack([found, *told])


def _start(values: Array, x: Array, y: Array, corner: Array) -> tuple[Array, NDArray[np.bool_]]:
    """Return first numbers of the model, and whether the brightness forms a saddle.

    A parabola through the window is level along both edges: ``dᵀ H d = 0``.
    """
    columns = np.stack([np.ones_like(x), x, y, x * x / 2, x * y, y * y / 2], axis=1)
    b, _, _, hxx, hxy, hyy = (values @ np.linalg.pinv(columns).T).T
    mean, difference = (hxx + hyy) / 2, (hxx - hyy) / 2
    swing = np.hypot(difference, hxy)
    saddle = np.abs(mean) < swing
    half = np.arccos(np.clip(-mean / np.where(swing > 0, swing, 1), -0.9, 0.9)) / 2
    middle = np.arctan2(hxy, difference) / 2
    width = np.full(len(values), np.log(max(1.0, np.abs(x).max() / 5)))
    none = np.zeros(len(values))
    numbers = np.stack(
        [*corner.T, middle - half, middle + half, width, b, none, none, none + 1], axis=1
    )
    pattern = _model(numbers, x, y)[0] - b[:, None]
    pattern -= pattern.mean(axis=1, keepdims=True)
    numbers[:, 8] = (pattern * values).sum(axis=1) / np.maximum((pattern**2).sum(axis=1), 1e-12)
    numbers[:, 5] = values.mean(axis=1)
    return numbers, saddle


def _model(numbers: Array, x: Array, y: Array) -> tuple[Array, Array]:
    """Return the brightness of windows, shape (N, M), and its derivatives, (N, 9, M).

    The numbers are cx, cy, the directions of the edges, the logarithm of the width, b, g, a.
    """
    cx, cy, first, second, width, b, gx, gy, a = (n[:, None] for n in numbers.T)
    dx, dy, width = x - cx, y - cy, np.maximum(np.exp(width), NARROWEST)
    S1, slopes1 = _step(dx, dy, first, width)
    S2, slopes2 = _step(dx, dy, second, width)
    by_first, by_second = a * slopes1 * S2, a * slopes2 * S1
    both = by_first + by_second
    derivatives = [both[0], both[1], by_first[2], by_second[2], both[3]]
    one = np.ones_like(dx)
    derivatives += [one, one * x, one * y, S1 * S2]
    return b + gx * x + gy * y + a * S1 * S2, np.stack(derivatives, axis=1)


def _step(dx: Array, dy: Array, angle: Array, width: Array) -> tuple[Array, Array]:
    """Return the step across an edge; its derivatives by cx, cy, angle and logarithm of width."""
    c, s = np.cos(angle), np.sin(angle)
    u = dy * c - dx * s
    step = np.tanh(u / width)
    slope = (1 - step**2) / width
    return step, slope * np.stack(np.broadcast_arrays(s, -c, -(dx * c + dy * s), -u))


def _least_squares(numbers: Array, values: Array, x: Array, y: Array) -> tuple[Array, Array, Array]:
    """Return the numbers that fit best, the sum of squares left, and the normal matrices.

    Levenberg and Marquardt's method, for all windows at once.
    """
    damping = np.full(len(numbers), 1e-2)
    model, J = _model(numbers, x, y)
    cost = ((values - model) ** 2).sum(axis=1)
    normal = J @ J.mT
    for _ in range(STEPS):
        gradient = (J @ (values - model)[..., None])[..., 0]
        scale = np.diagonal(normal, axis1=1, axis2=2)
        # Where nothing is to be seen, some numbers have no influence; they stay.
        scale = np.maximum(scale, 1e-6 * scale.max(axis=1, keepdims=True))
        damped = normal + (damping[:, None] * scale)[:, :, None] * np.eye(9)
        step = np.linalg.solve(damped, gradient[..., None])[..., 0]
        trial = numbers + step
        trial[:, 4] = np.clip(trial[:, 4], np.log(NARROWEST), 5)
        new_model, new_J = _model(trial, x, y)
        new_cost = ((values - new_model) ** 2).sum(axis=1)
        better = new_cost <= cost
        damping = np.clip(damping * np.where(better, 0.1, 10), LEAST_DAMPING, 1e9)
        numbers = np.where(better[:, None], trial, numbers)
        cost = np.where(better, new_cost, cost)
        model = np.where(better[:, None], new_model, model)
        J = np.where(better[:, None, None], new_J, J)
        normal = J @ J.mT
        if np.abs(step[:, :2]).max() < STILL:
            break
    return numbers, cost, normal
