"""Light to numbers: the sensor, its noise and its colours, and how long it looks.

Counts of photons and electrons are those of one pixel; DN ("digital number") is what the file
holds. Times in seconds, angles in radians.
"""

from course_lib.detector import (
    digitise,
    expose,
    expose_with_field,
    mean_electrons,
    sensor_response,
)
from course_lib.falloff import lateral_chromatic_shift, mechanical_vignetting, vignetting
from course_lib.mosaic import bayer_masks, bayer_mosaic
from course_lib.sensor_model import SensorModel

__all__ = [
    "SensorModel",
    "bayer_masks",
    "bayer_mosaic",
    "digitise",
    "expose",
    "expose_with_field",
    "lateral_chromatic_shift",
    "mean_electrons",
    "mechanical_vignetting",
    "sensor_response",
    "vignetting",
]
