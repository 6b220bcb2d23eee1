"""From the slider to new pixels, and pictures a second while dragging, in a real JupyterLab."""

from __future__ import annotations

import json
import statistics
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from urllib.request import urlopen

import websocket

from benchmarks.explorers import EXPLORERS
from benchmarks.table import Row
from tests.browser.lab import Lab, browser, free_port, open_notebook, run_all_cells, write_notebook

MOVES_A_SECOND = 60  # of the mouse while dragging
SWEEP = 80  # moves from end to end; fewer on a slider that has fewer positions

# What is on the screen: the number of the frame drawn, or the picture that Matplotlib made. New
# pixels count in the animation frame that finds them, for everyone alike.
SIGN = """
  const sign = () => {
    if (root.dataset.frame) return root.dataset.frame;
    const image = root.querySelector("img");
    const drawn = image?.complete && image.naturalWidth;
    return drawn ? `${image.src.length} ${image.src.slice(-400)}` : "";
  };"""

WATCH = (
    """(selector) => {
  const root = document.querySelector(selector);"""
    + SIGN
    + """
  const before = sign();
  window.benchNew = new Promise((resolve, reject) => {
    let start = 0;
    const once = { capture: true, once: true };
    root.addEventListener("keydown", (event) => { start = event.timeStamp; }, once);
    const end = performance.now() + 8000;
    const look = () => {
      const current = sign();
      if (start && current && current !== before) resolve(performance.now() - start);
      else if (performance.now() > end) {
        reject(new Error(`no new picture: ${selector}, which says: ${root.innerText.slice(-500)}`));
      }
      else requestAnimationFrame(look);
    };
    requestAnimationFrame(look);
  });
}"""
)

COUNT = (
    """(selector) => {
  const root = document.querySelector(selector);"""
    + SIGN
    + """
  const seen = { last: sign(), count: 0, stop: false };
  const look = () => {
    const current = sign();
    if (current && current !== seen.last) { seen.count += 1; seen.last = current; }
    if (!seen.stop) requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
  window.benchSeen = seen;
}"""
)

STOP = "() => { window.benchSeen.stop = true; return window.benchSeen.count; }"

#: From a movement of the pointer to the animation frame that shows what it reads.
POINTER = """(selector) => {
  const root = document.querySelector(selector), reading = root.querySelector(".ce-reading");
  window.benchPointer = [];
  root.addEventListener("pointermove", (event) => {
    requestAnimationFrame(() => {
      if (reading.textContent) window.benchPointer.push(performance.now() - event.timeStamp);
    });
  }, { capture: true });
}"""


@dataclass
class Contender:
    """Something with a slider: where it is on the page, and what was measured, in ms and 1/s."""

    name: str
    root: str
    handle: str
    latencies: list[float] = field(default_factory=list)
    rates: list[float] = field(default_factory=list)

    @property
    def slider(self) -> str:
        """Return the selector of what takes the keys."""
        return f"{self.root} {self.handle} >> nth=0"

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


class Mouse:
    """A mouse that moves as one in the hand does: it does not wait for what the page makes of it.

    Playwright's mouse waits until each movement was handled, so it could not send more movements
    than the page has time for, and would measure itself.
    """

    def __init__(self, port: int, address: str) -> None:
        listing = urlopen(f"http://127.0.0.1:{port}/json", timeout=10).read()
        (page,) = (p for p in json.loads(listing) if p["type"] == "page" and p["url"] == address)
        self._socket = websocket.create_connection(
            page["webSocketDebuggerUrl"], suppress_origin=True
        )
        self._sent = 0

    def move(self, x: float, y: float) -> None:
        """Move with the left button down, in px of the page."""
        self._sent += 1
        where = {"type": "mouseMoved", "x": x, "y": y, "button": "left", "buttons": 1}
        message = {"id": self._sent, "method": "Input.dispatchMouseEvent", "params": where}
        self._socket.send(json.dumps(message))

    def rest(self) -> None:
        """Wait until every movement was handled."""
        while json.loads(self._socket.recv()).get("id") != self._sent:
            pass


