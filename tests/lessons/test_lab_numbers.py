"""Chapter 12: every number in its text is what its cells give with the supplied photographs."""

import ast
import os
import re
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import cv2
import matplotlib as mpl
import numpy as np
import pytest
from lesson_text import LESSONS, lesson_text
from real_data import fetched

mpl.use("Agg")  # as a test has no screen

from course_lib import lab
from course_lib.authoring.expansion import REPORT, expand
from course_lib.authoring.lesson import read_lesson
from course_lib.calibration import calibrate, calibrate_stereo
from course_lib.distortion import distort_pixels
from course_lib.exercises import all_exercises
from course_lib.lab.real_pairs import BOARD, MODEL, NUMBERS, SIZE, corners
from course_lib.measuring import (
    distance_in_space,
    distance_on_plane,
    pointing_sigma,
    rays_miss,
    view_of_target,
)
from course_lib.measuring.shares import SHARED
from data_generators import desk

TEXT = lesson_text("12_lab")
CODE = re.findall(r"```\{code-cell\} ipython3\n(?::tags:.*\n\n)?(.*?)```", TEXT, re.DOTALL)


@pytest.fixture(scope="module")
def cells(tmp_path_factory):
    """Run the lesson's cells from top to bottom, but for that on real photographs."""
    scope, here = {"__name__": "__main__"}, Path.cwd()
    os.chdir(tmp_path_factory.mktemp("12_lab"))
    try:
        for cell in (c for c in CODE if not re.search("measure_(real_pairs|shifts)", c)):
            exec(compile(ast.parse(cell), "cell", "exec"), scope)
    finally:
        os.chdir(here)
    return scope


def test_photographs_and_camera(cells):
    work = cells["work"]
    assert len(work.photos) == 17
    assert work.measuring == (cells["plane_picture"], *cells["space_pictures"])
    TEXT.says("Seventeen supplied photographs", "leave 0.02 px")
    assert round(work.camera.rms, 2) == 0.02
    assert len(work.solved.views) == 12
    assert (work.judgement.coverage.counts > 0).sum() == 45
    assert cells["fx_found"].text("px") == "881.96 px ± 0.14 px (95 %)"
    np.testing.assert_allclose(work.camera.K, desk.intrinsics((1200, 900)), atol=0.4)


def test_a_straightened_photograph(cells, capsys):
    TEXT.says("It was off by 0.42 px, and 0.04 px are left.")
    before, after = (ax.get_title(loc="left") for ax in lab.straightened(cells["work"]).axes)
    assert before == "as taken: 0.42 px off a line, drawn 100 ×"
    assert after == "straightened: 0.04 px off a line, drawn 100 ×"
    assert lab.straightened(replace(cells["work"], photos=())) is None
    assert "so there is no figure here" in capsys.readouterr().out


def test_the_card(cells):
    width = cells["width"]
    assert str(width) == "85.6 mm ± 0.9 mm (95 %)"
    assert width.holds(lab.SUPPLIED.card)
    TEXT.says("| 85.6 mm |", "times 1.96 | ± 0.9 mm |", "0.39 mm by pointing")
    assert round(width.parts["pointing"], 2) == 0.39
    assert max(width.parts, key=width.parts.get) == "pointing"
    assert sorted(width.parts, key=width.parts.get)[-2] == "target"
    assert width.parts["camera"] + width.parts["pose"] < 0.02
    assert width.parts["scale"] == pytest.approx(0.001 * 85.6, rel=0.01)
    assert width.plus_minus == pytest.approx(1.96 * width.sigma, rel=1e-4)


