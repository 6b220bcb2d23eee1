"""The still figures of chapter 10, one function each, and what they are drawn from."""

from __future__ import annotations

from course_lib.drawing.bundle.acquisition import acquisition, timeline
from course_lib.drawing.bundle.flights import control_flatters, domes
from course_lib.drawing.bundle.growing import chain, grown, vase
from course_lib.drawing.bundle.matrices import small_block, sparsity, whole_jacobian
from course_lib.drawing.bundle.space import chains_from_above, two_gauges, vase_block

__all__ = [
    "acquisition",
    "chain",
    "chains_from_above",
    "control_flatters",
    "domes",
    "grown",
    "small_block",
    "sparsity",
    "timeline",
    "two_gauges",
    "vase",
    "vase_block",
    "whole_jacobian",
]
