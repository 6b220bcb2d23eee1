"""An exercise, written once, as data: reference, inputs in parts, misconceptions with hints."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from numpy.random import Generator

from course_lib.judging.comparison import Close, Comparison, Mismatch

Inputs = dict[str, Any]
#: What an answer must meet: None, or why it does not, from the answer and the inputs.
Demand = Callable[[Any, Inputs], Mismatch | None]


@dataclass(frozen=True)
class Known:
    """Inputs whose right answer is known by construction, not by the reference."""

    inputs: Inputs
    truth: Any


@dataclass(frozen=True)
class Raises:
    """The truth of inputs that have no answer: the exception with which to refuse them."""

    error: str


Draw = Callable[[Generator], Inputs | Known]


@dataclass(frozen=True)
class Part:
    """A named aspect of an exercise that earns its own share of the points.

    Parameters
    ----------
    draw : callable
        Makes inputs (by parameter name) from a random generator; may return `Known` instead.
    cases : int
        How many inputs are drawn. All must be answered rightly to earn the part.
    weight : float
        Share of the points, relative to the other parts.
    demand : callable, optional
        Where many answers are right: judges one by the inputs, instead of by the expected answer.
    """

    draw: Draw
    cases: int = 3
    weight: float = 1.0
    demand: Demand | None = None


@dataclass(frozen=True)
class Misconception:
    """A plausible wrong implementation, and what a good teaching assistant would ask about it.

    Parameters
    ----------
    variant : callable
        The wrong implementation.
    hint : str
        A question about it.
    also : sequence of callable
        The same mistake in other words, whose results differ: they get the same hint.
    compare : callable, optional
        How an answer is compared with the variant's, where chance leaves only the order of
        magnitude alike; else the exercise's comparison.
    explains : callable, optional
        Where many answers are right, and so are many wrong: whether this mistake leads to a wrong
        answer, from its case and the answer; else the variant's own answer is looked for.
    """

    variant: Callable[..., Any]
    hint: str
    also: Sequence[Callable[..., Any]] = ()
    compare: Comparison | None = None
    explains: Callable[[Case, Any], bool] | None = None

    @property
    def name(self) -> str:
        """The name of the wrong implementation, for reports."""
        return self.variant.__name__


@dataclass(frozen=True)
class Case:
    """One posed question: the inputs of one call."""

    part: str
    inputs: Inputs
    truth: Any = None
    known: bool = False


@dataclass(frozen=True)
class Exercise:
    """A function that a student writes.

    Parameters
    ----------
    chapter : str
        The chapter's module in `course_lib.exercises`, e.g. ``"pinhole"``.
    reference : callable
        The library's own function. Its signature and docstring become the stub, its body the
        solution, its results the expected ones.
    parts : mapping of str to Part or callable
        Named inputs; a bare function is a `Part` with the usual number of cases.
    misconceptions : sequence of Misconception
        At least three, each told apart from the reference and from the others by the inputs.
    points : float
        What a full answer earns.
    compare : callable
        How an answer is compared with the expected one.
    forbidden : sequence of str
        Full names of ready-made functions that would answer the exercise in one line; those of
        Python with the module in which they are defined.
    """

    chapter: str
    reference: Callable[..., Any]
    parts: Mapping[str, Part | Draw]
    misconceptions: Sequence[Misconception]
    points: float = 4.0
    compare: Comparison = field(default_factory=Close)
    forbidden: Sequence[str] = ()

    @property
    def none_is_untouched(self) -> bool:
        """Whether None says that nothing was answered yet, rather than being an answer."""
        return False

    @property
    def shows_expected(self) -> bool:
        """Whether a check may show the right answer for the inputs that it tried."""
        return True

    @property
    def function_name(self) -> str:
        """What the student's function is called: the name of the reference."""
        return self.reference.__name__

    @property
    def name(self) -> str:
        """Chapter and function, e.g. ``"pinhole.project_pinhole"``."""
        return f"{self.chapter}.{self.function_name}"

    def part(self, name: str) -> Part:
        """Return a part of the exercise by its name."""
        part = self.parts[name]
        return part if isinstance(part, Part) else Part(part)

    def part_points(self, name: str) -> float:
        """Return what a part is worth."""
        total = sum(self.part(other).weight for other in self.parts)
        return self.points * self.part(name).weight / total

    def as_answer(self, function: Callable[..., Any], case: Case) -> Any:
        """Return what `function`, as an answer to this exercise, gives for a case."""
        return function(*case.inputs.values())


@dataclass(frozen=True)
class ValuesExercise(Exercise):
    """Numbers that a student works out, each named, from given data.

    The reference takes the given data and returns a dictionary; its keys are the variables that
    the student assigns, and each is a part. `units` says what belongs behind each.
    """

    given: Inputs = field(default_factory=dict)
    units: Mapping[str, str] = field(default_factory=dict)
    parts: Mapping[str, Part | Draw] = field(init=False, default_factory=dict)

    def __post_init__(self) -> None:
        parts = {name: Part(self._draw, cases=1) for name in self.units}
        object.__setattr__(self, "parts", parts)

    @property
    def none_is_untouched(self) -> bool:
        """Variables start as None."""
        return True

    @property
    def shows_expected(self) -> bool:
        """Nothing is drawn at random here: what is expected is the answer."""
        return False

    def _draw(self, _: Generator) -> Inputs:
        return dict(self.given)

    def as_answer(self, function: Callable[..., Any], case: Case) -> Any:
        """Return the value that `function` gives to the variable this case asks for."""
        return function(**case.inputs)[case.part]


@dataclass(frozen=True)
class Explain:
    """A question answered in words and graded by a person with a rubric.

    The question itself stands in the lesson; here is what the grader needs.
    """

    chapter: str
    slug: str
    rubric: Sequence[tuple[float, str]]
    model_answer: str

    @property
    def name(self) -> str:
        """Chapter and slug, e.g. ``"pinhole.explain_focus"``."""
        return f"{self.chapter}.{self.slug}"

    @property
    def points(self) -> float:
        """What a full answer earns: the sum of the rubric."""
        return sum(points for points, _ in self.rubric)
