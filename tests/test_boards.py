import numpy as np
import pytest

from course_lib.boards import Charuco, Checkerboard, DotGrid, SquareGrid

BOARDS = [
    (Checkerboard(4, 3, 25), "4 × 3 corners"),
    (DotGrid(4, 3, 25, 15), "4 × 3 dots"),
    (Charuco(4, 3, 25, 18), "4 × 3 numbered corners"),
]


@pytest.mark.parametrize(("board", "name"), BOARDS)
def test_points(board, name):
    points = board.points()
    assert points.shape == (12, 3)
    np.testing.assert_allclose(
        points[[0, 3, 4, 11]], [(0, 0, 0), (75, 0, 0), (0, 25, 0), (75, 50, 0)]
    )
    assert board.name == name


def test_points_of_squares_go_around():
    points = SquareGrid(2, 2, 10, 16).points()
    assert points.shape == (16, 3)
    np.testing.assert_allclose(points[:4], [(0, 0, 0), (10, 0, 0), (10, 10, 0), (0, 10, 0)])
    np.testing.assert_allclose(points[4], (16, 0, 0))


@pytest.mark.parametrize(
    ("make", "said"),
    [
        (lambda: Checkerboard(2, 6, 25), "columns must be a whole number from 3 .* inner corners"),
        (lambda: DotGrid(9, 1, 25, 15), "rows must be a whole number from 2 .* dots"),
        (lambda: Checkerboard(9, 6.0, 25), "rows must be a whole number"),
        (lambda: Checkerboard(9, 6, 0), "square must be positive"),
        (lambda: Checkerboard(9, 6, float("nan")), "square must be finite"),
        (lambda: DotGrid(9, 6, 25, 25), "dots would touch"),
        (lambda: DotGrid(9, 6, 25, -1), "diameter must be positive"),
        (lambda: Charuco(9, 6, 25, 26), "marker must be smaller"),
        (lambda: SquareGrid(9, 6, 25, 20), "square must be smaller"),
    ],
)
def test_errors(make, said):
    with pytest.raises((TypeError, ValueError), match=said):
        make()
