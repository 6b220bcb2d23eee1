"""What a flight plan predicts is what its rendered pictures show: to 1 %, and counts."""

import numpy as np
import pytest
from white_light import WHITE, light

from course_lib.camera import Camera
from course_lib.planning import (
    base_for_overlap,
    ground_sample_distance,
    overlap,
    plan_flight,
    read_cameras,
    read_lenses,
    views_of_ground,
)
from data_generators.quick import QuickRenderer
from data_generators.scene import Scene, polygon
from data_generators.scene import box as solid

DRONE = read_cameras()["DJI Phantom 4 RTK"], read_lenses()["Phantom 4 RTK lens"]
AREA = np.array([[0, 0], [160, 0], [160, 90], [0, 90.0]])
HOUSE, TALL = np.array([[60, 40], [95, 75.0]]), 40.0  # corners west-south and east-north, m
AROUND = np.array([(-1, 1), (1, 1), (1, -1), (-1, -1)])


def coarser(camera, times):
    """The same view with pixels so many times as large."""
    size = tuple(n // times for n in camera.image_size)
    K = camera.K / times
    K[:2, 2], K[2, 2] = (np.array(size) - 1) / 2, 1
    return Camera(K, camera.R, camera.t, size)


def flown(heading, **settings):
    """A flight whose strips are as long as the area, whatever their direction."""
    c, s = np.cos(heading), np.sin(heading)
    return plan_flight(AREA @ [[c, -s], [s, c]], *DRONE, 0.02, heading=heading, **settings)


def shared(one, other, height):
    """Which part of one picture shows what another one shows, on level ground.

    Rays through the corners of the other one make a white field.
    """
    width, depth = other.image_size
    corners = np.array([[0, 0], [width, 0], [width, depth], [0, depth]]) - 0.5
    rays = other.pixel_ray(corners)
    field = other.centre + rays * ((height - other.centre[2]) / rays[:, 2])[:, None]
    return light(Scene((polygon(field, WHITE),), (0, 0, 0)), coarser(one, 8)).mean()


def house(x, y):
    """Heights of level ground with a house on it."""
    inside = [(low <= n) & (n <= high) for n, low, high in zip((x, y), *HOUSE, strict=True)]
    return TALL * (inside[0] & inside[1])


def counted(plan, places):
    """In how many pictures marks of different colours are seen whole, and in how many in part."""
    colours = [(60 + 3 * n, 200, 0) for n in range(len(places))]
    marks = [
        polygon(np.column_stack([place + 0.4 * AROUND, np.full(4, 0.01 + house(*place))]), colour)
        for place, colour in zip(places, colours, strict=True)
    ]
    black = np.zeros(3, int)
    walls = solid((*HOUSE[0], 0), (*(HOUSE[1] - HOUSE[0]), TALL), black, black)
    renderer = QuickRenderer(Scene((*walls, *marks), (0, 0, 0)), subpixels=1)
    pixels = np.array(
        [
            [np.count_nonzero(picture == n) for n in 60 + 3 * np.arange(len(places))]
            for picture in (renderer.picture(coarser(c, 8))[..., 0] for c in plan.cameras)
        ]
    )
    whole = pixels >= 0.8 * pixels.max(axis=0)
    return whole.sum(axis=0), (~whole & (pixels > 0)).sum(axis=0)


class TestFlight:
    @pytest.mark.parametrize("height", [0.0, -20.0, 14.0])
    def test_ground_sampling_distance_is_measured_between_marks(self, height):
        plan = plan_flight([[0, 0], [60, 0], [60, 40], [0, 40]], *DRONE, 0.02)
        camera, (x, y) = coarser(plan.cameras[0], 8), plan.centres[0, :2]
        half, apart = 0.5, 20.0
        marks = [
            polygon(
                [
                    (x + east + a * half, y + b * half, height)
                    for a, b in ((-1, 1), (1, 1), (1, -1), (-1, -1))
                ],
                WHITE,
            )
            for east in (-apart / 2, apart / 2)
        ]
        picture = light(Scene(tuple(marks), (0, 0, 0)), camera)
        column = np.arange(picture.shape[1])
        left, right = np.array_split(picture.sum(axis=0), 2)
        halves = np.array_split(column, 2)
        centres = [
            (part * at).sum() / part.sum() for part, at in zip((left, right), halves, strict=True)
        ]
        measured = apart / (centres[1] - centres[0]) / 8
        predicted = ground_sample_distance(plan.H - height, DRONE[1].f_mm, DRONE[0].pitch_um)
        assert measured == pytest.approx(float(predicted), rel=0.01)

    @pytest.mark.parametrize("share", [0.6, 2 / 3, 0.8])
    @pytest.mark.parametrize("height", [0.0, -20.0, 14.0])
    @pytest.mark.parametrize("heading", [0.0, 0.7])
    def test_forward_overlap(self, share, height, heading):
        plan = flown(heading, forward=share)
        depth = plan.image_size[1]
        length = depth * plan.gsd * (plan.H - height) / plan.H
        assert plan.base == pytest.approx(float(base_for_overlap(share, depth * plan.gsd)))
        seen = shared(plan.cameras[1], plan.cameras[0], height)
        assert seen == pytest.approx(float(overlap(plan.base, length)), rel=0.01)

    @pytest.mark.parametrize("share", [0.3, 0.6])
    @pytest.mark.parametrize("height", [0.0, -20.0, 14.0])
    @pytest.mark.parametrize("heading", [0.0, 0.7])
    def test_side_overlap(self, share, height, heading):
        """The last picture of a strip and the first one of the next are beside each other."""
        plan = flown(heading, side=share, forward=0.6)
        last = int(np.flatnonzero(plan.strips == 0)[-1])
        width = plan.image_size[0] * plan.gsd * (plan.H - height) / plan.H
        seen = shared(plan.cameras[last + 1], plan.cameras[last], height)
        assert seen == pytest.approx(float(overlap(plan.distance, width)), rel=0.01)

    @pytest.mark.parametrize("heading", [0.0, 0.7])
    def test_pictures_of_a_place_beside_a_house(self, heading):
        """Marks on the ground and on the roof are counted in all pictures, walls hide some."""
        plan = plan_flight([[0, 0], [150, 0], [150, 110], [0, 110]], *DRONE, 0.02, heading=heading)
        places = np.random.default_rng(5).uniform((0, 0), (150, 110), (60, 2))
        across = np.abs(places[:, None] - HOUSE).min(axis=(1, 2)) < 1
        places = places[~across]  # a mark shall not lie across a wall
        whole, part = counted(plan, places)
        predicted = views_of_ground(plan, places, house)
        wrong = np.maximum(whole - predicted, 0) + np.maximum(predicted - whole - part, 0)
        assert wrong.sum() <= 0.01 * predicted.sum()
        assert part.sum() < 0.06 * predicted.sum()
        assert predicted.sum() < 0.92 * views_of_ground(plan, places).sum()
