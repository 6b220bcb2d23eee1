"""The capstone of chapter 11: any set-up that meets the demands is right; each has its share."""

import itertools
import re
import types

import numpy as np
import pytest

from course_lib.camera import Camera
from course_lib.exercises.planning import PLAN_SETUP, demands, setup_inputs, setup_misconceptions
from course_lib.exercises.planning.plain_setup import plan_setup
from course_lib.judging import answer, judge, pose
from course_lib.judging.text import to_text
from course_lib.optics import airy_diameter, circle_of_confusion, magnification
from course_lib.planning import Box, box_in_view
from course_lib.sensor import motion_blur_pixels

#: The reference as a student would have typed it: calls of the reference itself are told apart.
typed = types.FunctionType(
    plan_setup.__code__.replace(co_filename="answer.py"), plan_setup.__globals__
)
DRAWS = ("dark", "bright", "tempting_cameras", "slow", "far_off")
DRAWS += ("with_small_pixels", "with_a_slow_lens", "with_a_far_focus")


def posed(draw, seed=0):
    return getattr(setup_inputs, draw)(np.random.default_rng(seed))


def verdict(function, seed=3, reveal=True):
    cases = pose(PLAN_SETUP, seed)
    return judge(PLAN_SETUP, cases, answer(PLAN_SETUP, function, cases), reveal=reveal)


def with_settings(**changes):
    """Return an answer that changes the right one's settings by factors."""

    def changed(task, cameras, lenses):
        plan = typed(task, cameras, lenses)
        return plan | {key: factor * plan[key] for key, factor in changes.items()}

    return changed


@pytest.fixture(params=itertools.product(DRAWS, range(4)), ids=str)
def given(request):
    inputs = posed(*request.param)
    return inputs, plan_setup(**inputs)


class TestSharesAgreeWithTheLibrary:
    def test_room_in_the_picture(self, given):
        inputs, plan = given
        task, camera = inputs["task"], inputs["cameras"][plan["camera"]]
        size = camera["width"], camera["height"]
        f = inputs["lenses"][plan["lens"]]["f_mm"] * 1e3 / camera["pitch_um"]
        K = [[f, 0, (size[0] - 1) / 2], [0, f, (size[1] - 1) / 2], [0, 0, 1]]
        box = Box([task[side] for side in ("width", "height", "depth")], [0, 0, plan["distance"]])
        moved = box.with_motion([task["motion"], task["motion"], 0])
        seen = box_in_view(moved, Camera(np.array(K), np.eye(3), np.zeros(3), size))
        needed = demands.shares(plan, inputs)["in view"]
        room = max((w - 2 * m) / w for w, m in zip(size, seen.margins[[0, 2]], strict=True))
        assert needed == pytest.approx(room)

    def test_spots_and_smear(self, given):
        inputs, plan = given
        task, camera = inputs["task"], inputs["cameras"][plan["camera"]]
        f_mm, half = inputs["lenses"][plan["lens"]]["f_mm"], task["depth"] / 2
        near, far = 1000 * (plan["distance"] - half), 1000 * (plan["distance"] + half)
        focus, spot = 2 * near * far / (near + far), task["blur_px"] * camera["pitch_um"] / 1000
        needed = demands.shares(plan, inputs)
        ends = circle_of_confusion([near, far], focus, f_mm, plan["N"])
        np.testing.assert_allclose(ends / spot, needed["depth of field"])
        airy = airy_diameter(0.55e-3, plan["N"] * (1 + magnification(f_mm, focus)))
        assert needed["diffraction"] == pytest.approx(airy / spot)
        pixel = near / 1000 * camera["pitch_um"] / 1000 / f_mm
        smear = motion_blur_pixels(task["speed"], plan["exposure_time"], pixel)
        assert needed["motion blur"] == pytest.approx(smear / task["blur_px"])


def test_any_set_up_that_meets_the_demands_earns_all_points():
    """Not only the nearest, with the widest aperture and the longest exposure."""
    inputs = posed("dark")
    for farther, wider, shorter in itertools.product((1, 1.03), (1.02, 1.1), (0.8, 0.98)):
        plan = plan_setup(**inputs)
        plan["distance"] *= farther
        plan["N"] *= wider
        plan["exposure_time"] *= shorter
        assert all(demands.judge_demand(d, plan, inputs) is None for d in PLAN_SETUP.parts)
    for seed in range(10):
        change = with_settings(N=1.05, exposure_time=0.95)
        assert verdict(change, seed).points == PLAN_SETUP.points, seed


def test_there_is_room_for_a_reserve():
    def with_reserve(task, cameras, lenses):
        larger = {key: 1.05 * task[key] for key in ("width", "height", "motion")}
        return typed(task | larger, cameras, lenses)

    for seed in range(20):
        assert verdict(with_reserve, seed).points == PLAN_SETUP.points, seed


def test_order_and_type_of_what_is_returned_do_not_matter():
    def turned(task, cameras, lenses):
        plan = typed(task, cameras, lenses)
        return {key: np.float64(plan[key]) for key in reversed(plan)}

    assert verdict(turned).points == PLAN_SETUP.points


