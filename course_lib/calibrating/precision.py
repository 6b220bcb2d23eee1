"""What the covariance of a camera means for lengths and directions measured with it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from course_lib.calibration import Calibration
from course_lib.checks import Array
from course_lib.distortion import undistort_points
from course_lib.distortion.pixels import normalised_from_pixels

#: Where directions are looked at: columns and rows of pixels over the picture.
GRID = (9, 7)
COEFFICIENTS = ["k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6", "s1", "s2", "s3", "s4"]


def length_sigma(calibration: Calibration) -> float:
    """Return the relative standard deviation of distances, from that of the focal length.

    Parameters
    ----------
    calibration : Calibration
        The camera.

    Returns
    -------
    float
        ``σ_f / f`` of the mean of fx and fy: a distance Z = f X / x has the same.
    """
    names = list(calibration.sigma)
    mine = [names.index(name) for name in ("fx", "fy") if name in names]
    if not mine:
        return 0.0
    mean = np.full(len(mine), 1 / len(mine))
    variance = mean @ calibration.covariance[np.ix_(mine, mine)] @ mean
    return float(np.sqrt(variance) / np.mean(np.diag(calibration.K)[:2]))


def angle_sigma(calibration: Calibration, reach: float = 1.0) -> float:
    """Return the standard deviation of the angle between directions, from the whole covariance.

    Parameters
    ----------
    calibration : Calibration
        The camera.
    reach : float
        How far out to look, by the distance of a corner of the picture from its middle.

    Returns
    -------
    float
        Root mean square over the picture, rad, of a direction against the mean of all: a turn
        that they have in common is no error, as the camera's pose takes it up.
    """
    rays, step = _directions(calibration, None, 0.0), 1e-4
    slopes = []
    for name in calibration.sigma:
        h = step * max(calibration.sigma[name], 1e-12)
        slopes.append((_directions(calibration, name, h) - rays) / h)
    J = np.moveaxis(np.array(slopes), 0, -1)
    good = np.isfinite(J).all(axis=(1, 2)) & _within(calibration.image_size, reach)
    J = J[good] - J[good].mean(axis=0)
    variances = np.einsum("nij,jk,nik->n", J, calibration.covariance, J)
    return float(np.sqrt(max(variances.mean(), 0.0)))


def fields_of_view(calibration: Calibration) -> tuple[float, float]:
    """Return the angles between the left and right, and the upper and lower edge of the picture.

    Parameters
    ----------
    calibration : Calibration
        The camera.

    Returns
    -------
    tuple of float
        Degrees, through the middle of the picture; NaN if the distortion cannot be undone there.
    """
    width, height = calibration.image_size
    u, v = (width - 1) / 2, (height - 1) / 2
    edges = np.array([[-0.5, v], [width - 0.5, v], [u, -0.5], [u, height - 0.5]])
    ideal = undistort_points(normalised_from_pixels(edges, calibration.K), calibration.coefficients)
    rays = np.column_stack([ideal, np.ones(4)])
    rays /= np.linalg.norm(rays, axis=1, keepdims=True)
    cosines = (rays[::2] * rays[1::2]).sum(axis=1)
    across, down = np.degrees(np.arccos(np.clip(cosines, -1, 1)))
    return float(across), float(down)


def _directions(calibration: Calibration, name: str | None, change: float) -> Array:
    """Return unit vectors towards a grid of pixels after one number of the camera has changed."""
    K, k = calibration.K.copy(), np.pad(calibration.coefficients, (0, 12))[:12]
    places = {"fx": (0, 0), "fy": (1, 1), "s": (0, 1), "cx": (0, 2), "cy": (1, 2)}
    if name in places:
        K[places[name]] += change
    elif name is not None:
        k[COEFFICIENTS.index(name)] += change
    pixels = _pixels(calibration.image_size)
    ideal = undistort_points(normalised_from_pixels(pixels, K), k)
    rays = np.column_stack([ideal, np.ones(len(ideal))])
    return np.asarray(rays / np.linalg.norm(rays, axis=1, keepdims=True))


def _pixels(size: tuple[int, int]) -> Array:
    """Return pixels all over the picture, shape (N, 2)."""
    u, v = (np.linspace(0, side - 1, count) for side, count in zip(size, GRID, strict=True))
    return np.stack(np.meshgrid(u, v), axis=-1).reshape(-1, 2)


def _within(size: tuple[int, int], reach: float) -> NDArray[np.bool_]:
    """Return which of these pixels are not farther out than `reach`."""
    middle = (np.array(size) - 1) / 2
    away = np.linalg.norm(_pixels(size) - middle, axis=1)
    return np.asarray(away <= reach * np.linalg.norm(middle))
