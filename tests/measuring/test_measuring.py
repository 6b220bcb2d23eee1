from dataclasses import replace

import cv2
import numpy as np
import pytest
from measuring_scene import (
    BOARD,
    COEFFICIENTS,
    FLAT,
    POSES,
    RAISED,
    SIZE,
    TARGET,
    K,
    calibrated,
    image,
    targeted,
)

from course_lib.calibration import CameraModel, calibrate_stereo
from course_lib.checks import DegenerateConfigurationError
from course_lib.measuring import (
    Measured,
    distance_in_space,
    distance_on_plane,
    point_in_space,
    point_on_plane,
    pointing_sigma,
    rays_miss,
    target_offsets,
    view_of_target,
    views_of_pair,
)
from course_lib.orientation import similarity_transform
from course_lib.transforms import compose, rotation_from_vector, rotation_x, rotation_y
from data_generators.board_observations import observe_board

TURNED = rotation_y(-0.15) @ rotation_x(0.02)
SHIFT = np.array([-100.0, 2, 5])


@pytest.fixture(scope="module")
def exact():
    """A camera and pictures without any error."""
    calibration = calibrated(noise=0)
    return calibration, targeted(calibration, noise=0)


def stereo(noise, rng, pairs=10):
    """Return a pair of equal cameras, calibrated from the same pairs of pictures with new noise."""
    seen = observe_board(np.random.default_rng(4), BOARD, K, COEFFICIENTS, SIZE, pairs)
    right = [image(BOARD, compose(TURNED, SHIFT, R, t)) for R, t in seen.poses]
    noisy = [[p + rng.normal(0, noise, p.shape) for p in side] for side in (seen.pixels, right)]
    return calibrate_stereo(BOARD, *noisy, SIZE)


def changed(pair, number, step):
    """Return a pair of which one number is larger by a step; the numbers are those of its sigma."""
    side, name = list(pair.sigma)[number].split(" ")
    if side == "turn":
        return replace(pair, R=rotation_from_vector(step * np.eye(3)["xyz".index(name)]) @ pair.R)
    if side == "shift":
        return replace(pair, t=pair.t + step * np.eye(3)["xyz".index(name)])
    K, k = (getattr(pair, f"{what}_{side}").copy() for what in ("K", "coefficients"))
    if name in ("fx", "fy", "cx", "cy"):
        K["xy".index(name[1]), "xy".index(name[1]) if name[0] == "f" else 2] += step
    else:
        k[("k1", "k2", "p1", "p2", "k3").index(name)] += step
    return replace(pair, **{f"K_{side}": K, f"coefficients_{side}": k})


def in_pair(points):
    """Return the exact pixels of points of the left camera's frame in both pictures."""
    return np.stack([image(points, (np.eye(3), np.zeros(3))), image(points, (TURNED, SHIFT))])


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


def spread(count, shape, sigma, rng):
    """Return noise whose covariance is exact in this sample, not only on average."""
    white = np.linalg.qr(rng.normal(size=(count, int(np.prod(shape)))))[0] * np.sqrt(count)
    return sigma * white.reshape(count, *shape)


def agrees(found, source, tolerance):
    """Assert that lengths scatter as the propagation told."""
    told = np.sqrt(np.mean([length.parts[source] ** 2 for length in found]))
    assert np.std([length.value for length in found]) == pytest.approx(told, rel=tolerance)


def both(views, flat, raised):
    """Return a length on the plane and one in space."""
    return (
        distance_on_plane(*flat, views[0], 0.3),
        distance_in_space(raised[:, 0], raised[:, 1], views, 0.3),
    )


PIXELS = image(FLAT, POSES[0]), np.stack([image(RAISED, pose) for pose in POSES])


