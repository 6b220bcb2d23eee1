"""Chapter 11 written out plainly gives what the library gives."""

import numpy as np
import pytest

from course_lib import planning
from course_lib.camera import Camera
from course_lib.exercises.planning import APERTURE_WINDOW, inputs, plain
from course_lib.exercises.planning.aperture_misconceptions import window as right_window
from course_lib.judging import answer, judge, pose
from course_lib.transforms import rotation_from_vector


@pytest.fixture(params=range(8))
def rng(request):
    return np.random.default_rng(request.param)


def camera_of(P, image_size):
    """Take the camera apart again: P is K [R | t] with an upright K."""
    turned, upright = np.linalg.qr(np.linalg.inv(P[:, :3]))
    signs = np.diag(np.sign(np.diag(upright)))
    K, R = np.linalg.inv(signs @ upright), (turned @ signs).T
    return Camera(K / K[2, 2], R, np.linalg.inv(K) @ P[:, 3], image_size)


@pytest.mark.parametrize("draw", [inputs.at_rest, inputs.moving, inputs.around_the_camera])
def test_room_is_that_of_the_library(rng, draw):
    posed = getattr(drawn := draw(rng), "inputs", drawn)
    box = planning.Box(posed["size"], posed["centre"]).with_motion(posed["motion"])
    camera = camera_of(posed["P"], posed["image_size"])
    ours = planning.box_in_view(box, camera).margins
    np.testing.assert_allclose(plain.box_in_view(**posed), ours, rtol=1e-9, atol=1e-7)


@pytest.mark.parametrize("draw", [inputs.facing, inputs.tilted])
def test_resolution_is_that_of_the_library(rng, draw):
    posed = draw(rng)
    f = posed["f_mm"] / posed["pitch_um"] * 1000
    camera = Camera(np.diag([f, f, 1]), np.eye(3), np.zeros(3), (640, 480))
    normal = rotation_from_vector([0, posed["tilt"], 0]) @ [0, 0, -1]
    ours = planning.object_resolution([0, 0, posed["Z"]], normal, camera)
    np.testing.assert_allclose(plain.object_resolution(**posed), ours)


@pytest.mark.parametrize("draw", [inputs.flat_object, inputs.deep_object])
def test_window_is_that_of_the_library(rng, draw):
    posed = draw(rng)
    ours = planning.aperture_window(**posed)
    np.testing.assert_allclose(plain.aperture_window(**posed), (ours.least, ours.most))
    assert ours.is_open == (draw is inputs.flat_object)


@pytest.mark.parametrize(
    ("draw", "name"),
    [
        (inputs.one_height, "ground_sample_distance"),
        (inputs.several_heights, "ground_sample_distance"),
        (inputs.with_overlap, "overlap"),
        (inputs.with_a_gap, "overlap"),
        (inputs.three_pictures, "base_for_overlap"),
        (inputs.several_shares, "base_for_overlap"),
        (inputs.smear_decides, "max_speed"),
        (inputs.several_flights, "max_speed"),
        (inputs.field, "photo_count"),
        (inputs.larger_field, "photo_count"),
        (inputs.even_field, "photo_count"),
        (inputs.narrow_field, "photo_count"),
    ],
)
def test_flight_is_that_of_the_library(rng, draw, name):
    posed = getattr(drawn := draw(rng), "inputs", drawn)
    ours = getattr(planning, name)(**posed)
    np.testing.assert_allclose(getattr(plain, name)(**posed), ours)


@pytest.mark.parametrize("factors", [(1.37, 1), (1, 0.61)])
@pytest.mark.parametrize("form", [tuple, list, np.array])
def test_of_two_f_numbers_the_right_one_is_named(factors, form):
    """Whatever the slip in the other one is; where both are wrong, none is called right."""

    def window(f_mm, near, far, spot_um, wavelength_um):
        least, most = right_window(f_mm, near, far, spot_um, wavelength_um)
        return form([factors[0] * least, factors[1] * most])

    cases = pose(APERTURE_WINDOW, 0)
    verdict = judge(APERTURE_WINDOW, cases, answer(APERTURE_WINDOW, window, cases))
    right = "The least is right" if factors[0] == 1 else "The most is right"
    assert [hint.partition(".")[0] for hint in verdict.hints] == [right]
    assert all("The other one is right." in part.feedback.message for part in verdict.parts)
    assert verdict.points == 0


def test_of_two_wrong_f_numbers_none_is_called_right():
    def window(f_mm, near, far, spot_um, wavelength_um):
        least, most = right_window(f_mm, near, far, spot_um, wavelength_um)
        return 1.37 * least, 0.61 * most

    cases = pose(APERTURE_WINDOW, 0)
    assert judge(APERTURE_WINDOW, cases, answer(APERTURE_WINDOW, window, cases)).hints == ()


def test_published_overlap_for_three_pictures():
    assert plain.overlap(30, 90) == pytest.approx(0.67, abs=0.005)
    assert plain.base_for_overlap(2 / 3, 90) == pytest.approx(30)


def test_published_lens_on_its_sensor():
    """85 mm, 2048 px on 27.6 mm: 6307.2 px with the rounded 74.2 px/mm; a pixel at 2 m."""
    finest, _ = plain.object_resolution(2.0, 85, 27.6e3 / 2048, 0.0)
    assert finest == pytest.approx(2 / 6307.2, rel=1e-4)
