"""Chapter 12 as a student meets it: photographs are dropped, and pointed at with the mouse."""

import numpy as np
import pytest
from lab import run_all_cells, write_notebook
from PIL import Image

from course_lib.lab.supplied import TARGET_AIMS
from data_generators import desk

SIZE = (1000, 750)
BOX = """from course_lib.boards import Checkerboard
from course_lib.widgets.lab import upload_box
upload_box("photographs", Checkerboard(9, 6, 25.0))"""
POINTER = """import numpy as np
from types import SimpleNamespace
from course_lib.widgets.lab import pointer
picture = np.full((600, 800, 3), 200, np.uint8)
picture[300:, 400:] = 60
shot = SimpleNamespace(name="desk.jpg", photograph=picture, own=False)
card = pointer(shot, ("left end", "right end"), [(100, 100), (390, 310)])
card"""

#: Drops a file as a mouse does; files named to the browser do not go this way.
DROP = """(box) => {
  const dataTransfer = new DataTransfer();
  dataTransfer.items.add(new File(["dear all"], "letter.txt"));
  box.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
}"""


@pytest.fixture(scope="module")
def page(lab, lab_page):
    path = write_notebook(lab.folder / "twelve" / "lab.ipynb", BOX, POINTER)
    page = lab_page(path)
    assert run_all_cells(page) == []
    return page


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """Write photographs as people have them; return their paths in the order of dropping."""
    folder = tmp_path_factory.mktemp("phone")
    for number, (aim, blur) in enumerate(((TARGET_AIMS[0], 0.6), (TARGET_AIMS[1], 8.0)), 1):
        view = desk.photograph_desk(
            *desk.pose_towards(*aim), SIZE, np.random.default_rng(number), blur
        )
        Image.fromarray(view.picture).save(folder / f"IMG_{number}.jpg")
    grey = Image.fromarray(np.full((750, 1000, 3), 120, np.uint8))
    grey.save(folder / "IMG_3.png", compress_level=0)  # 2.3 MB: more than one part
    (folder / "IMG_4.HEIC").write_bytes(b"\0\0\0\x18ftypheic" + bytes(5000))
    (folder / "IMG_5.jpg").write_text("a letter")
    return sorted(folder.iterdir())


def test_each_photograph_gets_its_verdict(page, lab, files):
    box = page.get_by_role("region", name="Your photographs")
    box.locator("input[type=file]").set_input_files([str(file) for file in files])
    box.get_by_text("All are looked at: 1 of 5 can be used.").wait_for(timeout=90_000)
    rows = box.locator("li").all()
    assert [row.locator("b").inner_text() for row in rows] == [  # what must be done comes first
        "✗ IMG_2.jpg",
        "✗ IMG_3.png",
        "✗ IMG_4.HEIC",
        "✗ IMG_5.jpg",
        "✓ IMG_1.jpg",
    ]
    words = [row.inner_text() for row in rows]
    assert "blurred" in words[0]
    assert "No checkerboard" in words[1]
    assert [row.locator("img").count() for row in rows] == [1, 1, 0, 0, 1]
    page.evaluate(DROP, box.locator(".cu-box").element_handle())
    box.locator("li b").get_by_text("✗ letter.txt").wait_for()
    kept = {file.name: file.read_bytes() for file in (lab.folder / "twelve/photographs").iterdir()}
    assert kept == {file.name: file.read_bytes() for file in files[:3]}


def test_a_mark_is_dragged_in_its_close_up(page):
    root = page.get_by_role("region", name="Point at left end and right end")
    root.scroll_into_view_if_needed()
    fine = root.get_by_role("slider", name="Right end, u finely")
    assert fine.get_attribute("aria-valuetext") == "0.0 px"
    close = root.get_by_role("img").nth(2)
    box, mouse = close.bounding_box(), page.mouse
    scale = box["width"] / 240
    grip = [box["x"] + (122.5 + 44 + 0.5) * scale, box["y"] + (122.5 + 44 + 0.5) * scale]
    mouse.move(*grip)
    mouse.down()
    mouse.move(grip[0] + 54 * scale, grip[1] - 60 * scale, steps=8)
    mouse.up()
    page.wait_for_function(
        "(s) => s.getAttribute('aria-valuetext') === '9.0 px'", arg=fine.element_handle()
    )
    down = root.get_by_role("slider", name="Right end, v finely")
    assert down.get_attribute("aria-valuetext") == "−10.0 px"
    root.locator("dl").get_by_text("399.0, 300.0 px").wait_for()
    fine.press("ArrowLeft")
    root.locator("dl").get_by_text("398.9, 300.0 px").wait_for()


def test_a_mark_is_dragged_over_the_whole_photograph(page):
    root = page.get_by_role("region", name="Point at left end and right end")
    whole = root.get_by_role("img").first
    box, mouse = whole.bounding_box(), page.mouse
    scale = box["width"] / 480 / (800 / 480)
    at = [box["x"] + 100.5 * scale, box["y"] + 100.5 * scale]
    mouse.move(*at)
    mouse.down()
    mouse.move(at[0] + 120 * scale, at[1] + 90 * scale, steps=8)
    mouse.up()
    page.wait_for_timeout(500)
    rough = root.get_by_role("slider", name="Left end, u", exact=True)
    assert abs(int(rough.get_attribute("aria-valuetext").removesuffix(" px")) - 220) <= 2


def test_marks_are_where_they_were_left(page):
    before = page.get_by_role("region", name="Point at left end and right end")
    left = before.locator("dd").first.inner_text()
    assert run_all_cells(page) == []
    page.get_by_text("The marks are where you left them").wait_for()
    root = page.get_by_role("region", name="Point at left end and right end")
    root.locator("dl").get_by_text("398.9, 300.0 px").wait_for()
    assert root.locator("dd").first.inner_text() == left != "100.0, 100.0 px"
