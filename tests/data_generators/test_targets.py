import numpy as np
import pytest

from data_generators.targets import (
    DARK,
    WHITE,
    bar_target,
    checkerboard,
    dot_grid,
    letter_chart,
    siemens_star,
)

TARGETS = {
    "checkerboard": lambda: checkerboard(9, 7, 16),
    "dot_grid": lambda: dot_grid(5, 4, 20),
    "siemens_star": lambda: siemens_star(128, 12),
    "bar_target": lambda: bar_target(256),
    "letter_chart": lambda: letter_chart(256, 5, rng=np.random.default_rng(1)),
}


@pytest.mark.parametrize("name", TARGETS)
def test_shapes(name):
    target = TARGETS[name]()
    assert target.ndim == 2
    assert target.dtype == np.uint8
    assert (target.min(), target.max()) == (DARK, WHITE)
    np.testing.assert_array_equal(target, TARGETS[name]())
    # A white rim all around, so that the target ends on its own terms.
    assert (target[[0, -1]] == WHITE).all()


def test_errors():
    with pytest.raises(ValueError, match="columns must be a whole number of at least 1, got 0"):
        checkerboard(0, 7)
    with pytest.raises(ValueError, match="spokes"):
        siemens_star(64, 0)
    with pytest.raises(ValueError, match="groups get finer"):
        bar_target(ratio=0.5)


def test_checkerboard_accuracy():
    board = checkerboard(4, 3, 10, 1.0)
    assert board.shape == (50, 60)
    np.testing.assert_array_equal(board[15, 15:50:10], (DARK, WHITE, DARK, WHITE))
    np.testing.assert_array_equal(board[15:40:10, 15], (DARK, WHITE, DARK))


def test_dot_grid_accuracy():
    grid = dot_grid(3, 2, 40, 0.5)
    share = (WHITE - grid.astype(float)).sum() / (WHITE - DARK)
    assert share == pytest.approx(6 * np.pi * 10**2, rel=0.01)
    u = np.arange(40)
    dot = WHITE - grid[:40, :40].astype(float)
    assert (dot * u).sum() / dot.sum() == pytest.approx(19.5)


def test_siemens_star_has_its_spokes():
    star = siemens_star(256, 12)
    angle = np.linspace(0, 2 * np.pi, 3601)[:-1]
    ring = star[
        np.rint(127.5 + 90 * np.sin(angle)).astype(int),
        np.rint(127.5 + 90 * np.cos(angle)).astype(int),
    ]
    dark = ring < 128
    assert (dark & ~np.roll(dark, 1)).sum() == 12


def test_letters_turn_with_the_generator():
    first = letter_chart(256, 5, rng=np.random.default_rng(1))
    assert (first != letter_chart(256, 5, rng=np.random.default_rng(2))).any()
