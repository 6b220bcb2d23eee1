"""Wrong answers to the exercises of chapter 02 on turning about an axis and on a gimbal."""

from __future__ import annotations

from typing import Any

import numpy as np

from course_lib.exercises.homogeneous.pose_misconceptions import inverse_of, matrix_of

# --- rotation_about_axis ----------------------------------------------------------------------


def _cross(v: Any) -> Any:
    x, y, z = v
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def _rodrigues(k: Any, angle: Any) -> Any:
    return np.eye(3) + np.sin(angle) * _cross(k) + (1 - np.cos(angle)) * _cross(k) @ _cross(k)


def axis_not_unit(axis, angle):
    return _rodrigues(axis, angle)


def angle_taken_for_degrees(axis, angle):
    return _rodrigues(axis / np.linalg.norm(axis), np.radians(angle))


def clockwise(axis, angle):
    return _rodrigues(axis / np.linalg.norm(axis), -angle)


def small_turns_only(axis, angle):
    return np.eye(3) + np.sin(angle) * _cross(axis / np.linalg.norm(axis))


def cosine_for_its_complement(axis, angle):
    k = _cross(axis / np.linalg.norm(axis))
    return np.eye(3) + np.sin(angle) * k + np.cos(angle) * k @ k


def three_turns_in_turn(axis, angle):
    x, y, z = angle * axis / np.linalg.norm(axis)
    about_z, about_y = _rodrigues((0, 0, 1), z), _rodrigues((0, 1, 0), y)
    return about_z @ about_y @ _rodrigues((1, 0, 0), x)


def number_for_a_matrix(axis, angle):
    n, c = axis / np.linalg.norm(axis), np.cos(angle)
    return c + (1 - c) * np.outer(n, n) + np.sin(angle) * _cross(n)


def number_for_the_outer_product(axis, angle):
    n, c = axis / np.linalg.norm(axis), np.cos(angle)
    return c * np.eye(3) + (1 - c) * (n @ n.T) + np.sin(angle) * _cross(n)


def _three_terms(n: Any, angle: Any, outer: Any) -> Any:
    c = np.cos(angle)
    return c * np.eye(3) + (1 - c) * outer + np.sin(angle) * _cross(n)


def axis_not_unit_in_three_terms(axis, angle):
    return _three_terms(axis, angle, np.outer(axis, axis))


def axis_not_unit_in_the_skew_matrix(axis, angle):
    n, c = axis / np.linalg.norm(axis), np.cos(angle)
    return c * np.eye(3) + (1 - c) * np.outer(n, n) + np.sin(angle) * _cross(axis)


def axis_not_unit_in_the_outer_product(axis, angle):
    n = axis / np.linalg.norm(axis)
    return _three_terms(n, angle, np.outer(axis, axis))


def axis_divided_by_its_square(axis, angle):
    n = axis / (axis @ axis)
    return _three_terms(n, angle, np.outer(n, n))


def cosine_of_the_outer_product(axis, angle):
    n, c = axis / np.linalg.norm(axis), np.cos(angle)
    return c * np.eye(3) + c * np.outer(n, n) + np.sin(angle) * _cross(n)


def outer_product_whole(axis, angle):
    n, c = axis / np.linalg.norm(axis), np.cos(angle)
    return c * np.eye(3) + np.outer(n, n) + np.sin(angle) * _cross(n)


def skew_matrix_whole(axis, angle):
    n, c = axis / np.linalg.norm(axis), np.cos(angle)
    return c * np.eye(3) + (1 - c) * np.outer(n, n) + _cross(n)


def sine_for_cosine(axis, angle):
    n = axis / np.linalg.norm(axis)
    return _three_terms(n, np.pi / 2 - angle, np.outer(n, n))


def one_outside_of_its_bracket(axis, angle):
    n, c = axis / np.linalg.norm(axis), np.cos(angle)
    return c * np.eye(3) + 1 - c * np.outer(n, n) + np.sin(angle) * _cross(n)


def axis_for_its_skew_matrix(axis, angle):
    n, c = axis / np.linalg.norm(axis), np.cos(angle)
    return c * np.eye(3) + (1 - c) * np.outer(n, n) + np.sin(angle) * n


def sine_term_forgotten(axis, angle):
    n, c = axis / np.linalg.norm(axis), np.cos(angle)
    return c * np.eye(3) + (1 - c) * np.outer(n, n)


def three_numbers_for_the_outer_product(axis, angle):
    n = axis / np.linalg.norm(axis)
    return _three_terms(n, angle, n * n.T)


# --- gimbal_pose ------------------------------------------------------------------------------

_LEVEL = np.array([[1, 0, 0], [0, 0, 1], [0, -1, 0]])


def _about_x(angle: Any) -> Any:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]])


def _about_z(angle: Any) -> Any:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def _from_axes(R_camera: Any, mount: Any, offset: Any) -> Any:
    return inverse_of(R_camera, mount + R_camera @ offset)


def tilted_first(pan, tilt, mount, offset):
    return _from_axes(_about_x(tilt) @ _about_z(pan) @ _LEVEL, mount, offset)


def offset_along_the_world(pan, tilt, mount, offset):
    return inverse_of(_about_z(pan) @ _about_x(tilt) @ _LEVEL, mount + offset)


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
    return inverse_of(R_camera, offset + R_camera @ mount)


def offset_forgotten(pan, tilt, mount, offset):
    return inverse_of(_about_z(pan) @ _about_x(tilt) @ _LEVEL, mount)


def matrix_of_the_placement(pan, tilt, mount, offset):
    R_camera = _about_z(pan) @ _about_x(tilt) @ _LEVEL
    return matrix_of(R_camera, mount + R_camera @ offset)


def matrix_of_the_pose(pan, tilt, mount, offset):
    return matrix_of(*_from_axes(_about_z(pan) @ _about_x(tilt) @ _LEVEL, mount, offset))


def offset_before_the_axes(pan, tilt, mount, offset):
    turned = _about_z(pan) @ _about_x(tilt)
    return inverse_of(turned @ _LEVEL, mount + turned @ offset)


def mount_forgotten(pan, tilt, mount, offset):
    return _from_axes(_about_z(pan) @ _about_x(tilt) @ _LEVEL, 0 * mount, offset)
