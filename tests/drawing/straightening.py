"""What the figures of chapter 05 are given, and what is read off them."""

import numpy as np

from course_lib import distortion
from course_lib.drawing import distortion as draw
from course_lib.drawing.distortion import boards
from course_lib.drawing.style import ROLES
from data_generators import rails

LENS = [-0.31, 0.12]


def straightened():
    picture = boards.computed_board()
    line = boards.board_lines(picture)[0]
    maps = distortion.undistortion_map(rails.K, LENS, rails.SIZE)
    return picture, maps, (line, distortion.undistort_pixels(line, rails.K, LENS))


def ideal_rails():
    lines = rails.rail_points(rails.photograph())
    return [distortion.undistort_pixels(line, rails.K, LENS) for line in lines]


def bent(yours=None):
    picture = boards.computed_board()
    return draw.bent_lines(picture, boards.board_lines(picture), yours)


def coloured(ax, role):
    """Return the points of the lines of a role in axes."""
    return [np.asarray(line.get_xydata()) for line in ax.lines if line.get_color() == ROLES[role]]
