"""The explorers of chapter 08 compute what they show."""

import numpy as np
import pytest
from real_data import fetched

from course_lib import data
from course_lib.drawing.explorers import epipolar as lines
from course_lib.drawing.explorers import pairs, ransac, rectification
from course_lib.drawing.explorers.trails import Trail
from course_lib.epipolar import (
    eight_point,
    epipolar_lines,
    fundamental_from_cameras,
    line_distance,
    sampson_error,
)
from course_lib.homogeneous import apply_homography

ARRANGEMENTS = list(pairs.EYES)


def value(frame, label):
    (reading,) = (r for r in frame.readouts if r.label == label)
    return reading.value


def by_role(picture, role):
    return [np.asarray(drawn.points) for drawn in picture.lines if drawn.role == role]


def fundamental(arrangement, width=lines.WIDTH):
    return fundamental_from_cameras(*(c.P for c in pairs.cameras(arrangement, width)))


# The street


@pytest.mark.parametrize("arrangement", ARRANGEMENTS)
def test_true_pairs_are_seen_by_both_cameras_and_keep_to_their_lines(arrangement):
    one, other, points = pairs.true_pairs(arrangement, 480)
    assert len(one) == len(other) == len(points) == 80
    both = pairs.cameras(arrangement, 480)
    for camera, seen in zip(both, (one, other), strict=True):
        np.testing.assert_allclose(camera.project(points), seen, atol=1e-6)
        assert ((seen > 0) & (seen < camera.image_size)).all()
    F = fundamental(arrangement, 480)
    assert line_distance(other, epipolar_lines(one, F)).max() < 1e-6


def test_a_pixel_of_the_road_is_as_far_as_the_height_of_the_camera_says():
    camera = pairs.cameras(pairs.APART, 480)[0]
    (point,) = pairs.surface(camera, np.array([[250.0, 340.0]]))
    assert point[2] == pytest.approx(0, abs=1e-9)
    np.testing.assert_allclose(camera.project(point), [250, 340], atol=1e-9)


# What the pointer draws


@pytest.mark.parametrize("arrangement", ARRANGEMENTS)
def test_the_trail_of_a_pixel_lies_on_its_epipolar_line(arrangement):
    one, other = pairs.cameras(arrangement, lines.WIDTH)
    trail = Trail.between(one, other, 1, 0.5, (4.0, 10.0))
    for at in ([40.0, 60], [300, 200], [170, 100]):
        (line,) = epipolar_lines([at], fundamental(arrangement))
        on = np.vstack([trail.path(at), trail.spots(at)])
        on = on[np.isfinite(on).all(axis=1)]  # a depth may be behind the other camera
        assert len(on) >= 3
        assert line_distance(on, line).max() < 1e-3 * np.abs(on).max() ** 0.5
        ray = one.pixel_ray(np.array(at))
        point = one.centre + 10 * ray / (ray @ one.R[2])
        np.testing.assert_allclose(trail.spots(at)[1], other.project(point), atol=1e-9)


def test_a_trail_ends_where_the_ray_does():
    one, other = pairs.cameras(pairs.TOWARDS, lines.WIDTH)
    trail, at = Trail.between(one, other, 1, 2.0), np.array([235.0, 35])
    ray = one.pixel_ray(at)
    far, near = (other.project(one.centre + z * ray / (ray @ one.R[2])) for z in (1e9, 2.0))
    np.testing.assert_allclose(trail.path(at)[0], far, atol=1e-4)
    if np.isfinite(near).all():
        np.testing.assert_allclose(trail.path(at)[1], near, atol=1e-6)


@pytest.mark.parametrize(
    ("w", "slope", "expected"),
    [
        (1.0, 0.0, (0.0, 4.0)),
        (1.0, -0.5, (0.0, 1.998)),
        (-1.0, 0.5, (2.002, 4.0)),
        (-1.0, 0.1, (np.nan, np.nan)),
        (-1.0, 0.0, (np.nan, np.nan)),
        (0.0, 0.0, (np.nan, np.nan)),
    ],
)
def test_only_what_is_in_front_has_an_image(w, slope, expected):
    from course_lib.drawing.explorers.trails import _in_front

    assert _in_front(w, slope, 4.0) == pytest.approx(expected, nan_ok=True)


# The epipolar explorer


@pytest.mark.parametrize("arrangement", ARRANGEMENTS)
def test_the_line_is_that_of_the_fundamental_matrix_and_the_candidate_is_on_it(arrangement):
    frame = lines.epipolar_frame(arrangement, 120, 140, 12.0)
    (line,) = epipolar_lines([[120, 140]], fundamental(arrangement))
    (drawn,) = by_role(frame.pictures[1], "ray")
    assert line_distance(drawn[:1], line).max() < 1e-6
    where = value(frame, "Candidate on the right")
    if where != "outside":
        place = np.array(where.strip("()").split(","), float)
        assert line_distance(place, line) < 0.75  # it is shown in whole pixels


def test_a_candidate_outside_has_no_number_and_no_unit():
    frames = [lines.epipolar_frame(pairs.APART, u, 140, Z) for u in (20, 320) for Z in (4, 60)]
    there = [value(frame, "Candidate on the right") != "outside" for frame in frames]
    assert {*there} == {True, False}
    for frame, shown in zip(frames, there, strict=True):
        _, where, difference = frame.readouts
        assert (where.unit, difference.unit) == (("px", "grey levels") if shown else ("", ""))


