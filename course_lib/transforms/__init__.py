"""Rotations and poses: where a camera is, and which way it looks.

A pose ``(R, t)`` maps coordinates of one frame into another, ``X_a = R_ab X_b + t_ab``. A camera's
pose maps world to camera. Camera frame: x right, y down, z forward. World: z up.
"""

from course_lib.checks import check_rotation
from course_lib.transforms.euler import (
    euler_from_rotation,
    omega_phi_kappa_from_rotation,
    rotation_from_euler,
    rotation_from_omega_phi_kappa,
)
from course_lib.transforms.exponential import (
    pose_from_twist,
    rotation_from_vector,
    twist_from_pose,
    vector_from_rotation,
)
from course_lib.transforms.placing import (
    camera_centre,
    cv_from_graphics_camera,
    gimbal_pose,
    look_at,
    pose_from_placement,
)
from course_lib.transforms.poses import (
    compose,
    invert_pose,
    pose_from_matrix,
    rigid_matrix,
    transform_points,
)
from course_lib.transforms.quaternions import quaternion_from_rotation, rotation_from_quaternion
from course_lib.transforms.rotations import (
    rotation_about_axis,
    rotation_x,
    rotation_y,
    rotation_z,
    skew,
)

__all__ = [
    "camera_centre",
    "check_rotation",
    "compose",
    "cv_from_graphics_camera",
    "euler_from_rotation",
    "gimbal_pose",
    "invert_pose",
    "look_at",
    "omega_phi_kappa_from_rotation",
    "pose_from_matrix",
    "pose_from_placement",
    "pose_from_twist",
    "quaternion_from_rotation",
    "rigid_matrix",
    "rotation_about_axis",
    "rotation_from_euler",
    "rotation_from_omega_phi_kappa",
    "rotation_from_quaternion",
    "rotation_from_vector",
    "rotation_x",
    "rotation_y",
    "rotation_z",
    "skew",
    "transform_points",
    "twist_from_pose",
    "vector_from_rotation",
]
