"""Boards to print: vector pages of exact size, with a bar to measure the print by."""

from __future__ import annotations

from pathlib import Path as FilePath
from typing import TYPE_CHECKING, Any

import numpy as np

from course_lib.boards import Board, Charuco, Checkerboard, DotGrid, SquareGrid
from course_lib.checks import Array
from data_generators.markers import charuco_markers

if TYPE_CHECKING:
    from matplotlib.path import Path

#: Width and height of pages held sideways, mm.
PAGES = {
    "A4": (297.0, 210.0),
    "A3": (420.0, 297.0),
    "A2": (594.0, 420.0),
    "A1": (841.0, 594.0),
    "letter": (279.4, 215.9),
}
MARGIN, FOOT = 8.0, 16.0  # mm: what printers leave white, and the line below the board
MM_PER_INCH = 25.4
#: Width of an upright bar, and the white that a detector wants around a board, mm.
BAR, RIM = 6.0, 8.0
#: Narrower, the room beside a board is too small for an object, mm.
ROOM = 60.0


def save_board(
    path: str | FilePath, board: Board, page: str = "A4", beside: bool = False
) -> FilePath:
    """Write a board as a PDF page.

    Parameters
    ----------
    path : str or Path
        The file; it is overwritten.
    board : Checkerboard, DotGrid, Charuco or SquareGrid
        The board, its lengths in mm.
    page : str
        ``"A4"``, ``"A3"``, ``"A2"``, ``"A1"`` or ``"letter"``, held sideways.
    beside : bool
        Whether the board is at the left, with a frame at its right into which an object is laid.

    Returns
    -------
    Path
        The file. All of it is lines and areas; the same board gives the same file.

    Raises
    ------
    ValueError
        If there is no such page, or the board does not fit; the message says what would.
    OSError
        If the file cannot be written.
    """
    import matplotlib as mpl
    from matplotlib.figure import Figure
    from matplotlib.patches import PathPatch

    page = _page_name(page)
    width, height = PAGES[page]
    board_size = printed_size(board)
    _check_fits(board, board_size, page)
    start = (np.array([width, height - FOOT]) - board_size) / 2
    if beside:
        start[0] = MARGIN + BAR + RIM
        _check_room(board, width - MARGIN - RIM - start[0], page)
    figure = Figure(figsize=(width / MM_PER_INCH, height / MM_PER_INCH))
    axes = figure.add_axes((0, 0, 1, 1), xlim=(0, width), ylim=(height, 0))
    axes.set_axis_off()
    corner = start + first_point(board)
    axes.add_patch(PathPatch(_outlines(board, corner), facecolor="black", linewidth=0))
    _draw_foot(axes, board, (width, height), beside)
    if beside:
        _draw_room(axes, start[0] + board_size[0] + RIM, start[1], (width - MARGIN, board_size[1]))
    path = FilePath(path)
    with mpl.rc_context({"pdf.fonttype": 42, "path.simplify": False}):
        figure.savefig(path, format="pdf", metadata={"CreationDate": None, "Title": board.name})
    return path


def printed_size(board: Board) -> Array:
    """Return width and height of what is printed dark, mm."""
    step = board.square if isinstance(board, Checkerboard | Charuco) else board.pitch
    counts = np.array([board.columns, board.rows])
    if isinstance(board, Checkerboard | Charuco):
        return np.asarray((counts + 1) * step)
    shape = board.diameter if isinstance(board, DotGrid) else board.square
    return np.asarray((counts - 1) * step + shape)


def first_point(board: Board) -> Array:
    """Return where the board's origin is, from the upper left of what is printed, mm."""
    if isinstance(board, Checkerboard | Charuco):
        return np.full(2, board.square)
    return np.full(2, board.diameter / 2 if isinstance(board, DotGrid) else 0.0)


def _page_name(page: str) -> str:
    """Return the page's name as it is written here: a4 is A4."""
    found = [name for name in PAGES if name.lower() == page.lower()]
    if not found:
        raise ValueError(f"page must be one of {', '.join(PAGES)}, got {page!r}")
    return found[0]


def _check_fits(board: Board, size: Array, page: str) -> None:
    """Raise unless the board, with its margins, fits on a page."""
    room = np.array(PAGES[page]) - 2 * MARGIN - (0, FOOT)
    if (size <= room).all():
        return
    larger = [
        name for name, of in PAGES.items() if (size <= np.array(of) - 2 * MARGIN - (0, FOOT)).all()
    ]
    raise ValueError(
        f"{board.name} take {size[0]:g} × {size[1]:g} mm, but {page} has room for "
        f"{room[0]:g} × {room[1]:g} mm: say {_smaller(board, float((room / size).min()))}"
        + (f", or --page {larger[0]}" if larger else "")
    )


def _check_room(board: Board, width: float, page: str) -> None:
    """Raise unless an object fits beside a board."""
    size = printed_size(board)[0]
    if size + ROOM > width:
        raise ValueError(
            f"{board.name} leave {max(width - size, 0):g} mm beside them on {page}, an object "
            f"wants {ROOM:g} mm: say {_smaller(board, (width - ROOM) / size)}, "
            "or leave out --beside"
        )


