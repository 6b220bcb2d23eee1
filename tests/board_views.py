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
