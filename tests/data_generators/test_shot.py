import numpy as np
import pytest

from course_lib.camera import Camera, image_centre
from course_lib.sensor import (
    SensorModel,
    bayer_mosaic,
    camera_gain_from_pairs,
    motion_blur_pixels,
    rolling_shutter_skew,
    sensor_response,
    signal_to_noise,
    vignetting,
)
from data_generators.aim import Shutter, aim_at
from data_generators.hole import Hole
from data_generators.lens import Lens
from data_generators.motion import Motion
from data_generators.raycast import rays
from data_generators.render import photograph, radiance
from data_generators.scene import Patch, Scene, moving
from data_generators.shot import Shot, falloff

F = 400.0  # px
GREY = Scene((), (128, 128, 128))


def facing(size=(96, 64), f=F):
    cx, cy = image_centre(size)
    return Camera([[f, 0, cx], [0, f, cy], [0, 0, 1]], np.eye(3), np.zeros(3), size)


def strip(width, height=10.0, Z=2.0, colour=(255, 255, 255), left=0.0):
    """A bright upright strip whose middle is at `left`, sizes in m."""
    corner = (left - width / 2, -height / 2, Z)
    return Patch(corner, (width, 0, 0), (0, height, 0), np.array(colour))


class TestMotion:
    def test_shapes(self):
        motion = Motion((1, 2, 3), (0, 0, 4), (1, 0, 0))
        origins, directions = motion.carry(np.zeros((5, 3)), np.ones((5, 3)), np.arange(5.0))
        assert origins.shape == directions.shape == (5, 3)

    def test_accuracy(self):
        # A quarter turn about the vertical through (1, 0, 0), while it rises by 2 m.
        motion = Motion((0, 0, 2), (0, 0, np.pi / 2), (1, 0, 0))
        origins, directions = motion.carry(
            np.array([[2.0, 0, 0]]), np.array([[1.0, 0, 0]]), np.array([1.0])
        )
        np.testing.assert_allclose(origins, [[1, 1, 2]], atol=1e-12)
        np.testing.assert_allclose(directions, [[0, 1, 0]], atol=1e-12)

    def test_round_trip(self):
        rng = np.random.default_rng(3)
        motion = Motion(*rng.normal(size=(3, 3)))
        origins, directions, times = rng.normal(size=(7, 3)), rng.normal(size=(7, 3)), rng.random(7)
        there = motion.carry(origins, directions, times)
        back = motion.bring_back(*there, times)
        np.testing.assert_allclose(back, (origins, directions), atol=1e-12)

    def test_errors(self):
        with pytest.raises(ValueError, match=r"velocity must have shape \(3,\)"):
            Motion((1, 2))
        with pytest.raises(ValueError, match="must not be negative"):
            Shutter(-1)


class TestAim:
    def test_a_still_pinhole_is_a_camera(self):
        camera, pixels = facing(), np.array([[3.25, 4.75], [80, 60]])
        for got, expected in zip(
            aim_at(camera, pixels, 2).rays(pixels), rays(camera, pixels), strict=True
        ):
            np.testing.assert_array_equal(got, expected)

    def test_rays_meet_where_the_lens_is_focused(self):
        lens, camera = Lens(50, 2, 1500), facing()
        pixels = np.broadcast_to([10.0, 20.0], (16, 2)) + 0.0
        aim = aim_at(camera, pixels + np.arange(16)[:, None] / 64, 4, lens)
        origins, directions = aim.rays(pixels)
        meeting = origins + directions * ((1.5 - origins[:, 2]) / directions[:, 2])[:, None]
        np.testing.assert_allclose(meeting, np.broadcast_to(meeting[0], (16, 3)), atol=1e-12)
        assert np.linalg.norm(origins, axis=1).max() < 0.0125

    @pytest.mark.parametrize("samples", [1, 2, 3, 4, 5, 8])
    def test_samples_share_lens_and_time_evenly(self, samples):
        within = (np.arange(samples) + 0.5) / samples - 0.5
        grid = np.stack(np.meshgrid(within, within), axis=-1).reshape(-1, 2) + np.array([7, 9])
        aim = aim_at(facing(), grid, samples, Lens(50, 2, 1500), Shutter(0.1, 0.01))
        share = np.sort((np.linalg.norm(aim.points, axis=1) / 0.0125) ** 2)
        np.testing.assert_allclose(share, (np.arange(samples**2) + 0.5) / samples**2)
        times = np.sort(aim.times - 9 * 0.01)
        assert times.min() >= -0.05
        assert times.max() <= 0.05
        np.testing.assert_allclose(np.diff(times), 0.1 / samples**2, atol=1e-12)


