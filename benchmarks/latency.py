"""Slider to new pixels, and pictures a second while dragging, in a real JupyterLab and Chromium."""

from __future__ import annotations

import statistics
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from tests.browser.lab import Lab, browser, open_notebook, run_all_cells, write_notebook

#: The picture counts as new in the animation frame that finds it drawn.
WATCH = """(selector) => {
  const root = document.querySelector(selector);
  const sign = () => {
    if (root.dataset.frame) return root.dataset.frame;
    const image = root.querySelector("img");
    return image && image.complete && image.naturalWidth ? image.src.length + image.src.slice(-400) : "";
  };
  const before = sign();
  window.benchNew = new Promise((resolve, reject) => {
    let start = 0;
    root.addEventListener("keydown", (event) => { start = event.timeStamp; }, { capture: true, once: true });
    const end = performance.now() + 8000;
    const look = (now) => {
      const current = sign();
      if (start && current && current !== before) resolve(performance.now() - start);
      else if (now > end) reject(new Error(`no new picture: ${selector}`));
      else requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
  });
}"""

COUNT = """(selector) => {
  const root = document.querySelector(selector);
  const seen = { last: "", count: 0, stop: false };
  const look = () => {
    const image = root.querySelector("img");
    const sign = root.dataset.frame ?? (image?.complete ? image.src.slice(-400) : seen.last);
    if (sign !== seen.last) { seen.count += 1; seen.last = sign; }
    if (!seen.stop) requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
  window.benchSeen = seen;
}"""


@dataclass
class Contender:
    """Something with a slider: where it is on the page, and what was measured."""

    name: str
    root: str
    slider: str

    def __post_init__(self) -> None:
        self.latencies: list[float] = []
        self.rates: list[float] = []

    @property
    def latency(self) -> float:
        """Median time from key to new pixels, ms."""
        return statistics.median(self.latencies)

    @property
    def rate(self) -> float:
        """Median number of pictures a second while dragging."""
        return statistics.median(self.rates)


def press(page: Any, contender: Contender, key: str) -> None:
    """Press a key on the contender's slider; note how long the new picture took."""
    page.locator(contender.slider).focus()
    page.evaluate(WATCH, contender.root)
    page.keyboard.press(key)
    contender.latencies.append(page.evaluate("() => window.benchNew"))


def drag(page: Any, contender: Contender, seconds: float) -> None:
    """Drag the contender's slider to and fro; note the pictures a second."""
    handle = page.locator(contender.slider)
    track = handle.locator("xpath=ancestor-or-self::*[contains(@class,'noUi-target') or self::input]")
    box = track.last.bounding_box()
    middle = box["y"] + box["height"] / 2
    place = handle.bounding_box() if "noUi" in contender.slider else box
    page.mouse.move(place["x"] + place["width"] / 2, middle)
    page.mouse.down()
    page.evaluate(COUNT, contender.root)
    start, step = time.perf_counter(), 0
    while time.perf_counter() - start < seconds:
        step += 1
        across = abs((step % 120) / 60 - 1)
        page.mouse.move(box["x"] + box["width"] * (0.1 + 0.8 * across), middle)
        page.wait_for_timeout(8)
    elapsed = time.perf_counter() - start
    contender.rates.append(page.evaluate("() => { window.benchSeen.stop = true; return window.benchSeen.count; }") / elapsed)
    page.mouse.up()
    page.wait_for_timeout(1500)


def measure(cells: list[str], contenders: list[Contender], rounds: int, drags: int, options: tuple[str, ...] = ()) -> None:
    """Measure all contenders, interleaved, in one page."""
    with tempfile.TemporaryDirectory() as place:
        folder, home = Path(place, "notebooks"), Path(place, "home")
        folder.mkdir()
        home.mkdir()
        path = write_notebook(folder / "bench.ipynb", *cells)
        lab = Lab(folder, home, options=options)
        try:
            with browser() as program:
                page = program.new_page(viewport={"width": 1400, "height": 1100})
                open_notebook(page, lab, path)
                errors = run_all_cells(page)
                if errors:
                    raise RuntimeError(f"the benchmark's notebook failed: {errors}")
                _rounds(page, contenders, rounds, drags)
        finally:
            lab.stop()


def _rounds(page: Any, contenders: list[Contender], rounds: int, drags: int) -> None:
    """Take turns: every contender once a round; the first round warms up and is dropped."""
    for turn in range(rounds + 1):
        for contender in contenders:
            page.locator(contender.root).scroll_into_view_if_needed()
            page.wait_for_timeout(250)
            for key in ("ArrowRight", "ArrowLeft"):
                press(page, contender, key)
                page.wait_for_timeout(120)
            if turn == 0:
                contender.latencies.clear()
    for _ in range(drags):
        for contender in contenders:
            page.locator(contender.root).scroll_into_view_if_needed()
            drag(page, contender, seconds=3.0)
