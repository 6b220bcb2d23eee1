import math
import re

import numpy as np


def image_distance(f, Z):
    """Follow two rays of a point at height 1: through the middle, and in parallel."""
    middle = -1 / np.asarray(Z, dtype=float)  # its slope
    parallel = -1 / f
    return 1 / (middle - parallel)  # they differ by 1 at the lens


def object_distance(f, m):
    beyond_the_focal_point = f / m  # Newton's form
    return beyond_the_focal_point + f


def f_number(f, d):
    return np.array([f / one for one in d]) if np.ndim(d) else f / d


def hyperfocal_distance(f, N, c):
    """Focus at H when the lens stands so far from the sensor that a star's cone is c wide there."""
    beyond_the_focal_point = c * N  # the cone opens by 1/N
    return 1 / (1 / f - 1 / (f + beyond_the_focal_point))


def depth_of_field(f, N, focus_distance, c):
    """Find the image distances whose cones are c wide on the sensor, and what they belong to."""
    near, far = [], []
    for s in np.atleast_1d(focus_distance):
        sensor, d = 1 / (1 / f - 1 / s), f / N
        behind, before = sensor * d / (d - c), sensor * d / (d + c)
        near.append(1 / (1 / f - 1 / behind))
        # Focused exactly on H, only rounding keeps the far limit from infinity.
        far.append(1 / (1 / f - 1 / before) if before > f * (1 + 1e-12) else math.inf)
    if np.ndim(focus_distance):
        return np.array(near), np.array(far)
    return near[0], far[0]


def aperture_for_depth(f, near, far, c):
    """Put the sensor between the two images so that both cones are equally wide, then size them."""
    first = 1 / (1 / f - 1 / far)
    last = 1 / (1 / f - 1 / near)
    sensor = 2 / (1 / first + 1 / last)
    d = c / (1 - sensor / last)
    return f / d, 1 / (1 / f - 1 / sensor)


def closeup_depth_of_field(m, N, c):
    depth_at_the_sensor = 2 * c * N * (1 + m)
    return depth_at_the_sensor / m / m


def airy_diameter(wavelength, N):
    sine = 1.22 * wavelength  # the first dark ring, for a hole of width 1
    return 2 * sine * N


def is_diffraction_limited(N, wavelength, pitch):
    widest = pitch / (2.44 * wavelength)
    if np.ndim(N) or np.ndim(pitch):
        return [bool(n > w) for n, w in np.broadcast(N, widest)]
    return bool(widest < N)


def lens_system(f1, f2, d):
    """Trace a ray from the left and one from the right, and prolong them until they meet."""

    def back_plane(first, second):
        height, slope = 1.0, -1 / first
        height += slope * d
        slope -= height / second
        return -1 / slope, (1 - height) / slope

    f, back = back_plane(f1, f2)
    _, front = back_plane(f2, f1)
    return [f, -front, back]


def parse_lens_name(name):
    """Split at the unit, then look for what stands before it and behind the sign of the stop."""
    before, after = name.split("mm", 1)  # a ValueError if there is no unit
    focal = [float(text) for text in before.split()[-1].split("-")]
    stop = re.findall(r"(?:[fF]/?|1:)([0-9.]+)(-[0-9.]+)?", after)
    if not stop:
        raise ValueError(name)
    stops = [float(text) for text in "".join(stop[0]).split("-")]
    return {"f_number": [stops[0], stops[-1]], "focal_length": (min(focal), max(focal))}
