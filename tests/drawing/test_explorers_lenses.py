import numpy as np
import pytest

from course_lib import optics
from course_lib.drawing.explorers import aperture_window as window
from course_lib.drawing.explorers import depth_of_field as depth
from course_lib.drawing.explorers import ray_tracer as rays
from course_lib.drawing.explorers.plot import Plot
from data_generators import signs

DEPTH = depth.depth_of_field_frame
RAYS = rays.ray_tracer_frame
WINDOW = window.aperture_window_frame


def value(frame, label):
    (reading,) = (r for r in frame.readouts if r.label == label)
    return float(reading.value.replace("−", "-").replace("∞", "inf"))


def texts(picture):
    return [label.text for label in picture.labels]


# Depth of field


def sharpness(frame, k, f, pitch, focus):
    """Return how much the letters of sign k differ from pixel to pixel."""
    f_px = float(optics.image_distance(f, 1000 * focus)) / (pitch / 1000)
    middle = (depth.SIZE[0] - 1) / 2 + f_px * signs.DIRECTIONS[k]
    half = 0.4 * f_px * signs.WIDTH
    u = slice(round(middle - half), round(middle + half))
    row = (depth.SIZE[1] - 1) / 2
    v = slice(round(row - half), round(row + half))
    grey = frame.pictures[0].image[v, u].mean(axis=2)
    return np.abs(np.diff(grey, axis=1)).mean() + np.abs(np.diff(grey, axis=0)).mean()


@pytest.mark.parametrize("k", range(5))
def test_the_sign_in_focus_is_the_sharpest(k):
    focus = signs.DISTANCES[k]
    frame = DEPTH(50, 1.4, focus, 50)
    seen = [sharpness(frame, i, 50, 50, focus) for i in range(5)]
    others = [DEPTH(50, 1.4, Z, 50) for Z in signs.DISTANCES]
    same_sign = [
        sharpness(other, k, 50, 50, Z) for other, Z in zip(others, signs.DISTANCES, strict=True)
    ]
    assert int(np.argmax(same_sign)) == k
    assert seen[k] > 1.3 * np.median(seen)


def test_stopping_down_sharpens_what_is_out_of_focus():
    series = [sharpness(DEPTH(50, N, 3.5, 50), 0, 50, 50, 3.5) for N in (1.4, 2.8, 5.6, 11)]
    assert series == sorted(series)
    assert series[-1] > 1.5 * series[0]


def test_the_limits_are_where_the_blur_is_one_pixel():
    frame = DEPTH(50, 4, 5, 40)
    near, far = value(frame, "Near limit"), value(frame, "Far limit")
    blurs = optics.circle_of_confusion(np.array([near, far]) * 1000, 5000, 50, 4) / 0.040
    np.testing.assert_allclose(blurs, 1, rtol=0.01)
    band = next(line for line in frame.pictures[1].lines if line.role == "image")
    reach = (depth.EYE[1] - np.asarray(band.points)[:, 1]) / depth.MAP_SCALE
    assert (reach.min(), reach.max()) == (
        pytest.approx(near, abs=0.006),
        pytest.approx(far, abs=0.006),
    )


def test_beyond_the_hyperfocal_distance_the_far_limit_is_infinite():
    frame = DEPTH(50, 8, 7, 50)
    assert value(frame, "Hyperfocal distance") == 6.3
    assert value(frame, "Far limit") == np.inf
    assert "↑ ∞" in texts(frame.pictures[1])
    assert "to infinity" in frame.pictures[1].alt


def test_a_range_beyond_the_map_is_said():
    assert "↑ sharp beyond the map" in texts(DEPTH(100, 1.4, 60, 20).pictures[1])


def test_signs_are_labelled_with_their_blur_and_distance():
    said = texts(DEPTH(50, 2.8, 3.5, 50).pictures[0])
    blurs = optics.circle_of_confusion(np.array(signs.DISTANCES) * 1000, 3500, 50, 2.8) / 0.05
    assert said[::2] == [f"{blur:.1f} px" for blur in blurs]
    assert said[1::2] == [f"{Z:g} m" for Z in signs.DISTANCES]
    assert not texts(DEPTH(20, 2.8, 3.5, 75).pictures[0])  # the signs are too small for words


def test_the_curve_is_the_circle_of_confusion():
    frame = DEPTH(35, 2, 4, 30)
    curve = np.asarray(frame.pictures[2].lines[3].points)
    assert np.nanmax(curve[:, 1]) == pytest.approx(depth.CURVE.box[3])  # zero at the focus
    star = float(optics.circle_of_confusion(60_000, 4000, 35, 2)) / 0.030
    np.testing.assert_allclose(curve[-1], depth.CURVE.pixels(60, star)[0], atol=0.5)


def test_the_view_narrows_when_the_lens_focuses_near():
    near, far = (DEPTH(100, 8, focus, 50).pictures[1].lines[1].points for focus in (1, 60))
    assert np.ptp(np.asarray(near)[:, 0]) == pytest.approx(
        np.ptp(np.asarray(far)[:, 0]) * (1 - 100 / 1000) / (1 - 100 / 60_000)
    )


