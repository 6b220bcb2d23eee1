"""When measurements do not determine a camera: named, with what to do about it.

Use these functions through `course_lib.calibration`.
"""

from __future__ import annotations

import numpy as np

from course_lib.calibration.model import CameraModel, State
from course_lib.calibration.refinement import Normals
from course_lib.calibration.views import Views
from course_lib.checks import Array, DegenerateConfigurationError

#: Boards whose planes differ by less are parallel: noise turns them by about as much.
PARALLEL_DEG = 0.5
#: So far from a homography, by the size of the board in the picture, no lens bends a board.
DISORDER = 0.12
#: A focal length with a standard deviation of more than this share of it is not determined.
VAGUE = 0.15
#: No lens has a focal length of so many widths of the picture: a boundless one fits as well.
FAR = 30.0


def check_enough(views: Views, model: CameraModel, known: bool) -> None:
    """Raise unless there are enough different views, and more measurements than unknowns."""
    inside = sum(name in ("fx", "fy", "s", "cx", "cy") for name in model.names)
    different = len({view.tobytes() for view in views.pixels.round(3)})
    needed = 1 if known else (inside + 1) // 2
    if different < needed:
        same = f" ({len(views.pixels)} were given, but some are the same)"
        raise DegenerateConfigurationError(
            f"{inside} unknowns of K need {needed} or more different views, got {different}"
            f"{same if different < len(views.pixels) else ''}: each gives two equations. Take more "
            "pictures of the board, tilted in different directions"
        )
    unknowns = len(model.names) + 6 * len(views.pixels)
    if views.observations <= unknowns:
        raise DegenerateConfigurationError(
            f"{views.observations // 2} points give {views.observations} equations, but there are "
            f"{unknowns} unknowns, six of them a view: use a board with more points, or leave "
            "fewer coefficients free"
        )


def disorder(views: Views, Hs: Array) -> Array:
    """Return how far each view's pixels are from a picture of the board, by its size there."""
    board = views.points[:, [0, 1, 1]].copy()
    board[:, 2] = 1
    image = Hs @ board
    apart = ((image[:, :2] / image[:, 2:] - views.pixels) ** 2).sum(axis=1)
    centred = views.pixels - views.pixels.mean(axis=2, keepdims=True)
    size = (centred**2).sum(axis=1)
    if views.weights is not None:
        apart, size = apart * views.weights, size * views.weights
    return np.asarray(np.sqrt(apart.sum(axis=1) / size.sum(axis=1)))


def check_order(views: Views, Hs: Array) -> None:
    """Raise if the pixels of a view are no picture of the board, however it is held."""
    apart = disorder(views, Hs)
    if apart.max() > DISORDER:
        raise DegenerateConfigurationError(
            f"the pixels of view {int(apart.argmax())} are no picture of this board: are "
            "columns and rows swapped, or the corners in another order?"
        )


def check_tilts(Hs: Array, image_size: Array, model: CameraModel) -> None:
    """Raise if all boards are parallel: then all views say the same of the camera."""
    if not (model.principal_point and model.focal):
        return
    scale = image_size.max()
    to_unit = np.array([[1, 0, -image_size[0] / 2], [0, 1, -image_size[1] / 2], [0, 0, scale]])
    # The line at infinity of the board's plane in the picture, H⁻ᵀ (0, 0, 1): alike for all
    # parallel planes, and in these units nearly the plane's normal.
    horizons = np.linalg.inv(to_unit @ Hs)[:, 2]
    horizons /= np.linalg.norm(horizons, axis=1, keepdims=True)
    apart = np.linalg.norm(np.cross(horizons, horizons[0]), axis=1)
    if np.degrees(apart.max()) < PARALLEL_DEG:
        raise DegenerateConfigurationError(
            "all boards are parallel, so that every view says the same of the camera: tilt the "
            "board by 20° to 45°, in different directions"
        )


def vagueness(state: State, normals: Normals, observations: int) -> float:
    """Return the standard deviation of fx as a share of it; 0 if fx is not free."""
    if not state.model.focal:
        return 0.0
    freedom = observations - len(state.model.names) - 6 * len(state.R)
    variance = normals.cost / freedom * normals.inverse_blocks[0][0, 0]
    return float(np.sqrt(variance) / state.camera[0])


def check_determined(state: State, vague: float, image_size: Array) -> None:
    """Raise if the minimum is so flat that a focal length could be anything."""
    longest = FAR * image_size.max()
    if vague > VAGUE or (state.model.focal and state.camera[0] > longest):
        raise DegenerateConfigurationError(
            f"the views leave the focal length open (fx {state.camera[0]:.0f} px, with a standard "
            f"deviation of {vague:.0%}): tilt the board by 20° to 45° in different directions, and "
            "fill the picture with it"
        )
