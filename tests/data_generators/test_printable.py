import re
import zlib

import cv2
import numpy as np
import pytest

from course_lib.boards import Charuco, Checkerboard, DotGrid, SquareGrid
from course_lib.detection import detect_board
from data_generators.printable import dark_rectangles, first_point, printed_size, save_board

POINT = 25.4 / 72  # mm
BOARDS = [
    Checkerboard(9, 6, 20),
    DotGrid(9, 6, 20, 12),
    Charuco(9, 6, 20, 15),
    SquareGrid(8, 6, 12, 20),
]


def page_of(path):
    """Size of the page in mm, and the drawing commands."""
    content = path.read_bytes()
    box = [float(x) for x in re.search(rb"/MediaBox \[([^\]]*)\]", content)[1].split()]
    streams = re.findall(rb"stream\r?\n(.*?)\r?\nendstream", content, re.S)
    texts = []
    for stream in streams:
        try:
            texts.append(zlib.decompress(stream).decode("latin-1"))
        except (zlib.error, UnicodeDecodeError):
            continue
    return np.array(box[2:]) * POINT, max((t for t in texts if " m\n" in t), key=len)


def rectangles_of(commands):
    """Left, top and size of the closed quadrilaterals of a page, mm; curves are left out."""
    found = []
    for part in re.split(r"\bh\b", commands):
        corners = re.findall(r"([-\d.]+) ([-\d.]+) [ml]\b", part)
        if len(corners) >= 4 and " c\n" not in part:
            points = np.array(corners, float) * POINT
            found.append([*points.min(axis=0), *np.ptp(points, axis=0)])
    return np.array(found)


@pytest.mark.parametrize("board", BOARDS)
def test_page_has_the_right_size(board, tmp_path):
    size, _ = page_of(save_board(tmp_path / "board.pdf", board))
    np.testing.assert_allclose(size, (297, 210), atol=1e-3)


@pytest.mark.parametrize("board", [b for b in BOARDS if not isinstance(b, DotGrid)])
def test_printed_to_scale(board, tmp_path):
    _, commands = page_of(save_board(tmp_path / "board.pdf", board))
    printed = rectangles_of(commands)
    squares = printed[(abs(printed[:, 2:] - board.square) < 0.01).all(axis=1)]
    expected = dark_rectangles(board, np.zeros(2))
    expected = expected[expected[:, 2] == board.square]
    assert len(squares) == len(expected)
    corners = squares[:, :2] * (1, -1)
    corners -= corners[np.lexsort(corners.T)[0]]
    wanted = expected[:, :2] - expected[np.lexsort(expected[:, :2].T)[0], :2]
    wanted, corners = (np.array(sorted(np.round(c, 2).tolist())) for c in (wanted, corners))
    np.testing.assert_allclose(corners, wanted, atol=0.02)
    # The bar below, and the one that stands where there is room.
    assert (abs(printed[:, 2] - 100) < 0.01).sum() == 2
    assert (abs(printed[:, 3] - 100) < 0.01).sum() == 2


def test_dots_are_round_and_to_scale(tmp_path):
    board = BOARDS[1]
    _, commands = page_of(save_board(tmp_path / "board.pdf", board))
    starts = re.findall(r"([-\d.]+) ([-\d.]+) m\n[^m]*? c\n", commands)
    bottoms = np.array(starts, float) * POINT
    bottoms = bottoms[bottoms[:, 1] > 25]
    assert len(bottoms) == 54
    np.testing.assert_allclose(np.diff(np.unique(bottoms[:, 0].round(2))), 20, atol=0.02)
    np.testing.assert_allclose(np.diff(np.unique(bottoms[:, 1].round(2))), 20, atol=0.02)


