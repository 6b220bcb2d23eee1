"""Two views against OpenCV and scikit-image, and against the calibration of real pairs."""

import cv2
import numpy as np
import pytest
from real_data import fetched
from two_views import K, angle_between, normalised, same_up_to_sign, scene, turn_between

from course_lib.calibration import board_points, calibrate_stereo
from course_lib.camera import camera_matrix, project
from course_lib.distortion import undistort_pixels
from course_lib.epipolar import (
    eight_point,
    epipolar_lines,
    essential_from_pose,
    five_point,
    fundamental_from_cameras,
    poses_from_essential,
    ransac_fundamental,
    ransac_pose,
    sampson_error,
    seven_point,
)
from course_lib.epipolar.matrices import unit
from course_lib.triangulation import depth_from_disparity, triangulate, triangulate_linear

SEEDS = range(5)


@pytest.mark.parametrize("seed", SEEDS)
def test_lines_and_errors(seed):
    s = scene(seed, count=40)
    F = fundamental_from_cameras(s.P1, s.P2)
    theirs = cv2.computeCorrespondEpilines(s.points1[:, None], 1, F)[:, 0]
    ours = epipolar_lines(s.points1, F)
    np.testing.assert_allclose(np.abs(ours), np.abs(theirs), rtol=1e-6, atol=1e-9)
    homogeneous = [np.column_stack([p, np.ones(len(p))]) for p in (s.points1, s.points2)]
    squares = [cv2.sampsonDistance(x1, x2, F) for x1, x2 in zip(*homogeneous, strict=True)]
    np.testing.assert_allclose(sampson_error(s.points1, s.points2, F) ** 2, squares, rtol=1e-7)


@pytest.mark.parametrize("seed", SEEDS)
def test_eight_seven_and_five_points(seed):
    s = scene(seed, count=40)
    theirs = unit(cv2.findFundamentalMat(s.points1, s.points2, cv2.FM_8POINT)[0])
    assert same_up_to_sign(eight_point(s.points1, s.points2), theirs, 1e-6)
    seven = cv2.findFundamentalMat(s.points1[:7], s.points2[:7], cv2.FM_7POINT)[0]
    ours = seven_point(s.points1[:7], s.points2[:7])
    assert len(ours) == len(seven) // 3
    for F in unit(seven.reshape(-1, 3, 3)):  # OpenCV's miss their pairs by 1e-5 px, ours by 1e-13
        assert any(same_up_to_sign(F, other, 1e-4) for other in ours)
    one, other = normalised(s.points1[:5]), normalised(s.points2[:5])
    five = cv2.findEssentialMat(one, other, np.eye(3), method=cv2.RANSAC)[0]
    ours = five_point(one, other)
    assert len(ours) == len(five) // 3
    for E in unit(five.reshape(-1, 3, 3)):
        assert any(same_up_to_sign(E, found, 1e-5) for found in ours)


def test_four_poses():
    s = scene(1)
    E = essential_from_pose(s.R, s.t)
    R1, R2, t = cv2.decomposeEssentialMat(E)
    ours = poses_from_essential(E)
    for R in (R1, R2):
        for sign in (1, -1):
            assert any(
                np.allclose(R, found[0], atol=1e-9) and np.allclose(sign * t[:, 0], found[1])
                for found in ours
            )


@pytest.mark.parametrize("seed", SEEDS)
def test_triangulation(seed):
    s = scene(seed, count=200)
    theirs = cv2.triangulatePoints(s.P1, s.P2, s.points1.T, s.points2.T)
    theirs = (theirs[:3] / theirs[3]).T
    ours = triangulate_linear(np.stack([s.points1, s.points2]), np.stack([s.P1, s.P2]))
    np.testing.assert_allclose(ours, theirs, rtol=1e-5)
    # The optimal correction of Hartley and Sturm, then the rays meet.
    F = fundamental_from_cameras(s.P1, s.P2)
    best1, best2 = cv2.correctMatches(F, s.points1[None], s.points2[None])
    best = cv2.triangulatePoints(s.P1, s.P2, best1[0].T, best2[0].T)
    best = (best[:3] / best[3]).T
    ours = triangulate(s.points1, s.points2, s.P1, s.P2)
    off = np.linalg.norm(ours - best, axis=1) / np.linalg.norm(theirs - s.points, axis=1)
    assert np.median(off) < 0.01


def test_triangulated_points_are_as_good_as_those_of_opencv():
    """RMS in space at 0.5 px of noise, 100 000 points: chance leaves millionths to either side."""
    P1, P2 = camera_matrix(K, np.eye(3), np.zeros(3)), scene(0, count=1).P2
    squares = np.zeros(2)
    for seed in range(10):
        rng = np.random.default_rng(seed)
        X = rng.uniform(-1, 1, (10_000, 3)) * [2, 1.5, 3] + [0, 0, 7]
        one, other = (project(X, P) + 0.5 * rng.standard_normal((len(X), 2)) for P in (P1, P2))
        theirs = cv2.triangulatePoints(P1, P2, one.T, other.T)
        found = triangulate(one, other, P1, P2), (theirs[:3] / theirs[3]).T
        squares += [((points - X) ** 2).sum() for points in found]
    assert np.sqrt(squares[0] / squares[1]) <= 1 + 1e-5


