"""The slanted front of a house: windows and corners are where they are said to be."""

import numpy as np
import pytest

from data_generators import facade


def brightness(picture, at):
    u, v = np.rint(at).astype(int)
    return picture[v - 1 : v + 2, u - 1 : u + 2].astype(float).mean()


@pytest.mark.parametrize(("column", "floor"), [(0, 0), (1, 2), (2, 1), (4, 0)])
def test_a_window_begins_where_its_corners_are(column, floor):
    camera = facade.slanted_camera((960, 720))
    picture, corners = facade.photograph(camera), facade.window(column, floor)
    centre = corners.mean(axis=0)
    for corner in corners:
        frame, wall = (
            camera.project(facade.in_space(centre + share * (corner - centre)))
            for share in (0.96, 1.12)
        )
        assert brightness(picture, frame) > brightness(picture, wall) + 15


def test_the_wall_ends_at_its_corners():
    camera = facade.slanted_camera()
    pixels = camera.project(facade.in_space(facade.CORNERS))
    assert ((pixels > 5) & (pixels < np.array(camera.image_size) - 5)).all()
    left_of, inside = camera.project(facade.in_space([[-0.3, 4.0], [0.3, 4.0]]))
    picture = facade.photograph(camera)
    assert brightness(picture, inside) > brightness(picture, left_of) + 15  # the side is in shade


def test_a_window_has_its_size():
    corners = facade.window(3, 1)
    np.testing.assert_allclose(corners[2] - corners[0], facade.WINDOW)
    assert (facade.window(5, 2)[2] < facade.WALL).all()
