"""Whatever goes in: either the answer is right, or the documented error comes. Nothing else."""

import math

import numpy as np
import pytest
from fuzzing import fuzzing, outcome
from hypothesis import given
from hypothesis import strategies as st

from course_lib import optics
from course_lib.checks import DegenerateConfigurationError

fuzz = fuzzing(150)

#: From a wavelength to the size of a country, in mm; and what is no length at all.
lengths = st.floats(1e-4, 1e9)
mischief = st.sampled_from(
    [0, -0.0, -1, math.nan, math.inf, -math.inf, "50", None, [], [1, [2, 3]], {}, 1j, True, "f/4"]
)
anything = st.one_of(lengths, lengths, lengths, mischief, st.lists(lengths, min_size=1, max_size=3))
POSITIVE = {
    "image_distance": 2,
    "magnification": 2,
    "object_distance": 2,
    "optical_power": 1,
    "pixel_on_object": 2,
    "f_number": 2,
    "aperture_diameter": 2,
    "working_f_number": 2,
    "stops_between": 2,
    "circle_of_confusion": 4,
    "hyperfocal_distance": 3,
    "depth_of_field": 4,
    "depth_of_field_approximate": 4,
    "closeup_depth_of_field": 3,
    "aperture_for_depth": 4,
    "apertures_for_limits": 5,
    "sharpest_f_number": 4,
    "airy_diameter": 2,
    "is_diffraction_limited": 3,
    "free_space": 1,
    "thin_lens": 1,
    "lens_system": 3,
    "two_lens_zoom": 3,
    "field_of_view": 2,
    "equivalent_focal_length": 2,
    "pinhole_blur_diameter": 3,
    "best_pinhole_diameter": 2,
    "image_of_point": 2,
    "cardinal_points": 1,
}


@pytest.mark.parametrize("name", POSITIVE)
@fuzz
@given(data=st.data())
def test_answer_or_documented_error(name, data):
    arguments = data.draw(st.tuples(*[anything] * POSITIVE[name]))
    answer = outcome(getattr(optics, name), *arguments)
    for value in answer if isinstance(answer, tuple) else [answer]:
        assert value is None or not np.isnan(value).any()


def test_every_public_function_is_fuzzed():
    matrices = {"system_matrix", "trace_rays"}  # with those of cameras, in test_geometry
    names = {"parse_lens_name"}
    assert set(optics.__all__) == set(POSITIVE) | matrices | names


@fuzz
@given(f=lengths, Z=st.one_of(lengths, st.just(math.inf)))
def test_thin_lens_equation(f, Z):
    distance = outcome(optics.image_distance, f, Z)
    assert (distance is None) == (f >= Z)
    if distance is not None:
        assert distance >= f
        assert abs(1 / distance - (1 / f - 1 / Z)) <= 1e-14 / f


@fuzz
@given(f=lengths, m=st.floats(1e-5, 1e3))
def test_distance_of_an_object_and_back(f, m):
    np.testing.assert_allclose(optics.magnification(f, optics.object_distance(f, m)), m, 1e-9)


@fuzz
@given(f=lengths, N=st.floats(0.3, 300), s=st.one_of(lengths, st.just(math.inf)), c=lengths)
def test_depth_of_field_ends_where_the_spot_is_c(f, N, s, c):
    limits = outcome(optics.depth_of_field, f, N, s, c)
    assert (limits is None) == (s <= f)
    if limits is None:
        return
    near, far = limits
    assert 0 < near <= s <= far
    assert math.isinf(far) == (s >= optics.hyperfocal_distance(f, N, c))
    rounding = 1e-14 * f / N * f / (1 - f / s)  # of the spot, for each 1/distance in it
    for limit in (near, far):
        spot = optics.circle_of_confusion(limit, s, f, N)
        if math.isinf(limit):
            assert spot <= c * (1 + 1e-9) + rounding / s
        else:
            assert abs(spot - c) <= 1e-9 * c + rounding * (1 / limit + 1 / s)


@fuzz
@given(Z=lengths, s=lengths, f=lengths, N=st.floats(0.3, 300))
def test_spot_by_similar_triangles(Z, s, f, N):
    if s <= f or f >= Z:
        return
    sensor, meet = optics.image_distance(f, s), optics.image_distance(f, Z)
    spot = f / N * abs(meet - sensor) / meet
    rounding = 1e-14 * f / N * sensor / f
    assert abs(optics.circle_of_confusion(Z, s, f, N) - spot) <= 1e-9 * spot + rounding


