"""One JupyterLab for the session; one Chromium a module, so that no event loop is left running."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from lab import Lab, browser, chromium, open_notebook


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark everything here slow; without Chromium skip it, but never on the build machine."""
    absent = chromium() is None and not os.environ.get("CI")
    for item in items:
        if Path(__file__).parent in item.path.parents:
            item.add_marker(pytest.mark.slow)
            if absent:
                item.add_marker(pytest.mark.skip(reason="no Chromium; set COURSE_CHROMIUM"))


@pytest.fixture(scope="session")
def lab(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Lab]:
    """Return a running JupyterLab that serves an empty folder."""
    if chromium() is None:
        pytest.fail("CI needs Chromium: install it, or set COURSE_CHROMIUM to its path")
    folder = tmp_path_factory.mktemp("notebooks")
    server = Lab(folder, tmp_path_factory.mktemp("home"))
    yield server
    server.stop()


@pytest.fixture(scope="module")
def chrome() -> Iterator[Any]:
    """Return a running Chromium."""
    with browser() as program:
        yield program


@pytest.fixture(scope="module")
def lab_page(lab: Lab, chrome: Any) -> Iterator[Callable[[Path], Any]]:
    """Return a function that opens a notebook of the lab's folder in a page of its own."""
    contexts = []

    def open_page(path: Path) -> Any:
        contexts.append(chrome.new_context(viewport={"width": 1400, "height": 1100}))
        page = contexts[-1].new_page()
        open_notebook(page, lab, path)
        return page

    yield open_page
    for context in contexts:
        context.close()