def test_the_part_of_the_target(cells):
    TEXT.says("If each went its own way", "and leave 0.06 mm", "That leaves much more, 0.17 mm.")
    width, shot = cells["width"], cells["shot"]
    assert round(width.parts["target"], 2) == 0.17
    rng, points, found = np.random.default_rng(0), desk.TARGET.points(), []
    for _ in range(300):  # the target is bent, the reader knows nothing of it
        moved = points + rng.normal(0, 0.1, points.shape)
        camera = desk.Camera(shot.view.K, shot.view.R, shot.view.t, (1200, 900))
        seen = distort_pixels(camera.project(moved), shot.view.K, shot.view.coefficients)
        view = view_of_target(points, seen, cells["work"].camera)
        found.append(distance_on_plane(*cells["card"].ends, view).value)
    assert round(float(np.std(found)), 2) == 0.06
    TEXT.says("a quarter of the target's diagonal", "here 59 mm", "25 mm apart share 91 %")
    reach = SHARED * float(np.linalg.norm(np.ptp(points, axis=0)))
    assert SHARED == 0.25
    assert round(reach) == 59
    assert round(100 * np.exp(-(25**2) / (2 * reach**2))) == 91


def test_one_mark_after_the_other_is_moved_by_its_sigma(cells):
    moves = np.abs(np.round(cells["moves"], 3))
    np.testing.assert_allclose(moves, [0.278, 0.026, 0.277, 0.006], atol=0.0011)
    TEXT.says(r"$\sqrt{0.278^2 + 0.026^2 + 0.277^2 + 0.006^2} = 0.39$ mm")
    assert np.linalg.norm(moves) == pytest.approx(0.39, abs=0.005)
    together = np.linalg.norm(cells["moves"])
    assert together == pytest.approx(cells["width"].parts["pointing"], rel=0.01)


def test_how_well_one_points(cells):
    TEXT.says("0.43 px: so 0.5 px")
    assert round(pointing_sigma(cells["attempts"]), 2) == 0.43


def test_a_forgotten_height(cells):
    TEXT.says(r"\frac{457}{457 - 0.76} = 1.0017", "which is 0.14 mm for the card")
    assert round(cells["height"]) == 457
    assert round(457 / (457 - 0.76), 4) == 1.0017
    assert round(85.6 * 0.76 / (457 - 0.76), 2) == 0.14
    shot, ends = cells["shot"], cells["card"].ends
    thin = distance_on_plane(*ends, shot.view, height=0.76)
    assert cells["width"].value - thin.value == pytest.approx(0.14, abs=0.005)


def test_the_lid_on_the_plane(cells):
    length = cells["on_plane"](cells["lid"].ends)
    assert str(length) == "138.2 mm ± 1.2 mm (95 %)"
    TEXT.says("138 mm, and it says ± 1.2 mm!", r"$120\cdot 457/(457 - 60) = 138$")
    assert round(120 * 457 / (457 - 60)) == 138
    assert not length.holds(120)
    lifted = distance_on_plane(*cells["lid"].ends, cells["shot"].view, height=60.0)
    assert lifted.holds(120)


def test_the_lid_in_space(cells):
    assert str(cells["edge"]) == "119.9 mm ± 0.7 mm (95 %)"
    assert cells["edge"].holds(120)
    assert rays_miss([cells["one"].ends, cells["other"].ends], cells["views"]) < 0.5
    assert cells["edge"].parts["pointing"] > cells["edge"].parts["target"] > 0.1


#: Marks between which there is no length, by pointer, and what the lesson calls length and marks.
LOST = {
    "on_plane": ({"card": [(600, 450), (600, 450)]}, "width", "card_ends"),  # on one place
    "in_space": (
        {"one": [(100, 300), (300, 300)], "other": [(1000, 300), (1100, 300)]},
        "edge",
        "lid_ends",
    ),
}


@pytest.mark.parametrize("how", LOST)
def test_marks_without_a_length_stop_no_cell(how, cells, capsys):
    marks, length, taken = LOST[how]
    begun = [cells[name].start for name in marks]
    ends = [np.array(places, float) for places in marks.values()]
    with pytest.raises(ValueError, match=r"same|behind"):
        cells[how](*ends)
    lost = [SimpleNamespace(ends=e, start=s) for e, s in zip(ends, begun, strict=True)]
    scope = cells | dict(zip(marks, lost, strict=True))
    using = rf"\b({'|'.join(marks)})\b"
    for cell in (c for c in CODE if re.search(using, c) and "pointer(" not in c):
        exec(compile(ast.parse(cell), "cell", "exec"), scope)
    np.testing.assert_array_equal(np.reshape(scope[taken], (-1, 2, 2)), begun)
    assert scope[length] == cells[how](*begun)
    assert "There is no length between these marks" in capsys.readouterr().out


