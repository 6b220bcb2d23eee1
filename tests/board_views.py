"""Views of a known board by a known camera, as calibrations of it need them."""

import numpy as np

from course_lib.calibration import board_points
from data_generators.board_observations import observe_board

SIZE = (640, 480)
K = np.array([[700.0, 0, 330], [0, 720, 250], [0, 0, 1]])
k = np.array([-0.25, 0.1, 0.001, -0.0008, 0.02])
BOARD = board_points(8, 6, 30)


def observe(seed=0, views=8, noise=0.0, K=K, k=k, **how):
    return observe_board(np.random.default_rng(seed), BOARD, K, k, SIZE, views, noise, **how)


def random_set(seed):
    """Draw a camera, a board and views of all kinds; return K, k and what was seen."""
    rng = np.random.default_rng(seed)
    f = rng.uniform(500, 1500)
    K = np.array([[f, 0, 0], [0, f * rng.uniform(0.95, 1.05), 0], [0, 0, 1]])
    K[:2, 2] = rng.uniform((260, 190), (380, 290))
    k = rng.uniform(-1, 1, 4) * [0.25, 0.1, 2e-3, 2e-3]
    board = board_points(int(rng.integers(5, 12)), int(rng.integers(4, 9)), 30)
    views = int(rng.integers(4, 16))
    return K, k, observe_board(rng, board, K, k, SIZE, views, 0.3, tilt=0.4)
