"""A real stereo rig, end to end: calibrated by some pairs, judged by the others.

OpenCV's 13 pairs of a board with squares of 30 mm, 640 × 480 px. J.-Y. Bouguet's toolbox found
T = (-99.802, 1.124, 0.050) mm for the same set.
"""

import cv2
import numpy as np
import pytest
from real_data import fetched

from course_lib.calibration import board_points, calibrate_stereo
from course_lib.distortion import undistort_pixels
from course_lib.epipolar import rectify
from course_lib.homogeneous import apply_homography
from course_lib.triangulation import depth_from_disparity, triangulate

NUMBERS = [n for n in range(1, 15) if n != 10]
#: Pairs that calibrate the rig; the others judge it.
FIRST = 8


def corners(side, number):
    path = str(fetched(f"opencv_stereo/{side}{number:02d}.jpg"))
    picture = cv2.imread(path, cv2.IMREAD_GRAYSCALE)
    coarse = cv2.findChessboardCorners(picture, (9, 6))[1]
    return cv2.cornerSubPix(picture, coarse, (5, 5), (-1, -1), (3, 100, 1e-6)).reshape(-1, 2)


@pytest.fixture(scope="module")
def rig():
    """Return the rig of the first pairs, and the corners of the others without distortion."""
    sides = [[corners(side, n) for n in NUMBERS] for side in ("left", "right")]
    found = calibrate_stereo(board_points(9, 6, 30), sides[0][:FIRST], sides[1][:FIRST], (640, 480))
    left = undistort_pixels(np.concatenate(sides[0][FIRST:]), found.K_left, found.coefficients_left)
    right = undistort_pixels(
        np.concatenate(sides[1][FIRST:]), found.K_right, found.coefficients_right
    )
    return found, left, right


def test_the_baseline_is_the_published_one(rig):
    np.testing.assert_allclose(rig[0].t, [-99.802, 1.124, 0.050], atol=0.6)


def test_rows_of_other_pairs_agree(rig):
    """Before rectification the rows differ by many pixels, after it by a fraction of one."""
    found, left, right = rig
    pair = rectify(found.K_left, found.K_right, found.R, found.t)
    one, other = apply_homography(left, pair.H1), apply_homography(right, pair.H2)
    rows = other[:, 1] - one[:, 1]
    assert np.abs(right[:, 1] - left[:, 1]).mean() > 10
    assert np.sqrt((rows**2).mean()) < 0.2
    assert abs(np.median(rows)) < 0.1
    # As good as OpenCV's rectification of the same rig.
    R1, R2, P1, P2, *_ = cv2.stereoRectify(
        found.K_left, np.zeros(5), found.K_right, np.zeros(5), (640, 480), found.R, found.t[:, None]
    )
    theirs = [
        cv2.undistortPoints(pixels[:, None], K, np.zeros(5), R=R, P=P)[:, 0]
        for pixels, K, R, P in ((left, found.K_left, R1, P1), (right, found.K_right, R2, P2))
    ]
    their_rows = (theirs[1] - theirs[0])[:, 1] / P1[1, 1]
    assert np.sqrt((rows**2).mean()) / pair.K[1, 1] < 1.05 * np.sqrt((their_rows**2).mean())


def test_other_boards_are_measured(rig):
    """Depth from disparity agrees with triangulation, and squares are 30 mm wide."""
    found, left, right = rig
    pair = rectify(found.K_left, found.K_right, found.R, found.t)
    one, other = apply_homography(left, pair.H1), apply_homography(right, pair.H2)
    disparity = one[:, 0] - other[:, 0]
    Z = depth_from_disparity(disparity, pair.K[0, 0], pair.baseline, 0)
    P1, P2 = found.K_left @ np.eye(3, 4), found.K_right @ np.column_stack([found.R, found.t])
    points = triangulate(left, right, P1, P2)
    np.testing.assert_allclose(Z, (points @ pair.R1.T)[:, 2], rtol=2e-3)
    boards = points.reshape(-1, 6, 9, 3)
    sides = np.concatenate(
        [np.linalg.norm(np.diff(boards, axis=k), axis=-1).ravel() for k in (1, 2)]
    )
    assert sides.mean() == pytest.approx(30, abs=0.1)
    assert sides.std() < 0.5
    long = np.linalg.norm(boards[:, 0, 8] - boards[:, 0, 0], axis=1)
    np.testing.assert_allclose(long, 240, atol=1.5)
