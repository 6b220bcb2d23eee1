"""Light to numbers: exposure, the sensor with its noise and colours, and how long it looks.

Counts of photons and electrons are those of one pixel; DN ("digital number") is what the file
holds. Times in seconds, angles in radians.
"""

from course_lib.sensor.detector import (
    digitise,
    expose,
    expose_with_field,
    mean_electrons,
    sensor_response,
)
from course_lib.sensor.exposure import (
    decibels,
    equivalent_exposure,
    exposure_difference,
    exposure_value,
    luminance,
    photons_per_pixel,
    stops,
)
from course_lib.sensor.falloff import lateral_chromatic_shift, mechanical_vignetting, vignetting
from course_lib.sensor.mosaic import bayer_masks, bayer_mosaic, demosaic_bilinear
from course_lib.sensor.photon_transfer import (
    camera_gain_from_pairs,
    clipped_fraction,
    dynamic_range,
    flat_field,
    signal_to_noise,
)
from course_lib.sensor.sensor_model import SensorModel
from course_lib.sensor.shutter import fastest_speed, motion_blur_pixels, rolling_shutter_skew
from course_lib.sensor.tone import (
    grey_from_rgb,
    hsv_from_rgb,
    rgb_from_hsv,
    srgb_decode,
    srgb_encode,
)

__all__ = [
    "SensorModel",
    "bayer_masks",
    "bayer_mosaic",
    "camera_gain_from_pairs",
    "clipped_fraction",
    "decibels",
    "demosaic_bilinear",
    "digitise",
    "dynamic_range",
    "equivalent_exposure",
    "expose",
    "expose_with_field",
    "exposure_difference",
    "exposure_value",
    "fastest_speed",
    "flat_field",
    "grey_from_rgb",
    "hsv_from_rgb",
    "lateral_chromatic_shift",
    "luminance",
    "mean_electrons",
    "mechanical_vignetting",
    "motion_blur_pixels",
    "photons_per_pixel",
    "rgb_from_hsv",
    "rolling_shutter_skew",
    "sensor_response",
    "signal_to_noise",
    "srgb_decode",
    "srgb_encode",
    "stops",
    "vignetting",
]
