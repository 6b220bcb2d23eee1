"""What follows the pointer is drawn in the browser alone; what is dragged moves the controls."""

import numpy as np
import pytest
from explorer_list import READABLE
from explorer_page import cells_with, explorer_in, number, photograph, pixels, reset, settle
from lab import run_all_cells, write_notebook

from course_lib.drawing.explorers.epipolar import trail
from course_lib.drawing.explorers.pairs import TOWARDS


@pytest.fixture(scope="module")
def page(lab, lab_page):
    path = write_notebook(
        lab.folder / "pointing.ipynb", *cells_with([*READABLE, "line", "residuals", "epipolar"])
    )
    page = lab_page(path)
    assert run_all_cells(page) == []
    return page


def at_its_start(page, key):
    root = explorer_in(page, key)
    reset(root)
    return root


@pytest.mark.parametrize("key", READABLE)
def test_the_pointer_reads_pixels_without_python(page, key):
    root = at_its_start(page, key)
    frame, picture = root.get_attribute("data-frame"), root.locator("figure").first
    box = picture.locator("canvas").first.bounding_box()
    root.page.mouse.move(box["x"] + box["width"] / 4, box["y"] + box["height"] / 2)
    u = int(picture.locator(".ce-reading").inner_text().split("(")[2].split(",")[0])
    assert abs(u - 480 / 4) <= 2
    assert root.get_attribute("data-frame") == frame


def test_the_keyboard_reads_pixels_too(page):
    root = at_its_start(page, "focal")
    picture = root.get_by_role("img").first
    picture.press("ArrowRight")
    reading = root.locator(".ce-reading").first
    assert "(241, 160) px" in reading.inner_text()
    picture.press("Shift+ArrowDown")
    assert "(241, 170) px" in reading.inner_text()
    assert "angle from the axis 1." in reading.inner_text()


def test_a_spot_of_a_picture_can_be_dragged(page):
    root = at_its_start(page, "corners")
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
    root = at_its_start(page, "line")
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


def test_marks_say_what_they_are_and_a_press_calls_the_spot(page):
    root = at_its_start(page, "residuals")
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


def test_the_pointer_draws_its_ray_in_other_pictures_without_python(page):
    root = at_its_start(page, "epipolar")
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
