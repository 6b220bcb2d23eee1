"""What the lesson says in a sentence of a student's matrix or pose, right or wrong."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.calibration import StereoCalibration
from course_lib.epipolar import epipolar_lines, line_distance
from course_lib.transforms import vector_from_rotation


def pose_errors(R: ArrayLike, t: ArrayLike, calibration: StereoCalibration) -> tuple[float, float]:
    """Return how far a relative pose is from the calibrated one, in degrees.

    Parameters
    ----------
    R, t : array_like, shape (3, 3) and (3,)
        Left camera to right camera; the length of t does not matter.
    calibration : StereoCalibration
        The calibrated pair.

    Returns
    -------
    tuple of float
        The turn between both rotations, and the angle between both directions of t.
    """
    turn = np.linalg.norm(vector_from_rotation(np.asarray(R, float) @ calibration.R.T))
    ours, theirs = (x / np.linalg.norm(x) for x in (np.asarray(t, float), calibration.t))
    between = 2 * np.arcsin(min(1.0, float(np.linalg.norm(ours - theirs)) / 2))
    return float(np.degrees(turn)), float(np.degrees(between))


def judged_pose(R: ArrayLike, t: ArrayLike, calibration: StereoCalibration) -> str:
    """Return in a sentence how far a relative pose is from the calibrated one, or what it lacks.

    Parameters
    ----------
    R, t, calibration
        As in `pose_errors`; R and t may be any numbers of their shapes.

    Returns
    -------
    str
        The sentence.
    """
    if not np.linalg.norm(np.asarray(t, float)) > 0:
        return "Your t has no direction, so there is nothing to compare."
    try:
        turn, direction = pose_errors(R, t, calibration)
    except ValueError as error:
        return f"Your R cannot be compared: {error}."
    return f"turn off by {turn:.3f}°, direction by {direction:.3f}°"


def judged_matrix(F: ArrayLike, points1: ArrayLike, points2: ArrayLike) -> str:
    """Return in a sentence how far pairs are from the lines of a matrix, or what it lacks.

    Parameters
    ----------
    F : array_like, shape (3, 3)
        Any numbers, perhaps a fundamental matrix.
    points1, points2 : array_like, shape (N, 2)
        Pairs, px.

    Returns
    -------
    str
        The sentence.
    """
    try:
        off = line_distance(points2, epipolar_lines(points1, F))
    except ValueError as error:
        return f"Your F gives no lines: {error}."
    return f"{off.mean():.3f} px off the lines on average"
