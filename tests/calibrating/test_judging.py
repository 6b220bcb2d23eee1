from dataclasses import replace

import numpy as np
import pytest

from course_lib.boards import DotGrid
from course_lib.calibrating.judgement import judge, missing_places
from course_lib.calibrating.looking import Photo
from course_lib.calibrating.photographs import on_distance
from course_lib.calibrating.pictures import Header
from course_lib.calibrating.precision import angle_sigma, length_sigma
from course_lib.calibrating.solving import solve
from course_lib.calibration import CameraModel, coverage
from course_lib.detection import Detection, detect_board
from data_generators.calibration_sets import calibration_set


def levels(judgement, words):
    """The levels of the statements that hold these words."""
    return [s.level for s in judgement.statements if words in s.text]


class TestCamera:
    def test_is_the_true_one(self, run, truth):
        camera = run.solved.calibration
        np.testing.assert_allclose(camera.K, truth.K, rtol=5e-4)
        np.testing.assert_allclose(camera.coefficients[:4], truth.coefficients[:4], atol=0.01)
        assert camera.rms < 0.06

    def test_poses_are_the_true_ones(self, run, truth):
        for (R, t), view in zip(run.solved.calibration.poses, truth.views, strict=False):
            np.testing.assert_allclose(R, view.R, atol=5e-3)
            np.testing.assert_allclose(t, view.t, rtol=0.01, atol=1)

    def test_dots_lose_their_bias(self):
        board = DotGrid(8, 6, 30, 20)
        pictures = calibration_set(
            6, rng=np.random.default_rng(2), board=board, image_size=(480, 360)
        )
        photos = [photographed(view.picture, board, i) for i, view in enumerate(pictures.views)]
        solved = solve(photos, board, CameraModel(coefficients=("k1", "k2", "p1", "p2")))
        raw = [p.detection.points - v.points for p, v in zip(photos, pictures.views, strict=True)]
        corrected = [p - v.points for p, v in zip(solved.pixels, pictures.views, strict=True)]
        assert np.mean(np.square(corrected)) < 0.2 * np.mean(np.square(raw))
        assert solved.calibration.rms < 0.06


def photographed(picture, board, number):
    from pathlib import Path

    path = Path(f"view{number}.png")
    header = Header(path, picture.shape[::-1], 0.0, str(number))
    return Photo(path, "", True, "", header, detect_board(picture, board), picture)


