import numpy as np
import pytest

from course_lib.camera import Camera
from course_lib.transforms import rotation_x
from data_generators import signs
from data_generators.quick import QuickRenderer

NORTH = rotation_x(np.pi / 2)
SIZE, F = (480, 320), 1000.0  # px
CAMERA = Camera(
    np.array([[F, 0, 239.5], [0, F, 159.5], [0, 0, 1]]), NORTH, -NORTH @ signs.VIEWPOINT, SIZE
)


@pytest.fixture(scope="module")
def scene():
    return signs.street_with_signs()


def charts(scene):
    """Return the patches with letters, nearest first."""
    found = [patch for patch in scene.patches if patch.texture.shape[:2] == (320, 320)]
    return sorted(found, key=lambda patch: patch.corners[0, 1])


def test_signs_are_seen_equally_large_from_the_viewpoint(scene):
    seen = [CAMERA.project(patch.corners) for patch in charts(scene)]
    assert len(seen) == len(signs.DISTANCES)
    for pixels, direction in zip(seen, signs.DIRECTIONS, strict=True):
        np.testing.assert_allclose(np.ptp(pixels, axis=0), F * signs.WIDTH)
        np.testing.assert_allclose(pixels.mean(axis=0), [239.5 + F * direction, 159.5])


def test_signs_stand_at_their_distances(scene):
    depths = [patch.corners[0, 1] - signs.VIEWPOINT[1] for patch in charts(scene)]
    np.testing.assert_allclose(depths, signs.DISTANCES)
    np.testing.assert_allclose(signs.sign_feet()[:, 2], 0)


def test_every_sign_is_seen_in_front_of_the_street(scene):
    picture = QuickRenderer(scene).picture(CAMERA).astype(float)
    for direction in signs.DIRECTIONS:
        middle = 239.5 + F * direction
        u = slice(round(middle - 30), round(middle + 30))
        letters = picture[130:190, u].mean(axis=2)
        assert letters.max() > 220  # paper
        assert letters.min() < 40  # ink


def test_the_same_street_every_time_unless_told_otherwise():
    one, same = signs.street_with_signs(), signs.street_with_signs()
    other = signs.street_with_signs(np.random.default_rng(1))
    letters = [charts(scene)[-1].texture for scene in (one, same, other)]
    np.testing.assert_array_equal(letters[0], letters[1])
    assert (letters[0] != letters[2]).any()
