"""Notebooks of later chapters, whose answers call functions of earlier ones, behind the walls."""

from pathlib import Path

import nbformat
import numpy as np
import pytest
from walls import walled

from course_lib.exercises import CHAPTERS
from course_lib.grading.outside import Judge, Submitted
from course_lib.grading.submissions import given_cells
from data_generators.classes import Simulation
from data_generators.typed_answers import right, wrong_answers
from data_generators.unusual import unusual_class

pytestmark = [pytest.mark.slow, walled]
NOTEBOOKS = Path(__file__).resolve().parents[2] / "notebooks"


def class_of(simulation):
    """Yield who types the references, which call each other, who errs, and who has own cells."""
    makers = {
        "right": right,
        "first": lambda exercise: next(wrong_answers(exercise)),
        "last": lambda exercise: [*wrong_answers(exercise)][-1],
    }
    for student, make in makers.items():
        yield simulation.hand_in(student, {e.name: make(e) for e in simulation.exercises})
    yield next(unusual_class(simulation, np.random.default_rng(8)))


@pytest.mark.parametrize("chapter", ["epipolar", "triangulation", "bundle", "planning"])
def test_points_are_exactly_those_expected(chapter):
    path = NOTEBOOKS / CHAPTERS[chapter] / f"{CHAPTERS[chapter]}.ipynb"
    with Judge() as judge:
        for handed_in in class_of(Simulation(nbformat.read(path, as_version=4), chapter)):
            notebook = nbformat.reads(handed_in.content.decode(), as_version=4)
            found = judge.judge(Submitted(notebook, "a seed", given_cells(path)))
            assert not found.reason
            points = {v.exercise: v.points for v in found.verdicts.values() if v is not None}
            assert points == handed_in.points, handed_in.student
