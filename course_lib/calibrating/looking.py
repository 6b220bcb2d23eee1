"""The board is looked for in each photograph, one after the other, so that memory holds one."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from course_lib.boards import Board, Charuco, Checkerboard, DotGrid
from course_lib.calibrating.pictures import (
    Header,
    Picture,
    SetAside,
    read_grey,
    read_header,
    usual_lens,
    usual_size,
    why_other_lens,
    why_other_size,
)
from course_lib.detection import Detection, detect_board
from course_lib.detection.result import grey_picture, shrunk

Tell = Callable[[str], None]

THUMBNAIL = 640  # px, long side
#: Two views whose points differ by less are the same view, px and by the picture's width.
SAME = 0.0005
#: So many photographs that agree on another board are believed.
AGREED = 3


@dataclass(frozen=True, eq=False)
class Photo:
    """A photograph, and what became of it.

    Attributes
    ----------
    path : Path
        The file.
    verdict : str
        A sentence: why it is used or not.
    used : bool
        Whether it takes part in the calibration.
    problem : str
        In a word, as `Detection.problem`; also ``"file"``, ``"size"``, ``"zoom"`` and
        ``"duplicate"``.
    header : Header, optional
        What the file says.
    detection : Detection, optional
        The board in it.
    thumbnail : ndarray, optional
        The picture, at most `THUMBNAIL` px, `uint8` grey.
    """

    path: Path
    verdict: str
    used: bool = False
    problem: str = ""
    header: Header | None = None
    detection: Detection | None = None
    thumbnail: Picture | None = None

    @property
    def name(self) -> str:
        """The file's name without its folder."""
        return self.path.name


def look_at_photos(paths: Sequence[Path], board: Board, tell: Tell) -> list[Photo]:
    """Return all photographs with the board in them or the reason why there is none.

    Parameters
    ----------
    paths : sequence of Path
        The files.
    board : Checkerboard, DotGrid, Charuco or SquareGrid
        What to look for.
    tell : callable
        Is told a line for each.

    Returns
    -------
    list of Photo
        In the order of the files.

    Raises
    ------
    ValueError
        If the first photographs agree on a board of other counts.
    """
    opened = [_opened(path) for path in paths]
    usual = _usual(opened)
    photos: list[Photo] = []
    for number, photo in enumerate(opened, 1):
        photo = _looked_at(photo, usual, photos, board)
        photos.append(photo)
        mark = "+" if photo.used else "-"
        tell(f"[{number:{len(str(len(paths)))}}/{len(paths)}] {mark} {photo.name}: {photo.verdict}")
        if not any(photo.used for photo in photos):
            check_board(photos, board)
    return photos


def look_at_photo(path: Path, board: Board, before: Sequence[Photo] = ()) -> Photo:
    """Return one photograph with the board in it or the reason why there is none.

    For photographs that come one by one, each of which wants its verdict at once.

    Parameters
    ----------
    path : Path
        The file.
    board : Checkerboard, DotGrid, Charuco or SquareGrid
        What to look for.
    before : sequence of Photo
        Those that came before: copies, and pictures of another size or zoom than most, are named.
        When all are there, `look_at_photos` knows better which size is the usual one.

    Returns
    -------
    Photo
        The photograph; nothing is raised for what is in a file.
    """
    photo = _opened(path)
    return _looked_at(photo, _usual([*before, photo]), before, board)


def _usual(photos: Sequence[Photo]) -> Header | None:
    """Return the header of a photograph like most: by its size, then by its lens."""
    headers = [photo.header for photo in photos if photo.header is not None]
    if not headers:
        return None
    size = usual_size(headers)
    return usual_lens([header for header in headers if header.size == size])


def check_board(photos: Sequence[Photo], board: Board) -> None:
    """Raise if three or more photographs, and most, agree on a board that is not this one.

    Raises
    ------
    ValueError
        The message says what was seen, and what to type.
    """
    if other := other_board(photos):
        raise ValueError(
            f"the photographs show {other[0]} × {other[1]}, not {board.name}: "
            f"{count_it(board, other)}"
        )
    kinds = [photo.problem for photo in photos if photo.detection]
    if AGREED <= kinds.count("other kind") > len(kinds) / 2:
        seen = Counter(p.detection.seen for p in photos if p.detection).most_common(1)[0][0]
        raise ValueError(
            f"the photographs show a checkerboard, not {board.name}: leave --kind out and say "
            f"--board {seen[0]}x{seen[1]}"
        )


def other_board(photos: Sequence[Photo]) -> tuple[int, int] | None:
    """Return the counts of another board, if most photographs, and three or more, show that one."""
    seen = Counter(
        p.detection.seen for p in photos if p.detection and p.problem in ("wrong size", "cut off")
    )
    seen.pop((0, 0), None)
    if not seen:
        return None
    counts, times = seen.most_common(1)[0]
    others = sum(1 for photo in photos if photo.detection) - times
    return counts if times >= AGREED and times > others else None


def count_it(board: Board, seen: tuple[int, int]) -> str:
    """Return what to type if the board has other counts."""
    what = "dots" if isinstance(board, DotGrid) else "squares"
    if isinstance(board, Checkerboard | Charuco):
        what = "inner corners, where four squares meet, not squares"
    return f"is it --board {seen[0]}x{seen[1]}? Count {what}"


def _opened(path: Path) -> Photo:
    try:
        return Photo(path, "", header=read_header(path))
    except SetAside as reason:
        return Photo(path, _sentence(reason), problem="file")


def _looked_at(photo: Photo, usual: Header | None, before: Sequence[Photo], board: Board) -> Photo:
    """Return a photograph with the board looked for, unless something stands against it."""
    header = photo.header
    if header is None or usual is None:
        return photo
    twin = next((b for b in before if b.header and b.header.digest == header.digest), None)
    if twin is not None:
        told = f"The same file as {twin.name}."
        return replace(photo, problem="duplicate", verdict=told, thumbnail=twin.thumbnail)
    try:
        grey = grey_picture(read_grey(photo.path))
    except SetAside as reason:
        return replace(photo, problem="file", verdict=_sentence(reason))
    small = shrunk(grey, max(1.0, max(grey.shape) / THUMBNAIL))[0]
    photo = replace(photo, thumbnail=np.clip(np.rint(small), 0, 255).astype(np.uint8))
    if header.size != usual.size:
        why = _sentence(why_other_size(header.size, usual.size))
        return replace(photo, problem="size", verdict=why)
    if why := why_other_lens(header, usual):
        return replace(photo, problem="zoom", verdict=_sentence(why))
    found = detect_board(grey, board)
    photo = replace(photo, detection=found, problem=found.problem)
    same = next((b for b in before if _same_view(b, found, usual.size[0])), None)
    if same is not None:
        told = f"The same as {same.name}: the board is where it is there, which tells nothing new."
        return replace(photo, problem="duplicate", verdict=told)
    return replace(photo, verdict=found.verdict, used=found.good)


def _same_view(photo: Photo, found: Detection, width: int) -> bool:
    """Return whether a photograph that is used shows the board at the same place."""
    other = photo.detection
    if not (photo.used and other and found.good) or not np.array_equal(other.ids, found.ids):
        return False
    apart = np.linalg.norm(other.points - found.points, axis=1)
    return bool(np.sqrt(np.mean(apart**2)) < max(0.2, SAME * width))


def _sentence(reason: object) -> str:
    text = str(reason)
    return text[0].upper() + text[1:] + "."
