"""Pose, answer, judge: what an exercise is and what an answer to it is worth.

The three steps are pure and separate, so that a process boundary can run between them:

- `pose` turns an exercise and a seed into cases (inputs),
- `answer` runs a student's function on the cases and returns plain values,
- `judge` compares the answers with the truth and returns a `Verdict`.

Nothing here knows Jupyter or files.
"""

from course_lib.judging.answering import Answer, OwnAnswers, answer
from course_lib.judging.comparison import Close, Exactly, YesOrNo
from course_lib.judging.exercise import (
    Case,
    Exercise,
    Explain,
    Known,
    Misconception,
    Part,
    Raises,
    ValuesExercise,
)
from course_lib.judging.geometric import ImageClose, RaySet, RotationClose, UpToScale
from course_lib.judging.limits import Limits
from course_lib.judging.posing import pose, seed_for
from course_lib.judging.verdict import Feedback, PartVerdict, Verdict, judge

__all__ = [
    "Answer",
    "Case",
    "Close",
    "Exactly",
    "Exercise",
    "Explain",
    "Feedback",
    "ImageClose",
    "Known",
    "Limits",
    "Misconception",
    "OwnAnswers",
    "Part",
    "PartVerdict",
    "Raises",
    "RaySet",
    "RotationClose",
    "UpToScale",
    "ValuesExercise",
    "Verdict",
    "YesOrNo",
    "answer",
    "judge",
    "pose",
    "seed_for",
]
