"""Chapter 04: the exercises on exposure, the sensor, colour and illumination."""

from course_lib.exercises.sensor.light import (
    EQUIVALENT_EXPOSURE,
    EXPOSURE_VALUE,
    MOTION_BLUR_PIXELS,
    ROLLING_SHUTTER_SKEW,
    SENSOR_RESPONSE,
    SIGNAL_TO_NOISE,
    STRIPE_HEIGHT,
)

#: In the order of the lesson.
EXERCISES = (
    EXPOSURE_VALUE,
    EQUIVALENT_EXPOSURE,
    SENSOR_RESPONSE,
    SIGNAL_TO_NOISE,
    MOTION_BLUR_PIXELS,
    ROLLING_SHUTTER_SKEW,
    STRIPE_HEIGHT,
)
