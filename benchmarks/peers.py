"""What the explorers are measured against: the bare round trip, and what notebooks usually do."""

from __future__ import annotations

from typing import Any

import anywidget
import traitlets

from course_lib.drawing.explorers import Picture
from course_lib.widgets.controls import Slider
from course_lib.widgets.explorer import Explorer


class RoundTrip(anywidget.AnyWidget):
    """A slider whose number goes to Python and back, and a canvas that then changes colour."""

    _esm = """
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
    ready = traitlets.Bool(True).tag(sync=True)

    def __init__(self) -> None:
        super().__init__()
        self.on_msg(lambda _, content, __: self.send(content))


def naive(explorer: Explorer, name: str) -> Any:
    """Show an explorer's pictures as notebooks usually do: ``interact`` and a Matplotlib figure.

    Parameters
    ----------
    explorer : Explorer
        Whose frame function draws the picture; its other controls stay at their defaults.
    name : str
        The slider that moves.
    """
    import matplotlib.pyplot as plt
    from ipywidgets import FloatSlider, interact

    slider = explorer._controls[name]
    assert isinstance(slider, Slider)
    still = explorer.state

    def show(value: float) -> None:
        frame = explorer._frame(**{**still, name: value})
        _, row = plt.subplots(1, len(frame.pictures), figsize=(8, 4), squeeze=False)
        for axes, picture in zip(row[0], frame.pictures, strict=True):
            _plot(axes, picture)
        plt.show()

    step = (slider.stop - slider.start) / 100
    return interact(show, value=FloatSlider(slider.default, min=slider.start, max=slider.stop, step=step))


def _plot(axes: Any, picture: Picture) -> None:
    """Draw one picture with its lines and labels."""
    if picture.image is not None:
        axes.imshow(picture.image)
    for line in picture.lines:
        axes.plot(*zip(*line.points, strict=True))
    for label in picture.labels:
        axes.text(*label.at, label.text)
    axes.set_title(picture.title)
