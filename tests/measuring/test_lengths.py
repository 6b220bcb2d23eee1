"""Lengths without noise are the true ones; what cannot be measured is said."""

from dataclasses import replace

import cv2
import numpy as np
import pytest
from measuring_scene import (
    COEFFICIENTS,
    FLAT,
    POSES,
    RAISED,
    SIZE,
    TARGET,
    K,
    calibrated,
    image,
    in_pair,
    stereo,
    targeted,
)

from course_lib.calibration import CameraModel
from course_lib.checks import DegenerateConfigurationError
from course_lib.measuring import (
    distance_in_space,
    distance_on_plane,
    point_in_space,
    point_on_plane,
    rays_miss,
    target_offsets,
    view_of_target,
    views_of_pair,
)
from course_lib.orientation import similarity_transform
from course_lib.transforms import rotation_x, rotation_y


class TestTruth:
    def test_on_the_plane(self, exact):
        view = exact[1][0]
        np.testing.assert_allclose(point_on_plane(image(FLAT, POSES[0]), view), FLAT, atol=1e-6)
        length = distance_on_plane(*image(FLAT, POSES[0]), view)
        assert length.value == pytest.approx(np.hypot(5, 85), abs=1e-6)

    def test_above_the_plane(self, exact):
        above, view = FLAT - [0, 0, 12], exact[1][0]
        pixels = image(above, POSES[0])
        np.testing.assert_allclose(point_on_plane(pixels, view, height=12), above, atol=1e-6)
        forgotten = distance_on_plane(*pixels, view).value / np.hypot(5, 85)
        distance = -view.centre[2]  # of the camera from the plane
        assert forgotten == pytest.approx(distance / (distance - 12), rel=1e-6)

    def test_in_space(self, exact):
        pixels = np.stack([image(RAISED, pose) for pose in POSES])
        np.testing.assert_allclose(point_in_space(pixels, exact[1]), RAISED, atol=1e-6)
        length = distance_in_space(pixels[:, 0], pixels[:, 1], exact[1])
        assert length.value == pytest.approx(np.linalg.norm(RAISED[1] - RAISED[0]), abs=1e-6)

    def test_by_a_pair(self):
        views = views_of_pair(stereo(0, np.random.default_rng(0)))
        points = np.array([[-40.0, 10, 420], [60, -30, 500]])
        np.testing.assert_allclose(point_in_space(in_pair(points), views), points, atol=1e-5)

    def test_pose_as_opencv(self, exact):
        rng = np.random.default_rng(5)
        pixels = image(TARGET, POSES[1]) + rng.normal(0, 0.3, (len(TARGET), 2))
        view = view_of_target(TARGET, pixels, exact[0])
        _, turn, t = cv2.solvePnP(TARGET, pixels, exact[0].K, exact[0].coefficients)
        np.testing.assert_allclose(view.R, cv2.Rodrigues(turn)[0], atol=2e-5)
        np.testing.assert_allclose(view.t, t[:, 0], atol=5e-3)

    def test_rays_miss_as_far_as_they_are_pointed(self, exact):
        points = RAISED[0] + np.random.default_rng(1).uniform(-30, 30, (400, 3))
        pixels = np.stack([image(points, pose) for pose in POSES])
        assert rays_miss(pixels, exact[1]) < 1e-6
        noise = np.random.default_rng(2).normal(0, 0.7, pixels.shape)
        assert rays_miss(pixels + noise, exact[1]) == pytest.approx(0.7, rel=0.08)

    def test_offsets_of_the_target(self):
        """Points that are off by known amounts are found from the pictures alone."""
        offsets = np.random.default_rng(3).normal(0, 0.2, TARGET.shape)
        camera = calibrated(noise=0)
        turns = (rotation_x(0.4), rotation_x(-0.4), rotation_y(0.4), rotation_y(-0.4), np.eye(3))
        poses = [(turn, np.array([-40.0, -50, 420])) for turn in turns]
        found = target_offsets(camera, TARGET, [image(TARGET + offsets, pose) for pose in poses])
        fit = similarity_transform(TARGET + offsets, TARGET)
        np.testing.assert_allclose(found, fit.apply(TARGET + offsets) - TARGET, atol=2e-3)

    def test_many_pictures_are_better_than_two(self, exact):
        poses = [*POSES, (rotation_x(-0.5), np.array([-90.0, -40, 460]))]
        views = targeted(exact[0], poses=poses)
        pixels = np.stack([image(RAISED, pose) for pose in poses])
        two = distance_in_space(pixels[:2, 0], pixels[:2, 1], views[:2])
        three = distance_in_space(pixels[:, 0], pixels[:, 1], views)
        assert three.sigma < two.sigma


class TestErrors:
    def test_same_point(self, exact):
        with pytest.raises(ValueError, match="both points are the same"):
            distance_on_plane([300, 200], [300, 200], exact[1][0])

    def test_above_the_horizon(self):
        calibration = calibrated(noise=0)
        low = (rotation_x(1.4), np.array([-40.0, 0, 500]))  # looks along the table
        (view,) = targeted(calibration, noise=0, poses=[low])
        with pytest.raises(DegenerateConfigurationError, match="horizon"):
            distance_on_plane([300, 460], [300, 200], view)

    @pytest.mark.parametrize(
        ("options", "said"),
        [
            ({"pointing": 0}, "pointing .px. must be positive"),
            ({"scale": -0.1}, "scale must not be negative"),
            ({"height_sigma": -1}, "height_sigma must not be negative"),
        ],
    )
    def test_impossible_sigmas(self, exact, options, said):
        with pytest.raises(ValueError, match=said):
            distance_on_plane([300, 200], [320, 200], exact[1][0], **options)

    def test_one_picture_is_not_enough_in_space(self, exact):
        with pytest.raises(ValueError, match="two or more"):
            point_in_space([[300, 200]], exact[1][:1])

    def test_pixels_of_another_picture_too_many(self, exact):
        with pytest.raises(ValueError, match="for V = 2 views"):
            point_in_space([[300, 200]], exact[1])

    def test_same_place(self, exact):
        with pytest.raises(DegenerateConfigurationError, match="same place"):
            point_in_space([[300, 200], [300, 200]], [exact[1][0]] * 2)

    def test_target_on_a_line(self, exact):
        with pytest.raises(DegenerateConfigurationError, match="one line"):
            view_of_target(TARGET[:5], image(TARGET[:5], POSES[0]), exact[0])

    def test_outside_the_lens_model(self, exact):
        with pytest.raises(ValueError, match="lens model"):
            point_on_plane([600, 20], replace(exact[1][0], coefficients=np.array([-4.0])))


def test_a_camera_that_is_known_exactly(exact):
    nothing = CameraModel(focal=False, principal_point=False, coefficients=())
    known = type(exact[0])(
        K, COEFFICIENTS, (), (), 0.0, {}, np.zeros((0, 0)), np.zeros((0, 6)), SIZE, nothing
    )
    view = view_of_target(TARGET, image(TARGET, POSES[0]), known)
    length = distance_on_plane(*image(FLAT, POSES[0]), view)
    assert length.parts["camera"] == 0
    assert length.value == pytest.approx(np.hypot(5, 85), abs=1e-6)
