"""Whether what was measured can determine a block: who is tied to whom, and by how much."""

from __future__ import annotations

import numpy as np

from course_lib.bundle.block import Block, Indices, Observations
from course_lib.bundle.control import Control
from course_lib.checks import DegenerateConfigurationError
from course_lib.correspondences import check_spread
from course_lib.similarity import similarity_transform


def connected_parts(observations: Observations, cameras: int) -> Indices:
    """Return for each camera the part of the block that it belongs to.

    Two cameras are in the same part if they see a point in common, or if a chain of such cameras
    leads from one to the other.

    Parameters
    ----------
    observations : Observations
        Who sees what.
    cameras : int
        How many cameras there are.

    Returns
    -------
    ndarray of int, shape (cameras,)
        Number of the part; parts are numbered in the order of their first cameras.

    Raises
    ------
    ValueError
        If an observation is by a camera that there is not.

    Examples
    --------
    >>> seen = Observations([0, 1, 2, 3], [5, 5, 8, 8], np.zeros((4, 2)))
    >>> connected_parts(seen, 4)
    array([0, 0, 1, 1])
    """
    if observations.cameras.max() >= cameras:
        raise ValueError(
            f"an observation is by camera {observations.cameras.max()}, but there are only "
            f"{cameras}, counted from 0: drop it, or add the camera"
        )
    part = np.arange(cameras)
    while True:
        # Each point takes the smallest part of its cameras, each camera that of its points.
        least = np.full(observations.points.max() + 1, cameras)
        np.minimum.at(least, observations.points, part[observations.cameras])
        following = part.copy()
        np.minimum.at(following, observations.cameras, least[observations.points])
        following = following[following]
        if (following == part).all():
            return np.asarray(np.unique(part, return_inverse=True)[1])
        part = following


def check_block(block: Block, observations: Observations, control: Control | None = None) -> None:
    """Raise unless the observations can determine the block.

    Parameters
    ----------
    block : Block
        Cameras and points.
    observations : Observations
        Who sees what where.
    control : Control, optional
        Surveyed points.

    Raises
    ------
    ValueError
        If an observation is of a camera or point that there is not, is there twice, or is of a
        point behind the camera.
    DegenerateConfigurationError
        If the block falls apart, a point has fewer than two rays, a camera fewer than three points,
        or control points are too few, on one line or mirrored.
    """
    _check_names(block, observations, control)
    _check_rays(block, observations, control)
    if control is not None:
        _check_control(block, observations, control)
    else:
        _check_connected(block, observations)
    hidden = np.isnan(block.project(observations.cameras, observations.points)[:, 0])
    if hidden.any():
        camera, point = observations.cameras[hidden][0], observations.points[hidden][0]
        raise ValueError(
            f"camera {camera} sees point {point}, which is behind it at the start "
            f"({int(hidden.sum())} observations in all): start from better poses or points"
        )


def _check_names(block: Block, observations: Observations, control: Control | None) -> None:
    seen = [
        (observations.cameras, len(block.R), "an observation is by camera", "camera"),
        (observations.points, len(block.points), "an observation is of point", "point"),
    ]
    if control is not None and len(control.points):
        seen.append((control.points, len(block.points), "a control point has number", "point"))
    for numbers, count, what, kind in seen:
        if numbers.max() >= count:
            raise ValueError(
                f"{what} {numbers.max()}, but the block has only {count}, counted from 0: drop it, "
                f"or add the {kind}"
            )
    pairs = observations.cameras * len(block.points) + observations.points
    found, counts = np.unique(pairs, return_counts=True)
    if (counts > 1).any():
        camera, point = divmod(int(found[counts > 1][0]), len(block.points))
        raise ValueError(f"camera {camera} sees point {point} twice: keep one of the two pixels")


def _check_rays(block: Block, observations: Observations, control: Control | None) -> None:
    rays = np.bincount(observations.points, minlength=len(block.points))
    if control is not None:
        rays[control.points] += 2
    if (rays < 2).any():
        few = np.flatnonzero(rays < 2)
        raise DegenerateConfigurationError(
            f"point {few[0]} is seen by {rays[few[0]]} cameras and is no control point "
            f"({len(few)} such points in all): leave it out, at least two rays fix a point"
        )
    seen = np.bincount(observations.cameras, minlength=len(block.R))
    if (seen < 3).any():
        camera = int(np.argmin(seen))
        raise DegenerateConfigurationError(
            f"camera {camera} sees {seen[camera]} points; a pose needs three or more: measure more "
            "tie points in its picture, or leave the camera out"
        )


def _check_control(block: Block, observations: Observations, control: Control) -> None:
    """Raise unless each part of the block sees control points enough to be placed."""
    parts = connected_parts(observations, len(block.R))
    for part in range(parts.max() + 1):
        seen = np.unique(observations.points[parts[observations.cameras] == part])
        mine = np.isin(control.points, seen)
        if mine.sum() < 3:
            cameras = np.flatnonzero(parts == part)[:3].tolist()
            raise DegenerateConfigurationError(
                f"{mine.sum()} control points that cameras {cameras} … see do not fix scale, place "
                "and directions of their part of the block: three are needed, not on one line; or "
                "leave control out and orient afterwards"
            )
        check_spread(control.coordinates[mine], 2, "control points")
    _check_not_mirrored(block, control)


def _check_connected(block: Block, observations: Observations) -> None:
    parts = connected_parts(observations, len(block.R))
    if parts.any():
        names = [np.flatnonzero(parts == part)[:3].tolist() for part in (0, 1)]
        raise DegenerateConfigurationError(
            f"the block falls into {parts.max() + 1} parts without a point in common (cameras "
            f"{names[0]} … and {names[1]} …): add tie points between them, or adjust each alone"
        )


def _check_not_mirrored(block: Block, control: Control) -> None:
    """Raise if control points, those known in all three directions, are a mirror image."""
    size = np.ptp(control.coordinates, axis=0).max()
    known = (np.asarray(control.sigma) < 0.1 * size).all(axis=1)
    places = control.coordinates[known]
    if len(places) < 4 or np.linalg.matrix_rank(places - places.mean(axis=0), 1e-6 * size) < 3:
        return  # points of a plane, or of a line, may be turned to lie on their mirror image
    try:
        similarity_transform(block.points[control.points[known]], places)
    except DegenerateConfigurationError as error:
        raise DegenerateConfigurationError(
            f"the control points cannot be laid over those of the start: {error}"
        ) from error