@pytest.mark.parametrize("wrong", [0.3, 0.6])
def test_robust_matrices_are_better_than_magsac(wrong):
    errors = []
    for seed in range(12):
        s = scene(seed, wrong=wrong)
        ours = ransac_fundamental(s.points1, s.points2, np.random.default_rng(seed)).F
        theirs = cv2.findFundamentalMat(s.points1, s.points2, cv2.USAC_MAGSAC, 1.5, 0.99)[0]
        exact = s.exact1[s.right], s.exact2[s.right]
        errors.append([np.sqrt(np.mean(sampson_error(*exact, F) ** 2)) for F in (ours, theirs)])
    ours, theirs = np.transpose(errors)
    assert np.mean(ours) <= np.mean(theirs)
    assert max(ours) < 2


@pytest.fixture(scope="module")
def real_pairs():
    """Return the calibrated rig of OpenCV's pairs, and each one's matches without distortion."""
    numbers = [n for n in range(1, 15) if n != 10]
    pictures = [
        [
            cv2.imread(str(fetched(f"opencv_stereo/{side}{n:02d}.jpg")), cv2.IMREAD_GRAYSCALE)
            for n in numbers
        ]
        for side in ("left", "right")
    ]
    corners = [[_corners(picture) for picture in side] for side in pictures]
    rig = calibrate_stereo(board_points(9, 6, 30), *corners, (640, 480))
    matches = [_sift(*pair) for pair in zip(*pictures, strict=True)]
    lenses = (rig.K_left, rig.coefficients_left), (rig.K_right, rig.coefficients_right)
    return rig, [
        [undistort_pixels(pairs[:, side], *lens) for side, lens in enumerate(lenses)]
        for pairs in matches
    ]


def pooled(pairs):
    """Return the matches of all pairs as those of one."""
    return [np.concatenate(side) for side in zip(*pairs, strict=True)]


def _corners(picture):
    coarse = cv2.findChessboardCorners(picture, (9, 6))[1]
    return cv2.cornerSubPix(picture, coarse, (5, 5), (-1, -1), (3, 100, 1e-6)).reshape(-1, 2)


def _sift(left, right):
    sift = cv2.SIFT_create(4000)
    (one, first), (other, second) = (sift.detectAndCompute(p, None) for p in (left, right))
    found = cv2.BFMatcher().knnMatch(first, second, k=2)
    kept = [best for best, second_best in found if best.distance < 0.8 * second_best.distance]
    return np.array([[one[m.queryIdx].pt, other[m.trainIdx].pt] for m in kept])


def test_relative_pose_of_real_pairs(real_pairs):
    rig, pairs = real_pairs
    found = ransac_pose(*pooled(pairs), rig.K_left, rig.K_right, np.random.default_rng(0))
    assert 0.3 < found.fits.mean() < 0.9  # a chessboard's corners look alike
    assert turn_between(found.R, rig.R) < 0.5
    assert angle_between(found.t, rig.t) < 1
    assert not found.doubt


def test_a_real_pair_alone_gives_the_pose_or_a_doubt(real_pairs):
    """Many of these matches are squares taken for their neighbours: a wrong pose may fit best."""
    rig, pairs = real_pairs
    doubted = 0
    for number, (one, other) in enumerate(pairs):
        found = ransac_pose(one, other, rig.K_left, rig.K_right, np.random.default_rng(0))
        off = max(turn_between(found.R, rig.R), angle_between(found.t, rig.t))
        assert found.doubt or off < 1, (number, off)
        doubted += bool(found.doubt)
    assert doubted <= 6


def test_real_lines(real_pairs):
    rig, pairs = real_pairs
    one, other = pooled(pairs)
    found = ransac_fundamental(one, other, np.random.default_rng(0))
    P2 = rig.K_right @ np.column_stack([rig.R, rig.t])
    truth = fundamental_from_cameras(rig.K_left @ np.eye(3, 4), P2)
    right = found.fits
    assert np.median(sampson_error(one[right], other[right], truth)) < 0.4
    assert right.mean() > 0.3


def test_motorcycle():
    from skimage.data import stereo_motorcycle

    disparity = stereo_motorcycle()[2]
    seen = np.isfinite(disparity) & (disparity > 0)
    f, baseline, offset = 994.978, 193.001, 31.086
    Z = depth_from_disparity(disparity[seen], f, baseline, offset)
    rows, columns = np.nonzero(seen)
    some = slice(None, None, 997)
    left = np.column_stack([columns, rows])[some].astype(float)
    right = left - np.column_stack([disparity[seen][some], 0 * rows[some]])
    middle = 311.193, 254.877
    K1 = np.array([[f, 0, middle[0]], [0, f, middle[1]], [0, 0, 1]])
    K2 = K1.copy()
    K2[0, 2] += offset
    P2 = K2 @ np.column_stack([np.eye(3), [-baseline, 0, 0]])
    points = triangulate(left, right, K1 @ np.eye(3, 4), P2)
    np.testing.assert_allclose(points[:, 2], Z[some], rtol=1e-6)
    assert 1500 < Z.min() < Z.max() < 8000  # mm: a workshop


def test_poses_are_about_as_good_as_magsac():
    turns = []
    for seed in range(8):
        s = scene(seed, wrong=0.3)
        ours = ransac_pose(s.points1, s.points2, K, K, np.random.default_rng(seed))
        usual = {"method": cv2.USAC_MAGSAC, "prob": 0.99, "threshold": 1.5}
        E, mask = cv2.findEssentialMat(s.points1, s.points2, K, **usual)
        R = cv2.recoverPose(E, s.points1, s.points2, K, mask=mask)[1]
        turns.append([turn_between(found, s.R) for found in (ours.R, R)])
    ours, theirs = np.mean(turns, axis=0)
    assert ours <= 1.3 * theirs
