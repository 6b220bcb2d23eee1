"""Whatever goes in: either the answer is right, or a documented NaN or error. Nothing else."""

import numpy as np
import pytest
from fuzzing import either, fuzzing, intrinsics, numbers, outcome, small
from hypothesis import given, settings
from hypothesis import strategies as st

from course_lib import distortion

fuzz = fuzzing(100)

tangents = st.floats(-2, 2)
points = st.lists(st.tuples(tangents, tangents), max_size=6)
pixels = st.lists(st.tuples(numbers, numbers), min_size=1, max_size=6)
above = st.floats(-0.5, 5)
coefficients = st.sampled_from([1, 2, 4, 5, 8, 12]).flatmap(
    lambda count: st.lists(
        st.one_of(st.floats(-0.5, 0.5), st.floats(-1e30, 1e30)), min_size=count, max_size=count
    )
)
angular = st.lists(st.floats(-1, 1), min_size=4, max_size=4)
space = st.lists(st.tuples(numbers, numbers, numbers), min_size=1, max_size=5)
series = st.lists(st.floats(-1e30, 1e30), min_size=1, max_size=12)


def exactly(count):
    """Return lists of so many numbers."""
    return st.lists(small, min_size=count, max_size=count)


#: Arguments of every public function.
ARGUMENTS = {
    "distort": (pixels, coefficients),
    "distort_radial": (pixels, series),
    "distort_rational_prism": (
        pixels,
        *[st.lists(small, min_size=n, max_size=n) for n in (6, 2, 4)],
    ),
    "distortion_jacobian": (pixels, coefficients),
    "undistort_points": (pixels, coefficients),
    "valid_radius": (coefficients,),
    "normalised_from_pixels": (pixels, intrinsics),
    "pixels_from_normalised": (pixels, intrinsics),
    "distort_pixels": (pixels, intrinsics, coefficients),
    "undistort_pixels": (pixels, intrinsics, coefficients),
    "displacement_field": (pixels, intrinsics, coefficients),
    "undistortion_map": (intrinsics, coefficients, st.tuples(*[st.integers(0, 30)] * 2)),
    "pixel_grid": (st.tuples(numbers, numbers), st.integers(0, 5), st.integers(0, 5)),
    "distort_division": (pixels, numbers),
    "undistort_division": (pixels, numbers),
    "fisheye_project": (space, intrinsics, angular),
    "fisheye_ray": (pixels, intrinsics, angular),
    "fisheye_valid_angle": (angular,),
    "photogrammetric_from_opencv": (coefficients, numbers),
    "opencv_from_photogrammetric": (
        st.lists(numbers, min_size=3, max_size=3),
        st.lists(numbers, min_size=2, max_size=2),
        numbers,
    ),
    "distort_photogrammetric": (pixels, st.tuples(numbers, numbers), series, series),
    "ebner": (pixels, st.lists(small, min_size=12, max_size=12), numbers),
    "bouguet_from_opencv": (intrinsics, coefficients),
    "opencv_from_bouguet": (
        st.tuples(numbers, numbers),
        st.tuples(numbers, numbers),
        numbers,
        st.lists(numbers, min_size=5, max_size=5),
    ),
    "radial_correction": (coefficients, numbers, st.integers(0, 12)),
    "straightness": (pixels,),
    "distortion_from_lines": (st.lists(pixels, max_size=4), intrinsics, st.integers(0, 3)),
}


@pytest.mark.parametrize("name", ARGUMENTS)
@fuzz
@given(data=st.data())
def test_answer_or_documented_error(name, data):
    arguments = [data.draw(either(argument)) for argument in ARGUMENTS[name]]
    answer = outcome(getattr(distortion, name), *arguments)
    for value in answer if isinstance(answer, tuple) else [answer]:
        if isinstance(value, np.ndarray) and value.ndim == 2 and value.shape[-1] == 2:
            bad = np.isnan(value)
            assert (bad.all(axis=-1) == bad.any(axis=-1)).all(), "a row is NaN as a whole"
        assert not np.isinf(np.asarray(value, dtype=float)).any() or name == "valid_radius"


def test_every_public_function_is_fuzzed():
    results = {"Bouguet", "Photogrammetric", "PlumbLines"}
    assert set(distortion.__all__) == set(ARGUMENTS) | results


@fuzz
@given(points=points.filter(len), k=coefficients)
def test_undistorted_points_are_a_solution(points, k):
    points = np.array(points)
    bent = outcome(distortion.distort, points, k)
    if bent is None or np.isnan(bent).any() or np.abs(bent).max() > 1e6:
        return
    ideal = distortion.undistort_points(bent, k)
    found = np.isfinite(ideal[:, 0])
    again = distortion.distort(ideal[found], k)
    np.testing.assert_allclose(again, bent[found], rtol=1e-9, atol=1e-9)
    radius = np.hypot(*ideal[found].T)
    assert (radius <= distortion.valid_radius(k)).all()


@fuzz
@given(points=points.filter(len), k1=above, k2=above, k3=above)
def test_radial_lenses_come_back(points, k1, k2, k3):
    k, points = [k1, k2, 0, 0, k3], np.array(points)
    inside = points[np.hypot(*points.T) < 0.999 * distortion.valid_radius(k)]
    back = distortion.undistort_points(distortion.distort(inside, k), k)
    np.testing.assert_allclose(back, inside, atol=1e-9)


@fuzz
@given(k=angular, turn=st.floats(-4, 4), share=st.floats(0, 0.999))
def test_fisheye_comes_back(k, turn, share):
    angle = share * distortion.fisheye_valid_angle(k)
    ray = [np.sin(angle) * np.cos(turn), np.sin(angle) * np.sin(turn), np.cos(angle)]
    K = np.array([[300.0, 1, 320], [0, 310, 240], [0, 0, 1]])
    back = distortion.fisheye_ray(distortion.fisheye_project(ray, K, k), K, k)
    np.testing.assert_allclose(back, ray, atol=1e-9)


@settings(fuzz, max_examples=20)
@given(lines=st.lists(st.lists(st.tuples(small, small), min_size=3, max_size=4), max_size=4))
def test_lines_of_any_points(lines):
    K = np.array([[10.0, 0, 0], [0, 10, 0], [0, 0, 1]])
    found = outcome(distortion.distortion_from_lines, lines, K)
    if found is not None:
        assert found.rms <= found.rms_before * (1 + 1e-9)
        assert np.isfinite([*found.coefficients, *found.sigma]).all()
