"""Chapter 04: the exercises on exposure, the sensor, colour and illumination."""

from course_lib.exercises.sensor.colours import BAYER_MOSAIC, DEMOSAIC_BILINEAR
from course_lib.exercises.sensor.light import (
    EQUIVALENT_EXPOSURE,
    EXPOSURE_VALUE,
    SENSOR_RESPONSE,
    SIGNAL_TO_NOISE,
)
from course_lib.exercises.sensor.motion import (
    MOTION_BLUR_PIXELS,
    ROLLING_SHUTTER_SKEW,
    STRIPE_HEIGHT,
)
from course_lib.exercises.sensor.pictures import (
    CAMERA_GAIN_FROM_PAIRS,
    CLIPPED_FRACTION,
    EXPLAIN_UNDER_OR_OVER,
    FLAT_FIELD,
    SILHOUETTE_AREA,
)

#: In the order of the lesson.
EXERCISES = (
    EXPOSURE_VALUE,
    SENSOR_RESPONSE,
    SIGNAL_TO_NOISE,
    MOTION_BLUR_PIXELS,
    BAYER_MOSAIC,
    FLAT_FIELD,
    EXPLAIN_UNDER_OR_OVER,
    EQUIVALENT_EXPOSURE,
    CAMERA_GAIN_FROM_PAIRS,
    CLIPPED_FRACTION,
    ROLLING_SHUTTER_SKEW,
    DEMOSAIC_BILINEAR,
    SILHOUETTE_AREA,
    STRIPE_HEIGHT,
)
