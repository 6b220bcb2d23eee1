import numpy as np
import pytest

from course_lib.drawing.explorers import aperture, dolly, focal
from course_lib.drawing.explorers import street as scenery
from course_lib.drawing.sensors import FULL_FRAME, SENSORS
from course_lib.optics import field_of_view

APERTURE = aperture.aperture_frame
FOCAL = focal.focal_length_frame
DOLLY = dolly.dolly_zoom_frame
ADJUSTED, FIXED = aperture.ADJUSTED, aperture.FIXED


def value(frame, label):
    (reading,) = (r for r in frame.readouts if r.label == label)
    return float(reading.value)


def detail(picture):
    """Return how much neighbouring pixels differ."""
    grey = picture.image.mean(axis=2)
    return np.abs(np.diff(grey, axis=0)).mean() + np.abs(np.diff(grey, axis=1)).mean()


# The hole


def test_the_sharpest_hole_is_the_best_one():
    holes = (2, 1, 0.6, 0.37, 0.15, 0.07)
    sharpness = [detail(APERTURE(d, 100, ADJUSTED).pictures[0]) for d in holes]
    assert int(np.argmax(sharpness)) == 3
    assert value(APERTURE(1, 100, ADJUSTED), "Best hole") == 0.37


def test_with_a_fixed_exposure_light_falls_with_the_area():
    small, smaller = (APERTURE(d, 100, FIXED) for d in (0.2, 0.1))
    light = "Light, against a 1 mm hole"
    assert value(small, light) / value(smaller, light) == pytest.approx(4, rel=0.01)
    ratio = small.pictures[0].image.mean() / smaller.pictures[0].image.mean()
    # A screen's light is about the 2.2nd power of the grey values, which are whole and few.
    assert ratio**2.2 == pytest.approx(4, rel=0.2)


def test_the_adjusted_exposure_keeps_the_brightness():
    bright, dark = (APERTURE(d, 100, ADJUSTED).pictures[0].image.mean() for d in (2, 0.1))
    assert bright == pytest.approx(dark, rel=0.02)


def test_the_spot_is_drawn_to_scale():
    frame = APERTURE(0.5, 100, ADJUSTED)
    disk = frame.pictures[1].lines[1]
    width = np.ptp(np.asarray(disk.points)[:, 0]) / aperture.SPOT_SCALE
    assert width == pytest.approx(value(frame, "Shadow of the hole"), abs=0.006)


# The focal length


@pytest.mark.parametrize("sensor", SENSORS)
@pytest.mark.parametrize("f", [4, 28, 300])
def test_the_pointer_reads_half_the_field_of_view_at_the_edge(sensor, f):
    frame = FOCAL(f, sensor)
    width, _ = frame.pictures[0].size
    angles = frame.pictures[0].probes[0].values
    middle = angles[angles.shape[0] // 2]
    half = np.degrees(field_of_view(f, SENSORS[sensor])[0]) / 2
    # The corner pixels' centres lie half a pixel inside the sensor's edge.
    inside = np.degrees(np.arctan(np.tan(np.radians(half)) * (width - 1) / width))
    assert middle.min() == pytest.approx(0, abs=0.2 / f)
    assert middle[0] == pytest.approx(inside, abs=1e-3)


def test_the_picture_has_the_shape_of_the_sensor():
    for sensor, (width, height) in SENSORS.items():
        w, h = FOCAL(28, sensor).pictures[0].size
        assert w / h == pytest.approx(width / height, abs=0.005)


def test_a_crop_sensor_shows_the_middle_of_the_full_frame():
    full, crop = (FOCAL(28, s).pictures[0].image.astype(float) for s in (FULL_FRAME, "APS-C (DX)"))
    share = 23.5 / 36
    w = round(480 * share)
    left = (480 - w) // 2
    middle = full[:, left : left + w].mean(axis=(0, 2))
    spread = np.interp(np.linspace(0, 1, w), np.linspace(0, 1, 480), crop.mean(axis=(0, 2)))
    assert np.corrcoef(middle, spread)[0, 1] > 0.9


def test_the_frustum_ends_at_the_corners_of_the_picture():
    camera = scenery.upright_camera(focal.EYE, 50, (36, 24))
    rectangle, edges, axis = scenery.frustum(camera, 14, camera)
    seen = np.asarray(edges.points)
    corners = scenery.corners(camera)
    ends = seen[23::25]  # the last point before each NaN row
    np.testing.assert_allclose(ends, corners, atol=1e-6)
    np.testing.assert_allclose(np.asarray(rectangle.points)[::24], corners, atol=1e-6)
    np.testing.assert_allclose(np.asarray(axis.points)[1:24], camera.K[:2, 2] * np.ones((23, 1)))


def test_the_view_from_outside_stays_the_same_array():
    assert FOCAL(28, FULL_FRAME).pictures[1].image is FOCAL(100, "APS-C (DX)").pictures[1].image


# The dolly zoom


def test_the_chart_stands_where_the_explorer_thinks():
    middles = [p.corners.mean(axis=0) for p in scenery.renderer().scene.patches]
    expected = [*scenery.CHART, np.mean(scenery.CHART_EDGES)]
    assert min(np.linalg.norm(m - expected) for m in middles) < 1e-9


def test_the_chart_keeps_its_size_and_the_tree_does_not():
    near, far = DOLLY(2, 50, True), DOLLY(25, 50, True)
    chart, tree = "Chart in the picture", "Tree behind it"
    assert value(near, chart) == value(far, chart)
    assert value(far, tree) > 4 * value(near, tree)
    assert far.follows["f"] == pytest.approx(28 * 25 / 4)


@pytest.mark.parametrize("Z", [4, 8, 12, 16])
def test_the_tree_is_seen_beside_the_chart(Z):
    frame = DOLLY(Z, 28, True)
    chart, tree = (np.asarray(line.points) for line in frame.pictures[0].lines)
    left_edge = frame.pictures[0].size[0] - 1 - chart[:, 0].max()
    assert tree[:, 0].max() < left_edge
    assert tree[:, 0].min() > 0


def test_uncoupled_the_chart_shrinks_with_distance():
    near, far = DOLLY(5, 50, False), DOLLY(10, 50, False)
    chart = "Chart in the picture"
    assert value(near, chart) == pytest.approx(2 * value(far, chart), abs=1.5)
    assert far.follows == {}


def test_the_bracket_is_as_high_as_the_chart_in_the_picture():
    frame = DOLLY(4, 28, True)
    camera = scenery.upright_camera((1.75, 1.0, 1.65), 28, (36, 24))
    edges = camera.project([[*scenery.CHART, z] for z in scenery.CHART_EDGES])
    bracket = np.asarray(frame.pictures[0].lines[0].points)
    assert np.ptp(bracket[:, 1]) == pytest.approx(np.ptp(edges[:, 1]), abs=1e-6)


# All of them


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (APERTURE(0.05, 60, ADJUSTED), APERTURE(2.5, 150, FIXED)),
        (FOCAL(4, FULL_FRAME), FOCAL(300, "1/2.3 inch")),
        (DOLLY(2, 14, False), DOLLY(25, 200, True)),
    ],
    ids=["aperture", "focal length", "dolly zoom"],
)
def test_pictures_and_words_follow_the_state(one, other):
    assert one.in_words() != other.in_words()
    for first, second in zip(one.pictures, other.pictures, strict=True):
        assert first.alt != second.alt
        assert first.alt.endswith(".")
    photographs = [frame.pictures[0].image for frame in (one, other)]
    assert photographs[0].shape != photographs[1].shape or (photographs[0] != photographs[1]).any()
