"""An explorer: controls that move pictures, drawn by one small front end of the course.

The browser sends the newest state and never more than two at a time; Python answers each with a
frame. So events coalesce while a slider is dragged, and the last state always arrives.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import anywidget
import traitlets

from course_lib.display import described_picture
from course_lib.drawing.explorers.frame import Frame
from course_lib.drawing.explorers.stills import still
from course_lib.widgets.controls import Control, Slider
from course_lib.widgets.messages import encode_frame

HERE = Path(__file__).parent
Value = float | str | bool


class Explorer(anywidget.AnyWidget):  # type: ignore[misc]
    """Controls and the pictures that follow them.

    Parameters
    ----------
    title : str
        Names the explorer, also for a screen reader.
    controls : sequence of Control
        What can be moved; the names are the arguments of `frame`.
    frame : callable
        Pure function from the state, as keyword arguments, to a `Frame`.

    Raises
    ------
    ValueError
        If two controls have the same name.
    """

    _esm = "\n".join((HERE / name).read_text("utf-8") for name in ("explorer.js", "picture.js"))
    _css = HERE / "explorer.css"
    spec = traitlets.Dict().tag(sync=True)
    first = traitlets.Dict().tag(sync=True)

    def __init__(
        self, title: str, controls: Sequence[Control], frame: Callable[..., Frame]
    ) -> None:
        names = [control.name for control in controls]
        if len(set(names)) < len(names):
            raise ValueError(f"every control needs its own name, got {names}")
        self._controls: dict[str, Control] = dict(zip(names, controls, strict=True))
        self._frame = frame
        self._state: dict[str, Value] = {c.name: c.nearest(c.default) for c in controls}
        self._count, self._raw = 0, False
        self._before: Frame | None = None
        # JupyterLab delivers widget messages on a thread of their own. Answers leave in the order
        # in which they were made: a frame names only what is new since the one before.
        self._lock = threading.Lock()
        message, buffers = self._answer({})
        super().__init__(
            spec={"title": title, "controls": [c.spec() for c in controls]},
            first={"message": message, "buffers": buffers},
        )
        self.on_msg(self._receive)

    @property
    def state(self) -> dict[str, Value]:
        """Where every control stands."""
        return dict(self._state)

    def set(self, **state: Value) -> None:
        """Move controls from Python; every view follows.

        Parameters
        ----------
        **state
            New values by control name; a slider moves to its nearest position.

        Raises
        ------
        ValueError
            If there is no control of that name, or a choice or a switch has no such value.
        """
        unknown = sorted(set(state) - set(self._controls))
        if unknown:
            names = ", ".join(self._controls)
            raise ValueError(f"no control named {', '.join(unknown)}; there are {names}")
        if refused := [why for n, v in state.items() if (why := self._controls[n].refusal(v))]:
            raise ValueError("; ".join(refused))
        with self._lock:
            self.send(*self._answer(state))

    def reset(self) -> None:
        """Move every control back to its default."""
        self.set(**{name: control.default for name, control in self._controls.items()})

    def frame_now(self) -> Frame:
        """Return the frame of the present state; errors of the frame function are raised."""
        return self._frame(**self._state)

    def _receive(self, _: object, content: Mapping[str, Any], __: object) -> None:
        """Answer a message of a view: its state, or only ``hello``."""
        mine = {"view": content.get("view"), "seq": content.get("seq")}
        with self._lock:
            self._raw = bool(content.get("raw"))
            if "state" not in content:  # a new view has nothing yet
                self._before = None
            message, buffers = self._answer(content.get("state") or {})
            self.send(message | mine, buffers)

    def _answer(self, changes: Mapping[str, Any]) -> tuple[dict[str, Any], list[bytes]]:
        """Move the controls, draw, and return the numbered frame, or why there is none."""
        self._move(changes)
        self._count += 1
        try:
            frame = self.frame_now()
            self._move(frame.follows)
            message, buffers = encode_frame(frame, self._raw, self._before)
            self._before = frame
        except Exception as error:  # a frame function may fail in any way; the reader is told
            message, buffers = {"error": self._sentence(error)}, []
        return {"count": self._count, "state": self.state} | message, buffers

    def _move(self, changes: Mapping[str, Any]) -> None:
        """Move controls to the positions nearest to the values in `changes`."""
        for name, value in changes.items():
            if name in self._controls:
                self._state[name] = self._controls[name].nearest(value)

    def _sentence(self, error: Exception) -> str:
        """Say which state could not be drawn, and why."""
        where = ", ".join(f"{name} = {self._shown(name)}" for name in self._state)
        return f"No picture for {where}. {type(error).__name__}: {error}"

    def _shown(self, name: str) -> str:
        """Return the value of a control with its unit."""
        control, value = self._controls[name], self._state[name]
        if isinstance(control, Slider):
            gap = "" if control.unit == "°" else " "
            return f"{control.text(float(value))}{gap}{control.unit}".strip()
        if isinstance(value, bool):
            return "on" if value else "off"
        return str(value)

    def _settings(self) -> str:
        """Return where the controls stand; sliders of one label together, if not at zero."""
        together: dict[str, list[Control]] = {}
        for control in self._controls.values():
            together.setdefault(control.label, []).append(control)
        shown = []
        for label, controls in together.items():
            if len(controls) == 1:
                shown.append(f"{label}: {self._shown(controls[0].name)}")
            elif moved := [c for c in controls if isinstance(c, Slider) and self._state[c.name]]:
                values = (f"{c.symbol} = {self._shown(c.name)}" for c in moved)
                shown.append(f"{label}: {', '.join(values)}")
        return "; ".join(shown) or "All sliders at zero"

    def _repr_mimebundle_(self, **kwargs: Any) -> tuple[dict[str, Any], dict[str, Any]] | None:
        """Return the live explorer, with a still figure and words for readers without a kernel."""
        bundle = super()._repr_mimebundle_(**kwargs)
        if bundle is None:
            return None
        data, metadata = bundle
        try:
            frame = self.frame_now()
            settings = self._settings()
            words = f"{settings}\n{frame.in_words()}"
            data["text/html"] = described_picture(still(frame, settings), words)
        except Exception as error:  # the live explorer shows the same sentence
            words = self._sentence(error)
        return data | {"text/plain": f"{self.spec['title']}\n{words}"}, metadata
