"""The explorers as a reader meets them."""

import cv2
import numpy as np
import pytest
from explorer_list import EXPLORERS
from lab import run_all_cells, write_notebook

from course_lib.drawing.explorers.epipolar import trail
from course_lib.drawing.explorers.pairs import TOWARDS

#: Those with a photograph that the pointer reads; everything is tried on them.
READABLE = ("aperture", "focal", "dolly", "depth", "corners")
each = pytest.mark.parametrize("explorer", EXPLORERS, indirect=True)
each_readable = pytest.mark.parametrize("explorer", READABLE, indirect=True)
CLUMSY = """
from course_lib.drawing.explorers.frame import Frame, Label, Line, Picture
from course_lib.widgets.controls import Slider
from course_lib.widgets.explorer import Explorer

def frame(n):
    if n == 7:
        raise ValueError("seven is not drawn; choose another")
    line, word = Line([[0, 0], [n, n]]), Label("edge", (98, 60))
    return Frame((Picture("Square", f"n is {n:g}", (100, 80), lines=(line,), labels=(word,)),))

clumsy = Explorer("Clumsy", [Slider("n", "Number", "n", "", 1, 9, 6)], frame)
clumsy
"""


@pytest.fixture(scope="module")
def page(lab, lab_page):
    cells = [
        f"from course_lib.widgets.{chapter} import {make}\n{key} = {make}()\n{key}"
        for key, (chapter, make, _, _) in EXPLORERS.items()
    ]
    path = write_notebook(lab.folder / "explorers.ipynb", *cells, CLUMSY)
    page = lab_page(path)
    assert run_all_cells(page) == []
    return page


@pytest.fixture
def explorer(request, page):
    *_, title, slider = EXPLORERS[request.param]
    root = page.get_by_role("region", name=title)
    root.scroll_into_view_if_needed()
    root.get_by_role("img").first.wait_for()
    yield root, root.get_by_role("slider", name=slider)
    root.get_by_role("button", name="Reset").click()
    settle(root)


def settle(root):
    """Wait until no new frame arrives for a moment."""
    page = root.page
    while True:
        frame = root.get_attribute("data-frame")
        page.wait_for_timeout(200)
        if root.get_attribute("data-frame") == frame:
            return


def pixels(picture):
    png = np.frombuffer(picture.screenshot(), np.uint8)
    return cv2.imdecode(png, cv2.IMREAD_COLOR).astype(int)


def photograph(root):
    settle(root)
    return pixels(root.get_by_role("img").first)


def number(text):
    """The number of a text that is typeset: with a minus sign and groups of three."""
    return float(text.replace("\N{MINUS SIGN}", "-").replace("\N{NARROW NO-BREAK SPACE}", ""))


def drag(slider, *stops):
    """Drag a slider's thumb from where it is over places of its track, 0 to 1; let go there."""
    box = slider.bounding_box()
    share = slider.evaluate("(s) => (s.value - s.min) / (s.max - s.min)")
    mouse, middle = slider.page.mouse, box["y"] + box["height"] / 2
    mouse.move(box["x"] + 9 + share * (box["width"] - 18), middle)
    mouse.down()
    for stop in stops:
        mouse.move(box["x"] + stop * box["width"], middle, steps=25)
    mouse.up()


@each
def test_it_appears_with_pictures_that_say_what_they_show(explorer):
    root, _ = explorer
    for picture in root.get_by_role("img").all():
        assert len(picture.get_attribute("aria-label")) > 30
        assert pixels(picture).std() > 5


@each
def test_every_control_has_a_name_and_a_value_with_its_unit(explorer):
    root, slider = explorer
    for control in root.get_by_role("slider").all():
        name = control.evaluate("(c) => c.labels[0].innerText")
        assert root.get_by_role("slider", name=name).count() == 1
        text = control.get_attribute("aria-valuetext")
        assert text == control.evaluate(
            "(c) => c.parentElement.querySelector('.ce-value').innerText"
        )
    assert slider.is_visible()


