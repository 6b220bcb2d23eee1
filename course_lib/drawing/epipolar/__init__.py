"""The still figures of chapter 08, one function each, and what they are drawn from."""

from __future__ import annotations

from course_lib.drawing.epipolar.geometry import epipolar_plane, four_poses
from course_lib.drawing.epipolar.gruber import von_gruber
from course_lib.drawing.epipolar.judged import judged_matrix, judged_pose, pose_errors
from course_lib.drawing.epipolar.photographs import (
    computed_boards,
    motorcycle,
    painted_wall,
    stereo_boards,
)
from course_lib.drawing.epipolar.real import (
    board_fundamental,
    corner_lines,
    rows,
    strokes,
    two_answers,
    two_halves,
)
from course_lib.drawing.epipolar.street import (
    candidates,
    eight_pairs,
    forward,
    forward_fundamental,
    lines_of_points,
    of_rank_three,
    rank,
    street_cameras,
    street_points,
)

__all__ = [
    "board_fundamental",
    "candidates",
    "computed_boards",
    "corner_lines",
    "eight_pairs",
    "epipolar_plane",
    "forward",
    "forward_fundamental",
    "four_poses",
    "judged_matrix",
    "judged_pose",
    "lines_of_points",
    "motorcycle",
    "of_rank_three",
    "painted_wall",
    "pose_errors",
    "rank",
    "rows",
    "stereo_boards",
    "street_cameras",
    "street_points",
    "strokes",
    "two_answers",
    "two_halves",
    "von_gruber",
]
