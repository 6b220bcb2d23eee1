"""The right answers of chapters 00 to 04, found again in scenes: built, traced, or simulated.

The reference of these exercises is the library's formula. What it answers to the poses that are
given is compared with pixels that are counted, rays traced, waves added up, photons drawn.
"""

import numpy as np
import pytest
from scipy.optimize import brentq, minimize_scalar

from course_lib.camera import project
from course_lib.exercises import all_exercises
from course_lib.judging import pose
from course_lib.judging.answering import expected_answer

EXERCISES = {exercise.name: exercise for exercise in all_exercises()}


def posed(name, *arguments):
    """Yield what is given in all poses, and the right answer."""
    for seed in range(4):
        for case in pose(EXERCISES[name], seed):
            given = [case.inputs[argument] for argument in arguments]
            yield *given, expected_answer(EXERCISES[name], case)


def one_by_one(name, *arguments):
    """Yield single numbers, one answer after the other, where a pose asks for several at once."""
    for row in posed(name, *arguments):
        yield from zip(*(np.ravel(a).tolist() for a in np.broadcast_arrays(*row)), strict=True)


def pixel_at(way, size, count):
    """Return in which pixel something is, so far from the middle of a sensor: pixels are laid."""
    edges = np.linspace(-size / 2, size / 2, count + 1)
    middles = (edges[1:] + edges[:-1]) / 2
    return np.interp(way, middles, np.arange(count))


def angle_between(ray, other):
    return np.arccos(ray @ other / (np.linalg.norm(ray) * np.linalg.norm(other)))


def test_the_middle_of_a_picture_is_the_mean_of_its_pixels():
    for (width, height), centre in posed("welcome.image_centre", "image_size"):
        np.testing.assert_allclose(centre, [np.arange(width).mean(), np.arange(height).mean()])


def test_intrinsics_put_points_into_the_pixels_that_the_sensor_has_there():
    numbers = "f", "sensor_size", "image_size"
    focal = [answer for *_, answer in posed("pinhole.pixel_focal_length", *numbers)]
    guesses = list(posed("pinhole.first_guess_intrinsics", *numbers))
    for (f, sizes, counts, K), (fx, fy) in zip(guesses, focal, strict=True):
        Z = 3000.0
        across, down = 0.3 * Z / f * np.array(sizes)
        point = np.array([across, -down, Z])
        by_similar_triangles = point[:2] * f / Z  # mm on the sensor
        seen = [pixel_at(*axis) for axis in zip(by_similar_triangles, sizes, counts, strict=True)]
        np.testing.assert_allclose(project(point, K @ np.eye(3, 4)), seen)
        np.testing.assert_allclose([fx, fy], np.diag(K)[:2])


def test_fields_of_view_are_angles_between_rays():
    for f, (width, height), answer in posed("pinhole.field_of_view", "f", "sensor_size"):
        for x, y, angle in zip((width, 0, width), (0, height, height), answer, strict=True):
            rays = np.array([x / 2, y / 2, f]), np.array([-x / 2, -y / 2, f])
            assert angle_between(*rays) == pytest.approx(angle)


def test_an_equivalent_lens_sees_from_corner_to_corner_as_much():
    for f, sides, equivalent in posed("pinhole.equivalent_focal_length", "f", "sensor_size"):
        small, full = (
            angle_between(np.array([x, y, 2 * own]), np.array([-x, -y, 2 * own]))
            for own, (x, y) in ((f, sides), (equivalent, (36, 24)))
        )
        assert small == pytest.approx(full)


def test_after_a_dolly_zoom_the_object_fills_as_many_pixels():
    for f, Z, Z_new, f_new in one_by_one("pinhole.dolly_zoom", "f", "Z", "Z_new"):
        tall = [
            np.ptp(project([[0.0, 0, far], [0, 1.8, far]], np.diag([own, own, 1]) @ np.eye(3, 4)))
            for own, far in ((f, Z), (f_new, Z_new))
        ]
        assert tall[1] == pytest.approx(tall[0])


def first_dark_ring(wavelength, diameter, distance):
    """Return the radius at which the waves from all over a round opening cancel."""
    half = np.arange(-2000, 2001) / 2000 * np.pi / 2
    x, strip = np.sin(half) * diameter / 2, np.cos(half) ** 2  # how high × how wide the strips are

    def amplitude(radius):
        return (strip * np.cos(2 * np.pi / wavelength * x * radius / distance)).sum()

    blur = wavelength * distance / diameter
    return brentq(amplitude, 0.5 * blur, 2 * blur)


def test_in_the_first_dark_ring_waves_cancel():
    for wavelength, N, diameter in one_by_one("lenses.airy_diameter", "wavelength", "N"):
        ring = 2 * first_dark_ring(wavelength, 50 / N, 50)
        assert diameter == pytest.approx(ring, rel=3e-4)  # 2.4393 is rounded to 2.44


