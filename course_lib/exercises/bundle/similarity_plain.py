"""Chapter 10 written out plainly: pictures for a circle, and a model laid over the world.

The library (`course_lib.orientation`) checks what comes in and takes weights. The tests hold the
two against each other.
"""

from __future__ import annotations

import math

import numpy as np


def pictures_for_circle(step):
    """Return how many pictures all around an object are needed, so that neighbours are near.

    Parameters
    ----------
    step : float
        Largest angle between the directions of two neighbours, rad.

    Returns
    -------
    int
        The smallest number of pictures, evenly around the circle, whose steps are not larger. A
        step counts as larger only if it is so by more than rounding: where ``2π / step`` is above
        a whole number by less than 1e-9, that number is enough.

    Examples
    --------
    >>> pictures_for_circle(np.radians(10)), pictures_for_circle(np.radians(7))
    (36, 52)
    """
    return math.ceil(2 * np.pi / step - 1e-9)


def similarity_transform(points, targets):
    """Return the scale, turn and move that bring points nearest to their targets.

    The sum of the squared distances between ``scale R x + t`` and the target of x is smallest. With
    the means taken off all points and targets, M is the sum of the products ``y' x'ᵀ`` over all
    points x' and their targets y'; its SVD ``U S Vᵀ`` gives ``R = U Vᵀ``. If the determinant of
    that is negative, it is no rotation: then the last column of U and the last number of S change
    their sign first.

    Parameters
    ----------
    points : ndarray, shape (N, 3)
        N ≥ 3 points of the model, not all on one line.
    targets : ndarray, shape (N, 3)
        Where each of them is in the world, with some error.

    Returns
    -------
    scale : float
        Sum of the numbers S by the sum of the squared lengths of all x'.
    R : ndarray, shape (3, 3)
        Rotation, model to world, never a reflection.
    t : ndarray, shape (3,)
        Translation: it brings the mean of the points to the mean of the targets.

    Examples
    --------
    >>> points = np.array([[-1.0, 0, 0], [1, 0, 0], [0, -2, 0], [0, 2, 0]])
    >>> targets = np.array([[10.0, 17, 5], [10, 23, 5], [16, 20, 5], [4, 20, 5]])
    >>> scale, R, t = similarity_transform(points, targets)
    >>> round(float(scale), 9), (R @ [1, 0, 0]).round(9) + 0.0, t.round(9)
    (3.0, array([0., 1., 0.]), array([10., 20.,  5.]))
    """
    middle, goal = points.mean(axis=0), targets.mean(axis=0)
    x, y = points - middle, targets - goal
    U, S, Vt = np.linalg.svd(y.T @ x)
    if np.linalg.det(U @ Vt) < 0:
        U[:, 2] = -U[:, 2]
        S[2] = -S[2]
    R = U @ Vt
    scale = S.sum() / (x**2).sum()
    return scale, R, goal - scale * R @ middle


def check_point_rmse(estimated, surveyed):
    """Return the root mean square errors of check points: along each axis, and in space.

    Nothing was fitted to these points, so the mean is that over all N points.

    Parameters
    ----------
    estimated : ndarray, shape (N, 3)
        Where the model says that the points are.
    surveyed : ndarray, shape (N, 3)
        Where they are.

    Returns
    -------
    ndarray, shape (4,)
        Root mean squares of dx, of dy, of dz, and of the distances in space, in the unit of the
        points.

    Examples
    --------
    >>> check_point_rmse(np.array([[3.0, 4, 0], [1, 1, 1]]), np.array([[0.0, 0, 0], [1, 1, 1]]))
    array([2.12132034, 2.82842712, 0.        , 3.53553391])
    """
    squares = ((estimated - surveyed) ** 2).mean(axis=0)
    return np.sqrt(np.append(squares, squares.sum()))
