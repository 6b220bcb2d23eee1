"""Epipolar geometry from matches of which many are wrong.

Use these functions through `course_lib.epipolar`.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.checks import Array, check_intrinsics, check_length
from course_lib.epipolar.degeneracy import find_degeneracy, raise_degeneracy
from course_lib.epipolar.essential import poses_from_essential
from course_lib.epipolar.five_point import five_point_samples
from course_lib.epipolar.fundamental import common_scale, seven_point_samples
from course_lib.epipolar.lines import check_pairs
from course_lib.epipolar.matrices import check_two_view, unit
from course_lib.epipolar.refinement import PosedPair, RankTwo, refined
from course_lib.epipolar.rivals import Pairs, doubt_about, last_look, pose_sigma, standing
from course_lib.epipolar.search import Problem, check_confidence, search

#: Numbers of F that are left open in turn when seven pairs are solved for the others.
FREE = 7, 5, 3, 1


class RobustFundamental(NamedTuple):
    """A fundamental matrix, and which pairs it fits.

    Attributes
    ----------
    F : ndarray, shape (3, 3)
        Of rank 2 and length 1.
    fits : ndarray of bool, shape (N,)
        Which pairs have a Sampson error within the threshold.
    """

    F: Array
    fits: NDArray[np.bool_]


class RobustPose(NamedTuple):
    """A relative pose, and which pairs it fits.

    Attributes
    ----------
    R, t : ndarray, shape (3, 3) and (3,)
        Camera 1 to camera 2; the length of t is 1.
    fits : ndarray of bool, shape (N,)
        Which pairs have a Sampson error within the threshold.
    turn_sigma, direction_sigma : float
        Standard deviations of the rotation and of the direction of t, degrees: what the errors of
        the pairs that fit make of them, if the pose is the right one.
    doubt : str
        Why the pose may be the wrong one, and what to do: another pose fits nearly as well, the
        points are on a plane, or the standard deviations are larger than 0.5 and 1 degree. Empty if
        nothing says so, which is no proof.
    """

    R: Array
    t: Array
    fits: NDArray[np.bool_]
    turn_sigma: float
    direction_sigma: float
    doubt: str


def refine_fundamental(F: ArrayLike, points1: ArrayLike, points2: ArrayLike) -> Array:
    """Return the fundamental matrix with the smallest Sampson errors, near a first guess.

    Parameters
    ----------
    F : array_like, shape (3, 3)
        First guess, such as the result of `eight_point`.
    points1, points2 : array_like, shape (N, 2)
        N ≥ 7 pixels of picture 1, and their partners in picture 2; all of them right pairs.

    Returns
    -------
    ndarray, shape (3, 3)
        F of rank 2 and length 1, with the smallest sum of squares of `sampson_error`.

    Raises
    ------
    TypeError, ValueError
        If the shapes do not fit, a number is not finite, F is zero, or there are fewer than seven
        pairs.
    DegenerateConfigurationError
        If the points of a picture are on a line.

    References
    ----------
    Hartley & Zisserman, Multiple View Geometry, 2nd ed., section 11.4.3.
    """
    points1, points2 = check_pairs(points1, points2, least=7)
    x1, x2, T1, T2, _ = common_scale(points1, points2)
    start = np.linalg.inv(T2).T @ unit(check_two_view(F)) @ np.linalg.inv(T1)
    return unit(T2.T @ refined(RankTwo.near(start), x1, x2).matrix @ T1)


def ransac_fundamental(
    points1: ArrayLike,
    points2: ArrayLike,
    rng: np.random.Generator,
    threshold: float = 1.5,
    confidence: float = 0.99,
    most_samples: int = 500,
) -> RobustFundamental:
    """Return the fundamental matrix that most matches agree on, although many are wrong.

    Samples of seven pairs are solved and judged by all pairs. The best one is refined: each pair
    counts by how likely it is a right one, which its error tells.

    Parameters
    ----------
    points1, points2 : array_like, shape (N, 2)
        N ≥ 8 pixels of picture 1, and their partners in picture 2.
    rng : numpy.random.Generator
        Draws the samples.
    threshold : float
        Largest Sampson error of a right pair, px: about three standard deviations of a pixel.
    confidence : float
        It ends when a sample of right pairs alone was drawn with this probability.
    most_samples : int
        It ends after so many samples at the latest. More are needed if more than 60 % are wrong.

    Returns
    -------
    RobustFundamental
        F, and which pairs it fits.

    Raises
    ------
    TypeError, ValueError
        If the shapes do not fit, a number is not finite, or there are fewer than eight pairs.
    DegenerateConfigurationError
        If `find_degeneracy` finds that the pairs that fit are on a plane or the camera has only
        turned, which it cannot always; if no matrix fits more than seven pairs; if the points of a
        picture are on a line.

    References
    ----------
    O. Chum, J. Matas & J. Kittler, "Locally optimized RANSAC" (2003); P. Torr & A. Zisserman,
    "MLESAC", CVIU 78 (2000); Hartley & Zisserman, Multiple View Geometry, 2nd ed., algorithm 11.4.
    """
    points1, points2 = check_pairs(points1, points2, least=8)
    threshold = check_length(threshold, "threshold")
    x1, x2, T1, T2, scale = common_scale(points1, points2)
    near1, near2 = x1[:2].T.copy(), x2[:2].T.copy()

    def hypotheses(samples: NDArray[np.intp], turn: int) -> Array:
        return seven_point_samples(near1[samples], near2[samples], FREE[turn % len(FREE)])

    problem = Problem(x1, x2, threshold * scale, 7, hypotheses, RankTwo.near)
    best = search(problem, check_confidence(confidence), most_samples, rng)
    raise_degeneracy(find_degeneracy(points1[best.fits], points2[best.fits], threshold))
    return RobustFundamental(unit(T2.T @ best.geometry.matrix @ T1), best.fits)


def ransac_pose(
    points1: ArrayLike,
    points2: ArrayLike,
    K1: ArrayLike,
    K2: ArrayLike,
    rng: np.random.Generator,
    threshold: float = 1.5,
    confidence: float = 0.99,
    most_samples: int = 500,
    rivals: bool = True,
) -> RobustPose:
    """Return the relative pose of calibrated cameras that most matches agree on.

    As `ransac_fundamental`, with samples of five pairs. If tie points are few, near together or on
    a plane, other poses may fit them equally well. At the end such rivals are looked for; the one
    that fits best is returned, and `doubt` names the next.

    Parameters
    ----------
    points1, points2 : array_like, shape (N, 2)
        N ≥ 6 pixels of picture 1, and their partners in picture 2, without distortion.
    K1, K2 : array_like, shape (3, 3)
        Intrinsics in px.
    rng, threshold, confidence, most_samples
        As in `ransac_fundamental`.
    rivals : bool
        Whether rivals are looked for, which takes most of the time. To find wrong pairs, they need
        not be.

    Returns
    -------
    RobustPose
        The relative pose, camera 1 to camera 2, which pairs it fits, and how sure it is.

    Raises
    ------
    TypeError, ValueError
        If the shapes do not fit, a number is not finite, intrinsics are none, or there are fewer
        than six pairs.
    DegenerateConfigurationError
        If the camera has only turned; if no pose fits more than five pairs; if the points of a
        picture are on a line.

    References
    ----------
    D. Nistér, "An efficient solution to the five-point relative pose problem", IEEE PAMI 26
    (2004); and as `ransac_fundamental`.
    """
    points1, points2 = check_pairs(points1, points2, least=6)
    threshold = check_length(threshold, "threshold")
    K1, K2 = check_intrinsics(K1), check_intrinsics(K2)
    pairs = _calibrated(points1, points2, K1, K2, threshold)
    found = search(pairs.problem, check_confidence(confidence), most_samples, rng)
    fits = found.fits
    open_by = find_degeneracy(points1[fits], points2[fits], threshold, K1, K2)
    if open_by == "rotation":
        raise_degeneracy(open_by)
    best, rival = last_look(pairs, found) if rivals else (standing(pairs, found), None)
    sigma = pose_sigma(pairs, best)
    doubt = doubt_about(best, rival, sigma, open_by == "plane")
    return RobustPose(best.R, best.t, best.found.fits, *sigma, doubt)


def _calibrated(points1: Array, points2: Array, K1: Array, K2: Array, threshold: float) -> Pairs:
    """Return the search for the relative pose of calibrated cameras."""
    x1, x2, T1, T2, scale = common_scale(points1, points2)
    right, left = np.asarray(np.linalg.inv(T1 @ K1)), np.asarray(np.linalg.inv(T2 @ K2).T)
    near1, near2 = (right @ x1)[:2].T.copy(), (left.T @ x2)[:2].T.copy()

    def hypotheses(samples: NDArray[np.intp], turn: int) -> Array:
        return unit(left @ five_point_samples(near1[samples], near2[samples]) @ right)

    def geometry(F: Array) -> PosedPair:
        U, _, Vt = np.linalg.svd((T2 @ K2).T @ F @ (T1 @ K1))
        return PosedPair(*poses_from_essential(U[:, :2] @ Vt[:2])[0], left, right)

    problem = Problem(x1, x2, threshold * scale, 5, hypotheses, geometry)
    return Pairs(problem, near1, near2, 2 * threshold / float(K2[0, 0]))