@each
def test_dragging_moves_the_picture_its_words_and_its_numbers(explorer):
    root, slider = explorer
    before, pictures = photograph(root), root.get_by_role("img").all()
    words = [picture.get_attribute("aria-label") for picture in pictures]
    numbers = root.locator("dl").inner_text()
    drag(slider, 0.8, 0.15)
    assert (photograph(root) != before).mean() > 0.005
    assert [picture.get_attribute("aria-label") for picture in pictures] != words
    assert root.locator("dl").inner_text() != numbers


@each_readable
def test_a_drag_ends_with_the_picture_of_its_last_state(explorer):
    root, slider = explorer
    drag(slider, 0.1, 0.9, 0.1, 0.9, 0.45, 0.6)
    dragged = photograph(root)
    slider.press("ArrowRight")
    assert (photograph(root) != dragged).any()
    slider.press("ArrowLeft")
    np.testing.assert_array_equal(photograph(root), dragged)


@each_readable
def test_the_keyboard_moves_it_and_the_notebook_does_not_take_the_keys(explorer):
    root, slider = explorer
    cells = root.page.locator(".jp-Cell").count()
    before, place = photograph(root), slider.input_value()
    slider.focus()
    for key in ("ArrowRight", "PageUp", "b"):  # b makes a new cell in the notebook
        slider.page.keyboard.press(key)
    assert int(slider.input_value()) > int(place) + 1
    assert (photograph(root) != before).any()
    slider.press("Home")
    assert slider.input_value() == "0"
    assert root.page.locator(".jp-Cell").count() == cells


@each_readable
def test_reset_brings_the_first_picture_back(explorer):
    root, slider = explorer
    root.get_by_role("button", name="Reset").click()
    before, text = photograph(root), slider.get_attribute("aria-valuetext")
    slider.press("End")
    assert (photograph(root) != before).any()
    root.get_by_role("button", name="Reset").click()
    np.testing.assert_array_equal(photograph(root), before)
    assert slider.get_attribute("aria-valuetext") == text


@each_readable
def test_the_pointer_reads_pixels_without_python(explorer):
    root, _ = explorer
    frame, picture = root.get_attribute("data-frame"), root.locator("figure").first
    box = picture.locator("canvas").first.bounding_box()
    root.page.mouse.move(box["x"] + box["width"] / 4, box["y"] + box["height"] / 2)
    u = int(picture.locator(".ce-reading").inner_text().split("(")[2].split(",")[0])
    assert abs(u - 480 / 4) <= 2
    assert root.get_attribute("data-frame") == frame


def test_the_keyboard_reads_pixels_too(page):
    root = page.get_by_role("region", name=EXPLORERS["focal"][2])
    picture = root.get_by_role("img").first
    picture.press("ArrowRight")
    reading = root.locator(".ce-reading").first
    assert "(241, 160) px" in reading.inner_text()
    picture.press("Shift+ArrowDown")
    assert "(241, 170) px" in reading.inner_text()
    assert "angle from the axis 1." in reading.inner_text()


def test_a_spot_of_a_picture_can_be_dragged(page):
    root = page.get_by_role("region", name=EXPLORERS["corners"][2])
    root.scroll_into_view_if_needed()
    root.get_by_role("button", name="Reset").click()
    settle(root)
    before = photograph(root)
    box = root.get_by_role("img").first.bounding_box()
    scale, mouse = box["width"] / 480, page.mouse
    mouse.move(box["x"] + 350.5 * scale, box["y"] + 80.5 * scale)
    mouse.down()
    mouse.move(box["x"] + 300.5 * scale, box["y"] + 120.5 * scale, steps=12)
    mouse.up()
    settle(root)
    for name, value in (("Top right u₃", 300), ("Top right v₃", 120)):
        text = root.get_by_role("slider", name=name).get_attribute("aria-valuetext")
        assert abs(int(text.removesuffix(" px")) - value) <= 1
    assert (photograph(root) != before).mean() > 0.005
    mouse.move(box["x"] + 200 * scale, box["y"] + 200 * scale)
    frame = root.get_attribute("data-frame")
    mouse.down()  # no spot is here
    mouse.move(box["x"] + 240 * scale, box["y"] + 240 * scale, steps=5)
    mouse.up()
    settle(root)
    assert root.get_attribute("data-frame") == frame


