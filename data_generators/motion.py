"""Things that move while the picture is taken."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from course_lib.checks import Array, check_vector


@dataclass(frozen=True, eq=False)
class Motion:
    """A steady motion: along a line, around an axis, or both, as a screw.

    At time 0 the thing is where the scene has it.

    Attributes
    ----------
    velocity : array_like, shape (3,)
        m/s, world frame.
    turning : array_like, shape (3,)
        Angular velocity: along the axis, its length in rad/s; world frame.
    about : array_like, shape (3,)
        A point of the axis at time 0, m.

    Raises
    ------
    TypeError, ValueError
        If a vector is not one of three numbers.
    """

    velocity: Array | tuple[float, float, float] = (0.0, 0.0, 0.0)
    turning: Array | tuple[float, float, float] = (0.0, 0.0, 0.0)
    about: Array | tuple[float, float, float] = (0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        for name in ("velocity", "turning", "about"):
            object.__setattr__(self, name, check_vector(getattr(self, name), 3, name))

    def carry(self, origins: Array, directions: Array, times: Array) -> tuple[Array, Array]:
        """Return rays that move with the thing, where they are at their times.

        Parameters
        ----------
        origins, directions : ndarray, shape (N, 3)
            The rays at time 0.
        times : ndarray, shape (N,)
            s.

        Returns
        -------
        origins, directions : ndarray, shape (N, 3)
            The rays at their times.
        """
        moved = self._turned(origins - self.about, times) + self.about
        return moved + times[:, None] * self.velocity, self._turned(directions, times)

    def bring_back(self, origins: Array, directions: Array, times: Array) -> tuple[Array, Array]:
        """Return the rays as the moving thing sees them: the inverse of `carry`."""
        back = origins - times[:, None] * self.velocity - self.about
        return self._turned(back, -times) + self.about, self._turned(directions, -times)

    def _turned(self, vectors: Array, times: Array) -> Array:
        """Return vectors, each turned for its time, by Rodrigues' formula."""
        speed = float(np.linalg.norm(self.turning))
        if speed == 0:
            return vectors
        axis = np.asarray(self.turning) / speed
        cosine, sine = np.cos(speed * times)[:, None], np.sin(speed * times)[:, None]
        along = (vectors @ axis)[:, None] * axis
        return np.asarray(along + cosine * (vectors - along) + sine * np.cross(axis, vectors))
