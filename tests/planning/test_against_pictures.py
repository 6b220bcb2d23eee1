"""What a plan predicts is what rendered pictures show: within 1 %, or half a pixel."""

from dataclasses import replace
from itertools import product

import numpy as np
import pytest
from white_light import WHITE, light

from course_lib.camera import Camera
from course_lib.drawing.planning.panel import _exposed
from course_lib.planning import (
    Box,
    Setup,
    Task,
    box_in_view,
    depth_range,
    judge_setup,
    read_cameras,
    read_lenses,
)
from course_lib.planning.setup import blur_of
from course_lib.transforms import rotation_x, rotation_y, rotation_z
from data_generators.lens import Lens
from data_generators.render import radiance
from data_generators.scene import Patch, Scene, polygon
from data_generators.scene import box as solid
from data_generators.shot import Shot

CAMERA, LENS = read_cameras()["mvBlueFOX3-2024a"], read_lenses()["Computar M2514-MP2"]
TURN = np.radians(20)
EYE = 1.1 * np.array([np.sin(TURN), -np.cos(TURN), 0])
SETUP = Setup(CAMERA, LENS, EYE, np.zeros(3), N=4, exposure_time=1 / 500, focus_distance=1.05)
BOX = Box([0.3, 0.1, 0.2])
BARREL, CUSHION = np.array([-0.4, 0.1, 0.002, -0.002, 0]), np.array([0.5, 0, 0, 0.002, 0])
AROUND = ((0, 0), (0, 1), (1, 1), (1, 0))
FINE = 4  # pixels of a cutting in one of the picture


def spot(setup, point, samples=8):
    """Diameter of the picture of a small lamp, px: a uniform disk's is 4 sigma."""
    view, K = setup.view, setup.view.K.copy()
    Z = float((view.R @ point + view.t)[2])
    K[:2, 2] += 40 - np.rint(view.project(point))
    side = 3 * Z / K[0, 0]
    right, down = side * view.R[0], side * view.R[1]
    lamp = Patch(point - (right + down) / 2, right, down, WHITE)
    lens = Lens(setup.lens.f_mm, setup.N, 1000 * setup.focus_distance)
    camera = Camera(K, view.R, view.t, (81, 81))
    picture = radiance(Scene((lamp,), (0, 0, 0)), camera, samples, Shot(lens=lens)).sum(axis=2)
    variances = [
        (picture * (axis - (picture * axis).sum() / picture.sum()) ** 2).sum() / picture.sum()
        for axis in np.indices(picture.shape)
    ]
    return float(4 * np.sqrt(np.mean(variances) - 9 / 12 - 1 / 12))


def white_box(box):
    """A box of white light, its faces as patches."""
    x, y, z = np.array([-1, 1]) * box.size[:, None] / 2
    half = [np.array(ends) for ends in (x, y, z)]
    faces = []
    for axis in range(3):
        others = [n for n in range(3) if n != axis]
        for side in half[axis]:
            corners = np.zeros((4, 3))
            corners[:, axis] = side
            corners[:, others] = [(half[others[0]][a], half[others[1]][b]) for a, b in AROUND]
            faces.append(polygon(box.centre + corners @ box.R.T, WHITE))
    return Scene(tuple(faces), (0, 0, 0))


def cutting(camera, times, low, size):
    """A part of the picture, enlarged in u and v: from the corner `low`, `size` px large there."""
    K, times = camera.K.copy(), np.array(times)
    K[:2] *= times[:, None]
    K[:2, 2] += (times - 1) / 2 - times * (np.array(low) + 0.5)
    return Camera(K, camera.R, camera.t, tuple(np.rint(times * size).astype(int).tolist()))


def outermost(scene, camera, distortion):
    """Room between the light and the picture's left, right, top and bottom, by rays, px."""

    def lit(part):
        return radiance(scene, part, 1, Shot(distortion=distortion)).sum(axis=2) > 0

    width, height = camera.image_size
    coarse = lit(cutting(camera, (1 / 8, 1 / 8), (-0.5, -0.5), camera.image_size))
    found = []
    for axis, length in ((0, width), (1, height)):
        ends = 8 * np.flatnonzero(coarse.any(axis=axis))[[0, -1]] + 4
        for side, end in enumerate(ends):
            # A strip of 24 px around the end that was found, along the whole picture.
            low, size, times = np.full(2, -0.5), np.array(camera.image_size), np.full(2, 2)
            low[axis], size[axis], times[axis] = end - 12.5, 24, FINE
            there = np.flatnonzero(lit(cutting(camera, times, low, size)).any(axis=axis))
            place = low[axis] + (there[-side] + side) / FINE  # where its pixel begins or ends
            found.append(length - 0.5 - place if side else place + 0.5)
    return np.array(found)


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

    @pytest.mark.parametrize(
        ("distortion", "turn"), [(None, 0.3), (BARREL, 0.0), (BARREL, 0.3), (CUSHION, 0.3)]
    )
    def test_from_the_side(self, distortion, turn):
        """Turned box, camera at the side, bent edges: the outermost light on each side."""
        box = Box(BOX.size, BOX.centre, rotation_z(turn) @ rotation_y(turn / 2))
        coefficients = () if distortion is None else distortion
        predicted = box_in_view(box, SETUP.view, coefficients)
        assert predicted.inside
        found = outermost(white_box(box), SETUP.view, distortion)
        np.testing.assert_allclose(predicted.margins, found, atol=0.25)

    def test_distortion_matters_there(self):
        straight = box_in_view(BOX, SETUP.view).margins
        for distortion in (BARREL, CUSHION):
            bent = box_in_view(BOX, SETUP.view, distortion).margins
            assert np.abs(bent - straight).max() > 5

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
        setup = replace(SETUP, eye=np.zeros(3), target=np.array([0, 1.0, 0]), N=N)
        predicted = float(blur_of(setup, Z))
        assert predicted > 3
        assert spot(setup, np.array([0, Z, 0])) == pytest.approx(predicted, rel=0.01, abs=0.5)

    @pytest.mark.parametrize("focus", [0.95, 1.2])
    def test_depth_of_field_is_the_largest_spot_of_a_turned_box(self, focus):
        box = Box([0.3, 0.1, 0.2], [0.02, 0.03, 0], rotation_z(0.6) @ rotation_x(0.4))
        setup = replace(SETUP, N=1.4, focus_distance=focus)
        task = Task(box, np.array([0, -1.0, 0]), 1e-3)
        (verdict,) = (v for v in judge_setup(setup, task) if v.name == "depth of field")
        spots = [spot(setup, corner, 4) for corner in box.corners]
        assert max(spots) == pytest.approx(verdict.value, rel=0.01, abs=0.5)
        near, far = depth_range(box, setup.view)
        assert verdict.value == pytest.approx(blur_of(setup, [near, far]).max())

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