def test_a_spot_that_moves_one_control_stays_in_its_column(page):
    root = page.get_by_role("region", name=EXPLORERS["line"][2])
    root.scroll_into_view_if_needed()
    height, slope = root.get_by_role("slider", name="Height"), root.get_by_role("slider").first
    before = float(height.get_attribute("aria-valuetext")), slope.get_attribute("aria-valuetext")
    box = root.get_by_role("img").first.bounding_box()
    scale, mouse = box["width"] / 440, page.mouse
    at = [box["x"] + 52.5 * scale, box["y"] + (296.5 - 268 * (before[0] + 100) / 700) * scale]
    mouse.move(*at)
    mouse.down()
    mouse.move(at[0] + 60 * scale, at[1] + 30 * scale, steps=8)
    mouse.up()
    settle(root)
    moved = before[0] - float(height.get_attribute("aria-valuetext"))
    assert abs(moved - 30 * 700 / 268) <= 3
    assert slope.get_attribute("aria-valuetext") == before[1]
    root.get_by_role("button", name="Reset").click()


def test_marks_say_what_they_are_and_a_press_calls_the_spot(page):
    root = page.get_by_role("region", name=EXPLORERS["residuals"][2])
    root.scroll_into_view_if_needed()
    root.get_by_role("button", name="Reset").click()
    settle(root)
    frame, cloud = root.get_attribute("data-frame"), root.locator("figure").first
    box = cloud.locator("canvas").first.bounding_box()
    scale, mouse = box["width"] / 300, page.mouse
    mouse.move(box["x"] + 167.5 * scale, box["y"] + 145.5 * scale)  # the middle of all
    reading = cloud.locator(".ce-reading").inner_text().split(" · ")
    assert [text.split()[0] for text in reading] == ["view", "corner", "du", "dv", "residual"]
    assert abs(number(reading[2].split()[1])) < 0.05
    assert root.get_attribute("data-frame") == frame
    mouse.down()
    mouse.up()
    settle(root)
    assert root.get_attribute("data-frame") != frame
    for name in ("Look at du", "Look at dv"):
        text = root.get_by_role("slider", name=name).get_attribute("aria-valuetext")
        assert abs(number(text.removesuffix(" px"))) < 0.05
    root.get_by_role("button", name="Reset").click()


def test_the_pointer_draws_its_ray_in_other_pictures_without_python(page):
    root = page.get_by_role("region", name=EXPLORERS["epipolar"][2])
    root.scroll_into_view_if_needed()
    root.get_by_role("button", name="Reset").click()
    settle(root)
    frame, pictures = root.get_attribute("data-frame"), root.get_by_role("img").all()
    before = [pixels(picture.locator("xpath=..")) for picture in pictures[1:3]]
    box = pictures[0].bounding_box()
    scale, seen = box["width"] / 340, []
    for u, v in ((60, 60), (200, 200)):
        page.mouse.move(box["x"] + (u + 0.5) * scale, box["y"] + (v + 0.5) * scale)
        seen.append([pixels(picture.locator("xpath=..")) for picture in pictures[1:3]])
        path = trail(TOWARDS, 1).path((u, v))
        on = [p for p in np.linspace(*path, 400) if ((p > 12) & (p < (328, 243))).all()]
        rows, columns = np.transpose([(p[::-1] + 0.5) * scale for p in on]).astype(int)
        reds = seen[-1][0][rows, columns]  # BGR; labels of depths hide some
        assert len(on) > 40
        assert (np.abs(reds - (0xA7, 0x79, 0xCC)).max(axis=1) < 60).mean() > 0.6
    for which in (0, 1):  # on the right, and from above
        assert (seen[0][which] != before[which]).mean() > 0.003
        assert (seen[0][which] != seen[1][which]).mean() > 0.003
    page.mouse.move(box["x"] + 5, box["y"] - 60)
    after = pixels(pictures[1].locator("xpath=.."))
    np.testing.assert_array_equal(after, before[0])
    assert root.get_attribute("data-frame") == frame


