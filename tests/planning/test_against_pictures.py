"""What a plan predicts is what rendered pictures show: within 1 %, or half a pixel."""

from dataclasses import replace
from itertools import product

import numpy as np
import pytest

from course_lib.camera import Camera
from course_lib.drawing.planning.panel import _exposed
from course_lib.planning import (
    Box,
    Setup,
    Task,
    base_for_overlap,
    box_in_view,
    ground_sample_distance,
    judge_setup,
    overlap,
    plan_flight,
    read_cameras,
    read_lenses,
)
from course_lib.planning.setup import blur_of
from data_generators.lens import Lens
from data_generators.quick import QuickRenderer
from data_generators.render import radiance
from data_generators.scene import Patch, Scene, polygon
from data_generators.scene import box as solid
from data_generators.shot import Shot

CAMERA, LENS = read_cameras()["mvBlueFOX3-2024a"], read_lenses()["Computar M2514-MP2"]
TURN = np.radians(20)
EYE = 1.1 * np.array([np.sin(TURN), -np.cos(TURN), 0])
SETUP = Setup(CAMERA, LENS, EYE, np.zeros(3), N=4, exposure_time=1 / 500, focus_distance=1.05)
BOX = Box([0.3, 0.1, 0.2])
WHITE = np.array((255, 255, 255))
DRONE = read_cameras()["DJI Phantom 4 RTK"], read_lenses()["Phantom 4 RTK lens"]


def light(scene, camera):
    """A picture of white things on black, 0 to 1."""
    return QuickRenderer(scene, subpixels=8).picture(camera)[..., 1] / 255