class TestScatter:
    """Two hundred simulations scatter as the propagation says, each source by itself."""

    def test_pointing(self, exact):
        noise = spread(200, (3, 2, 2), 0.3, np.random.default_rng(7))
        found = [both(exact[1], PIXELS[0] + n[0], PIXELS[1] + n[1:]) for n in noise]
        for lengths in zip(*found, strict=True):
            agrees(lengths, "pointing", 0.02)

    def test_pose(self, exact):
        noise = spread(200, (2, len(TARGET), 2), 0.3, np.random.default_rng(7))
        found = []
        for each in noise:
            seen = [image(TARGET, pose) + n for pose, n in zip(POSES, each, strict=True)]
            found.append(both([view_of_target(TARGET, s, exact[0]) for s in seen], *PIXELS))
        for lengths in zip(*found, strict=True):
            agrees(lengths, "pose", 0.03)

    def test_target(self, exact):
        """A target whose points are off, neighbours by nearly the same, in all pictures alike."""
        apart = np.linalg.norm(TARGET[:, None] - TARGET, axis=2)
        reach = 0.25 * np.hypot(80, 100)
        likeness = np.exp(-(apart**2) / (2 * reach**2)) + 1e-9 * np.eye(len(TARGET))
        noise = spread(200, (len(TARGET), 3), 0.1, np.random.default_rng(7))
        found = []
        for each in np.linalg.cholesky(likeness) @ noise:
            seen = [image(TARGET + each, pose) for pose in POSES]
            views = [view_of_target(TARGET, pixels, exact[0], 0.1) for pixels in seen]
            found.append(both(views, *PIXELS))
        for lengths in zip(*found, strict=True):
            agrees(lengths, "target", 0.03)

    def test_camera(self):
        # 200 random draws know a standard deviation to 5 %.
        rng, found = np.random.default_rng(7), []
        for _ in range(200):
            views = targeted(calibrated(0.3, rng, views=6), noise=0)
            found.append(both(views, *PIXELS))
        for lengths in zip(*found, strict=True):
            agrees(lengths, "camera", 0.1)

    def test_pair(self):
        """Each number of the pair is moved and the length measured anew, instead of simulated."""
        pair = stereo(0.3, np.random.default_rng(9), pairs=6)
        pixels = in_pair(np.array([[-140.0, 10, 620], [160, -30, 800]])).swapaxes(0, 1)
        length = distance_in_space(*pixels, views_of_pair(pair))
        steps = 1e-4 * np.array(list(pair.sigma.values()))
        moved = [
            distance_in_space(*pixels, views_of_pair(changed(pair, number, step))).value
            for number, step in enumerate(steps)
        ]
        slopes = (np.array(moved) - length.value) / steps
        told = np.sqrt(slopes @ pair.covariance @ slopes)
        assert length.parts["camera"] == pytest.approx(told, rel=1e-3)

    def test_errors_of_the_camera_nearly_cancel_beside_the_target(self, exact):
        view = targeted(calibrated())[0]
        pixels = image(FLAT, POSES[0])
        cancelled = distance_on_plane(*pixels, view).parts["camera"]
        view.follows[-6:] = 0  # as if the pose did not follow
        assert cancelled < 0.2 * distance_on_plane(*pixels, view).parts["camera"]

    def test_target_and_height(self, exact):
        view, pixels = exact[1][0], image(FLAT, POSES[0])
        length = distance_on_plane(*pixels, view, scale=0.002, height=5, height_sigma=0.01)
        higher = distance_on_plane(*pixels, view, height=5.01)
        assert length.parts["scale"] == pytest.approx(0.002 * length.value)
        assert length.parts["target"] == 0  # its corners are where they should be
        assert not {"scale", "height"} & set(distance_on_plane(*pixels, view).parts)
        assert length.parts["height"] == pytest.approx(abs(higher.value - length.value), rel=1e-3)
        assert length.sigma == pytest.approx(np.linalg.norm(list(length.parts.values())))


class TestMeasured:
    @pytest.mark.parametrize(
        ("value", "sigma", "text"),
        [
            (82.31, 0.2, "82.3 mm ± 0.4 mm (95 %)"),
            (82.314, 0.07, "82.31 mm ± 0.14 mm (95 %)"),
            (119.34, 1.1, "119.3 mm ± 2.2 mm (95 %)"),
            (1234.0, 25.0, "1230 mm ± 50 mm (95 %)"),
            (5.0, 0.0, "5.000000 mm ± 0.000000 mm (95 %)"),
            (0.5, 0.00499, "0.500 mm ± 0.010 mm (95 %)"),
        ],
    )
    def test_text(self, value, sigma, text):
        assert str(Measured(value, {"pointing": sigma})) == text

    def test_interval(self):
        length = Measured(10.0, {"pointing": 3.0, "pose": 4.0})
        assert length.sigma == 5.0
        assert length.holds(10 + 1.95 * 5)
        assert not length.holds(10 - 1.97 * 5)

    def test_pointing(self):
        clicks = np.random.default_rng(0).normal([300, 200], 0.7, (2000, 2))
        assert pointing_sigma(clicks) == pytest.approx(0.7, rel=0.03)
        with pytest.raises(ValueError, match="two or more pixels"):
            pointing_sigma([[1, 2]])


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
