"""Inputs for the exercises of chapter 02 on cameras in the world; the answers are constructed."""

from __future__ import annotations

import numpy as np
from numpy.random import Generator

from course_lib.exercises.homogeneous.inputs import Floats, any_rotation, away_from_zero
from course_lib.judging import Known

IDENTITY = np.eye(3)
NOWHERE = np.zeros(3)


def a_place(rng: Generator) -> Floats:
    return np.asarray(away_from_zero(rng, 1, 9, 3))


def placed(R_camera: Floats, centre: Floats) -> tuple[Floats, Floats]:
    """Return the pose of a camera: what its axes measure of a point, seen from its centre."""
    axes = R_camera.T  # each row is an axis of the camera in the world
    return axes, np.array([-axis @ centre for axis in axes])


def inverse_of(R_camera: Floats, centre: Floats) -> Known:
    R, t = placed(R_camera, centre)
    return Known({"R": R, "t": t}, (R_camera, centre))


def moved_pose(rng: Generator) -> Known:
    return inverse_of(IDENTITY, a_place(rng))


def turned_pose(rng: Generator) -> Known:
    return inverse_of(any_rotation(rng), NOWHERE)


def any_pose(rng: Generator) -> Known:
    return inverse_of(any_rotation(rng), a_place(rng))


def placement(R_camera: Floats, centre: Floats) -> Known:
    return Known({"R_camera": R_camera, "centre": centre}, placed(R_camera, centre))


def moved_camera(rng: Generator) -> Known:
    return placement(IDENTITY, a_place(rng))


def turned_camera(rng: Generator) -> Known:
    return placement(any_rotation(rng), NOWHERE)


def any_camera(rng: Generator) -> Known:
    return placement(any_rotation(rng), a_place(rng))


def centre_of(rng: Generator, R_camera: Floats) -> Known:
    centre = a_place(rng)
    R, t = placed(R_camera, centre)
    return Known({"R": R, "t": t}, centre)


def centre_of_moved_camera(rng: Generator) -> Known:
    return centre_of(rng, IDENTITY)


def centre_of_any_camera(rng: Generator) -> Known:
    return centre_of(rng, any_rotation(rng))


def graphics(R_camera: Floats, centre: Floats) -> Known:
    """Write down our camera's axes as a graphics program would: x, -y, -z."""
    x, y, z = R_camera.T
    matrix = np.eye(4)
    matrix[:3] = np.column_stack([x, -y, -z, centre])
    return Known({"world_from_camera": matrix}, placed(R_camera, centre))


def graphics_camera_at_rest(rng: Generator) -> Known:
    return graphics(np.diag([1.0, -1.0, -1.0]), a_place(rng))


def any_graphics_camera(rng: Generator) -> Known:
    return graphics(any_rotation(rng), a_place(rng))


def gimbal(pan: float, tilt: float, mount: Floats, offset: Floats) -> Known:
    """Find the camera's axes by trigonometry in the world, without a product of matrices."""
    right = np.array([np.cos(pan), np.sin(pan), 0])
    level = np.array([-np.sin(pan), np.cos(pan), 0])
    up = np.array([0, 0, 1])
    forward = np.cos(tilt) * level + np.sin(tilt) * up
    down = np.sin(tilt) * level - np.cos(tilt) * up
    R_camera = np.column_stack([right, down, forward])
    inputs = {"pan": pan, "tilt": tilt, "mount": mount, "offset": offset}
    return Known(inputs, placed(R_camera, mount + R_camera @ offset))


def an_angle(rng: Generator) -> float:
    return float(away_from_zero(rng, 0.3, 1.1))


def panned(rng: Generator) -> Known:
    return gimbal(an_angle(rng), 0.0, a_place(rng), NOWHERE)


def tilted(rng: Generator) -> Known:
    return gimbal(0.0, an_angle(rng), a_place(rng), NOWHERE)


def panned_and_tilted(rng: Generator) -> Known:
    return gimbal(an_angle(rng), an_angle(rng), a_place(rng), NOWHERE)


def off_the_axes(rng: Generator) -> Known:
    return gimbal(an_angle(rng), an_angle(rng), a_place(rng), 0.1 * a_place(rng))


