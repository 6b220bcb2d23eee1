"""Which apertures keep a depth range sharp, between defocus and diffraction.

Use these functions through `course_lib.planning`.
"""

from __future__ import annotations

from dataclasses import dataclass

from course_lib.checks import check_length
from course_lib.optics import airy_diameter, aperture_for_depth, magnification


@dataclass(frozen=True)
class ApertureWindow:
    """The f-numbers between too much defocus and too much diffraction.

    Attributes
    ----------
    least, most : float
        Smallest f-number that keeps the ends of the range sharp, and largest one whose Airy disk is
        not larger than the spot allowed. Without any aperture that does both, least > most.
    focus_distance : float
        Where to focus, m.
    """

    least: float
    most: float
    focus_distance: float

    @property
    def is_open(self) -> bool:
        """True if there is an aperture that does both."""
        return self.least <= self.most


def aperture_window(
    f_mm: float, near: float, far: float, spot_um: float, wavelength_um: float = 0.55
) -> ApertureWindow:
    """Return the apertures at which a whole depth range is sharp.

    Parameters
    ----------
    f_mm : float
        Focal length, mm.
    near, far : float
        Ends of the range, measured from the lens along its axis, m; far may be ``np.inf``.
    spot_um : float
        Largest diameter on the sensor that counts as sharp, µm: one or two pixels.
    wavelength_um : float
        Of the light, µm.

    Returns
    -------
    ApertureWindow
        The f-numbers, and the distance to focus on.

    Raises
    ------
    TypeError, ValueError
        If the range is empty or not outside of the focal length, or a number is not positive.

    Notes
    -----
    Defocus: the spot of both ends is as large as allowed (`course_lib.optics.aperture_for_depth`).
    Diffraction: the Airy disk ``2.44 λ N (1 + m)`` is, where m is the magnification of the distance
    focused on. Each is held alone; at the ends of the window both blur.

    References
    ----------
    S. F. Ray, Applied Photographic Optics, 3rd ed., chapters on depth of field and on resolution.

    Examples
    --------
    >>> window = aperture_window(50, near=0.95, far=1.05, spot_um=10)
    >>> print(f"f/{window.least:.1f} to f/{window.most:.1f}")
    f/13.2 to f/7.1
    >>> window.is_open
    False
    """
    c = check_length(spot_um, "spot_um") / 1000
    wavelength = check_length(wavelength_um, "wavelength_um") / 1000
    least, focus = aperture_for_depth(f_mm, 1000 * near, 1000 * far, c)
    m = magnification(f_mm, focus)
    most = c / airy_diameter(wavelength, 1 + m)  # the disk grows with N
    return ApertureWindow(float(least), float(most), float(focus) / 1000)
