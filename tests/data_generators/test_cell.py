"""The robot's table: what is painted is where the numbers say."""

import numpy as np
import pytest
from scipy.ndimage import center_of_mass

from course_lib.homogeneous import apply_homography
from data_generators import cell

CAMERAS = {"above": cell.camera_above, "beside": cell.camera_beside}


def dark_centre(picture, at, reach):
    """Return where the dark spot around a pixel has its centre, px."""
    u, v = np.rint(at).astype(int)
    part = picture[v - reach : v + reach + 1, u - reach : u + reach + 1].astype(float).sum(axis=2)
    row, column = center_of_mass(np.clip(0.5 * part.max() - part, 0, None))
    return np.array([u - reach + column, v - reach + row])


@pytest.mark.parametrize("camera", CAMERAS)
def test_markers_are_seen_where_the_camera_projects_them(camera):
    view = CAMERAS[camera]()
    picture = cell.photograph(view, "nothing")
    for place in view.project(cell.on_table(cell.MARKERS)):
        assert np.linalg.norm(dark_centre(picture, place, 6) - place) < 0.5


@pytest.mark.parametrize(
    ("points", "standing"), [(cell.BLOCK, "block"), (cell.object_points(), "object")]
)
def test_what_stands_on_the_table_carries_its_dots(points, standing):
    view = cell.camera_beside()
    picture = cell.photograph(view, standing)
    for place in view.project(points):
        assert np.linalg.norm(dark_centre(picture, place, 5) - place) < 0.6


def test_targets_are_visible_to_both_cameras():
    for make in CAMERAS.values():
        view = make()
        picture = cell.photograph(view, "block")
        for place in view.project(np.vstack([cell.on_table(cell.TARGETS), cell.BLOCK])):
            u, v = np.rint(place).astype(int)
            red, green, _ = picture[v - 5 : v + 6, u - 6 : u + 7].reshape(-1, 3).max(axis=0)
            assert red > green + 20  # the pad around the target


def test_the_dots_of_the_object_lie_in_three_planes_and_not_in_one():
    points = cell.object_points() - cell.CORNER
    assert points.shape == (48, 3)
    assert ((points == 0).sum(axis=1) == 1).all()
    assert np.linalg.svd(points - points.mean(axis=0), compute_uv=False)[2] > 100


def test_noise_is_as_large_as_asked_for_and_repeats():
    pixels = np.zeros((4000, 2))
    found = cell.observed(pixels, 0.3, np.random.default_rng(1))
    assert found.std() == pytest.approx(0.3, rel=0.03)
    np.testing.assert_array_equal(found, cell.observed(pixels, 0.3, np.random.default_rng(1)))
    assert cell.observed(pixels, 0, np.random.default_rng(1)).tolist() == pixels.tolist()


def test_the_cover_bends_by_pixels_smoothly_and_is_no_homography():
    grid = np.stack(np.meshgrid(np.linspace(0, 639, 30), np.linspace(0, 479, 20)), -1)
    shift = cell.cover_shift(grid.reshape(-1, 2)).reshape(grid.shape)
    assert 1.0 < np.sqrt((shift**2).sum(-1).mean()) < 3.0
    assert np.abs(np.diff(shift, axis=1)).max() < 1.2
    flat = np.column_stack([grid.reshape(-1, 2), np.ones(600)])
    left = shift.reshape(-1, 2) - flat @ np.linalg.lstsq(flat, shift.reshape(-1, 2))[0]
    assert left.std() > 0.8


def test_errors():
    with pytest.raises(ValueError, match="standing must be block, object or nothing, got 'cat'"):
        cell.photograph(cell.camera_above(), "cat")
    with pytest.raises(ValueError, match="sigma must not be negative"):
        cell.observed([[1, 2]], -1, np.random.default_rng(1))


def test_points_at_a_height_are_mapped_by_a_homography_of_that_height():
    view = cell.camera_beside()
    H = view.P[:, [0, 1, 3]] + 60 * np.outer(view.P[:, 2], [0, 0, 1])
    np.testing.assert_allclose(
        apply_homography(cell.BLOCK[:, :2], H), view.project(cell.BLOCK), atol=1e-9
    )