def test_at_ten_degrees_the_part_of_the_pointing_is_four_times_as_large(cells):
    TEXT.says("Ours do at 51°. At 10°, the part of the pointing would be four times as large")
    camera, points, lid = cells["work"].camera, desk.TARGET.points(), desk.box_corners()[4:6]
    found = []
    for way in (7.5, 41):
        views, pixels = [], []
        for side in (-way, way):
            R, t = desk.pose_towards((190, 45), 42, side, 520, 0)
            seen = desk.Camera(camera.K, R, t, (1200, 900)).project(np.vstack([points, lid]))
            seen = distort_pixels(seen, camera.K, camera.coefficients)
            views.append(view_of_target(points, seen[: len(points)], camera))
            pixels.append(seen[len(points) :])
        one, other = (view.centre - lid.mean(axis=0) for view in views)
        cosine = one @ other / np.linalg.norm(one) / np.linalg.norm(other)
        length = distance_in_space(*np.stack(pixels, axis=1), views)
        found.append((np.degrees(np.arccos(cosine)), length.parts["pointing"]))
    (narrow, large), (wide, small) = found
    assert round(narrow) == 10
    assert round(wide) == 51
    assert round(large / small) == 4


def test_the_worked_examples():
    TEXT.says(r"$\sqrt{200^2 + 125^2} = 235.8$ mm")
    corners = desk.TARGET.points()[[0, -1]]
    assert round(float(np.linalg.norm(corners[1] - corners[0])), 1) == 235.8
    TEXT.says(r"\mathbf d = (0.1, 0, 1)", r"$\lambda = 500$ and $\mathbf X = (50, 0, 0)$")
    C, d = np.array([0, 0, -500.0]), np.array([100 / 1000, 0, 1])
    np.testing.assert_allclose(C - C[2] / d[2] * d, [50, 0, 0])
    TEXT.says(r"$\sqrt{0.5^2 + 0.5^2} = 0.7$ mm for the length")
    assert round(float(np.hypot(0.5, 0.5)), 1) == 0.7
    TEXT.says(r"\frac{|85.6 - 86.1|}{\sqrt{0.9^2 + 0.7^2}} = 0.44")
    assert round(abs(85.6 - 86.1) / np.hypot(0.9, 0.7), 2) == 0.44


def test_both_agree_with_the_truth(cells):
    assert all(result.ratio < 1 for result in cells["results"])
    assert cells["ruler"] == {"card": (lab.SUPPLIED.card, 0.1), "lid": (120.0, 0.1)}


def test_real_pairs():
    fetched("opencv_stereo/left01.jpg")
    checked = lab.measure_real_pairs()
    TEXT.says("Both diagonals of the board are 283.0 mm long", "25 of 26, or 96 %")
    assert [round(c.truth, 1) for c in checked] == [283.0] * 26
    assert sum(c.holds for c in checked) == 25
    assert round(100 * 25 / 26) == 96
    off = np.array([c.off for c in checked])
    TEXT.says("off by 0.5 mm, or 0.2 %", "Pair 8, by 2.2 mm")
    assert np.sqrt(np.mean(off**2)) == pytest.approx(0.5, abs=0.06)
    TEXT.says("fits its picture to 0.2 px", "Only together they do not.")
    alone = [calibrate(BOARD.points(), corners(s), SIZE, MODEL) for s in ("left", "right")]
    both = calibrate_stereo(BOARD.points(), corners("left"), corners("right"), SIZE, MODEL)
    eight = NUMBERS.index(8)
    for camera, residuals in zip(alone, (both.residuals_left, both.residuals_right), strict=True):
        together = [float(np.sqrt((r**2).sum(axis=1).mean())) for r in residuals]
        assert round(camera.view_rms[eight], 1) == 0.2
        assert together[eight] == max(together) > 1.2 * sorted(together)[-2]
    (worst,) = (c for c in checked if not c.holds)
    assert (worst.pair, round(abs(worst.off), 1)) == (8, 2.2)


