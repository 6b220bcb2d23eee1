"""Whatever goes in: tie points and blocks, or an error that says what to do."""

import numpy as np
import pytest
from fuzzing import either, fuzzing, numbers, outcome
from hypothesis import given
from hypothesis import strategies as st

from course_lib.bundle import Observations
from course_lib.reconstruction import reconstruct
from course_lib.tie_points import (
    Features,
    agreeing_matches,
    find_features,
    join_matches,
    match_features,
    tracks,
)
from data_generators.blocks import flight

fuzz = fuzzing(25)
pytestmark = pytest.mark.filterwarnings("error")

KNOWN = flight(np.random.default_rng(0), 1, 4, 120, wrong=0.1)
SEEN, K = KNOWN.observations, KNOWN.truth.K[0]
pictures = st.one_of(
    st.sampled_from(
        [
            np.zeros((40, 50), np.uint8),
            np.full((3, 3, 3), 0.5),
            np.zeros((1, 1), np.uint8),
            np.zeros((0, 4)),
            np.indices((60, 60)).sum(0) % 7 / 6,
            np.random.default_rng(1).integers(0, 65535, (70, 90), np.uint16),
        ]
    ),
    st.lists(st.lists(numbers, max_size=4), max_size=4),
    numbers,
)
sightings = st.lists(st.tuples(st.integers(0, 3), st.integers(0, 30)), min_size=1, max_size=90)
descriptors = st.integers(1, 6).flatmap(
    lambda n: st.lists(st.integers(0, 3), min_size=n, max_size=n)
)


def features(values):
    """Return details that differ in one number of their descriptors, some at the same place."""
    each = np.zeros((len(values), 128), np.float32)
    each[:, 0] = values
    return Features(np.repeat(np.array(values, float)[:, None], 2, axis=1), each)


@fuzz
@given(pictures, either(st.integers(1, 40)))
def test_find_features(picture, most):
    found = outcome(find_features, picture, most)
    if found is not None:
        assert 0 < len(found) <= most
        assert np.isfinite(found.points).all()


@fuzz
@given(st.lists(pictures, max_size=3))
def test_tracks(several):
    found = outcome(tracks, several)
    assert found is None or np.isfinite(found.pixels).all()


@fuzz
@given(descriptors, descriptors, descriptors, either(st.floats(0.1, 1)))
def test_matches_are_joined(one, other, third, ratio):
    each = [features(values) for values in (one, other, third)]
    pairs = {(i, j): outcome(match_features, each[i], each[j], ratio) for i, j in ((0, 1), (1, 2))}
    if any(found is None for found in pairs.values()):
        return
    for (i, j), found in pairs.items():
        assert len(np.unique(each[i].places[found[:, 0]])) == len(found)
        assert len(np.unique(each[j].places[found[:, 1]])) == len(found)
    seen = outcome(join_matches, each, pairs)
    if seen is not None:
        both = np.stack([seen.cameras, seen.points], axis=1)
        assert len(np.unique(both, axis=0)) == len(both)
        assert np.bincount(seen.points).min() >= 2
    assert outcome(agreeing_matches, each, pairs, K, np.random.default_rng(0)) == {}


@fuzzing(15)
@given(
    st.integers(0, 10**6),
    st.floats(0, 1),
    st.floats(0, 1),
    st.sampled_from([0.0, 1e-9, 30.0, 1e6]),
    either(st.floats(0.01, 50)),
)
def test_reconstruct(seed, share, moved, by, threshold):
    """A part of a block, of which a part is somewhere else."""
    rng = np.random.default_rng(seed)
    some = SEEN.only(rng.random(len(SEEN)) < share) if share > 0.01 else SEEN
    away = (rng.random(len(some)) < moved)[:, None] * by * rng.standard_normal((len(some), 2))
    seen = Observations(some.cameras, some.points, some.pixels + away)
    found = outcome(reconstruct, seen, K, np.random.default_rng(0), threshold)
    if found is not None:
        assert np.isfinite(found.block.points).all()
        assert np.isfinite(found.rms)
        assert (found.fates == "used").sum() == len(found.observations)
        assert len(found.cameras) + len(found.left_out) == seen.cameras.max() + 1


@fuzz
@given(
    st.lists(st.tuples(st.integers(0, 3), st.integers(0, 30)), min_size=1, max_size=90),
    st.floats(0, 1e6),
)
def test_nothing_at_all(pairs, size):
    """Observations that nobody made."""
    rows = np.array(sorted(set(pairs)))
    pixels = size * np.sin(np.arange(2.0 * len(rows))).reshape(-1, 2)
    seen = outcome(Observations, rows[:, 0], rows[:, 1], pixels)
    if seen is not None:
        outcome(reconstruct, seen, K, np.random.default_rng(0))
