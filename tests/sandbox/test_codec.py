"""Values pass the border unchanged, and nothing else passes."""

import json
import socket
import struct
import threading

import hypothesis.extra.numpy as numpy_strategies
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from course_lib.sandbox import wire
from course_lib.sandbox.codec import MalformedMessageError, decode, encode
from course_lib.sensor import SensorModel

ARRAYS = numpy_strategies.arrays(
    st.sampled_from(["?", "i4", "u2", "f4", "f8", "c16", "<U5"]),
    numpy_strategies.array_shapes(min_dims=0, max_dims=4, min_side=0, max_side=4),
)
PLAIN = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text() | st.complex_numbers(),
    lambda inner: (
        st.lists(inner, max_size=4)
        | st.lists(inner, max_size=4).map(tuple)
        | st.dictionaries(st.text() | st.integers(), inner, max_size=4)
    ),
    max_leaves=12,
)


def head(text: bytes, blob: bytes = b"") -> bytes:
    return struct.pack("!4sII", b"cam1", len(text), len(blob)) + text + blob


def same(one, other) -> bool:
    if isinstance(one, np.ndarray):
        equal = np.array_equal(one, other, equal_nan=one.dtype.kind in "fc")
        return equal and one.dtype == other.dtype and one.shape == other.shape
    return repr(one) == repr(other) and type(one) is type(other)


@given(PLAIN)
def test_plain_values_come_back_as_they_were(value):
    assert same(decode(encode(value)), value)


@given(ARRAYS)
def test_arrays_come_back_as_they_were(array):
    if array.dtype.kind == "U":
        letters = ["".join(c for c in text if not 0xD800 <= ord(c) < 0xE000) for text in array.flat]
        array = np.array(letters, dtype="<U5").reshape(array.shape)
    assert same(decode(encode({"a": (array, 1)}))["a"][0], array)


def test_what_the_grader_sends():
    rng = np.random.default_rng(3)
    before = rng.bit_generator.state
    sent = {"rng": rng, "sensor": SensorModel(gain=2.0), "n": np.float64(1.5), "b": b"\0\1"}
    got = decode(encode(sent), trusted=True)
    assert got["rng"].bit_generator.state == before
    assert got["sensor"] == sent["sensor"]
    assert type(got["n"]) is np.float64
    assert got["b"] == b"\0\1"


@pytest.mark.parametrize("value", [np.random.default_rng(0), SensorModel(), np.float64(1)])
def test_a_student_may_not_send_objects(value):
    with pytest.raises(MalformedMessageError, match="not allowed"):
        decode(encode([value]))


def test_what_cannot_be_sent_says_so():
    with pytest.raises(TypeError, match="a object cannot be sent"):
        encode([object()])


@pytest.mark.parametrize(
    ("text", "blob"),
    [
        (b"{}", b""),
        (b"[", b""),
        (b"\xff", b""),
        (b"[]", b""),
        (b'["object", "os", "system", ["dict"]]', b""),
        (b'["array", "O8", [1], 8]', bytes(8)),
        (b'["array", "f8", [-1], 8]', bytes(8)),
        (b'["array", "f8", [2], 8]', bytes(8)),
        (b'["array", "f8", [1], 8]', b""),
        (b'["array", "f8", ["1"], 8]', bytes(8)),
        (b'["array", "U4", [1], 4]', b"\xff\xff\xff\xff"),
        (b'["array", "U9999999999", [1], 4]', bytes(4)),
        (b'["array", ["f8"], [1], 8]', bytes(8)),
        (b'["array", "f8"]', b""),
        (b'["dict", [[1], 2]]', b""),
        (b'["dict", [1.5, 2]]', b""),
        (b'["dict", 3]', b""),
        (b'["dict", %s]' % b",".join(b"[%d, 0]" % (k * (2**61 - 1)) for k in range(200)), b""),
        (b'["bytes", ["list"]]', b""),
        (b'["complex", "x", 1]', b""),
        (b"1", b"left over"),
        (b"9" * 5000, b""),
        (b"[" * 100_000, b""),
        (b'["list",' * 50 + b"1" + b"]" * 50, b""),
    ],
)
def test_what_encode_never_wrote_is_refused(text, blob):
    with pytest.raises(MalformedMessageError):
        decode(head(text, blob))


@given(st.binary(max_size=200), st.binary(max_size=50))
def test_noise_is_refused_or_plain(text, blob):
    try:
        decode(head(text, blob))
    except MalformedMessageError:
        return
    json.loads(text)


def test_booleans_are_true_or_false_whatever_their_bytes():
    array = decode(head(b'["array", "b1", [3], 3]', b"\0\1\x07"))
    assert array.tolist() == [False, True, True]
    assert array.view(np.uint8).tolist() == [0, 1, 1]


def test_a_message_arrives_in_pieces():
    mine, its = socket.socketpair()
    with mine, its:
        value = {"a": np.arange(300_000.0)}
        sender = threading.Thread(target=wire.send, args=(mine, value))
        sender.start()
        assert same(wire.receive(its, 5)["a"], value["a"])
        sender.join()


def test_silence_a_closed_line_and_noise_have_names():
    mine, its = socket.socketpair()
    with its:
        with mine:
            with pytest.raises(wire.Late):
                wire.receive(its, 0.05)
            mine.sendall(encode(1)[:9])
            with pytest.raises(wire.Late):
                wire.receive(its, 0.05)
        with pytest.raises(wire.Closed):
            wire.receive(its, 1)
    mine, its = socket.socketpair()
    with mine, its:
        mine.sendall(b"GET / HTTP/1.0\r\n\r\n")
        with pytest.raises(wire.MalformedMessageError):
            wire.receive(its, 1)
        mine.sendall(struct.pack("!4sII", b"cam1", 2**32 - 1, 2**32 - 1))
    mine, its = socket.socketpair()
    with mine, its:
        mine.sendall(struct.pack("!4sII", b"cam1", 2**32 - 1, 2**32 - 1))
        with pytest.raises(wire.MalformedMessageError, match="too large"):
            wire.receive(its, 1)