def test_the_board_of_pair_8_moved_by_half_a_millimetre():
    """Each camera alone says where the board was; together they say how far that is apart."""
    fetched("opencv_stereo/left01.jpg")
    TEXT.says("if it moved by half a millimetre between the two exposures")
    points, moved = BOARD.points(), {}
    for left_out, number in enumerate(NUMBERS):
        seen = [list(corners(side)) for side in ("left", "right")]
        held = [side.pop(left_out) for side in seen]
        rig = calibrate_stereo(points, *seen, SIZE, MODEL)
        places = []
        for side, pixels in zip(("left", "right"), held, strict=True):
            K, k = getattr(rig, f"K_{side}"), getattr(rig, f"coefficients_{side}")
            _, turn, t = cv2.solvePnP(points, pixels, K, k)
            places.append(points @ cv2.Rodrigues(turn)[0].T + t[:, 0])
        apart = (places[1] - rig.t) @ rig.R - places[0]
        moved[number] = float(np.sqrt((apart[:, :2] ** 2).sum(axis=1).mean()))
        if number == 8:
            assert np.sqrt((apart**2).sum(axis=1).mean()) == pytest.approx(0.5, abs=0.1)
    others = [far for number, far in moved.items() if number != 8]
    assert moved[8] > 1.8 * max(others)  # across the view, where both know it well


def test_boards_and_cameras_of_real_pairs():
    fetched("opencv_stereo/left01.jpg")
    shifts, apart = lab.measure_shifts(), lab.measure_baselines()
    TEXT.says("77 of the 78 ways do, from 4 to 211 mm; typically they differ by 0.1 mm")
    assert len({c.pairs for c in shifts}) == 78
    assert sum(c.ratio < 1 for c in shifts) == 77
    ways = [c.one.value for c in shifts]
    assert (round(min(ways)), round(max(ways))) == (4, 211)
    differ = np.array([c.one.value - c.other.value for c in shifts])
    assert round(float(np.median(np.abs(differ))), 1) == 0.1
    assert np.median([c.one.plus_minus for c in shifts]) < 0.5  # so that it is easy to miss
    TEXT.says("all others together say 99.8 mm. It is 12 of 13.")
    assert [c.pairs for c in apart] == [(number,) for number in NUMBERS]
    assert sum(c.ratio < 1 for c in apart) == 12
    assert round(float(np.median([c.other.value for c in apart])), 1) == 99.8


def test_model_answers_give_the_same_numbers(cells):
    answers = {e.name.partition("_")[2]: e.model_answer for e in all_exercises("lab")}
    width, edge = (str(cells[name]).removesuffix(" (95 %)") for name in ("width", "edge"))
    assert all(width in answers[name] for name in ("plane", "ruler", "report"))
    assert all(edge in answers[name] for name in ("space", "report"))
    assert "Of 17 photographs 12 were used" in answers["camera"]
    assert "45 of 48 fields" in answers["camera"]
    assert "fx = 881.96 px ± 0.14 px." in answers["camera"]
    assert "0.39 mm of 0.44 mm" in answers["plane"]
    assert round(cells["width"].sigma, 2) == 0.44
    assert f"{85.6 - 85.5:.1f} mm, and both ± together are {np.hypot(0.9, 0.7):.1f} mm" in " ".join(
        answers["ruler"].split()
    )


def test_the_report_is_shown_by_a_cell_that_cannot_be_changed():
    notebook = expand(read_lesson(LESSONS / "12_lab.md"))
    (cell,) = (cell for cell in notebook.cells if cell.source == "lab.show_report()")
    assert cell.metadata["nbgrader"] == cell.metadata["nbgrader"] | {
        "grade_id": REPORT, "locked": True, "grade": False, "solution": False
    }  # fmt: skip
