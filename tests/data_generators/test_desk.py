"""The desk: what its photographs show is where the truth says."""

import cv2
import numpy as np
import pytest

from course_lib.detection import detect_board
from data_generators import desk

SIZE = (1200, 900)
CORNERS = (0, 1, 4, 5)  # of the box: its front edge below, and above


@pytest.fixture(scope="module")
def view():
    R, t = desk.pose_towards((180, 50), 24, -8, 500, 0)
    return desk.photograph_desk(R, t, SIZE, np.random.default_rng(1), noise=1.0)


def test_corners_are_found_where_the_camera_sees_them(view):
    assert view.picture.shape == (900, 1200, 3)
    found = detect_board(cv2.cvtColor(view.picture, cv2.COLOR_RGB2GRAY), desk.TARGET)
    assert found.good
    truth = view.project(desk.TARGET.points()[found.ids])
    assert np.abs(found.points - truth).max() < 0.1
    assert np.abs((found.points - truth).mean(axis=0)).max() < 0.01


def test_sizes_are_those_that_are_said():
    card, box = desk.card_corners(), desk.box_corners()
    sides = np.linalg.norm(np.roll(card, -1, axis=0) - card, axis=1)
    np.testing.assert_allclose(sides, [85.6, 53.98, 85.6, 53.98])
    np.testing.assert_allclose(card[:, 2], -0.76)
    np.testing.assert_allclose(np.linalg.norm(box[1] - box[0]), 120)
    np.testing.assert_allclose(np.linalg.norm(box[3] - box[0]), 80)
    np.testing.assert_allclose(box[4:] - box[:4], np.tile([0, 0, -60.0], (4, 1)))
    np.testing.assert_allclose((box[1] - box[0]) @ (box[3] - box[0]), 0, atol=1e-9)


def colours(view, points):
    u, v = np.rint(view.project(points)).astype(int).T
    return view.picture[v, u].astype(int)


def test_card_and_box_are_drawn_at_their_corners(view):
    card = desk.card_corners()
    inwards = card + 0.06 * (card.mean(axis=0) - card)
    outwards = card - 0.06 * (card.mean(axis=0) - card)
    blue = colours(view, inwards)
    assert (blue[:, 2] - blue[:, 0] > 60).all()
    wood = colours(view, outwards)
    assert (wood[:, 0] - wood[:, 2] > 20).all()
    lid = desk.box_corners()[4:]
    light = colours(view, lid + 0.1 * (lid.mean(axis=0) - lid))
    assert (light.min(axis=1) > 150).all()


def test_an_edge_of_the_box_ends_where_its_corner_is(view):
    """Around each corner, cards of the picture have different colours on different sides."""
    for corner in desk.box_corners()[list(CORNERS)]:
        u, v = view.project(corner[None])[0]
        patch = view.picture[round(v) - 6 : round(v) + 7, round(u) - 6 : round(u) + 7]
        assert patch.astype(float).std(axis=(0, 1)).max() > 12


def test_the_same_seed_gives_the_same_photograph():
    R, t = desk.pose_towards((100, 62), 30, 120, 330, 10)
    one, again, other = (
        desk.photograph_desk(R, t, (400, 300), np.random.default_rng(seed)).picture
        for seed in (5, 5, 6)
    )
    np.testing.assert_array_equal(one, again)
    assert (one != other).mean() > 0.3


def test_the_camera_stands_where_it_is_told():
    R, t = desk.pose_towards((180, 50), 40, 90, 520, 12)
    centre = -R.T @ t
    np.testing.assert_allclose(np.linalg.norm(centre - (180, 50, 0)), 520)
    assert centre[0] > 180 + 300  # on the right
    np.testing.assert_allclose(centre[1], 50, atol=1e-9)
    np.testing.assert_allclose(R @ (180, 50, 0) + t, [0, 0, 520], atol=1e-9)
