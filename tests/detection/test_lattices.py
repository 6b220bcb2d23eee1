import numpy as np
import pytest

from course_lib.detection.lattices import (
    cell_middles,
    grid_of_loose_points,
    mirrored,
    next_row,
    turned,
)


def bent_grid(rows=6, columns=9):
    """A grid as a lens and perspective show it, shape (rows, columns, 2)."""
    y, x = np.indices((rows, columns)).astype(float)
    w = 1 + 0.02 * x + 0.03 * y
    u, v = (40 * x + 10 * y) / w, (40 * y - 6 * x) / w
    return np.stack([100 + u + 1e-4 * u * v, 80 + v - 2e-4 * u**2], axis=-1)


class TestLoosePoints:
    @pytest.mark.parametrize("seed", range(5))
    def test_finds_the_grid_among_others(self, seed):
        rng = np.random.default_rng(seed)
        grid = bent_grid().reshape(-1, 2)
        others = rng.uniform((500, 0), (800, 300), (20, 2))
        order = rng.permutation(74)
        points = np.concatenate([grid, others])[order]
        places = grid_of_loose_points(points)
        assert sorted(order[list(places.values())]) == list(range(54))
        # Neighbours on the grid are neighbours on the board.
        number = {place: order[point] for place, point in places.items()}
        steps = {abs(number[r, c + 1] - number[r, c]) for r, c in number if (r, c + 1) in number}
        assert steps in ({1}, {9})

    def test_a_missing_point_is_left_out(self):
        points = np.delete(bent_grid().reshape(-1, 2), 20, axis=0)
        assert len(grid_of_loose_points(points)) == 53

    def test_sizes_tell_strangers(self):
        grid = bent_grid()
        stranger = next_row(grid)
        points = np.concatenate([grid.reshape(-1, 2), stranger])
        sizes = np.r_[np.full(54, 10.0), np.full(9, 30.0)]
        assert len(grid_of_loose_points(points)) == 63
        assert len(grid_of_loose_points(points, sizes)) == 54

    def test_stragglers_are_left_out(self):
        grid = bent_grid()
        points = np.concatenate([grid.reshape(-1, 2), next_row(grid)[:2]])
        assert len(grid_of_loose_points(points)) == 54

    @pytest.mark.parametrize("points", [np.empty((0, 2)), np.zeros((3, 2)), np.ones((9, 2))])
    def test_no_grid(self, points):
        assert len(grid_of_loose_points(points)) <= 1

    def test_a_line_is_no_grid(self):
        assert len(grid_of_loose_points(np.stack([np.arange(9.0), np.zeros(9)], axis=1))) <= 1


class TestTurned:
    @pytest.mark.parametrize("turn", range(4))
    @pytest.mark.parametrize("flip", [False, True])
    def test_however_it_comes(self, turn, flip):
        grid = bent_grid()
        came = np.rot90(grid.swapaxes(0, 1) if flip else grid, turn)
        np.testing.assert_array_equal(turned(came, 9, 6), grid)

    def test_wrong_size(self):
        with pytest.raises(ValueError, match="9 × 5"):
            turned(bent_grid(), 9, 5)

    def test_mirrored(self):
        assert not mirrored(bent_grid())
        assert mirrored(bent_grid()[:, ::-1])


def test_next_row_goes_on_as_before():
    longer = bent_grid(rows=7)
    np.testing.assert_allclose(next_row(longer[:6]), longer[6], atol=0.2)
    np.testing.assert_allclose(next_row(bent_grid(rows=2)), bent_grid(rows=3)[2], atol=4)


def test_cell_middles():
    y, x = np.indices((3, 4)).astype(float)
    middles = cell_middles(np.stack([x, y], axis=-1))
    assert middles.shape == (2, 3, 2)
    np.testing.assert_allclose(middles[1, 2], (2.5, 1.5))
