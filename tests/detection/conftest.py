from functools import cache
from types import SimpleNamespace

import numpy as np
import pytest

from data_generators.calibration_sets import calibration_set


@cache
def _rendered():
    flaws = {3: "blurred", 4: "glare", 5: "cut off"}
    rendered = calibration_set(
        6, rng=np.random.default_rng(3), image_size=(480, 360), flaws=flaws, samples=2
    )
    by_flaw = {view.flaw: view for view in rendered.views if view.flaw}
    clear = [view for view in rendered.views if not view.flaw]
    return SimpleNamespace(board=rendered.board, clear=clear, **rename(by_flaw))


def rename(by_flaw):
    return {flaw.replace(" ", "_"): view for flaw, view in by_flaw.items()}


@pytest.fixture(scope="session")
def rendered():
    """Pictures of a checkerboard: three clear ones, and one for each flaw."""
    return _rendered()
