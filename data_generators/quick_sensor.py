"""Noise for pictures that follow a slider: drawn once, scaled anew for every picture."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from course_lib.checks import check_not_negative, check_number
from course_lib.sensor import SensorModel, mean_electrons, sensor_response
from data_generators.paint import Picture

ROOM = 64  # px: frames begin at different places of a field that is larger by this


class QuickSensor:
    """Exposes 8-bit pictures of one size with the noise of any sensor, in about a millisecond.

    As `course_lib.sensor.expose_with_field`: shot and readout noise are one normal distribution.
    Light comes in 256 levels, so mean and spread are read from tables.

    Parameters
    ----------
    image_size : tuple of int
        Width and height, px.
    rng : numpy.random.Generator
        Draws the noise, once.

    Examples
    --------
    >>> quick = QuickSensor((160, 120), np.random.default_rng(0))
    >>> sensor = SensorModel(quantum_efficiency=0.5, gain=0.1, offset=16, bits=8)
    >>> grey = np.full((120, 160, 3), 128, np.uint8)
    >>> numbers = quick.numbers(grey, sensor, white=4000)
    >>> float(numbers.mean().round()), float(numbers.std().round())  # 1000 electrons, 16 + 100 DN
    (116.0, 3.0)
    """

    def __init__(self, image_size: tuple[int, int], rng: np.random.Generator) -> None:
        self.image_size = image_size
        width, height = image_size
        shape = (height + ROOM, width + ROOM, 3)
        self._field = rng.standard_normal(shape, np.float32)

    def numbers(
        self,
        picture: Picture,
        sensor: SensorModel,
        white: float,
        exposure_time: float = 0.0,
        frame: int = 0,
    ) -> NDArray[np.unsignedinteger]:
        """Return what a sensor writes down of a picture.

        Parameters
        ----------
        picture : ndarray, shape (height, width, 3) or (height, width), uint8
            Linear in light.
        sensor : SensorModel
            The sensor.
        white : float
            Photons in a pixel where the picture holds 255.
        exposure_time : float
            Seconds during which the dark current is collected.
        frame : int
            Another number, another noise; the same number, the same.

        Returns
        -------
        ndarray of the same shape, uint8 or uint16
            DN; `uint8` for up to 8 bits.

        Raises
        ------
        TypeError, ValueError
            If `white` is negative, or the picture is not of this size and type.
        """
        import cv2

        if picture.dtype != np.uint8 or picture.shape[1::-1] != self.image_size:
            raise ValueError(
                f"picture must be uint8 and {self.image_size} px (width, height), "
                f"got {picture.dtype} and {picture.shape[1::-1]}"
            )
        white = check_number(check_not_negative(white, "white"), "white")
        photons = np.linspace(0, white, 256)
        mean = sensor_response(photons, sensor, exposure_time).astype(np.float32)
        electrons = mean_electrons(photons, sensor, exposure_time)
        shot = np.where(electrons < sensor.full_well, electrons, 0)
        spread = (sensor.gain * np.sqrt(shot + sensor.read_noise**2)).astype(np.float32)
        levels = cv2.multiply(cv2.LUT(picture, spread), self._window(frame, picture.ndim))
        depth = cv2.CV_8U if sensor.bits <= 8 else cv2.CV_16U
        levels = cv2.add(levels, cv2.LUT(picture, mean), dst=levels)
        written = cv2.add(levels, 0.0, dtype=depth)
        if sensor.white not in (255, 65535):
            written = np.minimum(written, np.asarray(sensor.white, written.dtype), out=written)
        return np.asarray(written)

    def _window(self, frame: int, dimensions: int) -> NDArray[np.float32]:
        """Return a window of the field, another one for each of thousands of frames."""
        width, height = self.image_size
        left, top = frame * 37 % ROOM, frame * 23 // ROOM % ROOM
        field = self._field[top : top + height, left : left + width]
        return field if dimensions == 3 else np.ascontiguousarray(field[..., 0])


def developed(numbers: NDArray[np.unsignedinteger], sensor: SensorModel) -> Picture:
    """Return numbers as an 8-bit picture, linear in light: no light is 0, saturation 255.

    Parameters
    ----------
    numbers : ndarray, uint8 or uint16
        DN.
    sensor : SensorModel
        What wrote them.

    Returns
    -------
    ndarray of the same shape, uint8
        To look at, not to measure in.
    """
    import cv2

    top = min(sensor.white, sensor.offset + sensor.gain * sensor.full_well)
    scale = 255 / (top - sensor.offset)
    shown = cv2.addWeighted(numbers, scale, numbers, 0, -sensor.offset * scale, dtype=cv2.CV_8U)
    return np.asarray(shown)
