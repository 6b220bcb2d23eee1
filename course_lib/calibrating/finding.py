"""Which files are meant: pictures of folders and patterns, and what is left out of them."""

from __future__ import annotations

import glob
import re
from collections.abc import Sequence
from pathlib import Path

#: What is looked for in a folder.
ENDINGS = (".jpg", ".jpeg", ".png", ".tif", ".tiff", ".bmp", ".webp", ".pgm", ".ppm")
#: Pictures that cameras make and this program cannot open.
UNREADABLE = (".heic", ".heif", ".avif", ".dng", ".nef", ".cr2", ".cr3", ".arw", ".raf", ".orf")
HEIC_ENDINGS = (".heic", ".heif")
JPEG = "export as JPEG, in full size and not turned"
AS_JPEG = (
    f"{JPEG} (iPhone: Settings › Camera › Formats › Most "
    "Compatible takes the next ones as JPEG; for these, open them on a computer, or mail them "
    "in full size)"
)


def find_photos(arguments: Sequence[str]) -> list[Path]:
    """Return the files that are meant: files, all pictures of folders, or patterns like ``*.jpg``.

    Parameters
    ----------
    arguments : sequence of str
        As they were typed.

    Returns
    -------
    list of Path
        Each file once, in the order of the arguments. Names of files that do not exist stay.

    Raises
    ------
    ValueError
        If there are none.
    """
    found: list[Path] = []
    for argument in arguments:
        path = Path(argument)
        if path.is_dir():
            found += sorted(filter(_is_photo, path.iterdir()), key=_in_counting_order)
        elif any(sign in argument for sign in "*?[") and not path.exists():
            found += sorted(map(Path, glob.glob(argument)), key=_in_counting_order)
        elif not path.exists() and (not path.suffix or argument.endswith(("/", "\\"))):
            raise ValueError(f"there is no folder {argument}: is it written right?")
        else:
            found.append(path)
    if not found:
        others = "".join(f". {line}" for line in left_out(arguments)).rstrip(".")
        raise ValueError(f"no photographs in {' '.join(arguments)}: name files or a folder{others}")
    return list(dict.fromkeys(found))


def _is_photo(path: Path) -> bool:
    """Return whether a thing in a folder is meant: no hidden file, and nothing but a picture."""
    return path.suffix.lower() in ENDINGS and not path.name.startswith(".") and not path.is_dir()


def left_out(arguments: Sequence[str]) -> list[str]:
    """Return sentences on what is in the folders that were named, and is not looked at."""
    said = []
    for folder in (Path(argument) for argument in arguments if Path(argument).is_dir()):
        things = [p for p in sorted(folder.iterdir()) if not p.name.startswith(".")]
        inner = [p.name + "/" for p in things if p.is_dir()]
        others = [p for p in things if not p.is_dir() and not _is_photo(p)]
        unknown = [p for p in others if p.suffix.lower() in UNREADABLE]
        rest = [p.name for p in others if p not in unknown]
        if inner:
            said.append(f"Folders inside {folder}/ are not looked into: {_few(inner)}.")
        if unknown:
            told = _few([p.name for p in unknown])
            how = AS_JPEG if any(p.suffix.lower() in HEIC_ENDINGS for p in unknown) else JPEG
            said.append(f"Cannot be read: {told}. {how[0].upper()}{how[1:]}.")
        if rest:
            said.append(f"No photographs by their names: {_few(rest)}.")
    return said


def _few(names: Sequence[str], most: int = 4) -> str:
    """Return the first of some names, and how many more there are."""
    more = f" and {len(names) - most} more" if len(names) > most else ""
    return ", ".join(names[:most]) + more


def _in_counting_order(path: Path) -> list[tuple[int, str]]:
    """Return a key by which view2 comes before view10."""
    parts = re.split(r"(\d+)", path.name)
    return [(int(part), "") if part.isdigit() else (0, part) for part in parts]