@pytest.mark.parametrize(
    ("change", "lost", "words"),
    [
        ({"distance": 0.9}, "in view", "The box is cut off"),
        ({"distance": 1.3}, "resolution", "Too coarse: at the far face"),
        ({"N": 0.8}, "depth of field", "at the ends of the box"),
        ({"N": 2.5}, "diffraction", "Blurred by diffraction: the Airy disk is too large, "),
        ({"exposure_time": 1.25}, "motion blur", "Smeared: .* too far, by 25 %"),
        ({"exposure_time": 1.25}, "frame rate", "Too few pictures a second: .* by 25 %"),
        ({"exposure_time": 0.125}, "light", "Too dark: .* times too much"),
    ],
)
@pytest.mark.parametrize("reveal", [True, False])
def test_names_the_demand_that_fails_and_by_how_much(change, lost, words, reveal):
    found = verdict(with_settings(**change), reveal=reveal)
    (part,) = (p for p in found.parts if p.name == lost)
    assert part.points == 0 < part.possible
    assert re.search(words, part.feedback.message), part.feedback.message
    assert 0 < found.points < PLAN_SETUP.points


def test_the_smear_is_missed_by_as_much_as_the_exposure_is_longer():
    inputs = posed("dark")
    plan = plan_setup(**inputs)
    longer = plan | {"exposure_time": 2.5 * plan["exposure_time"]}
    assert "2.5 times too much" in demands.judge_demand("motion blur", longer, inputs).message


@pytest.mark.parametrize(
    "settings",
    [
        {"distance": 100.0},  # all of it in view, as a dot
        {"exposure_time": 1e-9},  # no smear, and black
        {"N": 1.4, "distance": 60.0, "exposure_time": 1e-7},
    ],
)
def test_giving_up_one_demand_altogether_earns_nothing(settings):
    def constant(task, cameras, lenses):
        return typed(task, cameras, lenses) | settings

    found = verdict(constant)
    assert found.points == 0
    assert "That far off, nothing else counts." in to_text(found)


@pytest.mark.parametrize(
    ("plan", "words"),
    [
        (None, "does one of your demands reject every pair"),
        (3.0, "A dictionary with the keys camera, lens, distance, N, exposure_time was expected"),
        ({"secret": 0}, "not a dictionary without camera, lens, distance, N, exposure_time"),
        ({"camera": 0, "lens": 0, "secret": 0}, "not a dictionary without distance, N, exposure_t"),
        ({"secret again": 0}, "was expected, not a dictionary with more"),
        ({"camera": 7}, "`camera` must be one of the numbers 0 to 2"),
        ({"lens": 0.5}, "`lens` is a number; its number in the list was expected, from 0"),
        ({"distance": 10**400}, "`distance` must be a positive number"),
        ({"camera": float("nan")}, "its number in the list"),
        ({"camera": "the second"}, "`camera` is a text"),
        ({"lens": {"f_mm": 25.0}}, "`lens` is a dictionary"),
        ({"N": "f/4"}, "`N` is a text; a number was expected"),
        ({"N": 64.0}, "This lens goes from f/1.4 to f/16"),
        ({"N": 0.5}, "This lens goes from f/1.4 to f/16"),
        ({"distance": -1.0}, "`distance` must be a positive number"),
        ({"distance": 0.01}, "is `distance` in metres"),
        ({"exposure_time": float("inf")}, "`exposure_time` must be a positive number"),
    ],
)
def test_what_is_no_set_up_is_told_why(plan, words):
    inputs = posed("bright")
    complete = isinstance(plan, dict) and "secret" not in plan
    given = plan_setup(**inputs) | plan if complete else plan
    mismatch = demands.judge_demand("light", given, inputs)
    assert re.search(words, mismatch.message), mismatch.message
    assert "secret" not in mismatch.message  # no text of a student's reaches the verdict


@pytest.mark.parametrize("draw", DRAWS)
def test_there_is_a_set_up_for_every_task(draw):
    for seed in range(200):
        inputs = posed(draw, seed)
        assert max(demands.shares(plan_setup(**inputs), inputs).values()) <= 1 + 1e-9, seed


@pytest.mark.parametrize(
    ("lost", "blind"),
    [
        ("diffraction", {"window_most": np.inf}),
        ("light", {"exposure_at_f1": 0.0}),
        ("distance", {"closest": 0.0}),
    ],
)
def test_a_search_that_looks_away_from_a_demand_loses_its_points(lost, blind):
    """The widest aperture alone does not meet it: a pair that does not do stands first."""

    def search(task, cameras, lenses):
        seen = task | {key: blind[key] for key in blind if key in task}
        closest = [lens | {"closest": blind.get("closest", lens["closest"])} for lens in lenses]
        return setup_misconceptions.search(seen, cameras, closest, airy="window_most" not in blind)

    for seed in range(40):
        found = verdict(search, seed)
        assert {part.name for part in found.parts if part.points < part.possible} == {lost}, seed
