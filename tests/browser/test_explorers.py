"""The explorers as a reader meets them."""

import numpy as np
import pytest
from explorer_list import EXPLORERS, READABLE
from explorer_page import cells_with, drag, explorer_in, photograph, pixels, reset, settle
from lab import run_all_cells, write_notebook
from playwright.sync_api import expect

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
    path = write_notebook(lab.folder / "explorers.ipynb", *cells_with(EXPLORERS), CLUMSY)
    page = lab_page(path)
    assert run_all_cells(page) == []
    return page


@pytest.fixture
def explorer(request, page):
    root, slider = explorer_in(page, request.param), EXPLORERS[request.param][3]
    root.get_by_role("img").first.wait_for()
    yield root, root.get_by_role("slider", name=slider)
    reset(root)


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
    dragged = photograph(root)
    assert (dragged != before).mean() > 0.005
    assert [picture.get_attribute("aria-label") for picture in pictures] != words
    assert root.locator("dl").inner_text() != numbers
    frame = int(root.get_attribute("data-frame"))
    for key in ("ArrowRight", "ArrowLeft"):  # a state has one picture, however it was reached
        slider.press(key)
    expect(root).to_have_attribute("data-frame", str(frame + 2))
    np.testing.assert_array_equal(pixels(pictures[0]), dragged)


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
    reset(root)
    before, text = photograph(root), slider.get_attribute("aria-valuetext")
    slider.press("End")
    assert (photograph(root) != before).any()
    reset(root)
    np.testing.assert_array_equal(photograph(root), before)
    assert slider.get_attribute("aria-valuetext") == text


def test_choices_and_switches_change_the_picture(page):
    focal = explorer_in(page, "focal")
    before = photograph(focal)
    focal.get_by_role("radiogroup", name="Sensor").get_by_role("radio", name="DX").check()
    assert photograph(focal).shape != before.shape or (photograph(focal) != before).any()
    dolly = explorer_in(page, "dolly")
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
    root = explorer_in(page, "setup")
    view = root.get_by_role("img").first
    assert photograph(root).mean() < 200
    root.get_by_role("combobox", name="Lens").select_option("Computar M3514-MP")
    settle(root)
    assert "mount" in view.get_attribute("aria-label")
    assert photograph(root).mean() > 250  # white paper, not the black of a canvas without one
    reset(root)
    assert root.get_by_role("combobox", name="Lens").input_value() == "Zeiss Milvus 1.4/85"


def test_numbers_are_typeset(page):
    root = explorer_in(page, "rays")
    slider = root.get_by_role("slider", name="Object distance Z")
    slider.press("End")
    settle(root)
    assert slider.get_attribute("aria-valuetext") == "1\u202f000\u202f000 mm"
    reset(root)
    lens = explorer_in(page, "lens")
    lens.get_by_role("slider", name="Radial k₁").press("Home")
    settle(lens)
    text = lens.get_by_role("slider", name="Radial k₁").get_attribute("aria-valuetext")
    assert text == "\N{MINUS SIGN}0.60"
    reset(lens)


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