def drag(page: Any, mouse: Mouse, contender: Contender, seconds: float) -> None:
    """Drag the contender's slider to and fro; note the pictures a second."""
    handle = page.locator(contender.slider)
    handle.scroll_into_view_if_needed()  # an explorer may be higher than the window
    box, sweep = handle.bounding_box(), SWEEP
    track = page.locator(f"{contender.root} .noUi-base")
    if track.count():
        box = track.first.bounding_box()
        handle.hover()
    else:
        place, last = handle.evaluate("(s) => [s.value - s.min, s.max - s.min]")
        share, sweep = place / last, min(SWEEP, last)
        page.mouse.move(box["x"] + 9 + share * (box["width"] - 18), box["y"] + box["height"] / 2)
    page.mouse.down()
    page.evaluate(COUNT, contender.root)
    start = time.perf_counter()
    for step in range(round(seconds * MOVES_A_SECOND)):
        across = 0.1 + 0.8 * abs(step % (2 * sweep) / sweep - 1)
        mouse.move(box["x"] + box["width"] * across, box["y"] + box["height"] / 2)
        time.sleep(max(0, start + (step + 1) / MOVES_A_SECOND - time.perf_counter()))
    count = page.evaluate(STOP)
    if count == 0:
        raise RuntimeError(f"{contender.name} showed nothing new while dragged; run it again")
    contender.rates.append(count / (time.perf_counter() - start))
    mouse.rest()
    page.mouse.up()
    page.wait_for_timeout(1500)


@contextmanager
def page_with(cells: list[str]) -> Iterator[tuple[Any, Mouse]]:
    """Run a notebook in a fresh JupyterLab; yield its page and a mouse."""
    with tempfile.TemporaryDirectory() as place:
        folder, home = Path(place, "notebooks"), Path(place, "home")
        folder.mkdir()
        home.mkdir()
        path = write_notebook(folder / "bench.ipynb", *cells)
        lab = Lab(folder, home)
        try:
            port = free_port()
            with browser(f"--remote-debugging-port={port}") as program:
                page = program.new_page(viewport={"width": 1400, "height": 1100})
                open_notebook(page, lab, path)
                errors = run_all_cells(page)
                if errors:
                    raise RuntimeError(f"the benchmark's notebook failed: {errors}")
                yield page, Mouse(port, page.url)
        finally:
            lab.stop()


def take_turns(
    page: Any, mouse: Mouse, contenders: list[Contender], rounds: int, drags: int
) -> None:
    """Measure every contender once a round; the first round warms up and is dropped."""
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
            drag(page, mouse, contender, seconds=3.0)


def pointer_latency(page: Any, root: str) -> float:
    """Return the median time from a pointer's movement to what it shows, ms."""
    page.locator(root).scroll_into_view_if_needed()
    box = page.locator(f"{root} canvas").first.bounding_box()
    page.evaluate(POINTER, root)
    for step in range(90):
        x = box["x"] + box["width"] * (0.1 + 0.8 * (step % 30) / 30)
        page.mouse.move(x, box["y"] + box["height"] * (0.2 + step / 150))
        page.wait_for_timeout(20)
    return statistics.median(page.evaluate("() => window.benchPointer"))


def measure(chapter: str, rounds: int = 15, drags: int = 3) -> list[Row]:
    """Measure a chapter's explorers against the bare round trip and what notebooks usually do."""
    cells = ["from benchmarks.peers import RoundTrip, naive"]
    cells += [f"from course_lib.widgets.{chapter} import *", "RoundTrip()"]
    bare = Contender("bare round trip", ".bench-round-trip", "input")
    pairs = []
    for place, (name, make, title, slider, *moved) in enumerate(EXPLORERS[chapter]):
        root = f'.course-explorer[aria-label="{title}"]'
        cells += [f"e{place} = {make}()\ne{place}", f"naive(e{place}, {slider!r})"]
        handle = f'input[name="{moved[0]}"]' if moved else "input[type=range]"
        ours = Contender(name, root, handle)
        peer = Contender(f"naive {name}", f".bench-naive-{slider}", ".noUi-handle")
        pairs.append((ours, peer))
    with page_with(cells) as (page, mouse):
        take_turns(page, mouse, [bare, *(c for pair in pairs for c in pair)], rounds, drags)
        rows = _rows(bare, pairs)
        if chapter in ("pinhole", "epipolar"):
            pointer = pointer_latency(page, pairs[0][0].root)
            rows.append(Row("what follows the pointer", pointer, "ms", goal="≤ 16 ms"))
    return rows


def _rows(bare: Contender, pairs: list[tuple[Contender, Contender]]) -> list[Row]:
    """Return the table: every explorer against both peers."""
    rows = []
    for ours, peer in pairs:
        what = f"{ours.name}: slider to new pixels"
        rows.append(Row(what, ours.latency, "ms", "bare round trip", bare.latency, "≤ 1.6 ×"))
        rows.append(Row(what, ours.latency, "ms", "interact + plt.show", peer.latency, "≤ 0.2 ×"))
    for ours, peer in pairs:
        what = f"{ours.name}: while dragging"
        rows.append(Row(what, ours.rate, "/s", "interact + plt.show", peer.rate, "≥ 20 /s"))
    rows.append(Row("bare round trip: while dragging", bare.rate, "/s"))
    return rows
