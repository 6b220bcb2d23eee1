"""Systems of lenses: the one lens that they are like, and how a zoom zooms.

Use these functions through `course_lib.optics`.
"""

from __future__ import annotations

from numpy.typing import ArrayLike

from course_lib.checks import (
    DegenerateConfigurationError,
    check_length,
    check_matrix,
)
from course_lib.optics.ray_transfer import check_focal_length, free_space, thin_lens


def check_focusing(C: float, scale: float) -> None:
    """Raise if a system's power -C is zero, but for the rounding of numbers of size `scale`."""
    if abs(C) <= 1e-14 * scale:
        raise DegenerateConfigurationError(
            "the system has no focal length: parallel rays leave it parallel, as from a "
            "telescope (two lenses at the distance f1 + f2). Move a lens"
        )


def cardinal_points(system: ArrayLike) -> tuple[float, float, float]:
    """Return the focal length of a system and where a single lens would have to stand for it.

    Parameters
    ----------
    system : array_like, shape (2, 2)
        Matrix from just before the first lens to just behind the last one, in air.

    Returns
    -------
    f, front, back : float
        Effective focal length in mm; place of the front principal plane, from the first lens; place
        of the back principal plane, from the last lens. Both in mm in the direction of the light.

    Raises
    ------
    DegenerateConfigurationError
        If parallel rays leave the system parallel (a telescope): there is no focal point.
    TypeError, ValueError
        If the matrix is not 2 × 2, not finite, or its determinant is not 1.

    References
    ----------
    E. Hecht, Optics, 5th ed., sections 6.1 (thick lenses) and 6.2.1 (matrix methods).

    Examples
    --------
    >>> cardinal_points(thin_lens(-50) @ free_space(75) @ thin_lens(100))
    (200.0, -300.0, -150.0)
    """
    (A, B), (C, D) = check_matrix(system, (2, 2), "system")
    size = abs(A * D) + abs(B * C)
    if abs(A * D - B * C - 1) > 1e-9 * max(size, 1):
        raise ValueError(
            f"system has the determinant {A * D - B * C:.6g}; between air and air it must be 1"
        )
    check_focusing(C, 1 / abs(B) if B else 0)
    # A ray that comes in parallel to the axis at height y leaves at A y with the angle C y.
    return float(-1 / C), float((D - 1) / C), float((1 - A) / C)


def lens_system(f1: float, f2: float, d: float) -> tuple[float, float, float]:
    """Return the focal length of two thin lenses, and where one lens would have to stand for them.

    Parameters
    ----------
    f1, f2 : float
        Focal lengths of the first and the second lens that the light meets, in mm; negative for a
        lens that spreads light. Not zero.
    d : float
        Distance between the lenses in mm, not negative.

    Returns
    -------
    f, front, back : float
        Effective focal length; place of the front principal plane, measured from the first lens;
        place of the back principal plane, measured from the second lens. All in mm; a place is
        positive in the direction of the light.

    Raises
    ------
    DegenerateConfigurationError
        If parallel rays leave the system parallel: d is f1 + f2.
    TypeError, ValueError
        If an argument is not one finite number, a focal length is zero or d is negative.

    References
    ----------
    E. Hecht, Optics, 5th ed., sections 6.1 (thick lenses) and 6.2.1 (matrix methods).

    Examples
    --------
    >>> lens_system(100, -50, d=75)
    (200.0, -300.0, -150.0)
    """
    f1, f2 = check_focal_length(f1, "f1"), check_focal_length(f2, "f2")
    (A, _), (C, D) = thin_lens(f2) @ free_space(d) @ thin_lens(f1)  # f1 is met first
    check_focusing(C, abs(1 / f1) + abs(1 / f2))
    # In front of the focal point, which a parallel ray crosses A / -C behind the second lens.
    return float(-1 / C), float((D - 1) / C), float((1 - A) / C)


def two_lens_zoom(f1: float, f2: float, f: float) -> tuple[float, float]:
    """Return where two thin lenses stand to have a wanted focal length together.

    Parameters
    ----------
    f1, f2 : float
        Focal lengths of the first and the second lens in mm; negative for a lens that spreads
        light. Not zero.
    f : float
        Wanted effective focal length in mm, positive.

    Returns
    -------
    d, back : float
        Distance between the lenses, and distance from the second lens to the sharp image of a
        star, both in mm. (Where `back` is negative, that image is virtual.)

    Raises
    ------
    TypeError, ValueError
        If an argument is not one finite number, a focal length is zero, f is not positive, or no
        distance between the lenses gives f.

    References
    ----------
    E. Hecht, Optics, 5th ed., section 5.2.3 (thin-lens combinations).

    Examples
    --------
    A lens that spreads and one that collects, as in many cheap zooms:

    >>> two_lens_zoom(-80, 60, f=120)
    (20.0, 150.0)
    """
    f1, f2 = check_focal_length(f1, "f1"), check_focal_length(f2, "f2")
    f = check_length(f, "f")
    d = f1 + f2 - f1 * f2 / f  # 1/f = 1/f1 + 1/f2 - d / (f1 f2)
    if d < 0:
        raise ValueError(
            f"two lenses of {f1:g} mm and {f2:g} mm cannot have f = {f:g} mm: the second would "
            f"have to stand {-d:.3g} mm before the first. Choose another f"
        )
    return d, f * (1 - d / f1)
