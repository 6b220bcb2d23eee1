"""The triangulation bench: two or three cameras, a point, and where noise makes it be found."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray

from course_lib.camera import Camera, camera_at
from course_lib.drawing.explorers.frame import Frame, Handle, Label, Line, Picture, Readout
from course_lib.drawing.explorers.plot import Plot
from course_lib.drawing.triangulation.uncertainty import inside, outline
from course_lib.triangulation import depth_uncertainty, point_covariance, refine_point

Floats = NDArray[np.float64]

TRIALS = 200
F, SIZE = 800.0, (640, 480)
K = np.array([[F, 0, 319.5], [0, F, 239.5], [0, 0, 1]])
PLAN_SIZE, NEAR_SIZE = (400, 400), (320, 400)
#: From above, m: sideways and away from the cameras.
PLAN = Plot((40, 388, 22, 352), (-3.0, 3.0), (-0.4, 5.29))
NEAR_BOX = (58, 308, 30, 346)
#: Half heights of the enlarged view, mm: the first that holds the ellipse is taken.
REACHES = (1.0, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000)


def bench_frame(b: float, Z: float, X: float, turn_deg: float, sigma: float, third: bool) -> Frame:
    """Return where cameras find a point, again and again, from pixels with noise.

    Parameters
    ----------
    b : float
        Distance of the outer cameras, m.
    Z, X : float
        Where the point is: away from the cameras, and to the right of their middle, m.
    turn_deg : float
        How far each outer camera is turned towards the other, degrees.
    sigma : float
        Standard deviation of each pixel coordinate, px.
    third : bool
        Whether a third camera stands in the middle.

    Returns
    -------
    Frame
        Cameras and point from above, the answers enlarged, and how uncertain they are.
    """
    point = np.array([X, Z, 0.0])
    cameras = stand(b, turn_deg, third)
    seeing = [sees(camera, point) for camera in cameras]
    used = [camera for camera, seen in zip(cameras, seeing, strict=True) if seen]
    one_ray = Readout("One ray is off by", "Z σ / f", f"{1000 * Z * sigma / F:.2f}", "mm")
    if len(used) < 2:
        words = f"Only {len(used)} camera sees the point" if used else "No camera sees the point"
        plan = _plan(cameras, seeing, point, None)
        return Frame((plan, _nothing(f"{words}: two have to see it.")), (one_ray,))
    P = np.stack([camera.P for camera in used])
    C = 1e6 * point_covariance(point, P, sigma)
    off = 1000 * (answers(point, P, sigma) - point)
    rule = 1000 * float(depth_uncertainty(Z, F, b, np.sqrt(2) * sigma))
    readouts = (
        *_spread(C),
        one_ray,
        Readout("Z² √2 σ / (f b)", "", f"{rule:.2f}", "mm"),
        Readout("Angle between the outer rays", "", f"{ray_angle(cameras, point):.1f}", "°"),
        Readout("Answers in the 2σ ellipse", "", f"{100 * inside(off[:, :2], C[:2, :2]):.0f}", "%"),
    )
    return Frame((_plan(cameras, seeing, point, C[:2, :2]), _near(off, C[:2, :2])), readouts)


def _spread(C: Floats) -> tuple[Readout, ...]:
    """Return the standard deviations sideways, in depth and in height, from a covariance in mm²."""
    names = (("Sideways", "σ of X"), ("In depth", "σ of Z"), ("Height", "σ of Y"))
    sigmas = np.sqrt(np.diag(C)).tolist()
    return tuple(
        Readout(label, symbol, f"{sigma:.2f}", "mm")
        for (label, symbol), sigma in zip(names, sigmas, strict=True)
    )


def stand(b: float, turn_deg: float, third: bool) -> list[Camera]:
    """Return the cameras: left, right and perhaps one in the middle; y leads away from them."""
    turn = np.radians(turn_deg)
    places = [(-b / 2, turn), (b / 2, -turn)] + [(0.0, 0.0)] * third
    return [camera_at((x, 0, 0), (x + np.sin(a), np.cos(a), 0), K, SIZE) for x, a in places]


def sees(camera: Camera, point: Floats) -> bool:
    """Return whether a point is in the picture of a camera."""
    pixel = camera.project(point)
    return bool(((pixel >= -0.5) & (pixel <= np.array(SIZE) - 0.5)).all())


def ray_angle(cameras: list[Camera], point: Floats) -> float:
    """Return the angle between the rays of the first two cameras to a point, degrees."""
    rays = [(point - camera.centre) / np.linalg.norm(point - camera.centre) for camera in cameras]
    return float(np.degrees(np.arccos(np.clip(rays[0] @ rays[1], -1, 1))))


@cache
def _chance() -> Floats:
    return np.random.default_rng(2).standard_normal((3, TRIALS, 2))


def answers(point: Floats, P: Floats, sigma: float) -> Floats:
    """Return the best answers for a point whose pixels have noise, (TRIALS, 3), m."""
    image = P @ np.append(point, 1)
    exact = image[:, :2] / image[:, 2:]
    seen = exact[:, None] + sigma * _chance()[: len(P)]
    return refine_point(np.tile(point, (TRIALS, 1)), seen, P)


def _plan(cameras: list[Camera], seeing: list[bool], point: Floats, C: Floats | None) -> Picture:
    """Return cameras, their fields of view, rays, point and ellipse from above."""
    lines = [PLAN.frame()]
    for camera, seen in zip(cameras, seeing, strict=True):
        lines += _camera(camera, point if seen else None)
    x, z, _ = point.tolist()
    if C is not None:
        around = np.add(outline(C / 1e6, 20), (x, z))
        lines.append(Line(PLAN.pixels(*around.T), "object", 1.5, closed=True))
    b = float(cameras[1].centre[0] - cameras[0].centre[0])
    turned = float(np.degrees(np.arcsin(np.clip(cameras[0].R[2, 0], -1, 1))))
    return Picture(
        "From above (ellipse: 20 σ)",
        f"{len(cameras)} cameras, the outer ones {b:.1f} m apart and turned inwards by "
        f"{turned:.0f}°; the point is {z:.1f} m away and {x:+.1f} m to the side. "
        f"{sum(seeing)} of them see it.",
        PLAN_SIZE,
        lines=tuple(lines),
        labels=(*PLAN.ticks((-2, -1, 0, 1, 2), (0, 1, 2, 3, 4, 5)), *PLAN.names("x (m)", "z (m)")),
        handles=_handles(x, z, b),
    )


def _handles(x: float, z: float, b: float) -> tuple[Handle, Handle]:
    """Return the spots that move the point, and the right camera with the left one."""
    left, right, top, bottom = PLAN.box
    across = (PLAN.x[1] - PLAN.x[0]) / (right - left)
    up = (PLAN.y[1] - PLAN.y[0]) / (bottom - top)
    start = PLAN.x[0] - across * left
    moves = (("X", start, across, 0.0), ("Z", PLAN.y[0] + up * bottom, 0.0, -up))
    apart = (("b", 2 * start, 2 * across, 0.0),)
    return Handle(PLAN.at(x, z), moves), Handle(PLAN.at(b / 2, 0), apart, "camera")


def _camera(camera: Camera, point: Floats | None) -> list[Line]:
    """Return a camera from above with its field of view, and its ray if it sees the point."""
    corners = np.array([[-0.5, 239.5], [SIZE[0] - 0.5, 239.5]])
    sides = camera.pixel_ray(corners)[:, :2]
    here = camera.centre[:2]
    body = np.array([here, here + 0.25 * sides[0], here + 0.25 * sides[1]])
    lines = [Line(PLAN.pixels(*body.T), "camera", 1.5, closed=True, fill=0.6)]
    for side in sides:
        steps = here + np.linspace(0.25, 7, 60)[:, None] * side
        lines.append(Line(PLAN.pixels(*steps.T), "guide", 0.8, dashed=True))
    if point is not None:
        lines.append(Line(PLAN.pixels(*np.array([here, point[:2]]).T), "ray", 1.5))
    return lines


def _near(off: Floats, C: Floats) -> Picture:
    """Return the answers around the true point, with the ellipse that was predicted."""
    spread = np.sqrt(np.diag(C))
    reach = next((r for r in REACHES if r >= 2.6 * spread.max()), REACHES[-1])
    left, right, top, bottom = NEAR_BOX
    wide = reach * (right - left) / (bottom - top)
    plot = Plot(NEAR_BOX, (-wide, wide), (-reach, reach))
    lines = (
        plot.frame(),
        Line(_crosses(plot.pixels(*off[:, :2].T)), "object", 1.5),
        Line(plot.pixels(*outline(C).T), "camera", 2.5, closed=True),
    )
    return Picture(
        f"{TRIALS} answers and the ellipse (2 σ)",
        f"{TRIALS} answers scatter around the true point; the ellipse of two standard deviations "
        f"is {4 * spread[1]:.1f} mm long in depth and {4 * spread[0]:.1f} mm sideways.",
        NEAR_SIZE,
        lines=lines,
        labels=(
            *plot.ticks((-reach / 2, 0, reach / 2), (-reach, 0, reach)),
            *plot.names("error in x (mm)", "error in z (mm)"),
        ),
    )


def _crosses(spots: Floats) -> Floats:
    """Return small crosses at pixels, those that are somewhere, as one line that lifts its pen."""
    spots = spots[np.isfinite(spots).all(axis=1)]
    arms = np.array([(-2, 0), (2, 0), (0, 0), (0, -2), (0, 2), (np.nan, np.nan)])
    return np.asarray((spots[:, None] + arms).reshape(-1, 2))


def _nothing(words: str) -> Picture:
    sentence, _, advice = words.partition(": ")
    labels = (
        Label(f"{sentence}:", (160, 180), anchor="middle"),
        Label(advice, (160, 202), anchor="middle"),
    )
    return Picture(f"{TRIALS} answers and the ellipse (2 σ)", words, NEAR_SIZE, labels=labels)
