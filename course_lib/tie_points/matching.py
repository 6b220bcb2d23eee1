"""Details of two pictures that look alike.

Use these functions through `course_lib.tie_points`.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.checks import Array, DegenerateConfigurationError, check_length
from course_lib.tie_points.features import Features, find_features

Pairs = NDArray[np.intp]


def match_features(one: Features, other: Features, ratio: float = 0.8) -> Pairs:
    """Return which details of two pictures look alike, and like no others.

    Two details are a pair if each is the other's nearest by the distance of descriptors, and the
    second nearest is clearly farther, both ways (the ratio test). What is there twice in a
    picture, such as the windows of a house, has no clear partner and is left out.

    Parameters
    ----------
    one, other : Features
        Details of two pictures.
    ratio : float
        Distance of the nearest by that of the second nearest, at most; above 0, up to 1. With 1
        nothing is left out.

    Returns
    -------
    ndarray of int, shape (M, 2)
        Numbers of a detail of `one` and of its partner, the most alike first; no place of a
        picture twice. M may be 0.

    Raises
    ------
    TypeError, ValueError
        If these are no features, or the ratio is not from above 0 to 1.

    References
    ----------
    D. Lowe, IJCV 60 (2004), section 7.1.
    """
    for features in (one, other):
        if not isinstance(features, Features):
            raise TypeError(f"features must come from find_features, got {features!r:.60}")
    ratio = check_length(ratio, "ratio")
    if ratio > 1:
        raise ValueError(f"ratio must be from above 0 to 1, got {ratio:g}: 0.8 is usual")
    pairs = _alike(one.descriptors, other.descriptors, ratio)
    return _once_each(pairs, one, other)


def tie_points(picture1: ArrayLike, picture2: ArrayLike, ratio: float = 0.8) -> tuple[Array, Array]:
    """Return where two pictures show the same details, with some errors among them.

    Parameters
    ----------
    picture1, picture2 : array_like
        As in `find_features`.
    ratio : float
        As in `match_features`.

    Returns
    -------
    points1, points2 : ndarray, shape (M, 2)
        Pixels of picture 1 and their partners in picture 2, the most alike first.

    Raises
    ------
    TypeError, ValueError
        As the functions before.
    DegenerateConfigurationError
        If a picture has no detail, or no detail of one is clearly in the other.

    Examples
    --------
    >>> picture = np.random.default_rng(0).integers(0, 255, (40, 40), np.uint8).repeat(4, 0)
    >>> picture = picture.repeat(4, 1)
    >>> points1, points2 = tie_points(picture[:, 20:], picture[:, :-20])  # the camera moved right
    >>> np.median(points2 - points1, axis=0).round(1)
    array([20.,  0.])
    """
    one, other = find_features(picture1), find_features(picture2)
    pairs = match_features(one, other, ratio)
    if not len(pairs):
        raise DegenerateConfigurationError(
            f"none of {len(one)} details of picture 1 is clearly one of {len(other)} of picture 2: "
            "the pictures do not overlap, or are too far apart; allow a larger ratio"
        )
    return one.points[pairs[:, 0]], other.points[pairs[:, 1]]


def _alike(one: NDArray[np.float32], other: NDArray[np.float32], ratio: float) -> Pairs:
    """Return the pairs of rows that are each other's nearest and pass the test, nearest first."""
    squares = _squares(one, other)
    rows, nearest = np.arange(len(one)), squares.argmin(axis=1)
    least = squares[rows, nearest]
    mutual = least == squares.min(axis=0)[nearest]
    rows, nearest, least = rows[mutual], nearest[mutual], least[mutual]
    # Without the nearest ones, the second nearest is the least.
    forward, backward = squares[rows], squares[:, nearest]
    forward[np.arange(len(rows)), nearest] = np.inf
    backward[rows, np.arange(len(rows))] = np.inf
    second = np.minimum(forward.min(axis=1), backward.min(axis=0))
    kept = least <= ratio**2 * second
    order = np.argsort(least[kept], kind="stable")
    return np.stack([rows[kept], nearest[kept]], axis=1)[order]


def _squares(one: NDArray[np.float32], other: NDArray[np.float32]) -> NDArray[np.float32]:
    """Return squared distances of all rows from all others; exact, as all numbers are whole."""
    sums = (one**2).sum(axis=1)[:, None] + (other**2).sum(axis=1)
    sums -= 2 * (one @ other.T)
    return np.asarray(sums)


def _once_each(pairs: Pairs, one: Features, other: Features) -> Pairs:
    """Return the pairs without those at a place that an earlier pair has already."""
    for features, side in ((one, 0), (other, 1)):
        places = features.places[pairs[:, side]]
        pairs = pairs[np.sort(np.unique(places, return_index=True)[1])]
    return pairs