def _draw_room(axes: Any, left: float, top: float, size: tuple[float, float]) -> None:
    """Draw where an object is laid: up to the right edge, as high as the board, grey and thin."""
    from matplotlib.patches import Rectangle

    right, height = size
    axes.add_patch(
        Rectangle((left, top), right - left, height, fill=False, edgecolor="0.7", linewidth=0.5)
    )
    said = "Lay what you measure here, flat on the paper."
    axes.text((left + right) / 2, top + height - 4, said, fontsize=8, ha="center", color="0.4")


def _smaller(board: Board, factor: float) -> str:
    """Return what to type for a board that is smaller by a factor, rounded down to half mm."""
    told = []
    for name in ("square", "pitch", "diameter", "marker"):
        if hasattr(board, name):
            length = np.floor(2 * factor * getattr(board, name)) / 2
            # A dot grid's pitch is asked for as its square.
            option = "square" if name == "pitch" and isinstance(board, DotGrid) else name
            told.append(f"--{option} {length:g}")
    return " ".join(told)


def _outlines(board: Board, corner: Array) -> Path:
    """Return everything dark as one path; its parts then meet without a seam."""
    from matplotlib.path import Path

    if isinstance(board, DotGrid):
        centres = board.points()[:, :2] + corner
        return Path.make_compound_path(*(Path.circle(c, board.diameter / 2) for c in centres))
    return Path.make_compound_path(*(_rectangle(*r) for r in dark_rectangles(board, corner)))


def dark_rectangles(board: Checkerboard | Charuco | SquareGrid, corner: Array) -> Array:
    """Return left, top, width and height of all that is dark, shape (N, 4), mm.

    Parameters
    ----------
    board : Checkerboard, Charuco or SquareGrid
        The board.
    corner : ndarray, shape (2,)
        Where its origin is.
    """
    side = board.square
    if isinstance(board, SquareGrid):
        corners = board.points()[::4, :2] + corner
        return np.column_stack([corners, np.full((len(corners), 2), side)])
    places = np.argwhere(np.indices((board.rows + 1, board.columns + 1)).sum(axis=0) % 2 == 0)
    corners = corner - side + side * places[:, ::-1]
    rectangles = [np.column_stack([corners, np.full((len(corners), 2), side)])]
    if isinstance(board, Charuco):
        for column, row, cells in charuco_markers(board):
            cell = board.marker / len(cells)
            start = corner - side + side * np.array([column, row]) + (side - board.marker) / 2
            corners = start + cell * np.argwhere(cells)[:, ::-1]
            rectangles.append(np.column_stack([corners, np.full((len(corners), 2), cell)]))
    return np.concatenate(rectangles)


def _rectangle(left: float, top: float, width: float, height: float) -> Path:
    from matplotlib.path import Path

    right, bottom = left + width, top + height
    corners = [(left, top), (right, top), (right, bottom), (left, bottom), (left, top)]
    return Path(corners, closed=True)


def _draw_foot(axes: Any, board: Board, page: tuple[float, float], beside: bool) -> None:
    """Draw the bars of 100 mm and what the board is."""
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    left, y = MARGIN + 2, page[1] - MARGIN - 4
    parts = [_rectangle(left + k, y, 10, 2) for k in range(0, 100, 20)]
    parts += [_rectangle(left, y - 2, 100, 0.3), _rectangle(left, y + 2, 100, 0.3)]
    parts += [_rectangle(left + k, y - 2, 0.3, 6) for k in (-0.15, 99.85)]
    upright = beside or _has_room_beside(board, page)
    if upright:
        parts += _upright_bar(left, y - 6)
    axes.add_patch(PathPatch(Path.make_compound_path(*parts), facecolor="black", linewidth=0))
    sizes = {"square": "squares", "pitch": "pitch", "diameter": "dots", "marker": "markers"}
    told = [f"{word} {getattr(board, n):g} mm" for n, word in sizes.items() if hasattr(board, n)]
    bars = "both bars must" if upright else "this bar must"
    said = f"{board.name}, {', '.join(told)}. Print at 100 %; {bars} measure 100 mm."
    axes.text(left + 104, y + 1, said, fontsize=8, va="center")


def _has_room_beside(board: Board, page: tuple[float, float]) -> bool:
    """Return whether an upright bar fits between the margin and a white rim around the board."""
    beside = (page[0] - printed_size(board)[0]) / 2
    return bool(beside >= MARGIN + BAR + RIM)


def _upright_bar(left: float, bottom: float) -> list[Path]:
    """Return a bar of 100 mm that stands: printers scale both directions by themselves."""
    parts = [_rectangle(left, bottom - k - 10, 2, 10) for k in range(0, 100, 20)]
    parts += [_rectangle(left + k, bottom - 100, 0.3, 100) for k in (-0.3, 2)]
    return [*parts, *(_rectangle(left - 2, bottom - k, 6, 0.3) for k in (0.15, 100.15))]
