"""The still figures of chapter 10, one function each, and what they are drawn from."""

from __future__ import annotations

from course_lib.drawing.bundle.acquisition import acquisition, timeline
from course_lib.drawing.bundle.flights import control_flatters, domes
from course_lib.drawing.bundle.growing import chain, grown, vase
from course_lib.drawing.bundle.matrices import small_block, sparsity, whole_jacobian
from course_lib.drawing.bundle.pictures import (
    followed_points,
    neighbours,
    photographs,
    reconstructed,
)
from course_lib.drawing.bundle.real import strasbourg, strasbourg_plan, textbook_resection
from course_lib.drawing.bundle.space import chains_from_above, two_gauges, vase_block
from course_lib.drawing.bundle.stepping import (
    adjustment_steps,
    arrow,
    block_rms,
    half_chain,
    pixel,
    pose_rms,
    small_equations,
    third_picture,
)

__all__ = [
    "acquisition",
    "adjustment_steps",
    "arrow",
    "block_rms",
    "chain",
    "chains_from_above",
    "control_flatters",
    "domes",
    "followed_points",
    "grown",
    "half_chain",
    "neighbours",
    "photographs",
    "pixel",
    "pose_rms",
    "reconstructed",
    "small_block",
    "small_equations",
    "sparsity",
    "strasbourg",
    "strasbourg_plan",
    "textbook_resection",
    "third_picture",
    "timeline",
    "two_gauges",
    "vase",
    "vase_block",
    "whole_jacobian",
]
