"""What a real hole does to a picture: it spreads every point of light, and lets light in.

Each point of the hole is a pinhole with a centre of its own, so a near point is seen as a disk
(`hole_cameras` does exactly that). Light also bends at the rim, which spreads it into an Airy
pattern. Together they are one multiplication of the picture's spectrum, as long as the disk is
equally large all over the picture (`Spread`).
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.camera import Camera
from course_lib.checks import Array, check_length, check_numbers, check_positive
from course_lib.optics import pinhole_blur_diameter

MM = 1e-3  # m


@dataclass(frozen=True)
class Hole:
    """A round hole in front of a sensor.

    Attributes
    ----------
    diameter : float
        mm.
    image_distance : float
        From the hole to the sensor, mm.
    wavelength : float or None
        Of the light, mm; without one, light travels in straight lines only.
    """

    diameter: float
    image_distance: float = 100.0
    wavelength: float | None = 550e-6

    def __post_init__(self) -> None:
        check_length(self.diameter, "diameter")
        check_length(self.image_distance, "image_distance")
        if self.wavelength is not None:
            check_length(self.wavelength, "wavelength")

    @property
    def light(self) -> float:
        """Irradiance on the sensor's middle by radiance, sr: the hole's area by distance squared.

        References
        ----------
        B. K. P. Horn, Robot Vision (1986), section 10.3.
        """
        return float(np.pi / 4 * (self.diameter / self.image_distance) ** 2)

    def pitch(self, camera: Camera) -> Array:
        """Return the size of a pixel of this camera, across and down, mm."""
        return np.asarray(self.image_distance / np.diag(camera.K)[:2])

    def spot(self, Z: ArrayLike) -> Array:
        """Return the diameter of the disk of a point at distance `Z` m (or infinite), mm."""
        Z = np.asarray(Z, float)
        near = np.isfinite(Z)
        finite = pinhole_blur_diameter(
            self.diameter, self.image_distance, np.where(near, Z / MM, 1.0)
        )
        return np.where(near, finite, self.diameter)


def transfer(
    frequency: ArrayLike, hole: Hole, Z: float = np.inf, disk: float | None = None
) -> Array:
    """Return how much of a fine pattern's contrast passes the hole.

    Parameters
    ----------
    frequency : array_like
        Periods a mm, on the sensor.
    hole : Hole
        The hole.
    Z : float
        Distance of the pattern from the hole, m.
    disk : float, optional
        Diameter of the disk of a point, mm, instead of that at distance `Z`.

    Returns
    -------
    ndarray
        1 at frequency 0; negative where dark and bright are exchanged.

    Raises
    ------
    TypeError, ValueError
        If a frequency is not finite or Z not positive.

    References
    ----------
    J. W. Goodman, Introduction to Fourier Optics, 3rd ed., sections 6.3.3 (diffraction, a round
    pupil) and 6.4.4 (geometrical optics). The product of both is an approximation: where they
    are of equal size, the exact answer is Fresnel's.
    """
    from scipy.special import j1

    frequency = np.abs(check_numbers(frequency, "frequency"))
    if np.isnan(Z) or Z <= 0:
        raise ValueError(f"Z must be positive, got {Z}")
    x = np.pi * (float(hole.spot(Z)) if disk is None else disk) * frequency
    tiny = x < 1e-6
    geometric = np.where(tiny, 1.0, 2 * j1(x) / np.where(tiny, 1.0, x))
    if hole.wavelength is None:
        return geometric
    cutoff = hole.diameter / (hole.wavelength * hole.image_distance)
    r = np.minimum(frequency / cutoff, 1)
    return np.asarray(geometric * (2 / np.pi) * (np.arccos(r) - r * np.sqrt(1 - r**2)))


def hole_cameras(camera: Camera, hole: Hole, count: int = 64) -> list[Camera]:
    """Return the pinhole cameras that a hole is made of, evenly spread over it.

    Parameters
    ----------
    camera : Camera
        Of the hole's centre; the world in m.
    hole : Hole
        The hole, whose image distance belongs to the camera's focal length.
    count : int
        How many.

    Returns
    -------
    list of Camera
        Their mean picture is that of the hole, without diffraction.

    Raises
    ------
    ValueError
        If the count is not positive.

    References
    ----------
    The points are H. Vogel's sunflower, Mathematical Biosciences 44 (1979) 179-189.
    """
    if count < 1:
        raise ValueError(f"count must be at least 1, got {count}")
    k = np.arange(count)
    radius = hole.diameter / 2 * np.sqrt((k + 0.5) / count)
    angle = k * np.pi * (3 - np.sqrt(5))
    cameras = []
    for x, y in zip(radius * np.cos(angle), radius * np.sin(angle), strict=True):
        # The same sensor, seen through a point beside the middle: the principal point shifts.
        K = camera.K.copy()
        K[:2, 2] -= np.array([x, y]) / hole.pitch(camera)
        t = camera.t - np.array([x, y, 0]) * MM
        cameras.append(Camera(K, camera.R, t, camera.image_size))
    return cameras


def through_points(
    take: Callable[[Camera], Array], camera: Camera, hole: Hole, count: int = 64
) -> Array:
    """Return the mean of the pictures that `take` makes through points of the hole."""
    return np.asarray(sum(take(point) for point in hole_cameras(camera, hole, count)) / count)


class Spread:
    """Spreads the light of one picture as holes of any size do.

    The picture is transformed once; each hole then costs a multiplication and a transform back.

    Parameters
    ----------
    picture : ndarray, shape (h, w, 3)
        Sharp, with a margin of real surroundings around it.
    margin : tuple of int
        Columns and rows to cut off on each side afterwards, px.
    pitch : array_like, shape (2,)
        Size of a pixel, mm.
    Z : float
        Distance of the scene from the hole, m.
    """

    def __init__(
        self, picture: ArrayLike, margin: tuple[int, int], pitch: ArrayLike, Z: float = np.inf
    ) -> None:
        import cv2

        sharp = np.asarray(picture, np.float32)
        self.margin, self.Z = margin, Z
        self._spectra = [cv2.dft(np.ascontiguousarray(sharp[..., k])) for k in range(3)]
        frequency = packed_frequency(sharp.shape[:2], check_positive(pitch, "pitch"))
        self._top = float(frequency.max())
        self._entry = np.rint(frequency * ((TABLE - 1) / self._top)).astype(np.intp)

    def through(
        self, hole: Hole, gain: float = 1.0, disk: float | None = None
    ) -> NDArray[np.float32]:
        """Return the picture through a hole.

        Parameters
        ----------
        hole : Hole
            The hole.
        gain : float
            Factor on the brightness.
        disk : float, optional
            Diameter of the disk of a point, mm, instead of that at distance `Z`.

        Returns
        -------
        ndarray, shape (h - 2 rows, w - 2 columns, 3), float32
            The picture without its margin.
        """
        import cv2

        table = transfer(np.linspace(0, self._top, TABLE), hole, self.Z, disk)
        weight = (gain * table).astype(np.float32)[self._entry]
        columns, rows = self.margin
        flags = cv2.DFT_SCALE | cv2.DFT_REAL_OUTPUT
        height, width = weight.shape
        inside = slice(rows, height - rows), slice(columns, width - columns)
        bands = [cv2.idft(spectrum * weight, flags=flags)[inside] for spectrum in self._spectra]
        return np.asarray(cv2.merge(bands), np.float32)


TABLE = 4096  # radial frequencies at which the transfer is tabulated


def packed_frequency(shape: tuple[int, ...], pitch: Array) -> Array:
    """Return the radial frequency of each entry of OpenCV's packed spectrum of a real picture.

    Parameters
    ----------
    shape : tuple of int
        Rows and columns.
    pitch : ndarray, shape (2,)
        Size of a pixel, mm.

    Returns
    -------
    ndarray, shape (rows, columns)
        Periods a mm.

    References
    ----------
    OpenCV, documentation of ``dft``: real and imaginary parts alternate along a row; the first
    column, and the last of an even number, hold the vertical frequencies in the same way.
    """
    rows, columns = shape
    down = np.abs(np.fft.fftfreq(rows, pitch[1]))[:, None]
    across = ((np.arange(columns) + 1) // 2 / (columns * pitch[0]))[None, :]
    frequency = np.hypot(down, across)
    alternating = (np.arange(rows) + 1) // 2 / (rows * pitch[1])
    frequency[:, 0] = alternating
    if columns % 2 == 0:
        frequency[:, -1] = np.hypot(alternating, across[0, -1])
    return np.asarray(frequency)


def with_margin(camera: Camera, least: int = 24) -> tuple[Camera, tuple[int, int]]:
    """Return a camera that sees more on all sides, in a size that transforms fast.

    Parameters
    ----------
    camera : Camera
        The camera.
    least : int
        Smallest margin, px.

    Returns
    -------
    camera : Camera
        With a larger sensor.
    margin : tuple of int
        Columns and rows added on each side, px.
    """
    import cv2

    width, height = camera.image_size
    extra = []
    for length in (width, height):
        total = length + 2 * least
        while (cv2.getOptimalDFTSize(total) - length) % 2:
            total = cv2.getOptimalDFTSize(total) + 1
        extra.append((cv2.getOptimalDFTSize(total) - length) // 2)
    columns, rows = extra
    K = camera.K.copy()
    K[:2, 2] += extra
    size = (width + 2 * columns, height + 2 * rows)
    return Camera(K, camera.R, camera.t, size), (columns, rows)
