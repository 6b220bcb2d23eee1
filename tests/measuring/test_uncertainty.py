"""Lengths scatter as the propagation of each source's error says."""

from dataclasses import replace

import numpy as np
import pytest
from measuring_scene import (
    FLAT,
    POSES,
    RAISED,
    TARGET,
    calibrated,
    image,
    in_pair,
    larger,
    spread,
    stereo,
    targeted,
)

from course_lib.measuring import (
    distance_in_space,
    distance_on_plane,
    view_of_target,
    views_of_pair,
)
from course_lib.transforms import rotation_from_vector

PIXELS = image(FLAT, POSES[0]), np.stack([image(RAISED, pose) for pose in POSES])


def changed(pair, number, step):
    """Return a pair of which one number is larger by a step; the numbers are those of its sigma."""
    side, name = list(pair.sigma)[number].split(" ")
    if side == "turn":
        return replace(pair, R=rotation_from_vector(step * np.eye(3)["xyz".index(name)]) @ pair.R)
    if side == "shift":
        return replace(pair, t=pair.t + step * np.eye(3)["xyz".index(name)])
    K, k = (getattr(pair, f"{what}_{side}") for what in ("K", "coefficients"))
    K, k = larger(K, k, name, step)
    return replace(pair, **{f"K_{side}": K, f"coefficients_{side}": k})


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
        steps = 0.01 * np.array(list(pair.sigma.values()))
        ahead, behind = (
            [
                distance_in_space(*pixels, views_of_pair(changed(pair, number, step))).value
                for number, step in enumerate(sign * steps)
            ]
            for sign in (1, -1)
        )
        slopes = (np.array(ahead) - behind) / (2 * steps)
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