# Rays


@pytest.mark.parametrize("second", rays.SECOND)
def test_drawn_rays_meet_in_the_image(second):
    frame = RAYS(150, 60, second, 80, 40)
    image = float(frame.readouts[0].value)
    m = value(frame, "Magnification")
    last = 0 if second == rays.ONE else 40
    drawn = [line for line in frame.pictures[0].lines if line.role == "ray" and line.width == 2.0]
    assert len(drawn) == 3
    for line in drawn:
        (u, v), (right, low) = np.asarray(line.points)[-2:]
        at = rays._pixels([(last + image, rays.HEIGHT * m)])[0]
        assert v + (low - v) / (right - u) * (at[0] - u) == pytest.approx(at[1], abs=0.4)


def test_three_rays_are_the_ones_that_are_easy_to_draw():
    frame = RAYS(150, 60, rays.ONE, 30, 30)
    drawn = [line for line in frame.pictures[0].lines if line.role == "ray" and line.width == 2.0]
    tip, (axis_u, axis_v) = rays._at(-150, rays.HEIGHT), rays._at(0, 0)
    for line in drawn:
        assert tuple(np.asarray(line.points)[0]) == pytest.approx(tip)
    parallel, centre, focal = (np.asarray(line.points) for line in drawn)
    assert parallel[1, 1] == pytest.approx(tip[1])
    assert centre[1] == pytest.approx([axis_u, axis_v])
    crossing = np.interp(axis_v, focal[:2, 1], focal[:2, 0])
    assert crossing == pytest.approx(rays._at(-60, 0)[0])
    assert focal[1, 1] == pytest.approx(focal[2, 1])  # it leaves parallel to the axis


def test_numbers_of_two_lenses_are_those_of_the_system():
    frame = RAYS(150, 50, rays.SPREADING, 30, 30)
    f, front, back = optics.lens_system(50, -30, 30)
    assert value(frame, "Focal length of the whole") == pytest.approx(f, abs=0.05)
    assert value(frame, "H behind lens 1") == pytest.approx(front, abs=0.05)
    assert value(frame, "H′ behind the last lens") == pytest.approx(back, abs=0.05)
    assert value(frame, "Power of the whole") == pytest.approx(1000 / f, abs=0.05)


def test_a_blur_beside_one_pixel_shows_on_which_side_it_is():
    c = float(optics.circle_of_confusion(7000, 3500, 50, 5.6)) / 1.02  # mm
    labels = DEPTH(50, 5.6, 3.5, 1000 * c).pictures[0].labels
    (beside,) = (label for label in labels if label.text == "1.02 px")
    assert beside.role == "object"
    assert "1.0 px" not in [label.text for label in labels]


def test_focal_points_of_a_pair_are_told_from_those_of_its_first_lens():
    alone = texts(RAYS(150, 60, rays.ONE, 30, 30).pictures[0])
    assert {"F", "F′"} <= set(alone)
    at = {label.text: label.at[0] for label in RAYS(150, 60).pictures[0].labels}
    assert at["F"] < at["lens"] < at["F′"]
    picture = RAYS(1e6, 50, rays.SPREADING, 30, 35).pictures[0]
    f, _, back = optics.lens_system(50, -30, 35)
    at = {label.text: label.at for label in picture.labels}
    assert at["F₁′"][0] == pytest.approx(rays._at(50, 0)[0])
    assert at["F′"][0] == pytest.approx(rays._at(35 + back + f, 0)[0])
    assert abs(at["image"][1] - at["F′"][1]) > 14  # px: both can be read
    assert abs(at["image"][1] - at["F₁′"][1]) > 14


def test_names_of_near_lenses_stand_on_their_two_sides():
    for gap, anchor in ((20, "end"), (80, "middle")):
        labels = {
            label.text: label for label in RAYS(150, 50, rays.SPREADING, 30, gap).pictures[0].labels
        }
        assert (labels["lens 1"].anchor, labels["lens 2"].anchor) == (anchor, "start")


def test_principal_planes_belong_to_two_lenses():
    assert not [t for t in texts(RAYS(150, 60, rays.ONE, 30, 30).pictures[0]) if t.startswith("H")]
    planes = RAYS(150, 50, rays.SPREADING, 30, 30).pictures[0]
    assert {"H", "H′"} <= set(texts(planes))


def test_a_virtual_image_is_dashed_and_named():
    frame = RAYS(40, 60)
    assert value(frame, "Image behind the lens") == -120
    assert "virtual image" in texts(frame.pictures[0])
    assert [line for line in frame.pictures[0].lines if line.dashed and line.role == "ray"]


def test_parallel_rays_make_no_image():
    for frame in (RAYS(60, 60, rays.ONE, 30, 30), RAYS(300, 50, rays.SPREADING, 30, 30)):
        assert (frame.readouts[0].value, frame.readouts[0].unit) == ("∞", "")
        assert (frame.readouts[1].value, frame.readouts[1].unit) == ("–", "")
        assert not [t for t in texts(frame.pictures[0]) if "image" in t]


