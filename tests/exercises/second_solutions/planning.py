import math

import numpy as np


def box_in_view(size, centre, motion, P, image_size):
    """Corner by corner, with the room of each on each side."""
    rooms = []
    for number in range(8):
        corner = [1.0] * 4
        for axis in range(3):
            step = size[axis] / 2 + motion[axis]
            corner[axis] = centre[axis] + (step if number >> axis & 1 else -step)
        a, b, w = P @ corner
        if w <= 0:
            return [-math.inf] * 4
        u, v = a / w, b / w
        rooms.append([u + 0.5, image_size[0] - u - 0.5, v + 0.5, image_size[1] - v - 0.5])
    return np.min(rooms, axis=0)


def object_resolution(Z, f_mm, pitch_um, tilt):
    """By way of the focal length in pixels."""
    f = f_mm * 1000 / pitch_um
    return np.array([Z / f, Z / f / math.cos(tilt)])


def aperture_window(f_mm, near, far, spot_um, wavelength_um):
    """In mm; from the near end, and with the image distance."""
    near, far, c = 1000 * near, 1000 * far, spot_um / 1000
    focus = 2 / (1 / near + 1 / far)
    image = 1 / (1 / f_mm - 1 / focus)
    aperture = c * near / (image / focus * (focus - near))
    return [f_mm / aperture, spot_um / 2.44 / wavelength_um / (image / f_mm)]


def ground_sample_distance(H, f_mm, pitch_um):
    return np.asarray(H) / (1000 * f_mm / pitch_um)


def overlap(base, footprint):
    return (footprint - base) / footprint


def base_for_overlap(share, footprint):
    return footprint - share * footprint


def max_speed(base, interval, gsd, exposure_time, blur):
    slower = base / interval < blur * gsd / exposure_time
    return np.where(slower, base / interval, blur * gsd / exposure_time)


def photo_count(length, width, base, distance, footprint_width):
    pictures, strips = 1, 1
    while (pictures - 1) * base < length:
        pictures += 1
    while footprint_width + (strips - 1) * distance < width:
        strips += 1
    return [pictures, strips]
