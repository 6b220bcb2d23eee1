from dataclasses import replace

import numpy as np
import pytest

from course_lib.calibrating.judgement import judge
from course_lib.calibrating.solving import solve
from course_lib.calibrating.turned import Views, turned_views
from course_lib.calibration import CameraModel


@pytest.fixture(scope="module")
def views(run):
    """The eight good photographs, with a lens that sits a little beside the sensor's middle."""
    used = run.solved.views
    points = run.solved.board.points()
    pixels = [p.detection.points + np.array([12, 8]) for p in used]
    return Views([points[p.detection.ids] for p in used], pixels, (480, 360))


def pinhole(points, K, R, t):
    x = (points @ R.T + t) @ K.T
    return x[:, :2] / x[:, 2:]


def changed(views, which, across, down):
    """Some views as they are after a program has turned or mirrored the picture."""
    pixels = list(views.pixels)
    objects = list(views.objects)
    for i in which:
        pixels[i] = np.where([across, down], np.array(views.size) - 1 - pixels[i], pixels[i])
        if across != down:  # the detector never sees a board from behind, so it counts from the end
            objects[i] = objects[i] * (-1, 1, 1)
    return Views(objects, pixels, views.size)


def test_nothing_was_turned(views):
    assert turned_views(views, CameraModel()) == {}


@pytest.mark.parametrize("which", [[4], [0, 2, 5], [1, 2, 3, 6, 7]])
def test_upside_down(views, which):
    told = turned_views(changed(views, which, True, True), CameraModel())
    fewer = which if len(which) < 4 else [0, 4, 5]
    assert sorted(told) == fewer
    assert all("is upside down against the others" in said for said in told.values())
    assert all("Take the original" in said for said in told.values())


@pytest.mark.parametrize(
    ("way", "said"), [((True, False), "left for right"), ((False, True), "top for bottom")]
)
def test_mirrored(views, way, said):
    told = turned_views(changed(views, [2, 5], *way), CameraModel())
    assert sorted(told) == [2, 5]
    assert all(said in sentence for sentence in told.values())


def test_a_lens_right_in_the_middle_that_bends_nothing_cannot_tell(run):
    """Half a turn leaves such a camera as it is, so nothing must be set aside."""
    camera, points = run.solved.calibration, run.solved.board.points()
    K = np.array([[camera.K[0, 0], 0, 239.5], [0, camera.K[1, 1], 179.5], [0, 0, 1]])
    noise = np.random.default_rng(3)
    pixels = [
        pinhole(points, K, R, t) + noise.normal(0, 0.1, (len(points), 2)) for R, t in camera.poses
    ]
    views = Views([points] * len(pixels), pixels, (480, 360))
    assert turned_views(changed(views, [1, 4], True, True), CameraModel()) == {}


def test_the_camera_stays_the_same(run):
    photos, points = list(run.solved.views), run.solved.board.points()
    pixels = [p.detection.points for p in photos]
    as_taken = Views([points[p.detection.ids] for p in photos], pixels, (480, 360))
    turned = changed(as_taken, [1, 3, 6], True, True)
    for i in (1, 3, 6):
        found = replace(photos[i].detection, points=turned.pixels[i])
        photos[i] = replace(photos[i], detection=found)
    solved = solve(photos, run.solved.board, CameraModel())
    assert [p.problem for p in solved.photos].count("turned") == 3
    alone = [p for i, p in enumerate(run.solved.views) if i not in (1, 3, 6)]
    expected = solve(alone, run.solved.board, CameraModel()).calibration
    np.testing.assert_allclose(solved.calibration.K, expected.K, atol=1e-6)
    texts = [s.text for s in judge(solved).statements]
    assert any(t.startswith("view2.png, view4.png, view7.png: upside down against") for t in texts)
