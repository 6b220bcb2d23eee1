"""What the fuzz tests share: settings, plausible and absurd inputs, and what may come out."""

import math

import numpy as np
from hypothesis import HealthCheck, settings
from hypothesis import strategies as st

#: What is no number, no point and no matrix, or one that nobody can have meant.
mischief = st.sampled_from(
    [math.nan, math.inf, "5", None, [], [1, [2, 3]], {}, 1j, True, [[[1.0]]], 1e60, -1e30, [0, 0]]
)
#: Mostly small numbers, some huge ones, some that are none.
numbers = st.one_of(st.floats(-2, 2), st.floats(-1e6, 1e6), st.floats())
small = st.floats(-10, 10)
whole = st.integers(-3, 3).map(float)
#: Numbers of which many are equal, so that points coincide or lie on a line.
often_equal = st.one_of(whole, whole, small, st.floats(-1e6, 1e6), st.floats())
#: A camera's intrinsics, upright and with a skew.
intrinsics = st.tuples(st.floats(1e-3, 1e6), st.floats(-1e3, 1e3)).map(
    lambda v: [[v[0], v[1], 320], [0, 2 * v[0], 240], [0, 0, 1]]
)


def fuzzing(examples, *suppressed):
    """Return settings that try the same examples every time."""
    return settings(
        derandomize=True,
        max_examples=examples,
        deadline=None,
        suppress_health_check=[HealthCheck.too_slow, *suppressed],
    )


def either(good):
    """Return arguments that are mostly good, sometimes mischief."""
    return st.one_of(good, good, good, mischief)


def rows_of(count, width):
    """Return tables: of plain numbers, which are often degenerate, and of any numbers."""
    return st.one_of(
        *(
            st.lists(
                st.lists(entry, min_size=width, max_size=width), min_size=count, max_size=count
            )
            for entry in (whole, small, often_equal)
        )
    )


def outcome(function, *arguments):
    """Return the answer, or None where the documented error came; anything else passes on."""
    try:
        return function(*arguments)
    except np.linalg.LinAlgError:  # a ValueError too, but it tells nobody what to do
        raise AssertionError("NumPy's own error came out") from None
    except (TypeError, ValueError) as error:
        message = str(error)
    assert len(message) > 15, "an error says what was expected"
    return None
