"""Details found, paired and followed: on blobs at known places, and on others' photographs."""

import cv2
import numpy as np
import pytest
from real_data import fetched
from two_views import K, scene

from course_lib.bundle import Observations
from course_lib.checks import DegenerateConfigurationError
from course_lib.homogeneous import apply_homography
from course_lib.tie_points import (
    Features,
    agreeing_matches,
    find_features,
    join_matches,
    match_features,
    tie_points,
    tracks,
)
from course_lib.transforms import rotation_from_vector


def features(*values, points=None):
    """Return details whose descriptors are one number and zeros."""
    descriptors = np.zeros((len(values), 128), np.float32)
    descriptors[:, 0] = values
    places = np.arange(2.0 * len(values)).reshape(-1, 2) if points is None else points
    return Features(np.asarray(places, float), descriptors)


def noise(shape=(200, 260), seed=0):
    """Return a picture full of blobs."""
    rough = np.random.default_rng(seed).normal(size=shape)
    smooth = cv2.GaussianBlur(rough, (0, 0), 2)
    return np.clip(128 + 60 * smooth / smooth.std(), 0, 255).astype(np.uint8)


def test_shapes():
    found = find_features(noise(), most=50)
    assert found.points.shape == (50, 2)
    assert found.descriptors.shape == (50, 128)
    assert len(found) == 50
    points1, points2 = tie_points(noise(), noise())
    np.testing.assert_array_equal(points1, points2)


def test_blobs_are_where_they_are():
    """The middle of the first pixel is (0, 0); OpenCV's usual SIFT is a quarter of a pixel off."""
    rng = np.random.default_rng(1)
    grid = np.stack(np.meshgrid(np.arange(5), np.arange(4)), axis=-1).reshape(-1, 2)
    places = 90 + 110 * grid + rng.uniform(-20, 20, (20, 2))
    v, u = np.mgrid[:520, :640]
    picture = 60.0 + sum(
        150 * np.exp(-((u - x) ** 2 + (v - y) ** 2) / (2 * s**2))
        for (x, y), s in zip(places, rng.uniform(2, 6, 20), strict=True)
    )
    found = find_features(np.clip(np.rint(picture), 0, 255).astype(np.uint8)).points
    away = found - places[np.linalg.norm(found[:, None] - places, axis=2).argmin(axis=1)]
    away = away[np.linalg.norm(away, axis=1) < 3]
    assert len(away) > 40
    assert np.abs(away).max() < 0.12
    assert np.abs(away.mean(axis=0)).max() < 0.02


def test_the_kind_of_picture_does_not_matter():
    grey = noise()
    for same in (np.repeat(grey[..., None], 3, axis=2), grey / 255, grey.astype(np.uint16) * 257):
        np.testing.assert_allclose(find_features(same).points, find_features(grey).points)


def test_nearest_both_ways():
    # 50 is the nearest of 42, but 42 is not the nearest of 50.
    one, other = features(10, 42, 90), features(92, 50, 11)
    pairs = match_features(one, other, 1)
    assert {tuple(pair) for pair in pairs.tolist()} == {(0, 2), (1, 1), (2, 0)}
    assert pairs[0].tolist() == [0, 2]  # the most alike first
    pairs = match_features(features(10, 42, 49), other, 1)
    assert [1, 1] not in pairs.tolist()
    assert [2, 1] in pairs.tolist()


def test_what_is_there_twice_has_no_clear_partner():
    one, twice = features(10, 100), features(11, 12, 130)
    assert match_features(one, twice, 0.4).tolist() == [[1, 2]]
    assert match_features(twice, one, 0.4).tolist() == [[2, 1]]  # both ways
    assert match_features(one, twice, 1).tolist() == [[0, 0], [1, 2]]
    # Exactly at the ratio: 1 / 2.
    assert len(match_features(one, twice, 0.5)) == 2


def test_no_place_twice():
    """SIFT describes a place once for each direction; one pair is enough."""
    one = features(10, 60, points=[[5, 5], [5, 5]])
    other = features(11, 62, points=[[7, 7], [9, 9]])
    assert match_features(one, other).tolist() == [[0, 0]]
    assert match_features(other, one).tolist() == [[0, 0]]


def test_the_pairs_are_those_of_opencv():
    """The same as OpenCV's matcher with a cross-check."""
    found = find_features(noise((500, 700))), find_features(noise((500, 700))[7:, 5:])
    assert min(len(each) for each in found) > 1000
    places = (np.arange(2.0 * len(each)).reshape(-1, 2) for each in found)  # none of them twice
    one, other = (Features(p, each.descriptors) for p, each in zip(places, found, strict=True))
    theirs = cv2.BFMatcher(cv2.NORM_L2, True).match(one.descriptors, other.descriptors)
    ours = {tuple(pair) for pair in match_features(one, other, 1).tolist()}
    theirs = {(match.queryIdx, match.trainIdx) for match in theirs}
    assert len(ours ^ theirs) < 0.01 * len(theirs)  # equal distances


def test_rows_of_a_rectified_pair_agree():
    """Middlebury's Motorcycle, as scikit-image ships it: partners share a row."""
    from skimage.data import stereo_motorcycle

    left, right, disparity = stereo_motorcycle()
    shares = {}
    for ratio in (1.0, 0.8):
        points1, points2 = tie_points(left, right, ratio)
        rows = points2[:, 1] - points1[:, 1]
        shares[ratio] = (np.abs(rows) < 1).mean()
        right_row = np.abs(rows) < 1
        assert np.abs(np.median(rows[right_row])) < 0.1
        column, row = np.rint(points1[right_row]).astype(int).T
        true = disparity[row, column]
        away = (points1 - points2)[right_row, 0] - true
        assert np.nanmedian(np.abs(away[np.isfinite(away)])) < 0.3
    assert len(points1) > 700
    assert shares[1.0] < 0.8
    assert shares[0.8] > 0.9