# --- the camera matrix ------------------------------------------------------------------------


def intrinsics(rng: Generator, skew: float = 0.0) -> Floats:
    f, aspect = rng.uniform(500, 1500), rng.uniform(1.1, 1.4)
    cx, cy = rng.uniform(250, 400), rng.uniform(120, 220)
    return np.array([[f, skew, cx], [0, f * aspect, cy], [0, 0, 1]])


def matrix_of(K: Floats, R_camera: Floats, centre: Floats) -> Known:
    """Compose the camera matrix column by column: the images of the axes and of the origin."""
    R, t = placed(R_camera, centre)
    columns = [K @ column for column in (*R.T, t)]
    return Known({"K": K, "R": R, "t": t}, np.column_stack(columns))


def matrix_at_the_origin(rng: Generator) -> Known:
    return matrix_of(intrinsics(rng), IDENTITY, NOWHERE)


def matrix_of_a_moved_camera(rng: Generator) -> Known:
    return matrix_of(intrinsics(rng), IDENTITY, a_place(rng))


def matrix_of_any_camera(rng: Generator) -> Known:
    skew = away_from_zero(rng, 20, 60)
    return matrix_of(intrinsics(rng, skew), any_rotation(rng), a_place(rng))


def seen(rng: Generator, skew: float = 0.0, at: Floats | None = None) -> tuple[Floats, Known]:
    """Put points on the rays of pixels: pixels first, then depths, then the world."""
    K, R_camera, centre = intrinsics(rng, skew), any_rotation(rng), a_place(rng)
    centre = centre if at is None else at
    pixels = rng.uniform((-300, -200), (940, 680), (5, 2))  # also outside of the picture
    y = (pixels[:, 1] - K[1, 2]) / K[1, 1]
    x = (pixels[:, 0] - K[0, 2] - skew * y) / K[0, 0]
    ahead = np.column_stack([x, y, np.ones(5)])
    rays = ahead @ R_camera.T
    R, t = placed(R_camera, centre)
    unit = rays / np.sqrt((rays**2).sum(axis=1, keepdims=True))
    case = Known({"pixels": pixels, "K": K, "R": R, "t": t}, (centre, unit))
    return centre + rng.uniform(2, 9, (5, 1)) * rays, case


def project_case(rng: Generator) -> Known:
    points, case = seen(rng, away_from_zero(rng, 20, 60))
    pose = {name: case.inputs[name] for name in ("K", "R", "t")}
    P = matrix_of(pose["K"], pose["R"].T, case.truth[0]).truth
    return Known({"points": points, "P": P}, case.inputs["pixels"])


def points_in_front(rng: Generator) -> Known:
    return project_case(rng)


def one_point(rng: Generator) -> Known:
    many = project_case(rng)
    return Known({**many.inputs, "points": many.inputs["points"][0]}, many.truth[0])


def points_behind(rng: Generator) -> Known:
    """Mirror two of the points in the camera's centre."""
    many = project_case(rng)
    points, truth, P = many.inputs["points"].copy(), many.truth.copy(), many.inputs["P"]
    centre = np.linalg.solve(P[:, :3], -P[:, 3])
    points[[1, 2]] = 2 * centre - points[[1, 2]]
    truth[[1, 2]] = np.nan
    return Known({"points": points, "P": P}, truth)


def negative_matrix(rng: Generator) -> Known:
    """Give the same camera by a negative multiple of its matrix."""
    many = project_case(rng)
    return Known({**many.inputs, "P": -rng.uniform(0.2, 3) * many.inputs["P"]}, many.truth)


def rays_of_pixels(rng: Generator) -> Known:
    return seen(rng)[1]


def rays_from_the_origin(rng: Generator) -> Known:
    return seen(rng, at=NOWHERE)[1]


def ray_of_one_pixel(rng: Generator) -> Known:
    case = seen(rng)[1]
    centre, directions = case.truth
    inputs = {**case.inputs, "pixels": case.inputs["pixels"][0]}
    return Known(inputs, (centre, directions[0]))


def rays_with_skew(rng: Generator) -> Known:
    return seen(rng, away_from_zero(rng, 60, 120))[1]