class TestMotionBlur:
    @pytest.mark.parametrize("speed", [0.5, 1.5])
    def test_length(self, speed):
        # An upright strip that moves: its width w, its smear L and the pixel add their variances,
        # each a twelfth of the square.
        camera, Z, width = facing(), 2.0, 0.02
        scene = Scene((*moving([strip(width)], Motion((speed, 0, 0))),), (0, 0, 0))
        light = radiance(scene, camera, 6, Shot(shutter=Shutter(0.04)))
        row, u, w = light[..., 0].mean(axis=0), np.arange(96), width * F / Z
        middle = (row * u).sum() / row.sum()
        variance = (row * (u - middle) ** 2).sum() / row.sum()
        length = np.sqrt(12 * variance - w**2 - 1)
        expected = motion_blur_pixels(speed, 0.04, Z / F)
        assert expected in (4.0, pytest.approx(12.0))
        assert length == pytest.approx(expected, rel=0.03)
        assert row.sum() == pytest.approx(w, rel=0.02)
        # The exposure's middle is time 0: the smear is around where the scene has the strip.
        assert middle == pytest.approx(camera.K[0, 2], abs=0.1)

    def test_moving_the_camera_is_moving_the_world(self):
        patch = strip(0.1, 0.1)
        shutter, camera = Shutter(0.05), facing()
        for motion, opposite in (
            (Motion((0.6, -0.3, 0.2)), Motion((-0.6, 0.3, -0.2))),
            (Motion(turning=(0.1, 0, 2)), Motion(turning=(-0.1, 0, -2))),
        ):
            world = Scene((*moving([patch], motion),), (0, 0, 0))
            one = radiance(world, camera, 3, Shot(shutter=shutter))
            camera_moves = Shot(shutter=shutter, motion=opposite)
            other = radiance(Scene((patch,), (0, 0, 0)), camera, 3, camera_moves)
            np.testing.assert_allclose(one, other, atol=1e-12)
            assert 0.1 < one.max() <= 1

    def test_what_stands_still_stays_sharp(self):
        scene = Scene((strip(0.1), *moving([strip(0.05, left=0.17)], Motion((2, 0, 0)))), (0, 0, 0))
        row = radiance(scene, facing(), 4, Shot(shutter=Shutter(0.05)))[32, :, 0]
        plain = radiance(Scene((strip(0.1),), (0, 0, 0)), facing(), 4)[32, :, 0]
        np.testing.assert_array_equal(row[:60], plain[:60])
        assert row[75:].max() == pytest.approx(0.5, abs=0.05)  # 10 px wide, smeared over 20


class TestRollingShutter:
    @pytest.mark.parametrize("speed", [2.0, -1.0])
    def test_skew(self, speed):
        camera, row_time = facing(), 1e-3
        patches = moving([strip(0.02)], Motion((speed, 0, 0)))
        shot = Shot(shutter=Shutter(0, row_time))
        light = radiance(Scene((*patches,), (0, 0, 0)), camera, 4, shot)[..., 0]
        column = (light * np.arange(96)).sum(axis=1) / light.sum(axis=1)
        seen = slice(0, 40)
        rows = np.arange(64)[seen]
        slope, start = np.polyfit(rows, column[seen], 1)
        expected = rolling_shutter_skew(speed * F / 2.0, row_time, 1)
        assert slope == pytest.approx(expected, rel=0.02)
        assert start == pytest.approx(camera.K[0, 2], abs=0.15)  # the top row sees time 0

    def test_global_shutter(self):
        patches = moving([strip(0.02)], Motion((3.0, 0, 0)))
        light = radiance(Scene((*patches,), (0, 0, 0)), facing(), 2, Shot(shutter=Shutter()))
        np.testing.assert_array_equal(light[5], light[60])


