"""Wrong answers to the exercises of chapter 02 on poses and placements of cameras."""

from __future__ import annotations

from typing import Any

import numpy as np


def matrix_of(R: Any, t: Any) -> Any:
    """Return a pose as one matrix."""
    M = np.eye(4)
    M[:3, :3], M[:3, 3] = R, t
    return M


def inverse_of(R_camera: Any, centre: Any) -> Any:
    """Return the pose of a placed camera."""
    return R_camera.T, -R_camera.T @ centre


# --- invert_pose ------------------------------------------------------------------------------


def only_R_transposed(R, t):
    return R.T, t


def R_and_t_apart(R, t):
    return R.T, -t


def R_where_its_inverse_belongs(R, t):
    return R.T, -R @ t


def sign_left_out(R, t):
    return R.T, R.T @ t


def R_kept(R, t):
    return R, -R.T @ t


def matrix_of_the_way_back(R, t):
    return matrix_of(R.T, -R.T @ t)


def R_times_t_entry_by_entry(R, t):
    return R.T, -R.T * t


def R_inverted_entry_by_entry(R, t):
    return 1 / R, -(1 / R) @ t


# --- camera_centre ----------------------------------------------------------------------------


def translation_as_centre(R, t):
    return t


def minus_translation(R, t):
    return -t


def minus_R_t(R, t):
    return -R @ t


def in_front_for_behind(R, t):
    return R.T @ t


def centre_entry_by_entry(R, t):
    return -R.T * t


def rotation_of_the_way_back(R, t):
    return R.T


def whole_way_back(R, t):
    return inverse_of(R, t)


# --- pose_from_placement ----------------------------------------------------------------------


def placement_as_pose(R_camera, centre):
    return R_camera, centre


def centre_as_translation(R_camera, centre):
    return R_camera.T, centre


def only_the_sign_changed(R_camera, centre):
    return R_camera.T, -centre


def R_camera_for_R(R_camera, centre):
    return R_camera, -R_camera @ centre


def R_camera_on_the_centre(R_camera, centre):
    return R_camera.T, -R_camera @ centre


def t_entry_by_entry(R_camera, centre):
    return R_camera.T, -R_camera.T * centre


def matrix_of_the_pose(R_camera, centre):
    return matrix_of(*inverse_of(R_camera, centre))


# --- cv_from_graphics_camera ------------------------------------------------------------------


def axes_left_as_they_are(world_from_camera):
    return inverse_of(world_from_camera[:3, :3], world_from_camera[:3, 3])


def only_z_turned_round(world_from_camera):
    R_camera = world_from_camera[:3, :3] @ np.diag([1, 1, -1])
    return inverse_of(R_camera, world_from_camera[:3, 3])


def only_y_turned_round(world_from_camera):
    R_camera = world_from_camera[:3, :3] @ np.diag([1, -1, 1])
    return inverse_of(R_camera, world_from_camera[:3, 3])


def all_axes_turned_round(world_from_camera):
    return inverse_of(-world_from_camera[:3, :3], world_from_camera[:3, 3])


def y_and_z_exchanged(world_from_camera):
    return inverse_of(world_from_camera[:3, [0, 2, 1]], world_from_camera[:3, 3])


def turned_about_y(world_from_camera):
    R_camera = world_from_camera[:3, :3] @ np.diag([-1, 1, -1])
    return inverse_of(R_camera, world_from_camera[:3, 3])


def turned_in_the_world(world_from_camera):
    R_camera = np.diag([1, -1, -1]) @ world_from_camera[:3, :3]
    return inverse_of(R_camera, world_from_camera[:3, 3])


def not_inverted(world_from_camera):
    return world_from_camera[:3, :3] @ np.diag([1, -1, -1]), world_from_camera[:3, 3]


def translation_not_turned(world_from_camera):
    R, t = inverse_of(world_from_camera[:3, :3], world_from_camera[:3, 3])
    return np.diag([1, -1, -1]) @ R, t


def only_z_turned_round_late(world_from_camera):
    R, t = inverse_of(world_from_camera[:3, :3], world_from_camera[:3, 3])
    return np.diag([1, 1, -1]) @ R, t


def last_row_for_the_centre(world_from_camera):
    R_camera = world_from_camera[:3, :3] @ np.diag([1, -1, -1])
    return inverse_of(R_camera, world_from_camera[3, :3])


def graphics_t_entry_by_entry(world_from_camera):
    R = (world_from_camera[:3, :3] @ np.diag([1, -1, -1])).T
    return R, -R * world_from_camera[:3, 3]


def matrix_of_the_graphics_pose(world_from_camera):
    R_camera = world_from_camera[:3, :3] @ np.diag([1, -1, -1])
    return matrix_of(*inverse_of(R_camera, world_from_camera[:3, 3]))