@pytest.mark.parametrize("board", [BOARDS[0], BOARDS[2]])
def test_what_is_printed_is_found(board):
    scale = 3  # px in a mm
    size = np.rint((printed_size(board) + 20) * scale).astype(int)
    picture = np.full(size[::-1], 230, np.uint8)
    corner = first_point(board) + 10
    for left, top, width, height in dark_rectangles(board, corner) * scale:
        columns, rows = (
            slice(round(left), round(left + width)),
            slice(round(top), round(top + height)),
        )
        picture[rows, columns] = 20
    found = detect_board(cv2.GaussianBlur(picture, (0, 0), 0.8), board)
    assert len(found.ids) == 54
    # Pixel edges are at -0.5.
    expected = (board.points()[:, :2] + corner) * scale - 0.5
    np.testing.assert_allclose(found.points, expected[found.ids], atol=0.05)


def test_same_board_same_file(tmp_path):
    one, two = (save_board(tmp_path / name, BOARDS[2]).read_bytes() for name in ("1.pdf", "2.pdf"))
    assert one == two


def test_too_large(tmp_path):
    with pytest.raises(ValueError, match=r"take 400 × 280 mm, .* say --square 25.*, or --page A2"):
        save_board(tmp_path / "board.pdf", Checkerboard(9, 6, 40))
    assert not list(tmp_path.iterdir())


def test_unknown_page(tmp_path):
    with pytest.raises(ValueError, match="page must be one of A4"):
        save_board(tmp_path / "board.pdf", BOARDS[0], "B5")


@pytest.mark.parametrize("board", [Checkerboard(9, 6, 40), DotGrid(12, 9, 30, 20)])
def test_the_size_that_is_proposed_fits(board, tmp_path):
    with pytest.raises(ValueError, match="say --square") as raised:
        save_board(tmp_path / "board.pdf", board)
    said = dict(re.findall(r"--(square|diameter) ([\d.]+)", str(raised.value)))
    lengths = [float(said[name]) for name in ("square", "diameter") if name in said]
    assert save_board(tmp_path / "b.pdf", type(board)(board.columns, board.rows, *lengths)).exists()


def test_page_in_small_letters(tmp_path):
    size, _ = page_of(save_board(tmp_path / "board.pdf", BOARDS[0], "a3"))
    np.testing.assert_allclose(size, (420, 297), atol=1e-3)


def test_no_room_for_a_second_bar(tmp_path):
    _, commands = page_of(save_board(tmp_path / "board.pdf", Checkerboard(13, 6, 20)))
    printed = rectangles_of(commands)
    assert (abs(printed[:, 3] - 100) < 0.01).sum() == 0


class TestBeside:
    board = Checkerboard(9, 6, 15.0)

    def test_frame_for_the_object(self, tmp_path):
        """The board is as large as without it; at its right is a frame, as high as the board."""
        pages = [
            page_of(save_board(tmp_path / f"{k}.pdf", self.board, beside=k == 1))[1]
            for k in range(2)
        ]
        centred, beside = (
            p[(abs(p[:, 2:] - 15) < 0.01).all(axis=1)] for p in map(rectangles_of, pages)
        )
        moved = centred[:, :2] - beside[:, :2]
        np.testing.assert_allclose(np.ptp(moved, axis=0), 0, atol=0.01)
        (frame,) = (p for p in rectangles_of(pages[1]) if abs(p[3] - 105) < 0.1)
        right_of_board = beside[:, 0].max() + 15
        assert frame[0] == pytest.approx(right_of_board + 8, abs=0.1)
        assert frame[0] + frame[2] == pytest.approx(297 - 8, abs=0.1)
        assert frame[2] > 86  # a bank card

    def test_no_room(self, tmp_path):
        with pytest.raises(ValueError, match=r"9 mm beside .* say --square 19.5") as raised:
            save_board(tmp_path / "board.pdf", Checkerboard(9, 6, 25.0), beside=True)
        square = float(re.findall(r"--square ([\d.]+)", str(raised.value))[0])
        smaller = Checkerboard(9, 6, square)
        assert save_board(tmp_path / "board.pdf", smaller, beside=True).exists()
