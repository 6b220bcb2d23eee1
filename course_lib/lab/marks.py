"""Where marks were left in photographs: in a small file beside the notebook, for another day."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from course_lib.lab.shots import Shot

FILE = "lab_marks.json"


def kept_marks(
    shot: Shot, names: Sequence[str], folder: str | Path = "."
) -> NDArray[np.float64] | None:
    """Return where the marks of these names were left in a photograph; None if nobody moved them.

    Parameters
    ----------
    shot : Shot
        The photograph.
    names : sequence of str
        Of both marks.
    folder : str or Path
        Where the file is.

    Returns
    -------
    ndarray, shape (2, 2), optional
        Pixels.
    """
    try:
        places = np.array(_read(Path(folder, FILE)).get(_key(shot, names)), float)
    except (TypeError, ValueError):
        return None
    return places if places.shape == (2, 2) and np.isfinite(places).all() else None


def keep_marks(
    shot: Shot, names: Sequence[str], places: NDArray[np.float64], folder: str | Path = "."
) -> None:
    """Write down where the marks are, beside those of other photographs.

    Parameters
    ----------
    shot, names, folder
        As of `kept_marks`.
    places : ndarray, shape (2, 2)
        Pixels.
    """
    path = Path(folder, FILE)
    held = _read(path) | {_key(shot, names): np.round(places, 1).tolist()}
    lines = ",\n".join(f"{json.dumps(k)}: {json.dumps(v)}" for k, v in held.items())
    try:
        path.write_text(f"{{\n{lines}\n}}\n", encoding="utf-8")
    except OSError:
        return  # nothing can be written here: the marks last as long as the notebook is open


def _key(shot: Shot, names: Sequence[str]) -> str:
    whose = "" if shot.own else "supplied "
    return f"{whose}{shot.name}: {', '.join(names)}"


def _read(path: Path) -> dict[str, Any]:
    """Return what was kept; nothing if there is no such file, or another one."""
    try:
        held = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return held if isinstance(held, dict) else {}
