import math

import numpy as np


def exposure_value(N, t, iso=100):
    light_of_settings = t * iso / 100 / np.square(N)
    return -np.log(light_of_settings) / math.log(2)


def equivalent_exposure(t, N, N_new, iso=100, iso_new=100):
    stops = 2 * np.log2(np.asarray(N_new) / N) - math.log2(iso_new / iso)
    return t * 2.0**stops


def sensor_response(photons, sensor, exposure_time=0.0):
    numbers = []
    for count in photons:
        electrons = count * sensor.quantum_efficiency + exposure_time * sensor.dark_current
        if electrons > sensor.full_well:
            electrons = sensor.full_well
        numbers.append(min(sensor.offset + electrons * sensor.gain, 2**sensor.bits - 1))
    return numbers


def signal_to_noise(photons, sensor, exposure_time=0.0):
    """In DN instead of electrons."""
    K = sensor.gain
    signal = K * sensor.quantum_efficiency * photons
    shot = K * signal
    dark = K**2 * sensor.dark_current * exposure_time
    readout = (K * sensor.read_noise) ** 2
    return signal / (shot + dark + readout + 1 / 12) ** 0.5


def motion_blur_pixels(speed, exposure_time, pixel_size):
    pixels_per_second = speed / pixel_size
    return exposure_time * pixels_per_second


def rolling_shutter_skew(speed, row_time, rows):
    reading = np.asarray(rows) * row_time
    return reading * speed


def stripe_height(shift, light_angle, camera_angle=0.0):
    """Where the two lines meet: x = z tan(light) and shift - x = z tan(camera)."""
    heights = []
    for s in np.atleast_1d(shift):
        lines = np.array([[1, -math.tan(light_angle)], [1, math.tan(camera_angle)]])
        heights.append(np.linalg.solve(lines, [0, s])[1])
    return np.array(heights) if np.ndim(shift) else heights[0]
