import cv2
import numpy as np
import pytest

from course_lib.drawing.explorers.frame import (
    Frame,
    Handle,
    Label,
    Line,
    Picture,
    Probe,
    Readout,
    matrix,
)
from course_lib.drawing.explorers.stills import _caption, still

GREY = np.full((60, 80, 3), 128, np.uint8)
READING = Readout("Field", "θ", "65.5", "°")


def test_a_frame_says_in_words_what_it_shows():
    frame = Frame((Picture("Street", "A grey street.", (80, 60), GREY),), (READING,))
    assert frame.in_words() == "A grey street.\nField θ: 65.5°"


def test_the_still_figure_shows_the_photograph_and_its_lines():
    line = Line([[10, 30], [40, 30], [np.nan, np.nan], [60, 30], [70, 30]], "object", 6.0)
    frame = Frame((Picture("Street", "", (80, 60), GREY, lines=(line,)),), (READING,))
    png = cv2.imdecode(np.frombuffer(still(frame), np.uint8), cv2.IMREAD_COLOR_RGB)
    middle = png[png.shape[0] // 5 : -png.shape[0] // 5]
    assert (middle == 128).all(axis=2).mean() > 0.4  # the photograph
    assert (middle == (0xD5, 0x5E, 0x00)).all(axis=2).any()  # the line, in its role's colour


@pytest.mark.parametrize("length", range(1, 26))
def test_lines_of_a_caption_end_between_two_settings(length):
    settings = f"{'Name' * length}: 1 mm; Focal length: 24 mm; Corner: u = 3 px, v = 4 px; Aim: 5 °"
    *lines, last = _caption(Frame((Picture("Street", "", (80, 60), GREY),)), settings).split("\n")
    assert all(line.endswith((";", ",")) for line in lines)
    assert last.replace("\N{NO-BREAK SPACE}", " ").endswith("Aim: 5 °")


def test_numbers_of_a_still_are_typeset_as_in_the_browser():
    frame = Frame(
        (Picture("Street", "", (80, 60), GREY),),
        (Readout("Line", "l", "(0.3, -1, -.7)"), Readout("Photons", "", "27165.25")),
    )
    minus, gap = "\N{MINUS SIGN}", "\N{NARROW NO-BREAK SPACE}"
    assert _caption(frame, "Look at: u-v = -4.00 px").split("\n") == [
        f"Look at: u-v = {minus}4.00 px".replace(" ", "\N{NO-BREAK SPACE}"),
        f"Line: (0.3, {minus}1, {minus}.7)   ·   Photons: 27{gap}165.25",
    ]


def test_every_ingredient_can_be_drawn():
    disk = Line([[0, 0], [9, 0], [9, 9]], "ray", closed=True, fill=0.4, dashed=True)
    labels = tuple(Label("x", (40, 30), "ink", anchor) for anchor in ("start", "middle", "end"))
    probe = Probe("angle", "°", np.zeros((2, 2)))
    handle = Handle((20, 20), (("x", 0, 1, 0),))
    sketch = Picture("Sketch", "", (80, 60), None, (disk,), labels, (probe,), True, (handle,))
    assert still(Frame((sketch, sketch), (READING,) * 7))[:4] == b"\x89PNG"


@pytest.mark.parametrize("image", [GREY / 255, GREY[:, :, 0], GREY[:50]])
def test_errors(image):
    with pytest.raises(ValueError, match=r"Street: expected a uint8 image of shape \(60, 80, 3\)"):
        Picture("Street", "", (80, 60), image)


def test_a_matrix_is_a_table_and_can_be_read_in_one_line():
    reading = matrix("Camera matrix", "P", [[400.04, -0.04, 7], [0, 1, 0.125]], (1, 3))
    assert reading.rows == (("400.0", "0.0", "7.0"), ("0.000", "1.000", "0.125"))
    assert reading.quantity == "[400.0 0.0 7.0; 0.000 1.000 0.125]"
    frame = Frame((Picture("Street", "A grey street.", (80, 60), GREY),), (READING, reading))
    assert frame.in_words().endswith("Camera matrix P: [400.0 0.0 7.0; 0.000 1.000 0.125]")
    assert still(frame)[:4] == b"\x89PNG"
