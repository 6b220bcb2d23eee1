"""The question of chapter 10 that is answered in words: residuals at control points."""

from __future__ import annotations

from course_lib.judging import Explain

EXPLAIN_CONTROL_RESIDUALS = Explain(
    "bundle",
    "explain_control_residuals",
    rubric=[
        (1, "Says that the map was turned, moved and scaled to make just these residuals small."),
        (1, "Says that few control points flatter most: three give 9 numbers for 7 unknowns."),
        (1, "Names check points, surveyed but not used, as the test (or leaving one out in turn)."),
        (1, "Says where errors can hide: far from control, outside of it, in the middle (doming)."),
        (1, "Says where to put points: control around the edge and inside, checks in between."),
    ],
    model_answer=(
        "No. Scale, turn and place of the map were chosen so that just these residuals become as "
        "small as possible, so they tell how well the map was fitted, not how good it is. The "
        "fewer control points there are, the more this flatters: three give nine numbers for "
        "seven unknowns. Whoever wants the accuracy needs check points, which were surveyed and "
        "took no part in the adjustment; or leaves out each control point in turn. And the map "
        "may be worse where no control is: outside of it, where errors grow with the distance, or "
        "in the middle of the block, where a wrong lens bends it up like a dome. So control "
        "belongs around the edge and also inside, and check points lie between them."
    ),
)
