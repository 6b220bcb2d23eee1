"""Judge a set-up: whether this camera with this lens, standing there, measures what is wanted.

Use these functions through `course_lib.planning`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import Array, check_not_negative
from course_lib.optics import airy_diameter, circle_of_confusion, magnification
from course_lib.planning.depth import ApertureWindow, aperture_window
from course_lib.planning.task import Setup, Task, Verdict
from course_lib.planning.view import box_in_view, depth_range, object_resolution
from course_lib.sensor import motion_blur_pixels
from course_lib.triangulation import point_covariance

WAVELENGTH_UM = 0.55  # green
NOMINAL = 0.01  # share by which sensors and image circles of a format differ from its name


def judge_setup(setup: Setup, task: Task, second: Setup | None = None) -> list[Verdict]:
    """Return a verdict on each demand of a task.

    Parameters
    ----------
    setup : Setup
        The camera.
    task : Task
        The demands.
    second : Setup, optional
        The other camera of a pair; only the last verdict looks at it.

    Returns
    -------
    list of Verdict
        In view, resolution, depth of field, diffraction, closest focus, image circle, motion blur,
        frame rate, light and, with a pair, the expected standard deviation in space.

    Raises
    ------
    ValueError
        If the box reaches behind the camera so that it has no depth range.
    """
    found = [demand(setup, task) for demand in (in_view, resolution, depth_of_field, diffraction)]
    found += [demand(setup, task) for demand in (closest_focus, image_circle, motion_blur)]
    found += [demand(setup, task) for demand in (frame_rate, light)]
    return found + ([expected_sigma(setup, second, task)] if second else [])


def in_view(setup: Setup, task: Task) -> Verdict:
    """Return whether the box is in the picture wherever it moves."""
    seen = box_in_view(task.box.with_motion(task.motion), setup.view, setup.coefficients)
    room = float(seen.margins.min())
    remedy = "" if seen.inside else "Stand farther off, take a shorter lens, or turn the camera."
    return Verdict("in view", seen.inside, room, 0.0, "px", seen.reason, remedy)


def resolution(setup: Setup, task: Task) -> Verdict:
    """Return whether a pixel is fine enough on the surface, at its farthest place."""
    corners = task.box.corners
    depth = corners @ setup.view.R[2] + setup.view.t[2]
    _, coarsest = object_resolution(corners[depth.argmax()], task.normal, setup.view)
    met = coarsest <= task.resolution
    reason = f"A pixel covers up to {1000 * coarsest:.3g} mm of the surface."
    remedy = "" if met else "Come nearer, take a longer lens or a camera with more pixels."
    limit = 1000 * task.resolution
    return Verdict("resolution", met, 1000 * coarsest, limit, "mm/px", reason, remedy)


def blur_of(setup: Setup, Z: ArrayLike) -> Array:
    """Return the diameter of the spot of defocus of points at a depth, px."""
    Z_mm, focus = 1000 * np.asarray(Z, float), 1000 * setup.focus_distance
    spot = circle_of_confusion(Z_mm, focus, setup.lens.f_mm, setup.N)
    return np.asarray(spot * 1000 / setup.camera.pitch_um)


def depth_of_field(setup: Setup, task: Task) -> Verdict:
    """Return whether the whole box, at rest, is sharp: the spot of defocus at its two ends."""
    near, far = _depths(setup, task)
    spots = blur_of(setup, [near, far])
    worst, met = float(spots.max()), bool(spots.max() <= task.blur_px * (1 + 1e-12))
    end = "near" if spots[0] > spots[1] else "far"
    reason = f"At the {end} end of the box a point makes a spot of {worst:.3g} px."
    window = _window(setup, task)
    remedy = f"Focus on {window.focus_distance:.3g} m and stop down to f/{window.least:.2g}."
    if not window.is_open:
        remedy = "No f-number does it, for diffraction. Turn the box, or stand farther off."
    return Verdict("depth of field", met, worst, task.blur_px, "px", reason, "" if met else remedy)


def diffraction(setup: Setup, task: Task) -> Verdict:
    """Return whether the Airy disk is small enough."""
    m = float(magnification(setup.lens.f_mm, 1000 * setup.focus_distance))
    airy = float(airy_diameter(WAVELENGTH_UM / 1000, setup.N * (1 + m))) * 1000
    disk, met = airy / setup.camera.pitch_um, airy <= task.blur_px * setup.camera.pitch_um
    reason = f"At f/{setup.N:g} the Airy disk measures {disk:.3g} px."
    most = setup.N * task.blur_px / disk
    remedy = "" if met else f"Open the aperture to f/{most:.2g} or wider."
    return Verdict("diffraction", met, disk, task.blur_px, "px", reason, remedy)


def closest_focus(setup: Setup, task: Task) -> Verdict:
    """Return whether the lens can be focused on so short a distance."""
    closest = setup.lens.closest
    met = setup.focus_distance >= closest
    reason = f"The focus is at {setup.focus_distance:.3g} m; this lens begins at {closest:g} m."
    remedy = "" if met else "Stand farther off, or take a lens or an extension ring for close work."
    return Verdict("closest focus", met, setup.focus_distance, closest, "m", reason, remedy)


def image_circle(setup: Setup, task: Task) -> Verdict:
    """Return whether what the lens draws covers the whole sensor; one of the same format does."""
    circle, diagonal = setup.lens.image_circle_mm, float(np.hypot(*setup.camera.sensor_size))
    met = circle >= diagonal * (1 - NOMINAL)
    reason = f"The lens draws {circle:.3g} mm across; the sensor's diagonal is {diagonal:.3g} mm."
    remedy = "" if met else "The corners stay dark: take a lens for a larger sensor."
    return Verdict("image circle", met, circle, diagonal, "mm", reason, remedy)


def motion_blur(setup: Setup, task: Task) -> Verdict:
    """Return whether the fastest point is smeared too far, where a pixel is finest."""
    check_not_negative(task.speed, "speed")
    near, _ = _depths(setup, task)
    pixel = near / setup.view.K[0, 0]  # across the line of sight
    smear = float(motion_blur_pixels(task.speed, setup.exposure_time, pixel))
    met = smear <= task.blur_px
    reason = f"In 1/{1 / setup.exposure_time:.0f} s the fastest point moves by {smear:.3g} px."
    longest = task.blur_px * pixel / task.speed if task.speed else np.inf
    remedy = "" if met else f"Expose for 1/{np.ceil(1 / longest):.0f} s or less, with more light."
    return Verdict("motion blur", met, smear, task.blur_px, "px", reason, remedy)


def frame_rate(setup: Setup, task: Task) -> Verdict:
    """Return whether the camera takes pictures fast enough, the exposure included."""
    fastest = min(setup.camera.frame_rate, 1 / setup.exposure_time)
    met = fastest >= task.frame_rate
    built = fastest == setup.camera.frame_rate
    why = "its maker's" if built else "the exposure's"
    reason = f"The camera takes {fastest:.4g} pictures a second, {why} limit."
    remedy = "Read fewer rows, or take a faster camera." if built else "Expose for less time."
    remedy = "" if met else remedy
    return Verdict("frame rate", met, fastest, task.frame_rate, "1/s", reason, remedy)


def light(setup: Setup, task: Task) -> Verdict:
    """Return whether the exposure is long enough for the aperture: t / N² makes the light."""
    t, needed = setup.exposure_time, task.exposure_at_f1 * setup.N**2
    met = t >= needed * (1 - 1e-12)
    reason = f"At f/{setup.N:g} the light needs {1e6 * needed:.3g} µs; it has {1e6 * t:.4g} µs."
    remedy = "" if met else f"Open to f/{setup.N * np.sqrt(t / needed):.2g}, or bring more lamps."
    return Verdict("light", met, 1e6 * t, 1e6 * needed, "µs", reason, remedy)


def expected_sigma(setup: Setup, second: Setup, task: Task, sigma_px: float = 0.1) -> Verdict:
    """Return whether two cameras together place points well enough.

    Parameters
    ----------
    setup, second : Setup
        The pair.
    task : Task
        The demands.
    sigma_px : float
        Standard deviation with which a point is found in a picture, px.
    """
    cameras = np.array([setup.view.P, second.view.P])
    spread = np.linalg.eigvalsh(point_covariance(task.box.corners, cameras, sigma_px))
    worst = float(np.sqrt(spread.max()))
    met = worst <= task.sigma
    reason = f"A corner of the box is known to ± {1000 * worst:.3g} mm in its worst direction."
    remedy = "" if met else "Move the cameras farther apart, or nearer to the object."
    return Verdict("expected σ", met, 1000 * worst, 1000 * task.sigma, "mm", reason, remedy)


def _depths(setup: Setup, task: Task) -> tuple[float, float]:
    near, far = depth_range(task.box, setup.view)
    if near <= 0:
        raise ValueError(
            f"the box reaches {-near:.3g} m behind the camera: move the camera away from it"
        )
    return near, far


def _window(setup: Setup, task: Task) -> ApertureWindow:
    near, far = _depths(setup, task)
    return aperture_window(setup.lens.f_mm, near, far, task.blur_px * setup.camera.pitch_um)
