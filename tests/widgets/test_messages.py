import json

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
from course_lib.drawing.explorers.marks import Marks
from course_lib.drawing.explorers.trails import Trail
from course_lib.widgets.messages import encode_frame, i420, jpeg

GRADIENT = np.stack(np.broadcast_arrays(np.arange(60)[None], np.arange(40)[:, None], 200), axis=2)
PHOTOGRAPH = Picture("Photograph", "a gradient", (60, 40), GRADIENT.astype(np.uint8))
ROOF = Line([[0, 40], [30, 10], [np.nan, np.nan], [60, 40], [30, 10]], "ray", 2.5, dashed=True)
ANGLES = Probe("angle", "°", np.arange(12.0).reshape(3, 4))
SKETCH = Picture("Sketch", "a roof", (60, 40), lines=(ROOF,), labels=(Label("roof", (30, 8)),))


def numbers(message, buffers, place):
    return np.frombuffer(buffers[0], "<f4")[place["start"] : place["start"] + place["count"]]


def test_points_and_grids_arrive_as_they_were():
    read = Picture("Read", "angles", (60, 40), lines=(ROOF, ROOF), probes=(ANGLES,))
    message, buffers = encode_frame(Frame((SKETCH, read)))
    for line in (message["pictures"][0]["lines"][0], message["pictures"][1]["lines"][1]):
        np.testing.assert_array_equal(
            numbers(message, buffers, line["points"]), np.ravel(ROOF.points)
        )
        assert (line["role"], line["width"], line["dashed"]) == ("ray", 2.5, True)
    probe = message["pictures"][1]["probes"][0]
    assert probe["shape"] == [3, 4]
    np.testing.assert_array_equal(numbers(message, buffers, probe["values"]), np.arange(12))


def test_handles_arrive_with_what_they_move():
    corner = Handle((12.0, 8.0), (("x", 1.5, 0.5, 0), ("y", 2, 0, -0.25)), "camera")
    message, _ = encode_frame(Frame((Picture("Corner", "", (60, 40), handles=(corner,)), SKETCH)))
    first, second = json.loads(json.dumps(message))["pictures"]
    moves = [["x", 1.5, 0.5, 0], ["y", 2, 0, -0.25]]
    assert first["handles"] == [{"at": [12, 8], "moves": moves, "role": "camera"}]
    assert second["handles"] == []


def test_marks_arrive_with_what_they_say():
    places, values = np.array([[3.0, 4], [np.nan, 1]]), np.array([[1, 0.25], [2, 0.5]])
    marks = Marks(places, values, ("view", "turn"), ("", "px"), (0, 2))
    message, buffers = encode_frame(Frame((Picture("Marked", "", (60, 40), marks=marks), SKETCH)))
    first, second = json.loads(json.dumps(message))["pictures"]
    assert second["marks"] is None
    said = first["marks"]
    np.testing.assert_array_equal(numbers(message, buffers, said["points"]), places.ravel())
    np.testing.assert_array_equal(numbers(message, buffers, said["values"]), values.ravel())
    assert (said["names"], said["units"], said["digits"]) == (["view", "turn"], ["", "px"], [0, 2])
    assert said["gaps"] == ["", " "]


@pytest.mark.parametrize("values", [np.zeros((2, 1)), np.zeros((3, 2))])
def test_marks_want_numbers_for_every_name(values):
    with pytest.raises(ValueError, match=r"2 points and 2 names want values of shape \(2, 2\)"):
        Marks(np.zeros((2, 2)), values, ("a", "b"), ("", ""), (0, 0))


def test_trails_arrive_with_all_that_the_browser_draws_them_from():
    trail = Trail(1, np.arange(9.0).reshape(3, 3), np.array([1.0, 2, 3]), 0.5, (4.0, 10.0), "m")
    pointed = Picture("Left", "a point", (60, 40), trails=(trail,))
    message, _ = encode_frame(Frame((pointed, SKETCH)))
    (sent,) = json.loads(json.dumps(message))["pictures"][0]["trails"]
    assert sent == {
        "picture": 1,
        "A": [[0, 1, 2], [3, 4, 5], [6, 7, 8]],
        "e": [1, 2, 3],
        "near": 0.5,
        "depths": [4, 10],
        "unit": "m",
        "role": "second",
    }
    assert message["pictures"][1]["trails"] == []


def test_a_photograph_arrives_as_jpeg_in_the_right_colours():
    message, buffers = encode_frame(Frame((SKETCH, PHOTOGRAPH)))
    assert [p["image"] for p in message["pictures"]] == [None, 1]
    assert not message["raw"]
    decoded = cv2.imdecode(np.frombuffer(buffers[1], np.uint8), cv2.IMREAD_COLOR_RGB)
    assert np.abs(decoded.astype(int) - GRADIENT).max() <= 6


def test_a_photograph_arrives_as_bytes_in_the_right_colours():
    message, buffers = encode_frame(Frame((PHOTOGRAPH,)), raw=True)
    assert message["raw"]
    planes = np.frombuffer(buffers[1], np.uint8).reshape(60, 60)
    decoded = cv2.cvtColor(planes, cv2.COLOR_YUV2RGB_I420)
    assert np.abs(decoded.astype(int) - GRADIENT).max() <= 6


def test_bytes_carry_the_mean_colour_of_four_pixels():
    mosaic = np.zeros((40, 60, 3), np.uint8)
    mosaic[::2, ::2, 0] = mosaic[::2, 1::2, 1] = mosaic[1::2, ::2, 1] = mosaic[1::2, 1::2, 2] = 255
    decoded = cv2.cvtColor(
        np.frombuffer(i420(mosaic), np.uint8).reshape(60, 60), cv2.COLOR_YUV2RGB_I420
    )
    red, green, blue = decoded.mean(axis=(0, 1)).tolist()
    assert green > red + 30
    assert abs(red - blue) < 25


def test_a_picture_of_odd_size_stays_jpeg():
    odd = Picture("Odd", "", (59, 40), GRADIENT[:, :59].astype(np.uint8))
    message, buffers = encode_frame(Frame((odd,)), raw=True)
    assert not message["raw"]
    assert buffers[1][:2] == b"\xff\xd8"


def test_a_photograph_that_stays_is_not_sent_again():
    other = Picture("Other", "", (60, 40), GRADIENT.astype(np.uint8))
    before, now = Frame((PHOTOGRAPH, other)), Frame((PHOTOGRAPH, PHOTOGRAPH))
    message, buffers = encode_frame(now, before=before)
    assert [p["image"] for p in message["pictures"]] == ["same", 1]
    assert len(buffers) == 2


def test_readouts_keep_value_and_unit_together():
    frame = Frame((SKETCH,), (Readout("Field", "θ", "65.5", "°"), Readout("Blur", "", "1.0", "mm")))
    message, _ = encode_frame(frame)
    assert [r["quantity"] for r in message["readouts"]] == ["65.5°", "1.0 mm"]


@pytest.mark.parametrize("encode", [jpeg, i420])
def test_encoding_leaves_the_picture_alone(encode):
    picture = GRADIENT.astype(np.uint8)
    encode(picture)
    np.testing.assert_array_equal(picture, GRADIENT)


def test_a_matrix_arrives_in_rows():
    frame = Frame((SKETCH,), (matrix("Pose", "R", [[1, 0], [0, 1]], 1), Readout("Field", "θ", "9")))
    message, _ = encode_frame(frame)
    rows = [r["rows"] for r in json.loads(json.dumps(message))["readouts"]]
    assert rows == [[["1.0", "0.0"], ["0.0", "1.0"]], []]
