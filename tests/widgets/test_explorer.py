import base64
import re
import threading

import cv2
import numpy as np
import pytest

from course_lib.drawing.explorers.frame import Frame, Picture, Readout
from course_lib.widgets.controls import Choice, Slider, Switch
from course_lib.widgets.explorer import Explorer

STILL = np.full((30, 40, 3), 90, np.uint8)
CONTROLS = (
    Slider("f", "Focal length", "f", "mm", 10, 100, 50, step=10),
    Slider("g", "Follower", "g", "mm", 10, 200, 50, step=10),
    Choice("sensor", "Sensor", ("FX", "DX"), "FX"),
    Switch("coupled", "Coupled"),
)


def frame(f, g, sensor, coupled):
    if f == 90:
        raise ValueError("a lens of 90 mm does not fit; choose another")
    moving = Picture("Moving", f"f is {f:g}", (40, 30), np.full((30, 40, 3), int(f), np.uint8))
    still = Picture("Still", "always grey", (40, 30), STILL)
    return Frame(
        (moving, still),
        (Readout("Doubled", "", f"{2 * f:g}", "mm"),),
        {"g": 2 * f} if coupled else {},
    )


class Recorded(Explorer):
    """An explorer that also keeps what it sends."""

    def __init__(self, *args):
        self.sent = []
        super().__init__(*args)

    def send(self, content, buffers=None):
        self.sent.append((content, buffers))
        super().send(content, buffers)

    def hear(self, **content):
        """Take a message as it comes from a browser; return the answer."""
        self._handle_custom_msg(content, [])
        return self.sent[-1]


@pytest.fixture
def explorer():
    return Recorded("Test bench", CONTROLS, frame)


def test_it_starts_at_its_defaults_with_a_first_frame(explorer):
    assert explorer.state == {"f": 50, "g": 50, "sensor": "FX", "coupled": False}
    assert explorer.first["message"]["pictures"][0]["alt"] == "f is 50"
    assert explorer.first["buffers"][1][:2] == b"\xff\xd8"  # JPEG, as the page may be anywhere


def test_python_can_drive_it(explorer):
    explorer.set(f=31, sensor="DX")
    assert explorer.state["f"] == 30
    assert explorer.frame_now().pictures[0].alt == "f is 30"
    assert explorer.sent[-1][0]["state"] == explorer.state
    explorer.reset()
    assert explorer.state == {"f": 50, "g": 50, "sensor": "FX", "coupled": False}


def test_every_message_is_answered_in_order_and_the_last_state_stays(explorer):
    answers = [explorer.hear(view="a", seq=i, state={"f": 10 * i})[0] for i in range(1, 8)]
    assert [a["seq"] for a in answers] == [1, 2, 3, 4, 5, 6, 7]
    assert [a["state"]["f"] for a in answers] == [10, 20, 30, 40, 50, 60, 70]
    counts = [a["count"] for a in answers]
    assert counts == sorted(set(counts))
    assert explorer.state["f"] == 70


def test_bad_states_from_a_browser_are_moved_to_good_ones(explorer):
    bad = {"f": "1e99", "g": None, "sensor": "<b>", "coupled": 3, "unknown": 1}
    answer, _ = explorer.hear(view="a", seq=1, state=bad)
    assert answer["state"] == {"f": 100, "g": 50, "sensor": "FX", "coupled": False}


def test_a_control_follows_when_the_frame_says_so(explorer):
    answer, _ = explorer.hear(view="a", seq=1, state={"f": 40, "coupled": True})
    assert answer["follows"] == {"g": 80}
    assert explorer.state["g"] == 80


def test_a_photograph_that_stays_is_sent_to_a_new_view_only(explorer):
    first, buffers = explorer.hear(view="a", seq=1, raw=True)
    assert [p["image"] for p in first["pictures"]] == [1, 2]
    assert len(buffers[2]) == 40 * 30 * 3 // 2
    later, _ = explorer.hear(view="a", seq=2, raw=True, state={"f": 60})
    assert [p["image"] for p in later["pictures"]] == [1, "same"]
    again, _ = explorer.hear(view="b", seq=1, raw=True)
    assert [p["image"] for p in again["pictures"]] == [1, 2]