def test_one_lens_has_no_numbers_of_a_system():
    assert [r.label for r in RAYS(150, 60).readouts] == ["Image behind the lens", "Magnification"]


@pytest.mark.parametrize(
    ("Z", "words"),
    [(65, "image 780 mm behind the lens →"), (55, "← virtual image 660 mm before the lens")],
)
def test_an_image_out_of_the_picture_is_announced(Z, words):
    assert words in texts(RAYS(Z, 60).pictures[0])


def test_light_of_a_far_object_comes_in_parallel_and_leaves_a_telescope_so():
    frame = RAYS(1e6, 50, rays.SPREADING, 30, 20)
    drawn = [line for line in frame.pictures[0].lines if line.role == "ray" and line.width == 2.0]
    assert len(drawn) == 3
    for line in drawn:
        (_, v0), (_, v1), *_, (_, v2), (_, v3) = np.asarray(line.points)
        assert v0 == pytest.approx(v1, abs=0.1)
        assert v2 == pytest.approx(v3, abs=0.1)
    assert [reading.value for reading in frame.readouts[:2]] == ["∞", "–"]
    assert value(frame, "Focal length of the whole") == np.inf
    assert not [x for x in frame.pictures[0].lines if x.dashed and x.role == "ray"]
    assert "← object 1000 m away" in texts(frame.pictures[0])
    assert value(RAYS(1e6, 50, rays.SPREADING, 30, 30), "Focal length of the whole") == 150


# The window


def test_both_blurs_are_equal_at_the_best_aperture():
    best = window.best_aperture(85, 2, 0.5)
    blur = window.blur_at_ends(best, 85, 2, 0.5)
    assert blur.defocus == pytest.approx(blur.airy)
    totals = [window.blur_at_ends(best * k, 85, 2, 0.5).total for k in (0.9, 1.0, 1.1)]
    assert int(np.argmin(totals)) == 1


def test_both_ends_have_the_same_defocus():
    blur = window.blur_at_ends(4, 50, 1, 0.7)
    far = optics.circle_of_confusion(1700, blur.focus, 50, 4)
    assert blur.defocus == pytest.approx(far)


def contrast(frame):
    return frame.pictures[2].image.astype(float).std()


def test_the_letters_are_clearest_near_the_best_aperture():
    stops = (2, 4, 8, 16, 32)
    seen = [contrast(WINDOW(N, 85, 2, 0.5, 13.5)) for N in stops]
    assert stops[int(np.argmax(seen))] == 16
    assert window.best_aperture(85, 2, 0.5) == pytest.approx(16, rel=0.05)


def test_the_image_of_a_point_is_as_wide_as_its_blur():
    def width(N):
        light = WINDOW(N, 85, 2, 0.5, 13.5).pictures[1].image[..., 0].astype(float)
        row = (light[window.SIDE // 2 + 3] / 255) ** 2.2  # beside a line of the grid
        return np.count_nonzero(row > 0.5) / window.CELL

    defocus = value(WINDOW(4, 85, 2, 0.5, 13.5), "Defocus at the ends")
    assert width(4) == pytest.approx(defocus, rel=0.15)
    airy = value(WINDOW(32, 85, 2, 0.5, 13.5), "Airy disk")
    # The half-maximum of an Airy pattern lies at 0.42 of its dark ring's diameter.
    assert 0.42 * airy < width(32) < airy


def test_words_on_the_dark_picture_lie_on_light_paper():
    picture = WINDOW(16, 85, 2, 0.5, 13.5).pictures[1]
    for label in picture.labels:
        u, v = (round(place) for place in label.at)
        reach = slice(u - 100, u) if label.anchor == "end" else slice(u, u + 70)
        assert (picture.image[v - 5 : v + 5, reach] > 200).all(), label.text


def test_a_spot_that_fills_the_picture_is_said_to():
    for pitch, wide in ((3.5, True), (13.5, False)):
        point = WINDOW(2.8, 85, 2, 0.5, pitch).pictures[1]
        assert ("is wider than this picture" in texts(point)) is wide
        assert bool(point.image[60:200].min() > 200) is wide  # all of it is light


def test_curves_run_through_the_marked_point():
    picture = WINDOW(8, 85, 2, 0.5, 13.5).pictures[0]
    total, dot = np.asarray(picture.lines[5].points), np.asarray(picture.lines[7].points)
    middle = dot.mean(axis=0)
    assert np.nanmin(np.linalg.norm(total - middle, axis=1)) < 2


# Axes


def test_axes_take_their_ends_to_their_corners_and_leave_the_rest_out():
    plot = Plot((10, 110, 20, 70), (1, 100), (0, 5), log_x=True)
    np.testing.assert_allclose(
        plot.pixels([1, 10, 100], [0, 2.5, 5]), [(10, 70), (60, 45), (110, 20)]
    )
    assert np.isnan(plot.pixels([0.5, 10, 10], [1, 6, -1])).all()
    assert plot.at(10, 2.5, 1, 2) == (61, 47)
