"""An everyday class: students of different strength with the usual mistakes, as in a real term.

`classes` has one submission of each kind and knows what it must get; this is for what is said
about a class as a whole.
"""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from nbformat import NotebookNode
from numpy.random import Generator

from course_lib.judging import Exercise, ValuesExercise
from data_generators.classes import TIMESTAMP, Simulation, Submission, write_submissions
from data_generators.handwriting import copy_off, rewrite
from data_generators.mishaps import TROUBLES
from data_generators.typed_answers import Typed, UnsteadyError, misconceived, right

#: First name, family name; some that a careless table would spoil.
PEOPLE = (
    ("Åsa", "Öberg"), ("Mai", "Nguyễn"), ("Liam", "O'Brien"), ("Zoë", "van der Berg"),
    ("Ana", "García, López"), ("Ivan", "Петров"), ("Sam", "=Summers"), ("Yuki", "Tanaka"),
    ("Fatima", "al-Hassan"), ("Jonas", "Weiß"), ("Ada", "Kowalska"), ("Tom", "Baker"),
    ("Lea", "Rossi"), ("Noah", "Schmidt"), ("Priya", "Patel"), ("Omar", "Farouk"),
    ("Nina", "Jovanović"), ("Luis", "Silva"), ("Emma", "Dubois"), ("Chen", "Wei"),
    ("Sara", "Lind"), ("Paul", "Mbeki"), ("Olga", "Novak"), ("Ben", "Cohen"), ("Ida", "Hansen"),
    ("Karl", "Huber"), ("Rosa", "Marino"), ("Amir", "Khan"), ("Eva", "Horák"), ("Max", "Keller"),
)  # fmt: skip
WORDS = (
    "The camera only changes how large the picture is.",
    "What is far away shrinks more when we come near, so the proportions change.",
    "I think it has to do with the distance and not with the lens.",
    "From far away all parts of a face have nearly the same distance.",
    "The ratio of two sizes in the picture is the ratio of size over depth.",
    "We tried it with the sliders, and the background grew.",
    "It is the same formula as above with another Z.",
    "I am not sure about this one.",
)
Function = Callable[..., Any]
LATE = "2026-10-03 09:30:00 UTC"


@dataclass(frozen=True)
class Member:
    """A student of the class and what came from them.

    Attributes
    ----------
    id, first_name, last_name : str
        As the gradebook has them.
    submission : Submission or None
        None if nothing was handed in.
    copied_from : str
        Whose answers these are; empty if they are the student's own.
    timestamp : str
        When it was handed in.
    """

    id: str
    first_name: str
    last_name: str
    submission: Submission | None
    copied_from: str = ""
    timestamp: str = TIMESTAMP

    @property
    def is_late(self) -> bool:
        """Whether it came after all others."""
        return self.timestamp == LATE


def everyday_class(released: NotebookNode, chapter: str, size: int, rng: Generator) -> list[Member]:
    """Make a class: one student copies another, one is late, one file damaged, one missing.

    Parameters
    ----------
    released : nbformat.NotebookNode
        The notebook that students got.
    chapter : str
        Its chapter's module of exercises, e.g. ``"pinhole"``.
    size : int
        How many students, at least 8 and at most 30.
    rng : numpy.random.Generator
        Chance.

    Returns
    -------
    list of Member
        In the order of `PEOPLE`.

    Raises
    ------
    ValueError
        If the size is too large or too small.
    """
    if not 8 <= size <= len(PEOPLE):
        raise ValueError(f"everyday_class makes 8 to {len(PEOPLE)} students, not {size}")
    simulation = Simulation(released, chapter)
    typed = [_answers(simulation, rng) for _ in range(size)]
    typed[-1] = _copied(typed[0], rng)
    members = []
    for number, own in enumerate(typed):
        who = f"s{number + 1:02d}"
        words = " ".join(rng.permutation(WORDS)[: rng.integers(0, 4)])
        members.append(Member(who, *PEOPLE[number], simulation.hand_in(who, own, words)))
    return _with_mishaps(members)


def _with_mishaps(members: list[Member]) -> list[Member]:
    """Let one be late, one file be cut off, and one student hand nothing in."""
    made = list(members)
    made[3] = replace(made[3], timestamp=LATE)
    whole = made[4].submission
    assert whole is not None
    half = Submission(whole.student, whole.content[: len(whole.content) // 2], None)
    made[4] = replace(made[4], submission=half)
    made[5] = replace(made[5], submission=None)
    made[-1] = replace(made[-1], copied_from=made[0].id)
    return made


def _answers(simulation: Simulation, rng: Generator) -> dict[str, Typed]:
    """Return what a student typed: more is right the stronger the student, less further on."""
    strength, typed = rng.normal(1.0, 1.2), {}
    for number, exercise in enumerate(simulation.exercises):
        hardness = 0.15 * number + 0.6 * math.sin(2 * number)
        one = _answer(exercise, strength - hardness, rng)
        if one:
            typed[exercise.name] = one
    return typed


def _answer(exercise: Exercise, ease: float, rng: Generator) -> Typed | None:
    if rng.random() < 1 / (1 + math.exp(-1.5 * ease)):
        return _in_own_hand(exercise, right(exercise), exercise.reference, rng)
    chance = rng.random()
    if chance < 0.15:
        return None
    if chance < 0.25 and not isinstance(exercise, ValuesExercise):
        return Typed(TROUBLES["undefined name"](exercise), 0.0)
    weights = [1 / (k + 1) ** 1.5 for k in range(len(exercise.misconceptions))]
    which = rng.choice(len(weights), p=[w / sum(weights) for w in weights])
    chosen = exercise.misconceptions[which]
    try:
        typed = misconceived(exercise, chosen)
    except UnsteadyError:
        return None
    return _in_own_hand(exercise, typed, chosen.variant, rng)


def _in_own_hand(exercise: Exercise, typed: Typed, function: Function, rng: Generator) -> Typed:
    if not isinstance(exercise, ValuesExercise):
        return Typed(rewrite(typed.source, rng), typed.points, typed.hint)
    values = function(**exercise.given)  # from a pocket calculator
    lines = [f"{name} = {float(values[name]):.6g}" for name in exercise.units]
    return Typed("\n".join(lines), typed.points, typed.hint)


def _copied(answers: Mapping[str, Typed], rng: Generator) -> dict[str, Typed]:
    """Type all functions of another student in, with other names."""
    functions = {name: one for name, one in answers.items() if one.source.startswith("def ")}
    return {n: Typed(copy_off(t.source, rng), t.points, t.hint) for n, t in functions.items()}


def write_everyday_class(directory: Path, assignment: str, members: Sequence[Member]) -> None:
    """Put what a class handed in where ``nbgrader collect`` would.

    Parameters
    ----------
    directory : pathlib.Path
        A term's directory.
    assignment : str
        E.g. ``"01_pinhole"``.
    members : sequence of Member
        From `everyday_class`.
    """
    handed_in = [member.submission for member in members if member.submission]
    write_submissions(directory, assignment, handed_in)
    for member in members:
        if member.submission:
            folder = directory / "submitted" / member.id / assignment
            (folder / "timestamp.txt").write_text(member.timestamp, encoding="utf-8")


def students_table(members: Sequence[Member]) -> str:
    """Return the table that ``nbgrader db student import`` reads."""
    table = io.StringIO()
    writer = csv.writer(table)
    writer.writerow(["id", "first_name", "last_name", "email"])
    for m in members:
        writer.writerow([m.id, m.first_name, m.last_name, f"{m.id}@university.example"])
    return table.getvalue()