def test_an_error_becomes_a_sentence_and_the_next_frame_works(explorer):
    answer, buffers = explorer.hear(view="a", seq=1, state={"f": 90})
    assert "f = 90 mm" in answer["error"]
    assert "does not fit; choose another" in answer["error"]
    assert buffers == []
    with pytest.raises(ValueError, match="does not fit"):
        explorer.frame_now()
    assert "error" not in explorer.hear(view="a", seq=2, state={"f": 80})[0]


def test_readers_without_a_kernel_get_a_figure_and_words(explorer):
    explorer.set(f=70)
    data, _ = explorer._repr_mimebundle_()
    assert "application/vnd.jupyter.widget-view+json" in data
    assert "f is 70" in data["text/plain"]
    assert "Doubled: 140 mm" in data["text/plain"]
    assert "Focal length: 70 mm" in data["text/plain"]
    assert "Coupled: off" in data["text/plain"]
    picture = re.fullmatch(
        r'<img alt="([^"]*)" src="data:image/png;base64,(.*)">', data["text/html"]
    )
    assert "Doubled: 140 mm" in picture[1]
    png = np.frombuffer(base64.b64decode(picture[2]), np.uint8)
    assert cv2.imdecode(png, cv2.IMREAD_COLOR).shape[1] == 800


def test_sliders_of_one_label_are_said_together_without_those_at_zero():
    sliders = [Slider(n, "Corner", n, "px", -9, 9, at) for n, at in (("u", 4), ("v", 0), ("w", -3))]
    shown = Explorer("Spots", [*sliders, Switch("grid", "Grid")], lambda **_: frame(50, 50, "", 0))
    words = shown._repr_mimebundle_()[0]["text/plain"]
    assert "Corner: u = 4 px, w = -3 px; Grid: off" in words.replace("−", "-")


def test_readers_without_a_kernel_learn_of_an_error_too(explorer):
    explorer.set(f=90)
    data, _ = explorer._repr_mimebundle_()
    assert "does not fit" in data["text/plain"]
    assert "text/html" not in data


def test_answers_of_two_threads_leave_in_the_order_in_which_they_were_made():
    class Slow(Recorded):
        def send(self, content, buffers=None):
            if content["state"]["f"] == 20:
                other.start()
                other.join(timeout=0.2)  # now it could overtake
            super().send(content, buffers)

    explorer = Slow("Test bench", CONTROLS, frame)
    other = threading.Thread(target=explorer.hear, kwargs={"state": {"f": 60}})
    explorer.set(f=20)
    other.join()
    assert [content["count"] for content, _ in explorer.sent] == [2, 3]


def test_two_threads_cannot_mix_their_states(explorer):
    def drag(view, value):
        for seq in range(30):
            explorer.hear(view=view, seq=seq, state={"f": value, "coupled": True})

    threads = [threading.Thread(target=drag, args=(v, f)) for v, f in (("a", 20), ("b", 60))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len({content["count"] for content, _ in explorer.sent}) == 60
    assert all(c["follows"]["g"] == 2 * c["state"]["f"] for c, _ in explorer.sent)


def test_errors():
    with pytest.raises(ValueError, match="own name"):
        Explorer("Twice", (CONTROLS[0], CONTROLS[0]), frame)
    with pytest.raises(ValueError, match="no control named focal; there are f, g, sensor, coupled"):
        Explorer("Bench", CONTROLS, frame).set(focal=3)
    before = (explorer := Explorer("Bench", CONTROLS, frame)).state
    with pytest.raises(ValueError, match="sensor must be one of 'FX', 'DX', got 'XX'"):
        explorer.set(sensor="XX", f=30)
    with pytest.raises(ValueError, match="coupled must be True or False, got 'no'"):
        explorer.set(coupled="no")
    assert explorer.state == before
