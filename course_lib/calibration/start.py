"""Where the refinement begins: Zhang's closed form for all views at once.

Use these functions through `course_lib.calibration`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.calibration.degeneracy import (
    check_enough,
    check_order,
    check_tilts,
    vagueness,
)
from course_lib.calibration.model import CameraModel, State, camera_numbers
from course_lib.calibration.refinement import Normals, arrow, minimised, view_products
from course_lib.calibration.views import Views
from course_lib.calibration.zhang import (
    homography_constraints,
    initial_distortion,
    intrinsics_from_homographies,
    pose_from_homography,
)
from course_lib.checks import Array, DegenerateConfigurationError
from course_lib.homography import fit_homographies

#: Between these, times the size of the picture, lie the focal lengths of most cameras.
LIKELY_FOCAL = (0.2, 20.0)
#: With twice as many points in a view, a part of them is enough for the first steps.
ENOUGH_POINTS = 40
#: With such a standard deviation of f, as a share of it, there may be another minimum.
DOUBTFUL = 0.02


def view_homographies(views: Views) -> Array:
    """Return the homography of each view, board to pixels, shape (V, 3, 3)."""
    Hs = np.empty((len(views.pixels), 3, 3))
    for count in np.unique(views.counts):
        some = views.counts == count
        points = views.points[0] if len(views.points) == 1 else views.points[some]
        board = points[..., :2, :count].swapaxes(-1, -2)
        pixels = views.pixels[some, :, :count].swapaxes(-1, -2)
        try:
            Hs[some] = fit_homographies(board, pixels)
        except DegenerateConfigurationError as error:
            _name_view(board, pixels, np.flatnonzero(some))
            raise error
    return Hs


def _name_view(board: Array, pixels: Array, numbers: NDArray[np.intp]) -> None:
    """Raise for the first view that has no homography on its own."""
    for i, view in enumerate(numbers):
        try:
            fit_homographies(board if board.ndim == 2 else board[i], pixels[i : i + 1])
        except DegenerateConfigurationError as error:
            raise DegenerateConfigurationError(f"view {view} has no homography: {error}") from error


def starting_state(
    views: Views,
    Hs: Array,
    image_size: Array,
    model: CameraModel,
    start: tuple[ArrayLike, ArrayLike] | None,
) -> State:
    """Return a camera and poses from homographies.

    Parameters
    ----------
    views : Views
        The measurements.
    Hs : ndarray, shape (V, 3, 3)
        Homography of each view, board to pixels.
    image_size : ndarray, shape (2,)
        Width and height, px.
    model : CameraModel
        What will be estimated.
    start : tuple of array_like, or None
        Intrinsics and distortion to begin with, unless the closed form comes closer. What is not
        free stays as it is there.

    Returns
    -------
    State
        The start, with k1 and k2 if the model has them.
    """
    K = starting_intrinsics(Hs, image_size, model)
    closed = with_distortion(_posed(camera_numbers(K, [0]), Hs, model), views)
    if start is None:
        return closed
    given = _posed(camera_numbers(*start), Hs, model)
    if not (model.focal and model.principal_point):
        return given
    step = (closed.camera - given.camera)[model.places]
    other = _posed(model.moved(given.camera, step), Hs, model)
    return min(given, other, key=lambda state: arrow(view_products(state, views)).cost)


def _posed(camera: Array, Hs: Array, model: CameraModel) -> State:
    R, t = pose_from_homography(State(model, camera, np.empty(0), np.empty(0)).K, Hs)
    return State(model, camera, R, t)


def starting_intrinsics(Hs: Array, image_size: Array, model: CameraModel) -> Array:
    """Return K in closed form, or with the principal point in the middle where that fails."""
    middle = (image_size - 1) / 2
    scale = image_size.max() / 2
    to_unit = np.array([[1, 0, -middle[0]], [0, 1, -middle[1]], [0, 0, scale]]) / scale
    units = to_unit @ Hs  # so that the numbers of the equations are of one size
    try:
        if not model.principal_point or len(Hs) < (3 if model.skew else 2):
            raise DegenerateConfigurationError("fewer unknowns than the closed form has")
        K = intrinsics_from_homographies(units)
    except DegenerateConfigurationError:
        K = _centred_intrinsics(units, model)
    if not _likely(K):
        K = _centred_intrinsics(units, model)
    K = np.linalg.inv(to_unit) @ K
    K /= K[2, 2]
    K[0, 1] = K[0, 1] if model.skew else 0.0
    if model.square_pixels:
        K[0, 0] = K[1, 1] = (K[0, 0] + K[1, 1]) / 2
    return np.asarray(K)


def _likely(K: Array) -> bool:
    """Return whether K, in half pictures from the middle, is one that a camera could have."""
    return bool((np.abs(K[:2, 2]) < 1).all() and _likely_focal(K[0, 0]) and _likely_focal(K[1, 1]))


def _likely_focal(f: float) -> bool:
    low, high = LIKELY_FOCAL
    return low < f / 2 < high


def _centred_intrinsics(units: Array, model: CameraModel) -> Array:
    """Return K with only fx and fy, or one f, from the same equations: B12 = B13 = B23 = 0.

    Homographies from pixels counted from the middle, of any scale.
    """
    units = units / np.linalg.norm(units, axis=(1, 2), keepdims=True)
    V = homography_constraints(units).reshape(-1, 6)
    # v · (1/fx², 0, 1/fy², 0, 0, 1) = 0
    left, right = V[:, [0, 2]], -V[:, 5]
    if model.square_pixels:
        left = left.sum(axis=1, keepdims=True)
    inverse, *_ = np.linalg.lstsq(left, right, rcond=None)
    low, high = (1 / (2 * f) ** 2 for f in reversed(LIKELY_FOCAL))
    fx, fy = 1 / np.sqrt(np.clip(np.broadcast_to(inverse, 2), low, high))
    return np.array([[fx, 0, 0], [0, fy, 0], [0, 0, 1]])


def with_distortion(state: State, views: Views) -> State:
    """Return the state with Zhang's first guess of k1 and k2, if the model has both."""
    if not {"k1", "k2"} <= set(state.model.coefficients):
        return state
    K = state.K
    X = state.R @ views.points + state.t[:, :, None]
    ideal = (K[:2] @ (X / X[:, 2:])).transpose(0, 2, 1)
    observed = views.pixels.transpose(0, 2, 1)
    seen = slice(None) if views.weights is None else views.weights > 0
    camera = state.camera.copy()
    camera[5:7] = initial_distortion(ideal[seen].reshape(-1, 2), observed[seen].reshape(-1, 2), K)
    return State(state.model, camera, state.R, state.t)