class TestStatements:
    def test_a_good_set(self, run):
        judgement = run.judgement
        assert levels(judgement, "typical point") == ["good"]
        assert levels(judgement, "photographs were used") == ["note"]
        assert levels(judgement, "The board is tilted") == ["good"]
        assert levels(judgement, "What that means") in (["good"], ["note"])
        assert levels(judgement, "10 photographs were set aside: 4 unreadable") == ["note"]

    def test_bad_things_come_first(self, run):
        order = {"bad": 0, "note": 1, "good": 2}
        ranks = [order[s.level] for s in run.judgement.statements]
        assert ranks == sorted(ranks)

    def test_few_views(self, run):
        photos = [p for p in run.photos.values() if p.used][:4]
        judgement = judge(solve(photos, run.solved.board, CameraModel(coefficients=("k1",))))
        assert levels(judgement, "Only 4 photographs") == ["bad"]
        assert not judgement.fine

    def test_a_slipped_corner_is_named(self, run):
        photos = [p for p in run.photos.values() if p.used]
        found = photos[2].detection
        points = found.points.copy()
        points[4] += (3, -2)
        slipped = replace(photos[2], detection=replace(found, points=points))
        photos[2] = slipped
        solved = solve(photos, run.solved.board, CameraModel())
        assert any(
            "view3.png: 1 of 35 points left out, up to 3." in reason for reason in solved.reasons
        )
        assert not solved.kept[2][4]
        np.testing.assert_allclose(solved.calibration.K, run.solved.calibration.K, rtol=0.01)

    def test_a_photograph_that_does_not_fit_is_set_aside(self, run):
        photos = [p for p in run.photos.values() if p.used]
        found = photos[5].detection
        mixed = np.random.default_rng(0).permutation(found.points)
        photos[5] = replace(photos[5], detection=replace(found, points=mixed))
        solved = solve(photos, run.solved.board, CameraModel())
        assert not solved.photos[5].used
        assert solved.photos[5].problem == "does not fit"
        assert "view6.png was left out" in solved.photos[5].verdict
        assert len(solved.views) == 7

    @pytest.mark.parametrize(("factor", "level"), [(1.04, "good"), (1.3, "note")])
    def test_focal_length_of_the_files(self, run, factor, level):
        f = float(np.mean(np.diag(run.solved.calibration.K)[:2]))
        told = factor * f * np.hypot(36, 24) / np.hypot(480, 360)
        views = tuple(replace(p, header=replace(p.header, focal_35=told)) for p in run.solved.views)
        judgement = judge(replace(run.solved, views=views))
        assert levels(judgement, f"is about {factor * f:.0f} px; calibrated, it is {f:.0f}") == [
            level
        ]

    def test_boards_that_face_the_camera(self, run):
        poses = tuple((np.eye(3), t) for _, t in run.solved.calibration.poses)
        camera = replace(run.solved.calibration, poses=poses)
        judgement = judge(replace(run.solved, calibration=camera))
        assert levels(judgement, "in 0 photographs only") == ["bad"]

    @pytest.mark.parametrize(
        ("farther", "words", "level"),
        [(1.2, "All boards were about equally far", "note"), (1.5, "was 1.5 times as far", "good")],
    )
    def test_range_of_distances(self, run, farther, words, level):
        middle = run.solved.board.points().mean(axis=0)
        facing = [np.array([0, 0, z]) - middle for z in (500, 500 * farther, 550)]
        camera = replace(run.solved.calibration, poses=tuple((np.eye(3), t) for t in facing))
        *_, said = on_distance(replace(run.solved, calibration=camera))
        assert said.level == level
        assert words in said.text

    def test_range_of_distances_is_told(self, run):
        assert levels(run.judgement, "Only between them is the camera tested") == ["good"]

    def test_large_residuals(self, run):
        camera = replace(run.solved.calibration, rms=3.0)
        judgement = judge(replace(run.solved, calibration=camera))
        assert levels(judgement, "times that): too much") == ["bad"]
        assert levels(judgement, "not too many --coefficients") == ["note"]

    def test_held_out(self, run):
        judgement = judge(replace(run.solved, held_out=np.full(8, 1.0)))
        assert levels(judgement, "fits these pictures only") == ["bad"]


class TestCoverage:
    def test_missing_places(self):
        u, v = np.meshgrid(np.arange(0, 640, 10.0), np.arange(0, 480, 10.0))
        everywhere = np.stack([u.ravel(), v.ravel()], axis=1)
        assert missing_places(coverage([everywhere], (640, 480))) == []
        left = everywhere[everywhere[:, 0] < 400]
        missing = missing_places(coverage([left], (640, 480)))
        assert set(missing) == {"upper right corner", "right edge", "lower right corner"}


class TestPrecision:
    def test_length_follows_the_focal_length(self, run):
        camera = run.solved.calibration
        larger = replace(camera, covariance=4 * camera.covariance)
        assert length_sigma(larger) == pytest.approx(2 * length_sigma(camera))
        fx, fy = camera.sigma["fx"], camera.sigma["fy"]
        assert length_sigma(camera) <= max(fx, fy) / camera.K[0, 0]

    def test_angle_of_a_camera_with_one_uncertain_number(self, run):
        camera = run.solved.calibration
        only_fx = np.zeros_like(camera.covariance)
        only_fx[0, 0] = 1.0  # px²
        pinhole = replace(
            camera, covariance=only_fx, coefficients=np.zeros(5), K=np.diag([400.0, 400, 1])
        )
        centred = pinhole.K.copy()
        centred[:2, 2] = (np.array(camera.image_size) - 1) / 2
        pinhole = replace(pinhole, K=centred)
        # On the axis u, tan θ = x / f: dθ = sin θ cos θ / f; the mean over the picture is smaller.
        steepest = 0.5 / 400
        assert 0.2 * steepest < angle_sigma(pinhole) < steepest

    def test_what_the_middle_does_is_no_error(self, run):
        camera = run.solved.calibration
        only_cx = np.zeros_like(camera.covariance)
        index = list(camera.sigma).index("cx")
        only_cx[index, index] = 1.0
        moved = angle_sigma(replace(camera, covariance=only_cx))
        # A shift of 1 px is nearly a turn of the whole camera by 1/f.
        assert moved < 0.4 / camera.K[0, 0]


def test_detection_of_photo_is_kept(run):
    assert isinstance(run.photos["view1.png"].detection, Detection)
