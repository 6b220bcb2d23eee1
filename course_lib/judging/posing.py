"""Pose: an exercise and a seed become cases. The seed is the only secret."""

from __future__ import annotations

import hashlib

import numpy as np

from course_lib.judging.exercise import Case, Exercise, Known


def seed_for(*words: str) -> int:
    """Derive a seed from words, e.g. a key, a student and an exercise.

    Parameters
    ----------
    *words : str
        What the seed depends on. Their order matters.

    Returns
    -------
    int
        64 bits of SHA-256; the same words always give the same seed.
    """
    digest = hashlib.sha256("\x1f".join(words).encode()).digest()
    return int.from_bytes(digest[:8], "big")


def pose(exercise: Exercise, seed: int) -> list[Case]:
    """Draw the inputs of an exercise.

    Parameters
    ----------
    exercise : Exercise
        What to pose.
    seed : int
        Non-negative. The same seed always gives the same cases.

    Returns
    -------
    list of Case
        Part by part.
    """
    cases = []
    for i, name in enumerate(exercise.parts):
        part = exercise.part(name)
        for j in range(part.cases):
            drawn = part.draw(np.random.default_rng([seed, i, j]))
            if isinstance(drawn, Known):
                cases.append(Case(name, drawn.inputs, drawn.truth, known=True))
            else:
                cases.append(Case(name, drawn))
    return cases