def test_at_the_true_depth_the_two_patches_look_alike():
    camera = pairs.cameras(pairs.APART, lines.WIDTH)[0]
    one, _, points = pairs.true_pairs(pairs.APART, lines.WIDTH)
    depths = (points - camera.centre) @ camera.R[2]
    read = []
    for at, depth in zip(one[:30], depths[:30], strict=True):
        frames = [lines.epipolar_frame(pairs.APART, *at, k * depth) for k in (1, 1.3)]
        texts = [value(frame, "The two patches differ by") for frame in frames]
        if "–" not in texts:
            read.append([float(text) for text in texts])
    true, wrong = np.median(read, axis=0)
    assert len(read) > 10
    assert true < 0.6 * wrong


def test_the_epipole_is_marked_only_where_it_is_inside():
    for arrangement in ARRANGEMENTS:
        frame = lines.epipolar_frame(arrangement, 100, 100, 10.0)
        for picture in frame.pictures[:2]:
            named = [label.text for label in picture.labels if label.text == "epipole"]
            assert len(named) == (arrangement == pairs.AHEAD)
    (ring,) = by_role(frame.pictures[1], "image")
    F = fundamental(pairs.AHEAD)
    assert np.abs(F.T @ np.append(ring.mean(axis=0), 1)).max() < 1e-3 * np.abs(F).max()


@pytest.mark.parametrize("at", [(100, 100), (240, 160), (190, 126), (150, 128), (169, 20)])
def test_the_names_of_epipole_and_candidate_do_not_overlap(at):
    for Z in (6, 10, 20, 55):
        names = {n.text: n.at for n in lines.epipolar_frame(pairs.AHEAD, *at, Z).pictures[1].labels}
        if "candidate" in names:
            assert abs(names["candidate"][1] - names["epipole"][1]) >= lines.ABOVE


def test_more_draws_than_a_million_are_not_counted():
    assert value(ransac.ransac_frame(1, 30.0, 1.0), "Draws needed, by the best") == (
        "more than a million"
    )
    assert int(value(ransac.ransac_frame(300, 30.0, 1.0), "Draws needed, by the best")) < 200
    none = ransac.ransac_frame(1, 30.0, 1e-9)
    assert value(none, "Most so far") == "0, draw 1"
    assert value(none, "Draws needed, by the best") == "more than a million"


# RANSAC


def test_the_stepper_draws_what_it_says():
    drawn = ransac.drawn(30.0)
    assert drawn.right.sum() == 42
    for n in (1, 18):
        sample = drawn.samples[n - 1]
        assert len(set(sample.tolist())) == ransac.SAMPLE
        F = eight_point(drawn.points1[sample], drawn.points2[sample])
        errors = sampson_error(drawn.points1, drawn.points2, F)
        frame = ransac.ransac_frame(n, 30.0, 1.0)
        assert value(frame, "Agree with this draw") == f"{(errors <= 1).sum()} of 60"
        good = drawn.right[sample].sum()
        assert value(frame, "Right pairs in this sample") == f"{good} of 8"


def test_the_best_so_far_never_gets_worse_and_wrong_pairs_are_wrong():
    most = [
        int(value(ransac.ransac_frame(n, 20.0, 1.0), "Most so far").split(",")[0])
        for n in (1, 10, 40, 120, 300)
    ]
    assert most == sorted(most)
    drawn = ransac.drawn(20.0)
    F = fundamental(pairs.TOWARDS, ransac.WIDTH)
    errors = sampson_error(drawn.points1, drawn.points2, F)
    assert errors[drawn.right].max() < 4 * ransac.NOISE
    assert np.median(errors[~drawn.right]) > 10


# Rectification


@pytest.mark.parametrize("pair", [rectification.STREET, rectification.BOARD])
def test_on_the_way_lines_stay_the_partners_lines_and_end_as_rows(pair):
    if pair == rectification.BOARD:
        fetched("opencv_stereo/left01.jpg")
    views = rectification.two_views(pair)
    for s in (0.0, 0.4, 1.0):
        frame = rectification.rectification_frame(s, pair)
        H1, H2, _ = rectification.turned(views, s)
        for k, (H, points) in enumerate(((H1, views.points1), (H2, views.points2))):
            spots = [
                np.asarray(line.points).mean(axis=0)
                for line in frame.pictures[k].lines
                if line.closed
            ]
            np.testing.assert_allclose(spots, apply_homography(points, H)[views.shown], atol=1e-6)
            strokes = [line.points for line in frame.pictures[k].lines if not line.closed]
            for stroke, spot in zip(strokes, spots, strict=True):
                line = np.cross(np.append(stroke[0], 1), np.append(stroke[1], 1))
                assert line_distance(spot, line) < 0.3
    assert float(value(frame, "Rows differ by (RMS)")) < 0.1
    assert float(value(frame, "Steepest line on the right")) < 0.005
    start = rectification.rectification_frame(0.0, pair)
    assert float(value(start, "Rows differ by (RMS)")) > 5


def test_without_photographs_the_street_takes_their_place(monkeypatch):
    def missing():
        raise data.Unavailable("no network")

    monkeypatch.setattr(rectification, "stereo_boards", missing)
    rectification.two_views.cache_clear()
    try:
        street = rectification.two_views(rectification.STREET)
        assert rectification.two_views(rectification.BOARD) is street
    finally:
        rectification.two_views.cache_clear()
