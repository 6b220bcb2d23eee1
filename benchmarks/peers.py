"""What the explorers are measured against: the bare round trip, and what notebooks usually do."""

from __future__ import annotations

from typing import Any

import anywidget

from course_lib.drawing.explorers.frame import Picture
from course_lib.widgets.explorer import Explorer

SCRIPT = """
export default { render({ model, el }) {
  const root = document.createElement("div"), input = document.createElement("input");
  const canvas = document.createElement("canvas");
  Object.assign(input, { type: "range", min: 0, max: 200, value: 100 });
  input.setAttribute("data-lm-suppress-shortcuts", "");
  root.className = "bench-round-trip";
  root.append(input, canvas);
  el.append(root);
  let sent = 0, answered = 0, waiting = false;
  const flush = () => {
    if (!waiting || sent - answered >= 2) return;
    waiting = false;
    sent += 1;
    model.send({ value: input.valueAsNumber });
  };
  input.addEventListener("input", () => { waiting = true; flush(); });
  model.on("msg:custom", (message) => {
    answered += 1;
    const context = canvas.getContext("2d");
    context.fillStyle = `hsl(${message.value} 80% 50%)`;
    context.fillRect(0, 0, canvas.width, canvas.height);
    root.dataset.frame = answered;
    flush();
  });
} };
"""


class RoundTrip(anywidget.AnyWidget):
    """A slider whose number goes to Python and back, and a canvas that then changes colour."""

    _esm = SCRIPT

    def __init__(self) -> None:
        super().__init__()
        self.on_msg(lambda _, content, __: self.send(content))


def naive(explorer: Explorer, name: str) -> Any:
    """Return an explorer's pictures as notebooks usually show them: ``interact``, Matplotlib.

    Parameters
    ----------
    explorer : Explorer
        Whose frame function draws the pictures; its other controls stay at their defaults.
    name : str
        The slider that moves.
    """
    import matplotlib.pyplot as plt
    from ipywidgets import IntSlider, VBox, interactive

    state, frame = explorer.state, explorer._frame
    positions = explorer._controls[name].positions

    def show(place: int) -> None:
        pictures = frame(**{**state, name: positions[place]}).pictures
        widths = [p.size[0] for p in pictures]
        # As many pixels as the explorer has, and a line for the titles.
        size = sum(widths) / 100, max(p.size[1] for p in pictures) / 100 + 0.3
        _, row = plt.subplots(
            1, len(pictures), figsize=size, dpi=100, width_ratios=widths, squeeze=False
        )
        for axes, picture in zip(row[0], pictures, strict=True):
            _plot(axes, picture)
        row[0][0].set_title(f"{name} = {positions[place]:g}", loc="left")  # always a new picture
        plt.show()

    slider = IntSlider(positions.index(state[name]), 0, len(positions) - 1)
    box = VBox([interactive(show, place=slider)])
    box.add_class(f"bench-naive-{name}")
    return box


def _plot(axes: Any, picture: Picture) -> None:
    """Draw one picture with its lines and labels, in its own pixels."""
    width, height = picture.size
    # Words outside the axes would enlarge what Jupyter saves, without a limit.
    axes.set(xlim=(-0.5, width - 0.5), ylim=(height - 0.5, -0.5))
    if picture.image is not None:
        axes.imshow(picture.image)
    for line in picture.lines:
        axes.plot(*zip(*line.points, strict=True))
    for label in picture.labels:
        axes.text(*label.at, label.text)
    axes.set_title(picture.title)