def test_choices_and_switches_change_the_picture(page):
    focal = page.get_by_role("region", name=EXPLORERS["focal"][2])
    before = photograph(focal)
    focal.get_by_role("radiogroup", name="Sensor").get_by_role("radio", name="DX").check()
    assert photograph(focal).shape != before.shape or (photograph(focal) != before).any()
    dolly = page.get_by_role("region", name=EXPLORERS["dolly"][2])
    follower = dolly.get_by_role("slider", name="Focal length f")
    assert follower.is_disabled()
    dolly.get_by_role("slider", name="Distance Z").press("End")
    settle(dolly)
    assert follower.get_attribute("aria-valuetext") == "112.0 mm"
    dolly.get_by_role("checkbox").uncheck()
    settle(dolly)
    assert follower.is_enabled()
    assert follower.get_attribute("aria-valuetext") == "112.0 mm"


def test_a_long_choice_is_a_list_and_a_picture_can_go(page):
    root = page.get_by_role("region", name=EXPLORERS["setup"][2])
    root.scroll_into_view_if_needed()
    view = root.get_by_role("img").first
    assert photograph(root).mean() < 200
    root.get_by_role("combobox", name="Lens").select_option("Computar M3514-MP")
    settle(root)
    assert "mount" in view.get_attribute("aria-label")
    assert photograph(root).mean() > 250  # white paper, not the black of a canvas without one
    root.get_by_role("button", name="Reset").click()
    settle(root)
    assert root.get_by_role("combobox", name="Lens").input_value() == "Zeiss Milvus 1.4/85"


def test_numbers_are_typeset(page):
    root = page.get_by_role("region", name=EXPLORERS["rays"][2])
    slider = root.get_by_role("slider", name="Object distance Z")
    slider.press("End")
    settle(root)
    assert slider.get_attribute("aria-valuetext") == "1\u202f000\u202f000 mm"
    root.get_by_role("button", name="Reset").click()
    lens = page.get_by_role("region", name=EXPLORERS["lens"][2])
    lens.get_by_role("slider", name="Radial k₁").press("Home")
    settle(lens)
    text = lens.get_by_role("slider", name="Radial k₁").get_attribute("aria-valuetext")
    assert text == "\N{MINUS SIGN}0.60"
    lens.get_by_role("button", name="Reset").click()


def test_an_error_is_said_and_the_next_picture_clears_it(page):
    root = page.get_by_role("region", name="Clumsy")
    slider = root.get_by_role("slider")
    slider.press("ArrowRight")
    status = root.get_by_role("status")
    status.get_by_text("seven is not drawn; choose another").wait_for()
    assert root.get_by_role("img").get_attribute("aria-label") == "n is 6"
    slider.press("ArrowRight")
    root.get_by_role("img", name="n is 8").wait_for()
    assert status.inner_text() == ""


def test_a_word_at_the_edge_is_moved_inwards(page):
    seen = photograph(page.get_by_role("region", name="Clumsy"))
    dark = np.flatnonzero((seen[60:85] < 160).all(axis=2).any(axis=0))
    assert dark.min() < 110  # where the word is asked for, it begins at 118
    assert dark.max() < seen.shape[1] - 1


def test_python_moves_the_page(page, lab, lab_page):
    path = write_notebook(
        lab.folder / "driven.ipynb",
        "from course_lib.widgets.pinhole import *\ndriven = dolly_zoom_explorer()\ndriven",
        "driven",
        "driven.set(Z=12, coupled=False, f=50)",
    )
    driven = lab_page(path)
    assert run_all_cells(driven) == []
    sliders = driven.get_by_role("slider", name="Distance Z")
    assert sliders.count() == 2  # two views of one explorer
    for root in driven.get_by_role("region", name="Dolly zoom").all():
        settle(root)
        assert root.get_by_role("slider").first.get_attribute("aria-valuetext") == "12.0 m"
    driven.get_by_role("slider", name="Distance Z").first.press("ArrowRight")
    for root in driven.get_by_role("region", name="Dolly zoom").all():
        settle(root)
        assert root.get_by_role("slider").first.get_attribute("aria-valuetext") == "12.1 m"
