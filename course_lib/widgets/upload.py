"""A box into which photographs are dropped; each gets its verdict while the next one travels.

A notebook's page and its kernel talk in messages, and JupyterLab closes the line at one of more
than 10 MB. So photographs come one after the other, in parts, and each part is answered.
"""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from html import escape
from pathlib import Path, PurePosixPath, PureWindowsPath
from typing import Any

import anywidget
import numpy as np
import traitlets
from numpy.typing import NDArray

from course_lib.drawing.lab.sheets import SIGNS
from course_lib.widgets.messages import jpeg

HERE = Path(__file__).parent
#: No photograph is larger, bytes.
MOST = 80_000_000


@dataclass(frozen=True, eq=False)
class Verdict:
    """What is said of a photograph that came.

    Attributes
    ----------
    name, words : str
        Its file, and a sentence: why it is used or not.
    used : bool
        Whether it is.
    thumbnail : ndarray, shape (h, w, 3), uint8, optional
        Small, with what was found in it.
    """

    name: str
    words: str
    used: bool
    thumbnail: NDArray[np.uint8] | None = None


class UploadBox(anywidget.AnyWidget):  # type: ignore[misc]
    """A place to drop photographs on, and a line on each that came.

    Parameters
    ----------
    title : str
        Names the box, also for a screen reader.
    folder : Path
        Where the photographs are put; it is made when the first one comes.
    look : callable
        From the path of a file in `folder` to its `Verdict`; it raises nothing.

    Attributes
    ----------
    rows : list of dict
        What the page shows of each photograph.
    """

    _esm = HERE / "upload.js"
    _css = "\n".join((HERE / name).read_text("utf-8") for name in ("explorer.css", "upload.css"))
    spec = traitlets.Dict().tag(sync=True)
    rows = traitlets.List().tag(sync=True)

    def __init__(self, title: str, folder: Path, look: Callable[[Path], Verdict]) -> None:
        self._folder, self._look = Path(folder), look
        self._parts: dict[str, bytearray] = {}
        super().__init__(spec={"title": title, "folder": _shown(self._folder), "most": MOST})
        self.on_msg(self._receive)

    def take(self, name: str, content: bytes) -> Verdict:
        """Look at a photograph, keep it if it is one, and show what is said of it.

        Parameters
        ----------
        name : str
            Of the file, as the browser tells it.
        content : bytes
            What is in it.

        Returns
        -------
        Verdict
            As `look` gave it; what has no thumbnail is no photograph, and not kept.
        """
        name = plain_name(name)
        try:
            self._folder.mkdir(parents=True, exist_ok=True)
            path = free_place(self._folder / name, content)
            new = not path.exists()
            path.write_bytes(content)
        except OSError as error:
            why = f"It cannot be written into {_shown(self._folder)} ({error.strerror})."
            verdict = Verdict(name, why, False)
        else:
            verdict = self._look(path)
            if verdict.thumbnail is None and new:  # no photograph
                path.unlink()
            if verdict.thumbnail is not None and path.name != name:
                other = f"It came as {name}, as another photograph is called already; both are kept"
                verdict = replace(verdict, words=f"{verdict.words} {other}.")
        self.rows = [*(row for row in self.rows if row["name"] != verdict.name), _row(verdict)]
        return verdict

    def _receive(self, _: object, content: Mapping[str, Any], buffers: Sequence[Any]) -> None:
        """Take a part of a photograph, and answer; with the last part, its verdict is there."""
        view, name, size = (content.get(key) for key in ("view", "name", "size"))
        if not (isinstance(view, str) and isinstance(name, str) and isinstance(size, int)):
            return
        parts = self._parts.setdefault(view, bytearray())
        if content.get("start") == 0:
            parts.clear()
        if content.get("start") == len(parts) and buffers:
            parts += buffers[0]
        if content.get("last"):
            del self._parts[view]
            whole = len(parts) == size <= MOST
            if whole:
                self.take(name, bytes(parts))
            else:
                lost = Verdict(plain_name(name), "It did not arrive whole: drop it again.", False)
                self.rows = [*self.rows, _row(lost)]
        self.send({"view": view, "taken": content.get("start")})

    def _repr_mimebundle_(self, **kwargs: Any) -> tuple[dict[str, Any], dict[str, Any]] | None:
        """Return the live box, with what came so far for readers without a kernel."""
        bundle = super()._repr_mimebundle_(**kwargs)
        if bundle is None:
            return None
        data, metadata = bundle
        title = self.spec["title"]
        said = [f"{row['sign']} {row['name']}: {row['words']}" for row in self.rows]
        words = said or ["Here, in a running notebook, photographs are dropped."]
        items = "".join(f"<li>{escape(line)}</li>" for line in words)
        data["text/html"] = f"<p><b>{escape(title)}</b></p><ul>{items}</ul>"
        return data | {"text/plain": "\n".join([title, *words])}, metadata


def free_place(path: Path, content: bytes) -> Path:
    """Return where a file is kept: ``IMG_1 (2).jpg`` if another one is called ``IMG_1.jpg``."""
    place, number = path, 1
    while place.exists() and place.read_bytes() != content:
        number += 1
        place = path.with_stem(f"{path.stem} ({number})")
    return place


def plain_name(name: str) -> str:
    """Return the name of a file without folders, whatever system it comes from."""
    last = PureWindowsPath(PurePosixPath(name).name).name.lstrip(".").strip()
    return "".join(c for c in last if c.isprintable() and c not in '<>:"|?*') or "photograph"


def _shown(folder: Path) -> str:
    """Return a folder as a reader knows it."""
    return folder.as_posix().rstrip("/") + "/"


def _row(verdict: Verdict) -> dict[str, Any]:
    picture = ""
    if verdict.thumbnail is not None:
        picture = "data:image/jpeg;base64," + b64encode(jpeg(verdict.thumbnail)).decode("ascii")
    said = {"name": verdict.name, "words": verdict.words, "used": verdict.used}
    return said | {"sign": SIGNS[verdict.used], "picture": picture}
