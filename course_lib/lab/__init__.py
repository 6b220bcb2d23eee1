"""The lab of chapter 12: photographs to measure in, a camera from them, and a report to hand in."""

from course_lib.lab.figures import (
    comparison,
    contact_sheet,
    contributions,
    coverage,
    from_above,
    lens_bend,
    rays,
    straightened,
)
from course_lib.lab.numbers import number, say_pointing
from course_lib.lab.photographs import Work, calibrate, look
from course_lib.lab.real_pairs import (
    Checked,
    Compared,
    honest,
    measure_baselines,
    measure_real_pairs,
    measure_shifts,
)
from course_lib.lab.report import show_report, write_report
from course_lib.lab.results import Result, meeting, result
from course_lib.lab.shots import Shot, shot
from course_lib.lab.supplied import SUPPLIED
from course_lib.lab.words import say

__all__ = [
    "SUPPLIED",
    "Checked",
    "Compared",
    "Result",
    "Shot",
    "Work",
    "calibrate",
    "comparison",
    "contact_sheet",
    "contributions",
    "coverage",
    "from_above",
    "honest",
    "lens_bend",
    "look",
    "measure_baselines",
    "measure_real_pairs",
    "measure_shifts",
    "meeting",
    "number",
    "rays",
    "result",
    "say",
    "say_pointing",
    "shot",
    "show_report",
    "straightened",
    "write_report",
]