def minimum(
    views: Views,
    size: Array,
    model: CameraModel,
    start: tuple[ArrayLike, ArrayLike] | None = None,
) -> tuple[State, Normals]:
    """Return the smallest reprojection error of checked measurements, from the closed form.

    Parameters
    ----------
    views, size, model, start
        As for `starting_state`.

    Returns
    -------
    State, Normals
        As `refined`.

    Raises
    ------
    DegenerateConfigurationError
        If the measurements do not determine the camera.
    """
    check_enough(views, model, known=start is not None)
    few = views.thinned(ENOUGH_POINTS)
    Hs = view_homographies(few)
    check_order(few, Hs)
    check_tilts(Hs, size, model)
    state = starting_state(few, Hs, size, model, start)
    if few is not views:
        state, _ = minimised(state, few, last_gain=0.1)
    state, normals = minimised(state, views)
    if start is not None or vagueness(state, normals, views.observations) < DOUBTFUL:
        return state, normals
    # Views that say little of f have more than one minimum: try from an ordinary lens, too.
    middle, f = (size - 1) / 2, size.max()
    K = np.array([[f, 0, middle[0]], [0, f, middle[1]], [0, 0, 1]])
    other, others = minimised(_posed(camera_numbers(K, [0]), Hs, model), views)
    return (other, others) if others.cost < normals.cost else (state, normals)
