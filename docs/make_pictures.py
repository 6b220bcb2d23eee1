"""Make the pictures of README.md anew: python docs/make_pictures.py (needs Chromium)."""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
PICTURES = ROOT / "docs" / "pictures"
sys.path[:0] = [str(ROOT), str(ROOT / "tests" / "browser")]

import lab as jupyter  # noqa: E402

from course_lib.drawing import welcome  # noqa: E402
from course_lib.exercises import find  # noqa: E402
from course_lib.exercises.pinhole.misconceptions_perspective import (  # noqa: E402
    mirrors_what_is_behind,
)
from course_lib.judging import Exercise, Verdict, answer, judge, pose  # noqa: E402
from course_lib.judging.html import to_html  # noqa: E402

EXPLORERS = (("pinhole", "focal_length"), ("lenses", "depth_of_field"))


def draw_map() -> None:
    """Write the map of the chapters."""
    welcome.course_map().savefig(PICTURES / "map.png", dpi=100)


def example_verdict() -> Verdict:
    """Return what a student is told who forgot that nothing behind the camera has an image."""
    exercise = find("pinhole.project_pinhole")
    assert isinstance(exercise, Exercise)
    cases = pose(exercise, 5)
    return judge(exercise, cases, answer(exercise, mirrors_what_is_behind, cases))


def show_verdict(browser: Any) -> None:
    """Write how that looks."""
    page = browser.new_page(viewport={"width": 800, "height": 600}, device_scale_factor=2)
    page.set_content(
        f"<body style='margin:1rem;background:white'>{to_html(example_verdict())}</body>"
    )
    page.locator(".course-verdict").screenshot(path=PICTURES / "verdict.png")
    page.close()


def show_explorers(browser: Any) -> None:
    """Write some explorers as they look in JupyterLab."""
    with _notebook() as (lab, path):
        page = browser.new_page(viewport={"width": 1280, "height": 1600})
        jupyter.open_notebook(page, lab, path)
        jupyter.run_all_cells(page)
        explorers = page.locator(".course-explorer")
        for index, (_, name) in enumerate(EXPLORERS):
            explorers.nth(index).locator("img, canvas").first.wait_for()
            page.wait_for_timeout(1500)
            explorers.nth(index).screenshot(path=PICTURES / f"{name}.png")
        page.close()


@contextmanager
def _notebook() -> Iterator[tuple[jupyter.Lab, Path]]:
    with tempfile.TemporaryDirectory() as folder:
        work, home = Path(folder, "work"), Path(folder, "home")
        work.mkdir()
        home.mkdir()
        cells = [
            f"from course_lib.widgets.{chapter} import {name}_explorer\n{name}_explorer()"
            for chapter, name in EXPLORERS
        ]
        path = jupyter.write_notebook(work / "pictures.ipynb", *cells)
        lab = jupyter.Lab(work, home)
        try:
            yield lab, path
        finally:
            lab.stop()


def main() -> None:
    """Make them all."""
    PICTURES.mkdir(exist_ok=True)
    draw_map()
    with jupyter.browser() as browser:
        show_verdict(browser)
        show_explorers(browser)


if __name__ == "__main__":
    main()
