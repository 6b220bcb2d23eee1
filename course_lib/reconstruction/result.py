"""What a reconstruction gives back: the block, and every step on the way to it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from course_lib.bundle import Block, BundleAdjustment, Observations
from course_lib.bundle.block import Indices, check_numbers_of
from course_lib.checks import Array
from course_lib.similarity import Similarity
from course_lib.triangulation import refine_point, triangulate_linear


@dataclass(frozen=True, eq=False)
class Step:
    """One step of a reconstruction: two pictures to begin with, or one more.

    Attributes
    ----------
    pictures : tuple of int
        Which were placed.
    seen : int
        How many points that were known before the new picture shows; the common points of the
        first two.
    agreed : int
        How many of them agree on its pose.
    added : int
        New points.
    rejected : int
        Observations that were thrown out in this step.
    rms_before, rms_after : float
        Root mean square of the lengths of the residuals before and after the adjustment, px.
    block : Block
        The block after this step; rotated, moved and scaled as it happens to be.
    cameras : ndarray of int, shape (v,)
        Which picture each camera of the block took.
    points : ndarray of int, shape (n,)
        Which point of the observations each point of the block is.
    """

    pictures: tuple[int, ...]
    seen: int
    agreed: int
    added: int
    rejected: int
    rms_before: float
    rms_after: float
    block: Block
    cameras: Indices
    points: Indices

    def __str__(self) -> str:
        """Return the step in a sentence."""
        which = " and ".join(str(picture) for picture in self.pictures)
        many = "s" if len(self.pictures) > 1 else ""
        return (
            f"Picture{many} {which}: {self.agreed} of {self.seen} points agree, {self.added} new; "
            f"adjusted from {self.rms_before:.2f} to {self.rms_after:.2f} px, "
            f"{self.rejected} observations thrown out."
        )


@dataclass(frozen=True, eq=False)
class Reconstruction:
    """Cameras and points from tie points alone.

    Attributes
    ----------
    adjustment : BundleAdjustment
        The last one, of all that was kept.
    cameras : ndarray of int, shape (v,)
        Which picture each camera of the block took, in the order in which they were placed.
    points : ndarray of int, shape (n,)
        Which point of the observations each point of the block is.
    observations : Observations
        What was kept, numbered as in the block.
    fates : ndarray of str, shape (m,)
        What became of each observation that was given: ``"used"``, or why not: ``"off"`` (too far
        from where the block puts it), ``"behind"`` (the point would be behind the camera),
        ``"alone"`` (no second ray, or none at a wide enough angle, goes to its point) or
        ``"left out"`` (its picture was not placed).
    left_out : dict
        From the number of a picture that was not placed to the reason, a sentence.
    steps : tuple of Step
        How the block grew.
    """

    adjustment: BundleAdjustment
    cameras: Indices
    points: Indices
    observations: Observations
    fates: NDArray[np.str_]
    left_out: dict[int, str]
    steps: tuple[Step, ...]

    @property
    def block(self) -> Block:
        """Cameras and points; rotated, moved and scaled as it happens to be."""
        return self.adjustment.block

    @property
    def rms(self) -> float:
        """Root mean square of the lengths of the residuals, px."""
        return self.adjustment.rms

    def triangulated(self, observations: Observations) -> tuple[Indices, Array]:
        """Return where in the block other points are, such as survey marks.

        Parameters
        ----------
        observations : Observations
            Where pictures show them; cameras are numbered as the pictures.

        Returns
        -------
        numbers : ndarray of int, shape (k,)
            Those that two placed pictures or more show, in increasing order.
        points : ndarray, shape (k, 3)
            Where they are, in the frame and unit of the block.

        Raises
        ------
        ValueError, DegenerateConfigurationError
            If two rays of a point are parallel, or it would be behind a camera.
        """
        row = np.full(max(int(observations.cameras.max()), int(self.cameras.max())) + 1, -1)
        row[self.cameras] = np.arange(len(self.cameras))
        kept = observations.only(row[observations.cameras] >= 0)
        numbers = np.flatnonzero(np.bincount(kept.points) >= 2)
        kept = kept.only(np.isin(kept.points, numbers))
        pixels = np.full((len(self.cameras), len(numbers), 2), np.nan)
        pixels[row[kept.cameras], np.searchsorted(numbers, kept.points)] = kept.pixels
        P = camera_matrices(self.block)
        points = refine_point(triangulate_linear(pixels, P), pixels, P)
        return check_numbers_of(numbers, None, "numbers"), points

    def oriented(self, similarity: Similarity) -> Block:
        """Return the block turned, moved and scaled, as control points want it.

        Parameters
        ----------
        similarity : Similarity
            From the frame of the block to that of the world.

        Returns
        -------
        Block
            The same pixels see the same points, in the world.
        """
        block = self.block
        R, C = block.R @ similarity.R.T, similarity.apply(block.centres)
        t = -np.einsum("vij,vj->vi", R, C)
        return Block(block.K, R, t, similarity.apply(block.points))


def camera_matrices(block: Block) -> Array:
    """Return the camera matrices of a block, shape (v, 3, 4)."""
    return np.asarray(block.K @ np.concatenate([block.R, block.t[:, :, None]], axis=2))
