from dataclasses import replace

import numpy as np
import pytest

from course_lib.optics import airy_diameter, circle_of_confusion
from course_lib.planning import (
    Box,
    Setup,
    Task,
    aperture_window,
    judge_setup,
    read_cameras,
    read_lenses,
)
from course_lib.triangulation import triangulate

CAMERA = read_cameras()["mvBlueFOX3-2024a"]
LENS = replace(read_lenses()["Computar M2514-MP2"], image_circle_mm=13.4)  # as its sensor wants
BOX = Box([0.25, 0.1, 0.2])
NORMAL = np.array([0, -1.0, 0])
TASK = Task(BOX, NORMAL, resolution=3e-4, motion=0.005, speed=0.2, frame_rate=30, sigma=3e-4)
GOOD = Setup(CAMERA, LENS, [0, -1, 0], [0, 0, 0], N=5.6, exposure_time=1 / 1000, focus_distance=1)
OTHER = replace(GOOD, eye=[0.3, -0.95, 0])


def verdict(name, setup=GOOD, task=TASK, second=OTHER):
    (found,) = (v for v in judge_setup(setup, task, second) if v.name == name)
    return found


class TestVerdicts:
    def test_a_good_setup_meets_every_demand(self):
        verdicts = judge_setup(GOOD, TASK, OTHER)
        assert [v.name for v in verdicts if not v.met] == []
        assert len(verdicts) == 10
        assert all(v.reason.endswith(".") and not v.remedy for v in verdicts)

    def test_one_camera_is_not_asked_about_space(self):
        assert len(judge_setup(GOOD, TASK)) == 9

    @pytest.mark.parametrize(
        ("name", "setup", "task"),
        [
            ("in view", {"target": [0.1, 0, 0]}, {}),
            ("resolution", {"eye": [0, -2.5, 0], "focus_distance": 2.5}, {}),
            ("depth of field", {"N": 1.4}, {}),
            ("depth of field", {"focus_distance": 0.8}, {}),
            ("diffraction", {"N": 16}, {}),
            ("closest focus", {"focus_distance": 0.25}, {}),
            ("image circle", {"lens": read_lenses()["Computar M2514-MP2"]}, {}),
            ("motion blur", {"exposure_time": 1 / 60}, {}),
            ("frame rate", {"exposure_time": 1 / 20}, {}),
            ("frame rate", {}, {"frame_rate": 100}),
            ("light", {"N": 8}, {"exposure_at_f1": 2e-5}),
            ("expected σ", {}, {"sigma": 1e-5}),
        ],
    )
    def test_names_the_demand_that_is_not_met(self, name, setup, task):
        found = verdict(name, replace(GOOD, **setup), replace(TASK, **task))
        assert not found.met
        assert found.reason.endswith(".")
        assert found.remedy.endswith(".")

    def test_blur_is_that_of_the_worse_end(self):
        found = verdict("depth of field")
        ends = circle_of_confusion([950, 1050], 1000, 25, 5.6) * 1000 / 5.86
        assert found.value == pytest.approx(ends.max())

    def test_the_remedy_of_the_depth_of_field_works(self):
        window = aperture_window(25, 0.95, 1.05, 1.5 * 5.86)
        assert window.is_open
        mended = replace(GOOD, N=window.least, focus_distance=window.focus_distance)
        assert verdict("depth of field", mended).met
        assert not verdict("depth of field", replace(mended, N=0.99 * window.least)).met

    def test_without_a_window_the_remedy_says_so(self):
        deep = replace(TASK, box=Box([0.1, 0.9, 0.1]))
        assert "No f-number does it" in verdict("depth of field", task=deep).remedy

    def test_the_remedy_of_diffraction_works(self):
        closed = verdict("diffraction", replace(GOOD, N=16))
        N = 16 * closed.limit / closed.value
        assert verdict("diffraction", replace(GOOD, N=N - 1e-9)).met

    def test_a_slow_camera_is_not_told_to_expose_for_less_time(self):
        slow = verdict("frame rate", task=replace(TASK, frame_rate=100))
        assert "faster camera" in slow.remedy
        long = verdict("frame rate", replace(GOOD, exposure_time=1 / 20))
        assert long.remedy == "Expose for less time."

    def test_the_remedy_of_light_works(self):
        """Four times the f-number needs sixteen times the time."""
        task = replace(TASK, exposure_at_f1=1 / 16000)
        assert verdict("light", replace(GOOD, N=4), task).met
        found = verdict("light", replace(GOOD, N=8), task)
        assert found.limit == pytest.approx(4000)
        assert "f/4," in found.remedy
        assert not verdict("light", replace(GOOD, N=4.01), task).met

    def test_expected_sigma_is_the_scatter_of_simulated_points(self):
        """The worst corner, along its worst axis: 2000 triangulations."""
        rng = np.random.default_rng(0)
        views = GOOD.view, OTHER.view
        spreads = []
        for corner in BOX.corners:
            many = np.repeat(corner[None], 2000, axis=0)
            seen = [v.project(many) + 0.1 * rng.standard_normal((2000, 2)) for v in views]
            found = triangulate(*seen, *(v.P for v in views))
            spreads.append(np.sqrt(np.linalg.eigvalsh(np.cov(found.T)).max()))
        assert verdict("expected σ").value == pytest.approx(1000 * max(spreads), rel=0.06)

    def test_a_lens_of_the_same_format_covers_the_sensor(self):
        """2/3 inch: a circle of 11 mm, a sensor of 11.07 mm; both are nominal."""
        small = replace(
            GOOD, camera=read_cameras()["mvBlueFOX3-2051"], lens=read_lenses()[LENS.name]
        )
        assert verdict("image circle", small).met
        assert not verdict("image circle", replace(small, camera=CAMERA)).met


class TestErrors:
    def test_a_lens_must_fit(self):
        with pytest.raises(ValueError, match="choose a lens that fits"):
            replace(GOOD, lens=read_lenses()["Zeiss Milvus 1.4/85"])

    def test_a_box_around_the_camera_has_no_depth(self):
        with pytest.raises(ValueError, match="behind the camera: move the camera away"):
            judge_setup(GOOD, replace(TASK, box=Box([1, 3, 1])))

    @pytest.mark.parametrize("name", ["N", "exposure_time", "focus_distance"])
    def test_settings_must_be_positive(self, name):
        with pytest.raises(ValueError, match=f"{name} must be positive"):
            replace(GOOD, **{name: 0})


class TestApertureWindow:
    def test_spots_at_its_ends_are_as_large_as_allowed(self):
        window = aperture_window(50, 0.9, 1.1, 12)
        focus = 1000 * window.focus_distance
        spots = circle_of_confusion([900, 1100], focus, 50, window.least)
        np.testing.assert_allclose(spots, 0.012)
        m = 50 / (focus - 50)
        assert airy_diameter(550e-6, window.most * (1 + m)) == pytest.approx(0.012)

    def test_a_flat_plate_needs_no_stopping_down_and_a_deep_box_has_no_window(self):
        assert aperture_window(50, 0.999, 1.001, 12).least < 1
        assert not aperture_window(50, 0.7, 1.5, 12).is_open
