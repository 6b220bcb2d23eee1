"""What a calibration changes: the numbers of a camera, and the poses of the board.

The camera is a vector of seventeen numbers, ``fx fy s cx cy`` and the twelve coefficients of the
distortion; each view has six more: three of a small turn, three of its translation. Use these
functions through `course_lib.calibration`.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from course_lib.checks import Array, check_intrinsics
from course_lib.distortion.model import COUNTS, check_coefficients

COEFFICIENTS = ("k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6", "s1", "s2", "s3", "s4")
NAMES = ("fx", "fy", "s", "cx", "cy", *COEFFICIENTS)


@dataclass(frozen=True)
class CameraModel:
    """Which numbers of a camera a calibration estimates; the others keep their start.

    Attributes
    ----------
    focal : bool
        Whether fx and fy are estimated.
    square_pixels : bool
        Whether fy follows fx, in the ratio of the start (1 unless a start is given).
    skew : bool
        Whether s is estimated; otherwise it is 0, as sensors are made.
    principal_point : bool
        Whether cx and cy are estimated; otherwise they stay at the start, the middle of the picture
        unless one is given.
    coefficients : tuple of str
        Names of the coefficients of distortion that are estimated, of ``k1 k2 p1 p2 k3 k4 k5 k6 s1
        s2 s3 s4``.

    Raises
    ------
    ValueError
        If a name is none of these, or there twice.

    Examples
    --------
    >>> CameraModel(skew=True, coefficients=("k1", "k2")).names
    ('fx', 'fy', 's', 'cx', 'cy', 'k1', 'k2')
    """

    focal: bool = True
    square_pixels: bool = False
    skew: bool = False
    principal_point: bool = True
    coefficients: tuple[str, ...] = ("k1", "k2", "p1", "p2", "k3")

    def __post_init__(self) -> None:
        given = tuple(self.coefficients)
        if len(set(given) & set(COEFFICIENTS)) < len(given):
            raise ValueError(
                f"coefficients must be some of {' '.join(COEFFICIENTS)}, each once, got {given}"
            )
        object.__setattr__(self, "coefficients", given)

    @cached_property
    def names(self) -> tuple[str, ...]:
        """The names of what is estimated, in the order of a covariance's rows."""
        chosen = set(self.coefficients)
        chosen |= {"fx"} if self.focal else set()
        chosen |= {"fy"} if self.focal and not self.square_pixels else set()
        chosen |= {"s"} if self.skew else set()
        chosen |= {"cx", "cy"} if self.principal_point else set()
        return tuple(name for name in NAMES if name in chosen)

    @cached_property
    def places(self) -> list[int]:
        """Where the free numbers are among the seventeen of a camera."""
        return [NAMES.index(name) for name in self.names]

    def moved(self, camera: Array, step: Array) -> Array:
        """Return the camera's seventeen numbers after a step of the free ones, shape (n,)."""
        camera = camera.copy()
        aspect = camera[1] / camera[0]
        camera[self.places] += step
        if self.square_pixels:
            camera[1] = aspect * camera[0]
        return camera


@dataclass(frozen=True, eq=False)
class State:
    """A camera and where it stood: what the refinement moves.

    Attributes
    ----------
    model : CameraModel
        Which numbers of the camera are free.
    camera : ndarray, shape (17,)
        ``fx fy s cx cy k1 … s4``.
    R, t : ndarray, shape (V, 3, 3) and (V, 3)
        Pose of each view, board to camera.
    """

    model: CameraModel
    camera: Array
    R: Array
    t: Array

    @property
    def K(self) -> Array:
        """The intrinsics, shape (3, 3)."""
        fx, fy, s, cx, cy = self.camera[:5]
        return np.array([[fx, s, cx], [0, fy, cy], [0, 0, 1]])

    @property
    def coefficients(self) -> Array:
        """The coefficients of distortion: up to the last that is free or not zero."""
        free = [COEFFICIENTS.index(name) for name in self.model.coefficients]
        last = max([0, *free, *np.flatnonzero(self.camera[5:]).tolist()])
        return self.camera[5 : 5 + next(count for count in COUNTS if count > last)].copy()

    @property
    def is_camera(self) -> bool:
        """Whether the focal lengths are positive; a step can lead too far."""
        return bool(self.camera[:2].min() > 0)

    def moved(self, camera_step: Array, pose_steps: Array) -> State:
        """Return the state after a step; boards turn about the camera's axes, around their origin.

        Parameters
        ----------
        camera_step : ndarray, shape (n,)
            What the free numbers of the camera change by.
        pose_steps : ndarray, shape (V, 6)
            For each view a turn (axis times angle, rad) and a shift.

        Returns
        -------
        State
            The new one.
        """
        turns = rotations_from_vectors(pose_steps[:, :3])
        camera = self.model.moved(self.camera, camera_step)
        return State(self.model, camera, turns @ self.R, self.t + pose_steps[:, 3:])


def camera_numbers(K: ArrayLike, coefficients: ArrayLike) -> Array:
    """Return the seventeen numbers of a camera, from checked intrinsics and coefficients."""
    K = check_intrinsics(K)
    return np.concatenate([K[[0, 1, 0, 0, 1], [0, 1, 1, 2, 2]], check_coefficients(coefficients)])


def rotations_from_vectors(vectors: Array) -> Array:
    """Return ``exp([w]ₓ)`` for rows w, shape (V, 3, 3): `rotation_from_vector` for many."""
    angle = np.sqrt((vectors**2).sum(axis=1))[:, None, None]
    k = np.zeros((len(vectors), 3, 3))
    k[:, 2, 1], k[:, 0, 2], k[:, 1, 0] = vectors.T
    k -= k.transpose(0, 2, 1)
    # sin(a) / a, and (1 - cos a) / a² without its cancellation.
    half = np.sinc(angle / (2 * np.pi))
    return np.asarray(np.eye(3) + np.sinc(angle / np.pi) * k + 0.5 * half**2 * (k @ k))
