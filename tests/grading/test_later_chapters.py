"""Notebooks of later chapters, whose answers call functions of earlier ones, behind the walls."""

from pathlib import Path

import nbformat
import pytest
from walls import walled

from course_lib.exercises import CHAPTERS
from course_lib.grading.outside import Judge, Submitted
from course_lib.grading.submissions import given_cells
from data_generators.classes import Simulation
from data_generators.typed_answers import right, wrong_answers

pytestmark = [pytest.mark.slow, walled]
NOTEBOOKS = Path(__file__).resolve().parents[2] / "notebooks"


@pytest.mark.parametrize("chapter", ["epipolar", "triangulation", "bundle", "planning"])
def test_points_are_exactly_those_expected(chapter):
    """One student types the references, which call each other; one has misconceptions."""
    path = NOTEBOOKS / CHAPTERS[chapter] / f"{CHAPTERS[chapter]}.ipynb"
    simulation = Simulation(nbformat.read(path, as_version=4), chapter)
    with Judge() as judge:
        for make in (right, lambda exercise: next(wrong_answers(exercise))):
            handed_in = simulation.hand_in("ada", {e.name: make(e) for e in simulation.exercises})
            notebook = nbformat.reads(handed_in.content.decode(), as_version=4)
            found = judge.judge(Submitted(notebook, "a seed", given_cells(path)))
            assert not found.reason
            points = {v.exercise: v.points for v in found.verdicts.values() if v is not None}
            assert points == handed_in.points
