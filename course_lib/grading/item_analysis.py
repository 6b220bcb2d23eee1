"""What the points of a class say about an exercise: how hard it is, and whom it tells apart."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from course_lib.checks import Array
from course_lib.grading.standings import Item, Standing, Standings
from course_lib.grading.states import STATES, State, failure_of, state_of

#: From so many students on, a correlation says anything.
FEWEST = 10


@dataclass(frozen=True)
class ItemAnalysis:
    """What is known of one item.

    Attributes
    ----------
    item : Item
        Which.
    count : int
        Of how many students points are known.
    difficulty : float or None
        The mean share of the points that they got: 1 is easy. None without students.
    discrimination : float or None
        The item-rest correlation: of the points here with those of all other exercises that are
        graded automatically. None for too few students, or where all have the same.
    states : mapping of str to int
        How many answers are in which state, where that was recorded.
    seconds : float or None
        What the answers took in the grader, median.
    """

    item: Item
    count: int
    difficulty: float | None
    discrimination: float | None
    states: Mapping[State, int]
    seconds: float | None


def analyse(standings: Standings) -> list[ItemAnalysis]:
    """Analyse every item of an assignment.

    Parameters
    ----------
    standings : Standings
        Of a class.

    Returns
    -------
    list of ItemAnalysis
        In the order of the notebooks.
    """
    automatic = [item.name for item in standings.items if not item.by_hand]
    return [_analysis(item, automatic, standings.graded) for item in standings.items]


def _analysis(item: Item, automatic: Sequence[str], graded: Sequence[Standing]) -> ItemAnalysis:
    known = [s for s in graded if s.points.get(item.name) is not None]
    if item.by_hand and any(item.name in s.waiting for s in graded):
        known = []  # until all are read, those that were not tried would stand for the class
    own = np.array([s.points[item.name] for s in known], dtype=float)
    others = [name for name in automatic if name != item.name]
    rest = np.array([sum(s.points.get(name) or 0.0 for name in others) for s in known])
    records = [s.record.get("exercises", {}).get(item.name) for s in graded]
    found = [record for record in records if record]
    states = Counter(state_of(record) for record in found)
    times = [record["seconds"] for record in found if record.get("seconds")]
    return ItemAnalysis(
        item,
        len(known),
        float(own.mean() / item.possible) if len(own) and item.possible else None,
        item_rest_correlation(own, rest),
        {state: states[state] for state in STATES},
        float(np.median(times)) if times else None,
    )


def item_rest_correlation(points: Array, rest: Array) -> float | None:
    """Return how the points of an item go with those of the rest: Pearson's correlation.

    Parameters
    ----------
    points, rest : ndarray, shape (N,)
        Points of each student in the item, and in all others.

    Returns
    -------
    float or None
        From -1 to 1; None for fewer than `FEWEST` students, or where one of both never varies.

    References
    ----------
    L. Crocker, J. Algina, Introduction to Classical and Modern Test Theory, 1986, chapter 14: the
    corrected item-total correlation.
    """
    if len(points) < FEWEST or np.ptp(points) == 0 or np.ptp(rest) == 0:
        return None
    return float(np.corrcoef(points, rest)[0, 1])


@dataclass(frozen=True)
class CommonMisconception:
    """A misconception, who showed it, and the hint that they saw."""

    exercise: str
    name: str
    hint: str
    students: tuple[str, ...]
    points_lost: float


def common_misconceptions(standings: Standings) -> list[CommonMisconception]:
    """Return what to talk about: misconceptions, those of most students first.

    Parameters
    ----------
    standings : Standings
        Of a class.

    Returns
    -------
    list of CommonMisconception
        Among those of as many students, those that cost most points first.
    """
    hints: dict[tuple[str, str], str] = {}
    who: dict[tuple[str, str], list[str]] = {}
    lost: Counter[tuple[str, str]] = Counter()
    for student in standings.graded:
        for exercise, found in student.record.get("exercises", {}).items():
            named = zip(found.get("misconceptions", ()), found.get("hints", ()), strict=False)
            for name, hint in named:
                key = (exercise, name)
                hints[key] = hint
                who.setdefault(key, []).append(student.student)
                lost[key] += found["possible"] - found["points"]
    ranked = sorted(who, key=lambda key: (-len(who[key]), -lost[key], key))
    return [CommonMisconception(*k, hints[k], tuple(who[k]), float(lost[k])) for k in ranked]


@dataclass(frozen=True)
class CommonFailure:
    """How points were lost without a known misconception: what, whose, points by exercise."""

    name: str
    students: tuple[str, ...]
    lost: Mapping[str, float]

    @property
    def points_lost(self) -> float:
        """Points lost in all exercises."""
        return sum(self.lost.values())


def common_failures(standings: Standings) -> list[CommonFailure]:
    """Return how points were lost where no misconception was found, e.g. by a forgotten return.

    Parameters
    ----------
    standings : Standings
        Of a class.

    Returns
    -------
    list of CommonFailure
        What cost most points first; its exercises, too.
    """
    who: dict[str, list[str]] = {}
    lost: dict[str, Counter[str]] = {}
    for student in standings.graded:
        for exercise, found in student.record.get("exercises", {}).items():
            if not found.get("misconceptions") and (name := failure_of(found)):
                who.setdefault(name, []).append(student.student)
                lost.setdefault(name, Counter())[exercise] += found["possible"] - found["points"]
    failures = [
        CommonFailure(name, tuple(dict.fromkeys(who[name])), dict(lost[name].most_common()))
        for name in who
    ]
    return sorted(failures, key=lambda f: (-f.points_lost, f.name))