def coarser(camera, times):
    """The same view with pixels so many times as large."""
    size = tuple(n // times for n in camera.image_size)
    K = camera.K / times
    K[:2, 2], K[2, 2] = (np.array(size) - 1) / 2, 1
    return Camera(K, camera.R, camera.t, size)


def rooms(picture):
    """Darkness before the light begins, from the left, right, top and bottom, px."""
    seen = picture > 0
    full = np.minimum(picture / np.median(picture[seen]), 1)
    across, upright = full.sum(axis=1), full.sum(axis=0)
    row, column = full[across.argmax()], full[:, upright.argmax()]
    found = []
    for line in (row, row[::-1], column, column[::-1]):
        start = int(np.argmax(line > 0.99))
        found.append(start - line[:start].sum())
    return np.array(found)


class TestInView:
    @pytest.mark.parametrize("distance", [0.85, 1.1, 2.0])
    def test_room_is_what_the_picture_leaves(self, distance):
        """From straight ahead, all edges of the front are parallel to those of the picture."""
        camera = replace(SETUP, eye=distance * np.array([0, -1.0, 0])).view
        corner, size = -BOX.size / 2, BOX.size
        scene = Scene(tuple(solid(corner, size, WHITE, WHITE)), (0, 0, 0))
        predicted = box_in_view(BOX, camera)
        assert predicted.inside
        np.testing.assert_allclose(rooms(light(scene, camera)), predicted.margins, atol=0.5)

    def test_from_the_side(self):
        camera = SETUP.view
        scene = Scene(tuple(solid(-BOX.size / 2, BOX.size, WHITE, WHITE)), (0, 0, 0))
        seen = light(scene, camera) > 0
        columns, lines = np.flatnonzero(seen.any(axis=0)), np.flatnonzero(seen.any(axis=1))
        width, height = camera.image_size
        found = [columns[0], width - 1 - columns[-1], lines[0], height - 1 - lines[-1]]
        # The outermost pixel that has any light begins at most one pixel before the box.
        np.testing.assert_allclose(box_in_view(BOX, camera).margins - 0.5, found, atol=0.5 + 1 / 8)

    def test_with_motion_it_is_the_least_room_over_all_places(self):
        camera, motion = SETUP.view, np.array([0.02, 0.01, 0.015])
        least = np.full(4, np.inf)
        for signs in product((-1, 1), repeat=3):
            moved = Box(BOX.size, motion * signs)
            least = np.minimum(least, box_in_view(moved, camera).margins)
        np.testing.assert_allclose(box_in_view(BOX.with_motion(motion), camera).margins, least)


class TestBlur:
    @pytest.mark.parametrize(("Z", "N"), [(0.85, 1.4), (1.3, 1.4), (0.8, 2.8), (2.0, 4)])
    def test_defocus_is_that_of_rays_through_the_lens(self, Z, N):
        """A small lamp becomes a disk; a uniform disk's diameter is 4 sigma."""
        setup = replace(SETUP, eye=np.zeros(3), target=np.array([0, 1.0, 0]), N=N)
        view, size = setup.view, (81, 81)
        K = view.K.copy()
        K[:2, 2] = 40
        camera = Camera(K, view.R, view.t, size)
        side = 3 * Z / K[0, 0]
        corner = np.array([-side / 2, Z, side / 2])
        lamp = Patch(corner, np.array([side, 0, 0]), np.array([0, 0, -side]), WHITE)
        lens = Lens(setup.lens.f_mm, N, 1000 * setup.focus_distance)
        picture = radiance(Scene((lamp,), (0, 0, 0)), camera, 8, Shot(lens=lens)).sum(axis=2)
        places = np.indices(picture.shape)
        variances = [
            (picture * (axis - (picture * axis).sum() / picture.sum()) ** 2).sum() / picture.sum()
            for axis in places
        ]
        found = 4 * np.sqrt(np.mean(variances) - 9 / 12 - 1 / 12)
        predicted = float(blur_of(setup, Z))
        assert predicted > 3
        assert found == pytest.approx(predicted, rel=0.01, abs=0.5)

    @pytest.mark.parametrize("speed", [0.5, 2.0, 3.7])
    def test_a_smear_is_the_way_between_two_pictures(self, speed):
        task = Task(Box([0.01, 0.002, 0.01]), np.array([0, -1.0, 0]), 1e-3, speed=speed)
        setup = replace(SETUP, eye=np.array([0, -1.0, 0]))
        (verdict,) = (v for v in judge_setup(setup, task) if v.name == "motion blur")
        near = np.array([0, -0.001, 0])
        way = np.array([0, 0, speed * setup.exposure_time])
        pixels = setup.view.project([near - way / 2, near + way / 2])
        assert verdict.value == pytest.approx(np.linalg.norm(pixels[1] - pixels[0]), rel=1e-9)

    @pytest.mark.parametrize("smear", [0.4, 1.5, 6.2])
    def test_the_shown_smear_is_as_long_as_it_says(self, smear):
        """A line of one pixel, smeared: its light spreads over a box, and each pixel's over 1."""
        picture = np.zeros((41, 9, 3), np.uint8)
        picture[20] = 255
        column = _exposed(picture, smear, 1.0)[:, 4, 0] / 255
        assert column.sum() == pytest.approx(1, abs=0.02)
        assert 1 / column.max() == pytest.approx(max(smear, 1), abs=0.5)
        assert np.count_nonzero(column) == 2 * np.ceil(smear / 2 - 0.5 + 1e-9) + 1


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
    def test_overlap_is_the_part_of_a_picture_that_shows_the_footprint_of_the_last(
        self, share, height
    ):
        """Rays through the corners of one picture make a white field; the next one shows it."""
        plan = plan_flight([[0, 0], [60, 0], [60, 90], [0, 90]], *DRONE, 0.02, forward=share)
        one, other = plan.cameras[:2]
        width, depth = one.image_size
        corners = np.array([[0, 0], [width, 0], [width, depth], [0, depth]]) - 0.5
        rays = one.pixel_ray(corners)
        field = one.centre + rays * ((height - one.centre[2]) / rays[:, 2])[:, None]
        seen = light(Scene((polygon(field, WHITE),), (0, 0, 0)), coarser(other, 8)).mean()
        length = depth * plan.gsd * (plan.H - height) / plan.H
        assert plan.base == pytest.approx(float(base_for_overlap(share, depth * plan.gsd)))
        assert seen == pytest.approx(float(overlap(plan.base, length)), rel=0.01)
