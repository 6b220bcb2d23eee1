import math

import numpy as np


def pixel_focal_length(f, sensor_size, image_size):
    pitch_x = sensor_size[0] / image_size[0]
    pitch_y = sensor_size[1] / image_size[1]
    return [f / pitch_x, f / pitch_y]


def field_of_view(f, sensor_size):
    width, height = sensor_size
    sides = [width, height, math.sqrt(width**2 + height**2)]
    return np.array([math.pi - 2 * math.atan2(f, side / 2) for side in sides])


def equivalent_focal_length(f, sensor_size):
    diagonal_angle = 2 * math.atan(math.dist((0, 0), sensor_size) / 2 / f)
    return math.dist((0, 0), (36, 24)) / 2 / math.tan(diagonal_angle / 2)


def first_guess_intrinsics(f, sensor_size, image_size):
    K = np.eye(3)
    for axis in range(2):
        K[axis, axis] = f / (sensor_size[axis] / image_size[axis])
        K[axis, 2] = image_size[axis] / 2 - 0.5
    return K


def project_pinhole(points, f, c):
    fx, fy = (f, f) if np.ndim(f) == 0 else f
    K = np.array([[fx, 0, c[0]], [0, fy, c[1]], [0, 0, 1]])
    pixels = []
    for X in np.atleast_2d(points):
        x = K @ X
        pixels.append(x[:2] / x[2] if X[2] > 0 else (math.nan, math.nan))
    return np.array(pixels) if np.ndim(points) == 2 else np.array(pixels[0])


def vanishing_point(direction, f, c):
    pixels = []
    for d in np.atleast_2d(direction):
        if d[2] == 0:
            pixels.append([math.nan, math.nan])
        else:
            far = d / d[2] * 1e9  # a point very far along the line
            pair = (f, f) if np.ndim(f) == 0 else f
            pixels.append([c[i] + pair[i] * far[i] / far[2] for i in range(2)])
    return np.array(pixels) if np.ndim(direction) == 2 else np.array(pixels[0])


def dolly_zoom(f, Z, Z_new):
    size_in_picture = f / Z
    return size_in_picture * Z_new


def best_pinhole_diameter(image_distance, wavelength):
    """Minimise d + 2.44 λ s / d by Newton's method on its derivative."""
    spread = 2.44 * wavelength * image_distance
    d = 0.3 + 0 * spread
    for _ in range(60):
        d = d - (1 - spread / d**2) / (2 * spread / d**3)
        d = np.maximum(d, 1e-3)
    return d


def data_sheet(f, sensor_size, image_size, f_calibrated):
    """Typed in with the digits of a pocket calculator."""
    return {
        "pixels_per_mm": 74.2,
        "f_px": 6307.2,
        "c_x": 1023.5,
        "c_y": 959.5,
        "f_calibrated_mm": 92.9,
    }
