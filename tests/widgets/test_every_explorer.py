"""What every explorer of the course owes its reader, wherever its controls stand."""

import importlib
import inspect
import pkgutil
from functools import partial
from pathlib import Path

import numpy as np
import pytest
from explorer_list import EXPLORERS
from matplotlib import get_data_path
from PIL import ImageFont
from real_data import fetched

from course_lib import widgets
from course_lib.widgets.controls import Choice, Slider
from course_lib.widgets.explorer import Explorer


def makers():
    """Return the functions that make an explorer, by name."""
    modules = [
        importlib.import_module(f"course_lib.widgets.{module.name}")
        for module in pkgutil.iter_modules(widgets.__path__)
    ]
    return {
        name: function
        for module in modules
        for name, function in inspect.getmembers(module, inspect.isfunction)
        if function.__module__ == module.__name__
        and inspect.signature(function).return_annotation in ("Explorer", Explorer)
    }


#: Letters as large as the browser's, which has 9 px for 10 of a picture on a laptop.
LETTERS = ImageFont.truetype(Path(get_data_path(), "fonts/ttf/DejaVuSans.ttf"), 12)
NARROWED = 0.9
MAKERS = makers()
MAKERS["distortion_explorer, twelve"] = partial(MAKERS["distortion_explorer"], twelve=True)


@pytest.fixture(scope="module", params=MAKERS)
def explorer(request):
    return MAKERS[request.param]()


def places(control):
    """Return where a control can stand."""
    if isinstance(control, Slider):
        return control.positions
    return list(control.options) if isinstance(control, Choice) else [False, True]


def anywhere(explorer, rng):
    """Return a state of an explorer, often at an end of its controls."""
    return {
        name: (where := places(control))[int(rng.choice([0, -1, rng.integers(len(where))]))]
        for name, control in explorer._controls.items()
    }


def seen(explorer):
    """Return all that a frame shows, as something to compare."""
    frame = explorer.frame_now()
    pictures = [
        (
            p.image.tobytes() if p.image is not None else b"",
            [np.array(x.points).tobytes() for x in p.lines],
        )
        for p in frame.pictures
    ]
    return frame.in_words(), pictures


def test_the_browser_meets_all_of_them():
    assert sorted(maker for _, maker, _, _ in EXPLORERS.values()) == sorted(makers())


def test_whatever_its_state_it_can_be_drawn_and_put_into_words(explorer):
    rng, said = np.random.default_rng(1), []
    for _ in range(25):
        explorer.set(**anywhere(explorer, rng))
        pictures = explorer.frame_now().pictures
        said.append([picture.alt for picture in pictures])
        for picture in pictures:
            assert len(picture.alt) > 30
            assert picture.alt.endswith(".")
            for label in picture.labels:
                at = np.array(label.at)
                assert ((at >= 0) & (at <= picture.size)).all(), (explorer.state, label)
                # The browser moves a word inwards, where it has room.
                assert LETTERS.getlength(label.text) <= NARROWED * picture.size[0], label
    assert all(len(set(words)) > 1 for words in zip(*said, strict=True)), "the words never change"


def test_no_control_is_without_effect(explorer):
    rng, idle = np.random.default_rng(2), set(explorer._controls)
    for _ in range(12):
        explorer.set(**anywhere(explorer, rng))
        state = explorer.state
        for name in sorted(idle):
            shown = []
            for end in (places(explorer._controls[name])[0], places(explorer._controls[name])[-1]):
                explorer.set(**state | {name: end})
                shown.append(seen(explorer))
            if shown[0] != shown[1]:
                idle.remove(name)
    if idle & {"photograph", "pair"}:  # where there are no real ones, all are the same
        fetched("opencv_stereo/left01.jpg")
    assert not idle


def test_reset_shows_the_first_frame_again(explorer):
    explorer.reset()
    first, state, rng = seen(explorer), explorer.state, np.random.default_rng(3)
    while explorer.state == state:
        explorer.set(**anywhere(explorer, rng))
    assert seen(explorer) != first
    explorer.reset()
    assert seen(explorer) == first