def test_a_wall_from_another_side():
    """Graffiti under 30 degrees, against the published homography (K. Mikolajczyk)."""
    files = (str(fetched(f"opencv_stereo/graf{k}.png")) for k in (1, 3))
    one, other = (cv2.imread(file, cv2.IMREAD_GRAYSCALE) for file in files)
    file = cv2.FileStorage(str(fetched("opencv_stereo/H1to3p.xml")), cv2.FILE_STORAGE_READ)
    H = file.getFirstTopLevelNode().mat()
    shares = {}
    for ratio in (1.0, 0.8):
        points1, points2 = tie_points(one, other, ratio)
        away = np.linalg.norm(apply_homography(points1, H) - points2, axis=1)
        shares[ratio] = (away < 3).mean()
    assert (away < 3).sum() > 250
    assert np.median(away[away < 3]) < 1
    assert shares[1.0] < 0.5
    assert shares[0.8] > 0.65


def test_pairs_that_agree_are_right():
    """Four of ten pairs are wrong; pictures with too few right ones, or no baseline, drop out."""
    s = scene(0, count=200, wrong=0.4)
    each = [features(*range(200), points=points) for points in (s.points1, s.points2)]
    H = K @ rotation_from_vector([0, 0.05, 0]) @ np.linalg.inv(K)
    turned = apply_homography(s.points1, H) + 0.3 * np.random.default_rng(1).normal(size=(200, 2))
    each.append(features(*range(200), points=turned))
    every = np.stack([np.arange(200)] * 2, axis=1)
    matches = {(0, 1): every, (1, 0): every[~s.right], (0, 2): every}
    kept = agreeing_matches(each, matches, K, np.random.default_rng(0))
    assert list(kept) == [(0, 1)]
    right = s.right[kept[0, 1][:, 0]]
    assert right.sum() > 0.95 * s.right.sum()
    assert (~right).sum() < 10


def test_tracks_join_pairs():
    """Two details over three pictures, numbered by how often they are seen."""
    each = [features(1, 2), features(1, 2), features(1, 2)]
    seen = join_matches(each, {(0, 1): np.array([[0, 1]]), (1, 2): np.array([[1, 0], [0, 1]])})
    assert isinstance(seen, Observations)
    rows = {tuple(row) for row in np.column_stack([seen.cameras, seen.points, seen.pixels])}
    assert rows == {(0, 0, 0, 1), (1, 0, 2, 3), (2, 0, 0, 1), (1, 1, 0, 1), (2, 1, 2, 3)}


def test_a_track_that_comes_to_two_places_is_thrown_out():
    each = [features(1, 2, 3) for _ in range(3)]
    chain = {
        (0, 1): np.array([[0, 0], [2, 2]]),
        (1, 2): np.array([[0, 0], [2, 2]]),
        (0, 2): np.array([[1, 0]]),  # picture 0 twice in the first track
    }
    seen = join_matches(each, chain)
    assert set(seen.points) == {0}
    np.testing.assert_array_equal(seen.pixels, np.tile([4, 5], (3, 1)))
    # The same place, described twice, is no contradiction.
    each[0] = features(1, 2, 3, points=[[0, 1], [0, 1], [4, 5]])
    assert len(join_matches(each, chain)) == 6


def test_tracks_of_a_shifted_picture():
    wide = noise((300, 500))
    pictures = [wide[:, k : k + 400] for k in (0, 40, 80)]
    seen = tracks(pictures)
    often = np.bincount(seen.points)
    assert (often == 3).sum() > 100
    assert (np.diff(often) <= 0).all()
    shift = seen.pixels[:, 0] + 40 * seen.cameras
    first = np.array([shift[seen.points == point][0] for point in range(len(often))])
    assert (np.abs(shift - first[seen.points]) < 0.6).mean() > 0.95
    neighbours = tracks(pictures, pairs=[(0, 1)])
    assert set(neighbours.cameras) == {0, 1}


def test_errors_say_what_to_do():
    with pytest.raises(DegenerateConfigurationError, match="no texture"):
        find_features(np.full((50, 60), 90, np.uint8))
    with pytest.raises(TypeError, match="uint8"):
        find_features("left.jpg")
    with pytest.raises(ValueError, match="most must be a whole number"):
        find_features(noise(), most=0)
    with pytest.raises(ValueError, match=r"ratio must be from above 0 to 1, got 80"):
        match_features(features(1), features(2), 80)
    with pytest.raises(TypeError, match="find_features"):
        match_features(noise(), features(2))
    with pytest.raises(DegenerateConfigurationError, match="do not overlap"):
        tie_points(noise(seed=1), noise(seed=2), 0.2)
    with pytest.raises(ValueError, match="two pictures"):
        tracks([noise()])
    with pytest.raises(TypeError, match="rng"):
        tracks([noise(), noise()], K=np.eye(3))
    with pytest.raises(DegenerateConfigurationError, match="followed"):
        join_matches([features(1), features(1)], {(0, 1): np.empty((0, 2), int)})
