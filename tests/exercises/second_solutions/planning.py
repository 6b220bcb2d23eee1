import itertools
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


def plan_setup(task, cameras, lenses):
    """From the far end: the camera goes back as far as the resolution lets it, or nearly."""
    plans = []
    for (c, camera), (k, lens) in itertools.product(enumerate(cameras), enumerate(lenses)):
        f = lens["f_mm"] * 1000 / camera["pitch_um"]  # px
        room = [
            camera[side] / (task[side] + 2 * task["motion"]) / f for side in ("width", "height")
        ]
        near = max(1 / min(room), task["stand_off"], lens["closest"])
        reserve = task["resolution"] * f - near - task["depth"]
        if camera["frame_rate"] < task["frame_rate"] or reserve < 0:
            continue
        near += 0.3 * reserve
        middle = near + task["depth"] / 2
        spot = task["blur_px"] * camera["pitch_um"]
        ends = [lens["f_mm"], near, near + task["depth"], spot, 0.55]
        least, most = aperture_window(*ends)
        N = max(least * 1.01, lens["N_least"])
        shortest = 1.01 * N * N * task["exposure_at_f1"]
        smear = task["speed"] * shortest * f / near
        quick = smear < task["blur_px"] and shortest * task["frame_rate"] < 1
        if min(most, lens["N_most"]) > N and quick:
            plans.append((N, c, k, middle, shortest))
    N, c, k, middle, time = min(plans)
    return {"exposure_time": time, "N": N, "lens": k, "camera": c, "distance": middle}
