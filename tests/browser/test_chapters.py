"""Chapters 00 and 01 as a student meets them: open, run, drag, answer wrongly, answer rightly."""

import shutil
import sys
from pathlib import Path

import pytest
from lab import run_all_cells

ROOT = Path(__file__).resolve().parents[2]

WRONG = "def dolly_zoom(f, Z, Z_new):\n    return f * Z / Z_new"
RIGHT = "def dolly_zoom(f, Z, Z_new):\n    return f / Z * Z_new"
BROKEN = "def dolly_zoom(f, Z, Z_new):\n    return f * Z / Z_new["
#: What IPython calls a cell that ends too early.
SLIP = "SyntaxError" if sys.version_info < (3, 13) else "_IncompleteInputError: incomplete input"
HINT = "From farther away the object looks smaller."

#: Scrolls to the first code cell that holds a text, and makes it the active one.
GO_TO = """async (text) => {
  const notebook = window.jupyterapp.shell.currentWidget.content;
  const index = notebook.widgets.findIndex(
    (cell) => cell.model.type === "code" && cell.model.sharedModel.source.includes(text));
  notebook.activeCellIndex = index;
  notebook.deselectAll();
  await notebook.scrollToItem(index, "center");
  return index;
}"""
RUN = "async () => { await window.jupyterapp.commands.execute('notebook:run-cell'); }"
OUTPUT = """() => {
  const cell = window.jupyterapp.shell.currentWidget.content.activeCell;
  return cell.outputArea.node.innerText;
}"""


@pytest.fixture(scope="module")
def chapter(lab, lab_page):
    def open_chapter(name):
        path = lab.folder / name / f"{name}.ipynb"
        path.parent.mkdir()
        shutil.copy(ROOT / "notebooks" / name / path.name, path)
        page = lab_page(path)
        assert run_all_cells(page) == []
        return page

    return open_chapter


@pytest.fixture(scope="module")
def pinhole(chapter):
    return chapter("01_pinhole")


def go_to(page, text):
    assert page.evaluate(GO_TO, text) >= 0
    page.wait_for_timeout(300)


def answer(page, source):
    """Type an answer over the stub with the keyboard, run it and its check; return the verdict."""
    go_to(page, "def dolly_zoom(")
    page.locator(".jp-Notebook .jp-mod-active .cm-content").click()
    page.keyboard.press("Control+A")
    page.keyboard.insert_text(source)
    page.keyboard.press("Escape")
    page.evaluate(RUN)
    go_to(page, 'check("pinhole.dolly_zoom")')
    page.evaluate(RUN)
    return page.evaluate(OUTPUT)


def test_welcome_shows_a_hint_on_purpose(chapter):
    page = chapter("00_welcome")
    go_to(page, 'check("welcome.image_centre", {')
    assert "0 of 2 points" in page.evaluate(OUTPUT)
    assert "Hint." in page.evaluate(OUTPUT)


def test_a_slider_of_the_chapter_moves_its_picture(pinhole):
    go_to(pinhole, "aperture_explorer()")
    explorer = pinhole.get_by_role("region", name="The hole of a pinhole camera")
    picture = explorer.get_by_role("img").first
    picture.wait_for()
    before, words = picture.screenshot(), picture.get_attribute("aria-label")
    slider = explorer.get_by_role("slider", name="Hole diameter d")
    slider.focus()
    frame = explorer.get_attribute("data-frame")
    for _ in range(5):
        pinhole.keyboard.press("PageDown")
    pinhole.wait_for_function(
        "([root, frame]) => root.dataset.frame !== frame", arg=[explorer.element_handle(), frame]
    )
    pinhole.wait_for_timeout(1000)
    assert picture.screenshot() != before
    assert picture.get_attribute("aria-label") != words


def test_a_wrong_answer_gets_its_hint(pinhole):
    verdict = answer(pinhole, WRONG)
    assert "0 of 4 points" in verdict
    assert HINT in verdict
    assert "your answer" in verdict


def test_after_a_syntax_error_the_check_judges_the_function_as_it_was(pinhole):
    answer(pinhole, WRONG)
    verdict = answer(pinhole, BROKEN)
    assert "0 of 4 points" in verdict
    assert HINT in verdict
    go_to(pinhole, "def dolly_zoom(")
    assert SLIP in pinhole.evaluate(OUTPUT)


def test_a_right_answer_earns_all_points(pinhole):
    verdict = answer(pinhole, RIGHT)
    assert "4 of 4 points" in verdict
    assert "Hint" not in verdict
