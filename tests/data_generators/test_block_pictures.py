"""Pictures of blocks: the truth about them is what they show."""

import cv2
import numpy as np
import pytest

from course_lib.tie_points import find_features, match_features
from data_generators.block_pictures import flight_pictures, turntable_pictures


@pytest.fixture(scope="module")
def vase():
    """Return a quarter of the circle, 15 degrees apart."""
    return turntable_pictures(np.random.default_rng(0), 6, arc=np.pi / 2)


@pytest.fixture(scope="module")
def ground():
    """Return two short strips."""
    return flight_pictures(np.random.default_rng(0), 2, 3)


@pytest.fixture(params=["vase", "ground"])
def block(request):
    return request.getfixturevalue(request.param)


def test_shapes(block):
    assert len(block.pictures) == len(block.cameras) == 6
    assert all(picture.shape == (480, 640, 3) for picture in block.pictures)
    assert all(picture.dtype == np.uint8 for picture in block.pictures)
    assert block.centres.shape == (6, 3)
    assert sorted([*block.control, *block.check]) == list(range(12))


def test_the_same_seed_gives_the_same_pictures():
    one, other, third = (turntable_pictures(np.random.default_rng(s), 2) for s in (1, 1, 2))
    np.testing.assert_array_equal(one.pictures[1], other.pictures[1])
    assert (one.pictures[1] != third.pictures[1]).mean() > 0.5


def middle(grey, start):
    """Return the place near another about which a picture is the same after half a turn."""
    shifts = np.stack(np.meshgrid(*2 * [np.arange(-1.2, 1.25, 0.1)]), axis=-1).reshape(-1, 2)
    windows = [cv2.getRectSubPix(grey, (11, 11), (start + s).tolist()) for s in shifts]
    away = [np.abs(w - w[::-1, ::-1]).sum() for w in np.array(windows, float)]
    return start + shifts[int(np.argmin(away))]


def test_marks_are_painted_where_they_are(block):
    """A mark looks the same after half a turn about the corner where its black quarters meet."""
    seen = block.observed_marks(np.random.default_rng(0), 0)
    greys = [cv2.cvtColor(picture, cv2.COLOR_RGB2GRAY) for picture in block.pictures]
    where = zip(seen.cameras, seen.pixels, strict=True)
    away = np.array([middle(greys[camera], pixel) - pixel for camera, pixel in where])
    assert len(away) > 15
    assert np.median(np.linalg.norm(away, axis=1)) < 0.15
    assert np.abs(np.median(away, axis=0)).max() < 0.11


def test_marks_behind_the_vase_are_not_seen(vase):
    seen = vase.observed_marks(np.random.default_rng(0), 0)
    for camera in range(6):
        towards = vase.marks[:8, :2] @ vase.centres[camera, :2]
        mine = seen.points[(seen.cameras == camera) & (seen.points < 8)]
        assert (towards[mine] > 0).all()
        assert (towards < 0).any()


def test_errors_of_marks_are_what_was_asked_for(ground):
    exact, noisy = (ground.observed_marks(np.random.default_rng(1), s) for s in (0, 0.5))
    assert (noisy.pixels - exact.pixels).std() == pytest.approx(0.5, rel=0.3)
    assert noisy.sigma[0] == 0.5


def test_the_surface_projects_to_its_pixels(block):
    pixels = np.random.default_rng(2).uniform((0, 0), (639, 479), (300, 2))
    points = block.surface(3, pixels)
    there = np.isfinite(points[:, 0])
    assert there.sum() > 80
    np.testing.assert_allclose(block.cameras[3].project(points[there]), pixels[there], atol=1e-6)
    one = block.surface(3, pixels[there][0])
    np.testing.assert_allclose(one, points[there][0], rtol=1e-9)
    if block.marks[0, 2] > 10:
        return
    background = block.surface(3, [[2, 2]])
    assert np.isnan(background).all() == (block.pictures[3][2, 2].min() > 200)


def test_the_net_of_the_ground_has_the_height_of_its_marks(ground):
    camera = ground.cameras[1]
    pixel = camera.project(ground.marks[5])
    np.testing.assert_allclose(ground.surface(1, pixel), ground.marks[5], atol=1e-6)


def test_another_picture_shows_the_same_colours(block):
    """What is seen at a place of one picture is seen where the truth says in the other."""
    rng = np.random.default_rng(3)
    pixels = rng.integers((20, 20), (620, 460), (400, 2))
    there = block.transferred(0, pixels, 1)
    inside = ((there > 2) & (there < [637, 477])).all(axis=1)
    smooth = [cv2.GaussianBlur(p, (0, 0), 1).astype(float) for p in block.pictures[:2]]
    column, row = pixels[inside].T
    left = smooth[0][row, column]
    maps = [there[inside, k].astype(np.float32)[None] for k in (0, 1)]
    right = cv2.remap(smooth[1], *maps, cv2.INTER_LINEAR)[0]
    assert np.median(np.abs(left - right)) < 4  # of 255
    shuffled = np.median(np.abs(left - right[rng.permutation(len(right))]))
    assert shuffled > 10


@pytest.mark.parametrize(("name", "least"), [("vase", 400), ("ground", 200)])
def test_tie_points_are_right(name, least, request):
    """How many pairs are within 2 px of the truth, before the ratio test and after."""
    block = request.getfixturevalue(name)
    one, other = (find_features(picture) for picture in block.pictures[:2])
    shares = {}
    for ratio in (1.0, 0.8):
        pairs = match_features(one, other, ratio)
        points, partners = one.points[pairs[:, 0]], other.points[pairs[:, 1]]
        away = np.linalg.norm(block.transferred(0, points, 1) - partners, axis=1)
        shares[ratio] = (away < 2).mean()
    assert 0.6 < shares[1.0] < 0.9
    assert shares[0.8] > 0.95
    assert (away < 2).sum() > least
    assert np.median(away[away < 2]) < 0.25


def test_oblique_pictures_look_at_the_middle():
    flown = flight_pictures(np.random.default_rng(4), 1, 2, oblique=2)
    tilts = [np.degrees(np.arccos(-camera.R[2, 2])) for camera in flown.cameras]
    assert max(tilts[:2]) < 5
    assert min(tilts[2:]) > 30


def test_errors_say_what_to_do():
    rng = np.random.default_rng(0)
    with pytest.raises(ValueError, match="pictures must be a whole number, 2 or more"):
        turntable_pictures(rng, 1)
    with pytest.raises(TypeError, match="default_rng"):
        turntable_pictures(0)
    with pytest.raises(ValueError, match="overlap"):
        flight_pictures(rng, overlap=(80, 60))
    with pytest.raises(ValueError, match="noise"):
        flight_pictures(rng, noise=-1)
