"""Rectified pairs: partners share a row, cameras look square to the baseline."""

import numpy as np
import pytest
from two_views import SIZE, K, scene

from course_lib.camera import project
from course_lib.checks import DegenerateConfigurationError
from course_lib.epipolar import fundamental_from_cameras, rectify, rectify_uncalibrated
from course_lib.homogeneous import apply_homography


@pytest.mark.parametrize("t", [[-1, 0.1, 0.1], [1, -0.2, 0.1], [-5, 0, 0]])
def test_partners_share_a_row(t):
    s = scene(1, count=50, noise=0, t=t)
    K2 = K + np.diag([30, 40, 0])
    pair = rectify(K, K2, s.R, s.t)
    seen2 = project(s.points, K2 @ np.column_stack([s.R, s.t]))
    one, other = apply_homography(s.exact1, pair.H1), apply_homography(seen2, pair.H2)
    np.testing.assert_allclose(one[:, 1], other[:, 1], atol=1e-8)
    assert pair.baseline == pytest.approx(np.linalg.norm(t))
    np.testing.assert_allclose(pair.t[1:], 0, atol=1e-12)
    assert np.sign(pair.t[0]) == np.sign(t[0])  # camera 2 stays on its side
    # The rectified cameras see the points where the homographies put them.
    turned = s.points @ pair.R1.T
    for P, pixels in zip(pair.cameras, (one, other), strict=True):
        np.testing.assert_allclose(project(turned, P), pixels, atol=1e-8)
    # Disparity tells depth.
    disparity = np.sign(-t[0]) * (one[:, 0] - other[:, 0])
    np.testing.assert_allclose(pair.K[0, 0] * pair.baseline / disparity, turned[:, 2], rtol=1e-8)


def test_a_rectified_pair_stays_as_it_is():
    pair = rectify(K, K, np.eye(3), [-0.2, 0, 0])
    np.testing.assert_allclose(pair.H1, np.eye(3), atol=1e-12)
    np.testing.assert_allclose(pair.H2, np.eye(3), atol=1e-12)


@pytest.mark.parametrize("seed", range(3))
def test_without_intrinsics(seed):
    s = scene(seed, count=60, noise=0, t=[-1, 0.1, 0.05])
    F = fundamental_from_cameras(s.P1, s.P2)
    H1, H2 = rectify_uncalibrated(F, s.exact1, s.exact2, SIZE)
    one, other = apply_homography(s.exact1, H1), apply_homography(s.exact2, H2)
    np.testing.assert_allclose(one[:, 1], other[:, 1], atol=1e-6)
    # The picture keeps its place and size.
    assert np.abs(other - s.exact2).max() < 0.3 * SIZE[0]
    assert np.abs((one - other)[:, 0]).mean() < 100
    assert np.linalg.det(H1) > 0


def test_degenerate_geometry_is_named():
    forward = scene(2, t=[0, 0, 1])
    with pytest.raises(DegenerateConfigurationError, match="epipole is in the picture"):
        rectify(K, K, np.eye(3), forward.t)
    F = fundamental_from_cameras(forward.P1, forward.P2)
    with pytest.raises(DegenerateConfigurationError, match="epipole is in the picture"):
        rectify_uncalibrated(F, forward.exact1, forward.exact2, SIZE)
    with pytest.raises(DegenerateConfigurationError, match="same place"):
        rectify(K, K, np.eye(3), [0, 0, 0])
