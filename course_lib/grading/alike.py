"""Submissions that look alike, for a person to look at: never more than a reason to look.

An answer becomes a row of words in which all names of the student's own are one word, so that new
names, comments and line breaks change nothing. Runs of a few words in a row are compared, as in
MOSS (S. Schleimer, D. Wilkerson, A. Aiken, Winnowing: local algorithms for document fingerprinting,
SIGMOD 2003); answers are short, so all runs are kept and nothing needs to be winnowed. What the
notebook already held, and what many students write, counts little or nothing: a run that d of n
students have weighs log(n / d).
"""

from __future__ import annotations

import builtins
import io
import itertools
import keyword
import math
import re
import tokenize
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass

#: Words in a run.
RUN = 7
#: An answer with fewer runs of its own is left out: such answers must look alike.
FEWEST_RUNS = 12
#: Runs that at least this share of the class has are what one writes here.
COMMON = 0.5
#: Two submissions are listed from this weighed share of the smaller one on, ...
ALIKE = 0.8
#: ... if so many answers are alike, and the weights of their common runs have this sum.
FEWEST_ANSWERS, EVIDENCE = 3, 80.0
KNOWN = {*dir(builtins), *keyword.kwlist, "np", "numpy", "cv2", "scipy", "plt"}
_SKIPPED = {
    tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT,
    tokenize.ENCODING, tokenize.ENDMARKER,
}  # fmt: skip
_STARTS = {tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT, tokenize.NL, tokenize.ENCODING}

Word = tuple[str, int]
Run = tuple[str, ...]
Reader = Callable[[str], list[Word]]


@dataclass(frozen=True)
class AlikeAnswers:
    """Two answers to one question, and the lines (from 0) of each that the other has too."""

    cell: str
    sources: tuple[str, str]
    lines: tuple[frozenset[int], frozenset[int]]
    share: float


@dataclass(frozen=True)
class AlikePair:
    """Two students whose answers look alike.

    Attributes
    ----------
    students : tuple of str
        Who, in alphabetical order.
    share : float
        How much of the smaller submission the other has too, by weight; 1 is all of it.
    answers : tuple of AlikeAnswers
        Those that are alike.
    """

    students: tuple[str, str]
    share: float
    answers: tuple[AlikeAnswers, ...]


@dataclass(frozen=True)
class _Question:
    """The answers of a class to one question: their runs, and what these weigh."""

    cell: str
    is_prose: bool
    sources: Mapping[str, str]
    runs: Mapping[str, Mapping[Run, set[int]]]
    weight: Mapping[Run, float]
    rare: Mapping[str, frozenset[Run]]
    worth: Mapping[str, float]


def find_alike(
    given: Mapping[str, str], answers: Mapping[str, Mapping[str, str]], prose: Iterable[str] = ()
) -> tuple[list[AlikePair], float]:
    """Find pairs of submissions that look alike nearly everywhere.

    Parameters
    ----------
    given : mapping of str to str
        What the cells of the answers held when students got the notebook, by label.
    answers : mapping of str to mapping of str to str
        By student and label: the source of the cell.
    prose : iterable of str
        Labels of the cells that hold no code. What is alike in them is shown, but a person reads
        them anyway, and they are not needed to be listed.

    Returns
    -------
    pairs : list of AlikePair
        Those with the largest share first.
    others : float
        The largest share below `ALIKE`: how alike those are who are not listed.
    """
    in_words = set(prose)
    questions = []
    for cell, stub in given.items():
        read = prose_words if cell in in_words else code_words
        sources = {who: cells[cell] for who, cells in answers.items() if cell in cells}
        questions.append(_question(cell, read(stub), sources, read))
    found = [_compared(questions, pair) for pair in itertools.combinations(sorted(answers), 2)]
    pairs = [pair for pair in found if pair is not None]
    listed = [p for p in pairs if p.share >= ALIKE and len(p.answers) >= FEWEST_ANSWERS]
    others = max((p.share for p in pairs if p.share < ALIKE), default=0.0)
    return sorted(listed, key=lambda pair: (-pair.share, pair.students)), others


def _question(cell: str, stub: list[Word], sources: Mapping[str, str], read: Reader) -> _Question:
    """Weigh the runs of all answers to one question; keep the answers that are long enough."""
    known = set(_runs(stub))
    runs = {who: _runs(read(text)) for who, text in sources.items()}
    spread = Counter(run for own in runs.values() for run in own)
    many = COMMON * len(runs)
    weight = {r: math.log(len(runs) / d) for r, d in spread.items() if r not in known and d < many}
    rare = {who: frozenset(run for run in own if run in weight) for who, own in runs.items()}
    long = {who: own for who, own in rare.items() if len(own) >= FEWEST_RUNS}
    worth = {who: sum(weight[run] for run in own) for who, own in long.items()}
    return _Question(cell, read is prose_words, sources, runs, weight, long, worth)


def _compared(questions: Iterable[_Question], pair: tuple[str, str]) -> AlikePair | None:
    """Compare two students over all that both answered at length; None if little is the same."""
    one, other = pair
    common, worth, alike = 0.0, [0.0, 0.0], []
    for q in questions:
        if one not in q.rare or other not in q.rare:
            continue
        both = q.rare[one] & q.rare[other]
        same = sum(q.weight[run] for run in both)
        if not q.is_prose:
            common += same
            worth = [worth[0] + q.worth[one], worth[1] + q.worth[other]]
        share = same / min(q.worth[one], q.worth[other])
        if share >= ALIKE:
            first, second = (_lines(q.runs[who], both) for who in pair)
            texts = (q.sources[one], q.sources[other])
            alike.append(AlikeAnswers(q.cell, texts, (first, second), share))
    return AlikePair(pair, common / min(worth), tuple(alike)) if common >= EVIDENCE else None


def _runs(words: Sequence[Word]) -> dict[Run, set[int]]:
    """Return all runs of words, each with the lines in which it stands."""
    found: dict[Run, set[int]] = {}
    for start in range(len(words) - RUN + 1):
        part = words[start : start + RUN]
        found.setdefault(tuple(w for w, _ in part), set()).update(line for _, line in part)
    return found


def _lines(runs: Mapping[Run, set[int]], both: Iterable[Run]) -> frozenset[int]:
    return frozenset().union(*(runs[run] for run in both))


def code_words(source: str) -> list[Word]:
    """Return the words of a cell of code with their lines, without what can be changed freely.

    Parameters
    ----------
    source : str
        Python, or what a student takes for it: reading ends where it cannot be read.

    Returns
    -------
    list of tuple of str and int
        Words and lines, from 0. Names other than those of Python and its libraries are one word;
        comments and texts that stand alone are left out.
    """
    words: list[Word] = []
    before = tokenize.ENCODING
    try:
        for token in tokenize.generate_tokens(io.StringIO(source).readline):
            alone = token.type == tokenize.STRING and before in _STARTS
            if token.type not in _SKIPPED and not alone:
                after_dot = bool(words) and words[-1][0] == "."
                words.append((_word(token, after_dot), token.start[0] - 1))
            before = token.type if token.type != tokenize.COMMENT else before
    except (tokenize.TokenError, SyntaxError):
        pass
    return words


def _word(token: tokenize.TokenInfo, after_dot: bool) -> str:
    if token.type == tokenize.NAME and not after_dot and token.string not in KNOWN:
        return "name"
    return token.string


def prose_words(source: str) -> list[Word]:
    """Return the words of a text in small letters, with their lines."""
    return [
        (word, number)
        for number, line in enumerate(source.splitlines())
        for word in re.findall(r"\w+", line.lower())
    ]