def test_no_other_hole_makes_a_smaller_spot():
    names = "image_distance", "wavelength"
    for distance, wavelength, best in one_by_one("pinhole.best_pinhole_diameter", *names):

        def spot(hole, distance=distance, wavelength=wavelength):
            return hole + 2 * first_dark_ring(wavelength, hole, distance)

        found = minimize_scalar(spot, bounds=(0.01, 10), options={"xatol": 1e-6}).x  # mm
        assert best == pytest.approx(found, rel=3e-4)


def spot_of(Z, f, diameter, sensor):
    """Return the spot of a point on the axis: its rays through the edges of a thin lens."""
    edges = np.array([-0.5, 0.5]) * diameter
    bent = edges / Z - edges / f  # slopes behind the lens
    return np.ptp(edges + sensor * bent)


def test_a_close_up_is_sharp_between_points_whose_spots_are_as_large_as_allowed():
    for m, N, c, depth in one_by_one("lenses.closeup_depth_of_field", "m", "N", "c"):
        f = 1000 * c * N / m  # long enough for the formula
        focused, sensor = f * (1 + 1 / m), f * (1 + m)
        assert spot_of(focused, f, f / N, sensor) == pytest.approx(0, abs=1e-9 * c)

        def too_large(Z, f=f, N=N, sensor=sensor, c=c):
            return spot_of(Z, f, f / N, sensor) - c

        near = brentq(too_large, focused - depth, focused)
        far = brentq(too_large, focused, focused + depth)
        assert far - near == pytest.approx(depth, rel=2e-6)


def light(N, t, iso):
    """Return what a lens of 50 mm lets in through its opening, and what is made of it."""
    return np.pi * (50 / N / 2) ** 2 * t * iso


def test_exposure_values_count_how_often_the_light_is_halved():
    for N, t, iso, value in one_by_one("sensor.exposure_value", "N", "t", "iso"):
        assert light(N, t, iso) * 2**value == pytest.approx(light(1, 1, 100))


def test_equivalent_exposures_make_as_much_of_the_light():
    numbers = "N", "t", "iso", "N_new", "iso_new"
    for N, t, iso, N_new, iso_new, t_new in one_by_one("sensor.equivalent_exposure", *numbers):
        assert light(N_new, t_new, iso_new) == pytest.approx(light(N, t, iso))


def pictures(photons, camera, seconds, rng, count=40_000):
    """Return what a pixel holds in many pictures, DN: each photon and electron is drawn.

    Numbers are rounded at another place each time, so that rounding depends on nothing else.
    """
    freed = rng.binomial(rng.poisson(photons, count), camera.quantum_efficiency)
    held = np.minimum(freed + rng.poisson(camera.dark_current * seconds, count), camera.full_well)
    read = camera.gain * (held + camera.read_noise * rng.standard_normal(count)) + camera.offset
    place = rng.random(count)
    return np.minimum(np.rint(read + place) - place, 2**camera.bits - 1)


CHAIN = "photons", "camera", "exposure_time"


def test_the_response_is_the_mean_of_many_pictures():
    rng = np.random.default_rng(0)
    for photons, camera, seconds, answer in posed("sensor.sensor_response", *CHAIN):
        means = [pictures(n, camera, seconds, rng).mean() for n in photons]
        np.testing.assert_allclose(means, answer, rtol=5e-3)


def test_signal_to_noise_is_that_of_many_pictures():
    rng = np.random.default_rng(0)
    for photons, camera, seconds, answer in posed("sensor.signal_to_noise", *CHAIN):
        dark = camera.offset + camera.gain * camera.dark_current * seconds
        drawn = np.array([pictures(n, camera, seconds, rng) for n in photons])
        ratios = (drawn.mean(axis=1) - dark) / drawn.std(axis=1)
        np.testing.assert_allclose(ratios, answer, rtol=0.02)


def test_the_smear_reaches_from_where_a_point_begins_to_where_it_ends():
    names = "speed", "exposure_time", "pixel_size"
    for speed, seconds, pixel_size, smear in one_by_one("sensor.motion_blur_pixels", *names):
        P, Z = np.diag([800.0, 800, 1]) @ np.eye(3, 4), 800 * pixel_size
        ends = project([[0, 0, Z], [speed * seconds, 0, Z]], P)
        assert np.ptp(ends[:, 0]) == pytest.approx(smear)


def test_a_shutter_that_rolls_down_reads_the_edge_row_after_row():
    names = "speed", "row_time", "rows"
    for speed, row_time, rows, skew in one_by_one("sensor.rolling_shutter_skew", *names):
        edge = [0.0]
        for _ in range(int(rows)):
            edge.append(edge[-1] + speed * row_time)  # as far as it comes until the next row
        assert edge[-1] - edge[0] == pytest.approx(skew)
