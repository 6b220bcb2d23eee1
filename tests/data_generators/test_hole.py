import numpy as np
import pytest

from course_lib.camera import Camera, camera_at, first_guess_intrinsics
from course_lib.optics import airy_diameter, pinhole_blur_diameter
from data_generators.hole import Hole, Spread, hole_cameras, through_points, transfer, with_margin
from data_generators.places import street, street_camera
from data_generators.quick import QuickRenderer
from data_generators.render import irradiance, photograph
from data_generators.scene import Patch, Scene

PITCH = 0.15  # mm
SERIES = (2, 1, 0.6, 0.35, 0.15, 0.07)


def facing_camera(size=(128, 96), f=100.0):
    K = first_guess_intrinsics(f, (size[0] * PITCH, size[1] * PITCH), size)
    return Camera(K, np.eye(3), np.zeros(3), size)


def lamp_at(Z, side):
    """A square of light on the axis, a black world around it."""
    corner = np.array([-side / 2, -side / 2, Z])
    patch = Patch(corner, (side, 0, 0), (0, side, 0), np.array((255, 255, 255)))
    return Scene((patch,), (0, 0, 0))


def spot_diameter(light, side_px):
    """Diameter of a uniform disk from its second moment, D = 4 sigma; the lamp's taken off."""
    grey = light.sum(axis=2)
    v, u = np.indices(grey.shape)
    variances = []
    for axis in (u, v):
        mean = (grey * axis).sum() / grey.sum()
        variances.append((grey * (axis - mean) ** 2).sum() / grey.sum())
    lamp_and_pixel = side_px**2 / 12 + 1 / 12
    return 4 * np.sqrt(np.mean(variances) - lamp_and_pixel) * PITCH


class TestHole:
    def test_shapes(self):
        hole = Hole(0.4)
        assert hole.pitch(facing_camera()).shape == (2,)
        assert hole.spot([1.0, np.inf]).shape == (2,)
        assert transfer([0, 1, 2], hole).shape == (3,)

    @pytest.mark.parametrize(
        "arguments", [(0,), (-1,), (0.4, 0), (0.4, 100, -5e-4), (np.nan,), ([1, 2],)]
    )
    def test_errors(self, arguments):
        with pytest.raises(ValueError, match=r"positive|finite|one number"):
            Hole(*arguments)

    def test_errors_of_use(self):
        with pytest.raises(ValueError, match="Z must be positive, got -1"):
            transfer(1.0, Hole(0.4), -1)
        with pytest.raises(ValueError, match="count must be at least 1"):
            hole_cameras(facing_camera(), Hole(0.4), 0)

    def test_accuracy(self):
        hole = Hole(0.4, 120)
        np.testing.assert_allclose(hole.spot(0.9), pinhole_blur_diameter(0.4, 120, 900))
        assert hole.spot(np.inf) == 0.4
        assert Hole(0.8, 120).light == pytest.approx(4 * hole.light)
        np.testing.assert_allclose(hole.pitch(facing_camera(f=120)), PITCH)

    def test_transfer_is_the_spectrum_of_a_disk(self):
        hole = Hole(1.0, 100, None)
        # Against a sum over the points of the disk, which is seen edge-on as a chord.
        x = np.linspace(-0.5, 0.5, 20001)
        chord = np.sqrt(np.maximum(0.25 - x**2, 0))
        for frequency in (0.0, 0.3, 1.0, 2.5):
            expected = (chord * np.cos(2 * np.pi * frequency * x)).sum() / chord.sum()
            assert transfer(frequency, hole) == pytest.approx(expected, abs=1e-5)

    def test_degenerate(self):
        # Nothing finer than the cut-off frequency d / (wavelength s) passes.
        hole = Hole(0.35)
        cutoff = 0.35 / (550e-6 * 100)
        assert transfer(cutoff * 1.01, hole) == 0
        assert abs(transfer(cutoff * 0.3, hole, disk=0.0)) > 0.5


