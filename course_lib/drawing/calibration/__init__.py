"""The still figures of chapter 07, one function each, and what they are drawn from."""

from __future__ import annotations

from course_lib.drawing.calibration.judging import (
    held_out_models,
    steps_down,
    views_grow,
)
from course_lib.drawing.calibration.photographs import (
    BOARD,
    SIZE,
    computed_photographs,
    contact_sheet,
    detected_corners,
    left_photographs,
    opencv_corners,
    slipped_search,
    zhang_data,
)
from course_lib.drawing.calibration.residuals import (
    over_the_picture,
    residual_arrows,
    views_one_by_one,
)
from course_lib.drawing.calibration.space import board_poses, vanishing_columns
from course_lib.drawing.calibration.stepping import (
    closed_form,
    in_turns,
    opencv_calibration,
    packed,
    residuals_and_derivatives,
    without_lens,
)
from course_lib.drawing.calibration.targets import flatness, targets, tilted_views, with_dots
from course_lib.drawing.calibration.using import focus_changes, ray_uncertainty, set_of_rays

__all__ = [
    "BOARD",
    "SIZE",
    "board_poses",
    "closed_form",
    "computed_photographs",
    "contact_sheet",
    "detected_corners",
    "flatness",
    "focus_changes",
    "held_out_models",
    "in_turns",
    "left_photographs",
    "opencv_calibration",
    "opencv_corners",
    "over_the_picture",
    "packed",
    "ray_uncertainty",
    "residual_arrows",
    "residuals_and_derivatives",
    "set_of_rays",
    "slipped_search",
    "steps_down",
    "targets",
    "tilted_views",
    "vanishing_columns",
    "views_grow",
    "views_one_by_one",
    "with_dots",
    "without_lens",
    "zhang_data",
]
