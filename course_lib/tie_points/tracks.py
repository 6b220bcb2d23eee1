"""Details followed through many pictures.

Use these functions through `course_lib.tie_points`.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import combinations

import numpy as np
from numpy.typing import ArrayLike

from course_lib.bundle import Observations
from course_lib.checks import DegenerateConfigurationError, check_intrinsics
from course_lib.epipolar import ransac_pose
from course_lib.tie_points.features import Features, find_features
from course_lib.tie_points.matching import Pairs, match_features

#: So many pairs do not agree by accident.
LEAST_AGREEING = 15


def agreeing_matches(
    features: Sequence[Features],
    matches: Mapping[tuple[int, int], Pairs],
    K: ArrayLike,
    rng: np.random.Generator,
    threshold: float = 1.5,
) -> dict[tuple[int, int], Pairs]:
    """Return the pairs that agree with the relative pose that most pairs of two pictures have.

    Parameters
    ----------
    features : sequence of Features
        Of each picture.
    matches : mapping
        From two numbers of pictures to their pairs, as of `match_features`.
    K : array_like, shape (3, 3)
        Intrinsics of the camera, px; pictures without distortion.
    rng : numpy.random.Generator
        Draws the samples.
    threshold : float
        Largest Sampson error, px.

    Returns
    -------
    dict
        As `matches`; two pictures with fewer than 15 pairs that agree are left out.

    Raises
    ------
    TypeError, ValueError
        As `course_lib.epipolar.ransac_pose`.
    """
    K, kept = check_intrinsics(K), {}
    for (i, j), pairs in matches.items():
        if len(pairs) < LEAST_AGREEING:
            continue
        one, other = features[i].points[pairs[:, 0]], features[j].points[pairs[:, 1]]
        try:
            fits = ransac_pose(one, other, K, K, rng, threshold, rivals=False).fits
        except DegenerateConfigurationError:
            continue  # no pose, or no baseline: nothing to measure from
        if fits.sum() >= LEAST_AGREEING:
            kept[i, j] = pairs[fits]
    return kept


def join_matches(
    features: Sequence[Features], matches: Mapping[tuple[int, int], Pairs]
) -> Observations:
    """Return who sees which detail where, from pairs of details of many pictures.

    Pairs that share a detail are joined to a track. A track that comes to two places of one
    picture has a wrong pair in it; as nobody knows which, all of it is thrown out.

    Parameters
    ----------
    features : sequence of Features
        Of each picture.
    matches : mapping
        From two numbers of pictures to their pairs, as of `match_features`.

    Returns
    -------
    Observations
        Cameras are numbered as the pictures; points from 0, those seen most often first.

    Raises
    ------
    DegenerateConfigurationError
        If no track is left.
    """
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    first = np.concatenate([[0], np.cumsum([len(each) for each in features])])
    places = np.concatenate([each.places + k for each, k in zip(features, first, strict=False)])
    links = [places[np.reshape(p, (-1, 2)) + first[[i, j]]] for (i, j), p in matches.items()]
    one, other = np.concatenate([np.empty((0, 2), np.intp), *links]).T
    graph = coo_array((np.ones(len(one), np.int8), (one, other)), shape=(first[-1], first[-1]))
    track = connected_components(graph, directed=False)[1]
    nodes = np.unique(np.concatenate([one, other]))
    cameras = np.searchsorted(first, nodes, side="right") - 1
    # A track is right if it has no picture twice.
    apart = np.unique(np.stack([track[nodes], cameras], axis=1), axis=0)[:, 0]
    length = np.bincount(track[nodes], minlength=first[-1])
    good = length == np.bincount(apart, minlength=first[-1])
    kept = good[track[nodes]]
    if not kept.any():
        raise DegenerateConfigurationError(
            "no detail could be followed from picture to picture: the pictures do not overlap, or "
            "all tracks contradict themselves; allow fewer wrong pairs (a smaller ratio, or give K)"
        )
    nodes, cameras = nodes[kept], cameras[kept]
    often = np.unique(track[nodes])
    order = np.empty(first[-1], np.intp)
    order[often[np.argsort(-length[often], kind="stable")]] = np.arange(len(often))
    pixels = np.concatenate([each.points for each in features])[nodes]
    return Observations(cameras, order[track[nodes]], pixels)


def tracks(
    pictures: Sequence[ArrayLike],
    K: ArrayLike | None = None,
    rng: np.random.Generator | None = None,
    ratio: float = 0.8,
    pairs: Iterable[tuple[int, int]] | None = None,
    most: int = 3000,
) -> Observations:
    """Return who sees which detail where, from pictures.

    Parameters
    ----------
    pictures : sequence of array_like
        Two or more, as in `find_features`, without distortion.
    K : array_like, shape (3, 3), optional
        Intrinsics of the camera, px. With it, only pairs count that agree with one relative pose of
        the two pictures (`agreeing_matches`); wrong pairs join tracks that do not belong together.
    rng : numpy.random.Generator, optional
        Draws samples; needed with `K`.
    ratio : float
        As in `match_features`.
    pairs : iterable of tuple of int, optional
        Which pictures are compared, numbered from 0; each with each if not given.
    most : int
        How many details of a picture are used.

    Returns
    -------
    Observations
        As of `join_matches`.

    Raises
    ------
    TypeError, ValueError
        As the functions before, or if there are fewer than two pictures.
    DegenerateConfigurationError
        If a picture has no detail, or none could be followed.
    """
    if len(pictures) < 2:
        raise ValueError(f"tracks need two pictures or more, got {len(pictures)}")
    features = [find_features(picture, most) for picture in pictures]
    chosen = combinations(range(len(pictures)), 2) if pairs is None else pairs
    matches = {(i, j): match_features(features[i], features[j], ratio) for i, j in chosen}
    if K is not None:
        if rng is None:
            raise TypeError("with K, an rng is needed too: np.random.default_rng(0)")
        matches = agreeing_matches(features, matches, K, rng)
    return join_matches(features, matches)