@fuzz
@given(f=lengths, near=lengths, depth=st.one_of(st.floats(1e-3, 1e9), st.just(math.inf)), c=lengths)
def test_aperture_makes_the_range_sharp(f, near, depth, c):
    far = near * (1 + depth)
    answer = outcome(optics.aperture_for_depth, f, near, far, c)
    assert (answer is None) == (near <= f)
    if answer is not None:
        N, s = answer
        assert N > 0
        assert near < s < far
        spots = optics.circle_of_confusion([near, far], s, f, N)
        # Near the focal length, the sensor is so far away that s - f has few digits left.
        np.testing.assert_allclose(spots, c, rtol=1e-9 + 1e-13 * s / (s - f))


focal_lengths = st.one_of(lengths, lengths.map(lambda f: -f)).filter(lambda f: abs(f) < 1e6)


@fuzz
@given(f1=focal_lengths, f2=focal_lengths, d=st.one_of(st.just(0.0), st.floats(1e-4, 1e6)))
def test_two_lenses_by_the_closed_form(f1, f2, d):
    power = f1 + f2 - d  # times -1 / (f1 f2)
    size = abs(f1) + abs(f2) + d
    try:
        f, front, back = optics.lens_system(f1, f2, d)
    except DegenerateConfigurationError:
        assert abs(power) <= 1e-13 * size
        return
    off = 1e-9 + 1e-14 * size / abs(power)
    expected = f1 * f2 / power
    assert abs(f - expected) <= off * abs(expected)
    for place, closed in ((front, expected * d / f2), (back, -expected * d / f1)):
        assert abs(place - closed) <= off * abs(closed) + 1e-13 * abs(expected)


@fuzz
@given(f1=focal_lengths, f2=focal_lengths, d=st.floats(1e-4, 1e4), gap=st.floats(1e-4, 1e4))
def test_any_train_has_determinant_one_and_images_points(f1, f2, d, gap):
    system = optics.system_matrix(
        [optics.thin_lens(f1), optics.free_space(d), optics.thin_lens(f2)]
    )
    distance, m = optics.image_of_point(system, gap)
    if math.isinf(distance):
        return
    (A, B), (C, D) = system @ optics.free_space(gap)
    assert abs(B + distance * D) <= 1e-9 * (abs(B) + abs(distance * D))
    assert abs(m * D - 1) <= 1e-9 * (1 + abs(A * D) + abs(B * C))  # determinant one


@fuzz
@given(st.one_of(st.text(), st.text("0123456789.,-–f/F1:m ", max_size=30), mischief))
def test_lens_name_is_read_or_refused(name):
    found = outcome(optics.parse_lens_name, name)
    for first, last in found.values() if found else ():
        assert 0 < first <= last < math.inf


@fuzz
@given(
    focal=st.lists(st.integers(4, 800), min_size=1, max_size=2, unique=True).map(sorted),
    stops=st.lists(st.sampled_from([0.95, 1.4, 2, 2.8, 4.5, 11]), min_size=1, max_size=2).map(
        sorted
    ),
    sign=st.sampled_from(["f/", "F/", "f", "F", "1:", "1 : ", "ƒ/", "f / "]),
    dash=st.sampled_from(["-", " - ", "–"]),
    unit=st.sampled_from(["mm", " mm", "MM"]),
    maker=st.sampled_from(["", "AF-S NIKKOR ", "EF ", "Sonnar T* ", "M.Zuiko 4/3 ", "FUJINON "]),
    end=st.sampled_from(["", "E ED VR", " Macro 1:1", "L IS II USM", " | C"]),
)
def test_every_way_of_writing_is_read(focal, stops, sign, dash, unit, maker, end):
    stop = dash.join(f"{N:g}" for N in stops)
    name = f"{maker}{dash.join(map(str, focal))}{unit} {sign}{stop}{end}"
    found = optics.parse_lens_name(name)
    assert found == {"focal_length": (focal[0], focal[-1]), "f_number": (stops[0], stops[-1])}