class TestVignetting:
    def test_profile(self):
        size = (81, 61)
        camera = facing(size, f=50)
        picture = photograph(Scene((), (250, 250, 250)), camera, shot=Shot(vignetting=True))
        u = np.arange(81) - 40
        expected = 250 * vignetting(np.arctan(np.abs(u) / 50))
        np.testing.assert_allclose(picture[30, :, 1], expected, atol=0.51)

    def test_centre_and_corner(self):
        light = falloff(facing((81, 61), f=50))
        assert light[30, 40] == pytest.approx(1)
        assert light[0, 0] == pytest.approx((50**2 / (50**2 + 40**2 + 30**2)) ** 2)


class TestSensor:
    SENSOR = SensorModel(quantum_efficiency=0.5, full_well=12_000, read_noise=8, gain=0.3, bits=12)

    def flat(self, level, rng, white=20_000.0, time=0.01):
        shot = Shot(sensor=self.SENSOR, white=white, shutter=Shutter(time))
        scene = Scene((), (level, level, level))
        return photograph(scene, facing((128, 96)), shot=shot, samples=1, rng=rng)

    def test_shapes(self):
        picture = self.flat(128, np.random.default_rng(0))
        assert picture.shape == (96, 128, 3)
        assert picture.dtype == np.uint16

    def test_mean_and_noise(self):
        rng = np.random.default_rng(1)
        for level in (10, 60, 200):
            numbers = self.flat(level, rng).astype(float)
            photons = level / 255 * 20_000
            mean = sensor_response(photons, self.SENSOR, 0.01)
            assert numbers.mean() == pytest.approx(mean, abs=0.5)
            snr = (numbers.mean() - self.SENSOR.offset) / numbers.std()
            assert snr == pytest.approx(signal_to_noise(photons, self.SENSOR, 0.01), rel=0.02)

    def test_photon_transfer_finds_the_gain(self):
        rng = np.random.default_rng(2)
        levels = (8, 16, 40, 80, 120, 160, 200)
        pairs = [[self.flat(level, rng) for _ in range(2)] for level in levels]
        first, second = (np.stack([pair[k] for pair in pairs]) for k in range(2))
        dark = [self.flat(0, rng)[..., 1] for _ in range(2)]
        gain = camera_gain_from_pairs(first[..., 1], second[..., 1], *dark, self.SENSOR.white)
        assert gain == pytest.approx(self.SENSOR.gain, rel=0.02)

    def test_saturation(self):
        numbers = self.flat(255, np.random.default_rng(3), white=1e6)
        full = self.SENSOR.offset + self.SENSOR.gain * self.SENSOR.full_well
        assert numbers.mean() == pytest.approx(full, abs=0.2)
        assert numbers.std() == pytest.approx(self.SENSOR.gain * self.SENSOR.read_noise, rel=0.02)

    def test_dark_current_counts_the_time(self):
        warm = SensorModel(dark_current=5000, bits=12)
        means = []
        for time in (0.0, 0.2):
            shot = Shot(sensor=warm, shutter=Shutter(time))
            picture = photograph(
                Scene((), (0, 0, 0)), facing(), shot=shot, samples=1, rng=np.random.default_rng(4)
            )
            means.append(picture.mean())
        assert means[1] - means[0] == pytest.approx(warm.gain * 1000, rel=0.01)

    def test_determinism(self):
        one, same = (self.flat(90, np.random.default_rng(5)) for _ in range(2))
        np.testing.assert_array_equal(one, same)
        assert (one != self.flat(90, np.random.default_rng(6))).any()

    def test_mosaic(self):
        scene = Scene((strip(0.2, colour=(200, 120, 40)),), (10, 60, 90))
        camera = facing()
        plain = photograph(scene, camera, samples=2)
        mosaic = photograph(scene, camera, shot=Shot(mosaic=True), samples=2)
        assert mosaic.shape == (64, 96)
        np.testing.assert_array_equal(mosaic, bayer_mosaic(plain))

    def test_errors(self):
        with pytest.raises(TypeError, match="a sensor has noise: give an rng"):
            photograph(GREY, facing(), shot=Shot(sensor=self.SENSOR), samples=1)
        with pytest.raises(ValueError, match="give hole or shot, not both"):
            photograph(GREY, facing(), hole=Hole(1), shot=Shot())
        with pytest.raises(ValueError, match="white must be positive"):
            Shot(white=0)


def test_left_out_settings_do_nothing():
    scene = Scene((strip(0.2),), (10, 60, 90))
    plain = photograph(scene, facing(), samples=2)
    np.testing.assert_array_equal(plain, photograph(scene, facing(), shot=Shot(), samples=2))