class TestSpot:
    @pytest.mark.parametrize(("d", "Z"), [(1.5, 0.4), (1.5, 2.0), (3.0, 1.0)])
    def test_points_of_the_hole(self, d, Z):
        camera, hole, side = facing_camera(), Hole(d, wavelength=None), 0.001 * Z
        quick = QuickRenderer(lamp_at(Z, side), subpixels=8)
        light = through_points(lambda c: quick.picture(c).astype(float), camera, hole, 400)
        measured = spot_diameter(light, side * camera.K[0, 0] / Z)
        expected = pinhole_blur_diameter(d, 100, 1000 * Z)
        assert measured == pytest.approx(expected, rel=0.02)

    @pytest.mark.parametrize(("d", "Z"), [(1.5, 0.4), (1.5, 2.0), (3.0, 1.0)])
    def test_photograph(self, d, Z):
        camera, side = facing_camera(), 0.002 * Z
        light = irradiance(lamp_at(Z, side), camera, Hole(d, wavelength=None))
        measured = spot_diameter(light, side * camera.K[0, 0] / Z)
        assert measured == pytest.approx(pinhole_blur_diameter(d, 100, 1000 * Z), rel=0.03)

    def test_first_dark_ring(self):
        hole, size = Hole(0.07), 256
        point = np.zeros((size, size, 3))
        point[size // 2, size // 2] = 1
        row = Spread(point, (0, 0), (PITCH, PITCH)).through(hole, disk=0.0)[size // 2, :, 0]
        profile = row[size // 2 :]
        dark = int(np.argmax(np.diff(profile) > 0))
        expected = airy_diameter(550e-6, 100 / 0.07) / 2 / PITCH
        assert dark == pytest.approx(expected, abs=0.75)

    def test_cameras_see_the_disk(self):
        # The images of one point through all points of the hole fill its disk.
        camera, hole, Z = facing_camera(), Hole(2.0), 0.5
        seen = np.array([c.project((0.01, 0.02, Z)) for c in hole_cameras(camera, hole, 500)])
        centre = camera.project((0.01, 0.02, Z))
        radius = np.linalg.norm(seen - centre, axis=1).max() * PITCH
        assert 2 * radius == pytest.approx(pinhole_blur_diameter(2.0, 100, 500), rel=2e-3)
        np.testing.assert_allclose(seen.mean(axis=0), centre, atol=0.05)


class TestBrightness:
    def test_is_as_the_area(self):
        camera = facing_camera((64, 48))
        wall = Scene((), (128, 128, 128))
        exposure = 1 / Hole(2.0).light
        big = photograph(wall, camera, hole=Hole(2.0), exposure=exposure, samples=1)
        small = photograph(wall, camera, hole=Hole(1.0), exposure=exposure, samples=1)
        assert set(np.unique(big)) == {128}
        assert set(np.unique(small)) == {32}

    def test_adjusted_exposure(self):
        camera = facing_camera((64, 48))
        wall = Scene((), (128, 100, 60))
        for d in SERIES:
            picture = photograph(wall, camera, hole=Hole(d), samples=1)
            np.testing.assert_array_equal(picture[24, 32], (128, 100, 60))


class TestSeries:
    def test_sharpest_is_the_best_hole(self):
        camera = street_camera((320, 240), f=100, sensor_size=(48, 36))
        wide, margin = with_margin(camera)
        spread = Spread(QuickRenderer(street()).picture(wide), margin, (PITCH, PITCH), 8.5)
        sharpness = []
        for d in SERIES:
            grey = spread.through(Hole(d)).mean(axis=2)
            sharpness.append(np.hypot(*np.gradient(grey)).mean())
        assert SERIES[int(np.argmax(sharpness))] == 0.35
        best = max(sharpness)
        # Visibly: the hole of 2 mm and that of 0.07 mm lose much of the detail.
        assert sharpness[0] < 0.7 * best
        assert sharpness[-1] < 0.7 * best

    def test_spread_agrees_with_points(self):
        camera = street_camera((160, 120), f=100, sensor_size=(24, 18))
        quick, hole = QuickRenderer(street()), Hole(1.0, wavelength=None)
        wide, margin = with_margin(camera)
        disks = Spread(quick.picture(wide), margin, (PITCH, PITCH), 12.0).through(hole)
        points = through_points(lambda c: quick.picture(c).astype(float), camera, hole, 200)
        assert np.sqrt(np.mean((disks - points) ** 2)) < 2.0

    def test_margin(self):
        camera = camera_at((0, -3, 1), (0, 0, 1), facing_camera().K, (128, 96))
        wide, margin = with_margin(camera, 20)
        columns, rows = margin
        assert wide.image_size == (128 + 2 * columns, 96 + 2 * rows)
        assert min(columns, rows) >= 20
        point = (0.3, 1.0, 0.8)
        np.testing.assert_allclose(wide.project(point), np.add(camera.project(point), margin))
