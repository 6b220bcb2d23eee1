"""From tie points to a block: two pictures first, then one after the other."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.bundle import Observations
from course_lib.checks import (
    DegenerateConfigurationError,
    check_generator,
    check_intrinsics,
    check_length,
)
from course_lib.reconstruction.growth import LEAST_AGREED, Growth
from course_lib.reconstruction.result import Reconstruction
from course_lib.reconstruction.start import Pair, start_pairs

#: So many pairs are tried as the first one, if not all pictures could be placed.
TRIES = 3


def reconstruct(
    observations: Observations,
    K: ArrayLike,
    rng: np.random.Generator,
    threshold: float = 4.0,
) -> Reconstruction:
    """Return where all cameras and points are, from who sees which point where.

    Two pictures with many common points and a wide angle come first: their relative pose, and
    their points. Then, again and again, the picture that sees most known points is placed by
    resection, its new points are triangulated, and all is adjusted; what does not fit is thrown
    out. Scale, place and directions of the result are arbitrary: `similarity_transform` with
    control points gives it those of the world.

    Parameters
    ----------
    observations : Observations
        Tie points, such as of `course_lib.tie_points.tracks`; some may be wrong.
    K : array_like, shape (3, 3)
        Intrinsics of the one camera that took all pictures, px; pixels are without distortion.
    rng : numpy.random.Generator
        Draws samples.
    threshold : float
        How far a right observation may be from where the block puts it, px.

    Returns
    -------
    Reconstruction
        The block, the steps, and which pictures and observations were left out and why.

    Raises
    ------
    TypeError, ValueError
        If an argument is not what is said above, or a camera sees a point twice.
    DegenerateConfigurationError
        If there are no two pictures to begin with: none have enough points in common, or none see
        them at a wide enough angle.

    References
    ----------
    N. Snavely, S. Seitz & R. Szeliski, "Photo tourism", ACM TOG 25 (2006); J. Schönberger &
    J.-M. Frahm, "Structure-from-motion revisited", CVPR (2016).
    """
    K, rng = check_intrinsics(K), check_generator(rng)
    threshold = check_length(threshold, "threshold")
    _check_once(observations)
    best: Reconstruction | None = None
    pixels, trouble = Growth(observations, K, rng, threshold).pixels, ""
    for number, pair in enumerate(start_pairs(pixels, K, rng, threshold / 2)):
        try:
            found = _grown(Growth(observations, K, rng, threshold), pair)
        except DegenerateConfigurationError as error:
            trouble = str(error)
            continue
        if best is None or len(found.cameras) > len(best.cameras):
            best = found
        if not best.left_out or number + 1 >= TRIES:
            break
    if best is None:
        raise DegenerateConfigurationError(f"no block grows from any two pictures: {trouble}")
    return best


def _check_once(observations: Observations) -> None:
    pairs = np.stack([observations.cameras, observations.points], axis=1)
    found, counts = np.unique(pairs, axis=0, return_counts=True)
    if (counts > 1).any():
        camera, point = found[counts > 1][0]
        raise ValueError(f"camera {camera} sees point {point} twice: keep one of the two pixels")


def _grown(growth: Growth, pair: Pair) -> Reconstruction:
    """Return the block that begins with a pair."""
    growth.begin(pair)
    reasons: dict[int, str] = {}
    waiting = set(range(len(growth.pixels))) - set(growth.placed)
    while waiting:
        known = {k: int((growth.known & growth.trusted[k]).sum()) for k in waiting}
        best = max(waiting - set(reasons), key=lambda k: known[k], default=None)
        if best is None:
            break
        reason = _placed(growth, best, known[best])
        if reason:
            reasons[best] = reason
        else:
            # The block has grown: those that could not be placed have another chance.
            waiting.discard(best)
            reasons = {}
    adjustment = growth.finish()
    _, seen, points = growth.block()
    cameras = np.array(growth.placed)
    return Reconstruction(
        adjustment, cameras, points, seen, growth.fates(), reasons, tuple(growth.steps)
    )


def _placed(growth: Growth, picture: int, known: int) -> str:
    """Place a picture; return an empty reason, or why it could not be."""
    if not known:
        return f"picture {picture} has no point in common with the block: is it of the same thing?"
    if known < LEAST_AGREED:
        return (
            f"picture {picture} sees {known} points of the block, and {LEAST_AGREED} are needed: "
            "take a picture between it and the others"
        )
    try:
        placed = growth.place(picture)
    except ValueError as error:
        return f"picture {picture} cannot be placed: {error}"
    if not placed:
        return f"picture {picture} sees {known} points of the block, but too few agree on a pose"
    return ""
