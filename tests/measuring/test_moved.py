"""How far a target moved before a camera, and how far apart two cameras stood."""

from dataclasses import replace

import numpy as np
import pytest
from measuring_scene import POSES, TARGET, calibrated, image, larger, spread, stereo

from course_lib.measuring import cameras_apart, target_shift, view_of_target, views_of_pair

MIDDLE, CORNER = TARGET.mean(axis=0), np.array([100.0, -20, 5])
#: Truth: of the middle, of another point, and of the camera before a target at rest.
SHIFT, OTHER_SHIFT = (
    np.linalg.norm(np.diff([R @ X + t for R, t in POSES], axis=0)) for X in (MIDDLE, CORNER)
)
APART = np.linalg.norm(np.diff([-R.T @ t for R, t in POSES], axis=0))


def lengths(views):
    return target_shift(*views), target_shift(*views, CORNER), cameras_apart(*views)


def scatter_as_told(found, source, tolerance):
    """Assert that each of the lengths scatters as its part says."""
    for several in zip(*found, strict=True):
        told = np.sqrt(np.mean([length.parts[source] ** 2 for length in several]))
        assert np.std([length.value for length in several]) == pytest.approx(told, rel=tolerance)


class TestValue:
    def test_truth(self, exact):
        for length, truth in zip(lengths(exact[1]), (SHIFT, OTHER_SHIFT, APART), strict=True):
            assert length.value == pytest.approx(truth, abs=1e-6)

    def test_parts(self, exact):
        for length in lengths(exact[1]):
            assert list(length.parts) == ["pose", "camera", "target"]
        for length in (target_shift(*exact[1], scale=0.01), cameras_apart(*exact[1], scale=0.01)):
            assert length.parts["scale"] == pytest.approx(0.01 * length.value)


class TestScatter:
    """Two hundred simulations scatter as the propagation says, each source by itself."""

    def test_pose(self, exact):
        noise = spread(200, (2, len(TARGET), 2), 0.2, np.random.default_rng(7))
        found = []
        for each in noise:
            seen = [image(TARGET, pose) + n for pose, n in zip(POSES, each, strict=True)]
            found.append(lengths([view_of_target(TARGET, s, exact[0]) for s in seen]))
        scatter_as_told(found, "pose", 0.03)

    def test_target(self, exact):
        """Of a target whose points are off, neighbours by nearly the same, in both pictures."""
        apart = np.linalg.norm(TARGET[:, None] - TARGET, axis=2)
        likeness = np.exp(-(apart**2) / (2 * (0.25 * np.hypot(80, 100)) ** 2))
        root = np.linalg.cholesky(likeness + 1e-9 * np.eye(len(TARGET)))
        found = []
        for each in root @ spread(200, (len(TARGET), 3), 0.1, np.random.default_rng(7)):
            seen = [image(TARGET + each, pose) for pose in POSES]
            found.append(lengths([view_of_target(TARGET, s, exact[0], 0.1) for s in seen]))
        scatter_as_told(found, "target", 0.05)

    def test_camera(self):
        """Each number of the camera is moved, and the lengths measured anew."""
        camera = calibrated(0.3, views=6)
        seen = [image(TARGET, pose) for pose in POSES]
        before = lengths([view_of_target(TARGET, s, camera) for s in seen])
        slopes = []
        for name, sigma in camera.sigma.items():
            K, coefficients = larger(camera.K, camera.coefficients, name, 1e-3 * sigma)
            other = replace(camera, K=K, coefficients=coefficients)
            after = lengths([view_of_target(TARGET, s, other) for s in seen])
            moves = [b.value - a.value for a, b in zip(before, after, strict=True)]
            slopes.append(np.array(moves) / (1e-3 * sigma))
        for length, slope in zip(before, np.transpose(slopes), strict=True):
            told = np.sqrt(slope @ camera.covariance @ slope)
            assert length.parts["camera"] == pytest.approx(told, rel=0.05)

    def test_two_cameras_have_errors_of_their_own(self, exact):
        covariance = 1e-6 * np.eye(len(exact[0].covariance))
        own = [replace(view, covariance=covariance) for view in exact[1]]
        apart = [replace(view, covariance=view.covariance.copy()) for view in own]
        common, separate = (cameras_apart(*views).parts["camera"] for views in (own, apart))
        assert separate == pytest.approx(
            np.hypot(*(cameras_apart(*pair).parts["camera"] for pair in _one_sided(apart)))
        )
        assert common != pytest.approx(separate, rel=1e-3)


def _one_sided(views):
    """The same two views, with an error in the first or in the second only."""
    for number in (0, 1):
        some = list(views)
        some[number] = replace(some[number], covariance=0 * some[number].covariance)
        yield some


class TestErrors:
    def test_views_without_a_target(self):
        views = views_of_pair(stereo(0.1, np.random.default_rng(1), pairs=4))
        for measure in (target_shift, cameras_apart):
            with pytest.raises(ValueError, match="both views must show a target"):
                measure(*views)

    def test_nothing_moved(self, exact):
        view = exact[1][0]
        with pytest.raises(ValueError, match="both points are the same"):
            target_shift(view, view)

    def test_bad_numbers(self, exact):
        with pytest.raises(ValueError, match="scale"):
            target_shift(*exact[1], scale=-1)
        with pytest.raises(ValueError, match="point"):
            target_shift(*exact[1], [1, 2])
