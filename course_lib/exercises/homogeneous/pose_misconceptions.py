"""Wrong answers to the exercises of chapter 02 on poses and placements of cameras."""

from __future__ import annotations

from typing import Any

import numpy as np


def _matrix(R: Any, t: Any) -> Any:
    M = np.eye(4)
    M[:3, :3], M[:3, 3] = R, t
    return M


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
    return _matrix(R.T, -R.T @ t)


# --- camera_centre ----------------------------------------------------------------------------


def translation_as_centre(R, t):
    return t


def minus_translation(R, t):
    return -t


def minus_R_t(R, t):
    return -R @ t


def in_front_for_behind(R, t):
    return R.T @ t


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


# --- cv_from_graphics_camera ------------------------------------------------------------------


def _inverse(R_camera: Any, centre: Any) -> Any:
    return R_camera.T, -R_camera.T @ centre


def axes_left_as_they_are(world_from_camera):
    return _inverse(world_from_camera[:3, :3], world_from_camera[:3, 3])


def only_z_turned_round(world_from_camera):
    R_camera = world_from_camera[:3, :3] @ np.diag([1, 1, -1])
    return _inverse(R_camera, world_from_camera[:3, 3])


def turned_about_y(world_from_camera):
    R_camera = world_from_camera[:3, :3] @ np.diag([-1, 1, -1])
    return _inverse(R_camera, world_from_camera[:3, 3])


def turned_in_the_world(world_from_camera):
    R_camera = np.diag([1, -1, -1]) @ world_from_camera[:3, :3]
    return _inverse(R_camera, world_from_camera[:3, 3])


def not_inverted(world_from_camera):
    return world_from_camera[:3, :3] @ np.diag([1, -1, -1]), world_from_camera[:3, 3]


def translation_not_turned(world_from_camera):
    R, t = _inverse(world_from_camera[:3, :3], world_from_camera[:3, 3])
    return np.diag([1, -1, -1]) @ R, t


def only_z_turned_round_late(world_from_camera):
    R, t = _inverse(world_from_camera[:3, :3], world_from_camera[:3, 3])
    return np.diag([1, 1, -1]) @ R, t


def last_row_for_the_centre(world_from_camera):
    R_camera = world_from_camera[:3, :3] @ np.diag([1, -1, -1])
    return _inverse(R_camera, world_from_camera[3, :3])


# --- gimbal_pose ------------------------------------------------------------------------------

_LEVEL = np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]])


def _about_x(angle: Any) -> Any:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]])


def _about_z(angle: Any) -> Any:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def _from_axes(R_camera: Any, mount: Any, offset: Any) -> Any:
    return _inverse(R_camera, mount + R_camera @ offset)


def tilted_first(pan, tilt, mount, offset):
    return _from_axes(_about_x(tilt) @ _about_z(pan) @ _LEVEL, mount, offset)


def offset_along_the_world(pan, tilt, mount, offset):
    return _inverse(_about_z(pan) @ _about_x(tilt) @ _LEVEL, mount + offset)


def angles_in_degrees(pan, tilt, mount, offset):
    pan, tilt = np.radians(pan), np.radians(tilt)
    return _from_axes(_about_z(pan) @ _about_x(tilt) @ _LEVEL, mount, offset)


def pans_to_the_right(pan, tilt, mount, offset):
    return _from_axes(_about_z(-pan) @ _about_x(tilt) @ _LEVEL, mount, offset)


def tilts_down(pan, tilt, mount, offset):
    return _from_axes(_about_z(pan) @ _about_x(-tilt) @ _LEVEL, mount, offset)


def camera_to_world(pan, tilt, mount, offset):
    R_camera = _about_z(pan) @ _about_x(tilt) @ _LEVEL
    return R_camera, mount + R_camera @ offset


def looks_up_at_rest(pan, tilt, mount, offset):
    return _from_axes(_about_z(pan) @ _about_x(tilt), mount, offset)


def axes_as_rows(pan, tilt, mount, offset):
    return _from_axes(_about_z(pan) @ _about_x(tilt) @ _LEVEL.T, mount, offset)


def factors_reversed(pan, tilt, mount, offset):
    R_camera = _LEVEL @ _about_x(tilt) @ _about_z(pan)
    return _inverse(R_camera, offset + R_camera @ mount)


def offset_forgotten(pan, tilt, mount, offset):
    return _inverse(_about_z(pan) @ _about_x(tilt) @ _LEVEL, mount)


def matrix_of_the_placement(pan, tilt, mount, offset):
    R_camera = _about_z(pan) @ _about_x(tilt) @ _LEVEL
    return _matrix(R_camera, mount + R_camera @ offset)


def matrix_of_the_pose(pan, tilt, mount, offset):
    return _matrix(*_from_axes(_about_z(pan) @ _about_x(tilt) @ _LEVEL, mount, offset))
