"""The same lens in other people's words: photogrammetry's form and Bouguet's.

Photogrammetry measures in the image, in px or mm, where OpenCV uses tangents; a coefficient of
``rⁿ`` gets divided by ``fⁿ``. Use these functions through `course_lib.distortion`.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import (
    Array,
    check_intrinsics,
    check_length,
    check_number,
    check_positive,
    check_vector,
)
from course_lib.distortion.model import check_coefficients


class Photogrammetric(NamedTuple):
    """A lens in photogrammetry's form; d is the distance from the centre, in px or mm.

    Attributes
    ----------
    radial : ndarray, shape (3,)
        α, β, γ (or K1, K2, K3), the factors of d², d⁴ and d⁶.
    tangential : ndarray, shape (2,)
        P1, P2.
    """

    radial: Array
    tangential: Array


class Bouguet(NamedTuple):
    """A camera as the Camera Calibration Toolbox for MATLAB prints it.

    Attributes
    ----------
    fc, cc : ndarray, shape (2,)
        Focal lengths and principal point in px, the top left pixel being (0, 0).
    alpha_c : float
        Skew, in focal lengths.
    kc : ndarray, shape (5,)
        ``k1 k2 p1 p2 k3``.
    """

    fc: Array
    cc: Array
    alpha_c: float
    kc: Array


def photogrammetric_from_opencv(coefficients: ArrayLike, f: float) -> Photogrammetric:
    """Return a lens in photogrammetry's form.

    Parameters
    ----------
    coefficients : array_like, shape (1,), (2,), (4,), (5,), (8,) or (12,)
        As in `distort`, without rational and prism terms, which that form does not have.
    f : float
        Principal distance in the unit in which the image is measured: px or mm.

    Returns
    -------
    Photogrammetric
        Coefficients for image coordinates in that unit.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, `f` is not positive, or there are rational or prism terms.

    References
    ----------
    T. Luhmann et al., Close-Range Photogrammetry and 3D Imaging, 3rd ed., section 3.3.3.

    Examples
    --------
    A corner 1000 px from the centre, pulled in by a fifth:

    >>> photogrammetric_from_opencv([-0.2], f=1000).radial
    array([-2.e-07,  0.e+00,  0.e+00])
    """
    k, f = check_coefficients(coefficients), _check_principal_distance(f)
    if k[5:].any():
        raise ValueError(
            "photogrammetry's form has no rational and no prism terms (k4 … s4), but these are "
            f"{k[5:].tolist()}: calibrate again without them"
        )
    return Photogrammetric(k[[0, 1, 4]] / f ** np.array([2, 4, 6]), k[[2, 3]] / f)


def opencv_from_photogrammetric(radial: ArrayLike, tangential: ArrayLike, f: float) -> Array:
    """Return OpenCV's coefficients of a lens that is given in photogrammetry's form.

    Parameters
    ----------
    radial : array_like, shape (3,)
        α, β, γ (or K1, K2, K3), the factors of d², d⁴ and d⁶, with d in px or mm.
    tangential : array_like, shape (2,)
        P1, P2, where P1 is the factor of ``2 x y`` in x. Brown's papers and some programs
        (Metashape, Australis) name them the other way round.
    f : float
        Principal distance in the same unit.

    Returns
    -------
    ndarray, shape (5,)
        ``k1 k2 p1 p2 k3``.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite or `f` is not positive.

    References
    ----------
    T. Luhmann et al., Close-Range Photogrammetry and 3D Imaging, 3rd ed., section 3.3.3.

    Examples
    --------
    >>> opencv_from_photogrammetric([-2e-7, 0, 0], [0, 1e-6], f=1000).round(9)
    array([-0.2  ,  0.   ,  0.   ,  0.001,  0.   ])
    """
    f = _check_principal_distance(f)
    k = check_vector(radial, 3, "radial") * f ** np.array([2, 4, 6])
    p = check_vector(tangential, 2, "tangential") * f
    return check_coefficients([k[0], k[1], p[0], p[1], k[2]])[:5]


def bouguet_from_opencv(K: ArrayLike, coefficients: ArrayLike) -> Bouguet:
    """Return a camera as Bouguet's toolbox for MATLAB writes it.

    Parameters
    ----------
    K : array_like, shape (3, 3)
        Intrinsics in px.
    coefficients : array_like, shape (1,), (2,), (4,), (5,), (8,) or (12,)
        As in `distort`, without rational and prism terms, which the toolbox does not have.

    Returns
    -------
    Bouguet
        ``fc``, ``cc``, ``alpha_c`` and ``kc``. Both count pixels from (0, 0); MATLAB's own
        functions count from (1, 1).

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite, or there are rational or prism terms.

    References
    ----------
    J.-Y. Bouguet, Camera Calibration Toolbox for MATLAB, description of the parameters.

    Examples
    --------
    >>> bouguet_from_opencv([[800, 4, 320], [0, 790, 240], [0, 0, 1]], [-0.2]).alpha_c
    0.005
    """
    K, k = check_intrinsics(K), check_coefficients(coefficients)
    if k[5:].any():
        raise ValueError(f"kc has no rational and no prism terms, got {k[5:].tolist()}")
    return Bouguet(K[[0, 1], [0, 1]], K[:2, 2].copy(), float(K[0, 1] / K[0, 0]), k[:5])


def opencv_from_bouguet(
    fc: ArrayLike, cc: ArrayLike, alpha_c: float, kc: ArrayLike
) -> tuple[Array, Array]:
    """Return intrinsics and OpenCV's coefficients of a camera from Bouguet's toolbox.

    Parameters
    ----------
    fc, cc : array_like, shape (2,)
        Focal lengths and principal point in px.
    alpha_c : float
        Skew, in focal lengths.
    kc : array_like, shape (5,)
        ``k1 k2 p1 p2 k3``.

    Returns
    -------
    K : ndarray, shape (3, 3)
        Intrinsics in px.
    coefficients : ndarray, shape (5,)
        As in `distort`.

    Raises
    ------
    TypeError, ValueError
        If a shape is wrong, a number is not finite or a focal length not positive.

    References
    ----------
    J.-Y. Bouguet, Camera Calibration Toolbox for MATLAB, description of the parameters.

    Examples
    --------
    >>> opencv_from_bouguet([800, 790], [320, 240], 0.005, [-0.2, 0, 0, 0, 0])[0]
    array([[800.,   4., 320.],
           [  0., 790., 240.],
           [  0.,   0.,   1.]])
    """
    fx, fy = check_positive(check_vector(fc, 2, "fc"), "fc")
    cx, cy = check_vector(cc, 2, "cc")
    K = np.array([[fx, check_number(alpha_c, "alpha_c") * fx, cx], [0, fy, cy], [0, 0, 1]])
    return check_intrinsics(K), check_coefficients(check_vector(kc, 5, "kc"))[:5]


def _check_principal_distance(f: float) -> float:
    if not 1e-3 <= check_length(f, "f") <= 1e9:
        raise ValueError(f"f must be a principal distance in px or mm, got {f:g}: check its unit")
    return check_length(f, "f")
