"""The still figures of chapter 07, one function each, and what they are drawn from."""

from __future__ import annotations

from course_lib.drawing.calibration.judging import (
    coverage_map,
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
    zhang_data,
)
from course_lib.drawing.calibration.residuals import (
    over_the_picture,
    residual_arrows,
    views_one_by_one,
)
from course_lib.drawing.calibration.space import board_poses, vanishing_columns
from course_lib.drawing.calibration.targets import flatness, targets

__all__ = [
    "BOARD",
    "SIZE",
    "board_poses",
    "computed_photographs",
    "contact_sheet",
    "coverage_map",
    "detected_corners",
    "flatness",
    "held_out_models",
    "left_photographs",
    "over_the_picture",
    "residual_arrows",
    "steps_down",
    "targets",
    "vanishing_columns",
    "views_grow",
    "views_one_by_one",
    "zhang_data",
]
