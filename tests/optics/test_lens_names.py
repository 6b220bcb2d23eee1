import pytest

from course_lib.optics import parse_lens_name

NAMES = {
    "Nikkor 18-140 mm 1:3.5-5.6": ((18, 140), (3.5, 5.6)),  # published
    "18-140mm 1:3.5-5.6": ((18, 140), (3.5, 5.6)),
    "50mm f/1.8": ((50, 50), (1.8, 1.8)),
    "AF-S NIKKOR 24-70mm f/2.8E ED VR": ((24, 70), (2.8, 2.8)),
    "100mm F2.8 Macro": ((100, 100), (2.8, 2.8)),
    "EF 100-400mm f/4.5-5.6L IS II USM": ((100, 400), (4.5, 5.6)),
    "Sonnar T* FE 55mm F1.8 ZA": ((55, 55), (1.8, 1.8)),
    "M.Zuiko 4/3 14–42 mm 1 : 3.5–5.6": ((14, 42), (3.5, 5.6)),
    "90mm F2.8 Macro 1:1": ((90, 90), (2.8, 2.8)),
    "Macro 1:1 90mm f2,8": ((90, 90), (2.8, 2.8)),
    "f/1.4 10.5MM": ((10.5, 10.5), (1.4, 1.4)),
    "DX Fisheye 10,5 mm ƒ/2.8": ((10.5, 10.5), (2.8, 2.8)),
    "8 mm 1:1.4": ((8, 8), (1.4, 1.4)),
    "F 50mm f/2": ((50, 50), (2, 2)),
}


@pytest.mark.parametrize("name", NAMES)
def test_accuracy(name):
    focal_length, f_number = NAMES[name]
    assert parse_lens_name(name) == {"focal_length": focal_length, "f_number": f_number}


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("a good lens", "no focal length in 'a good lens'; a lens name reads like \"50mm f/1.8\""),
        ("", "no focal length"),
        ("f/1.8", "no focal length"),
        ("50mm", "no f-number"),
        ("fast 50mm 1.8", "no f-number"),
        ("50 millimetres f/1.8", "no focal length"),
        ("140-18mm f/4", "focal_length .* runs from 140 to 18"),
        ("0mm f/4", "focal_length .* runs from 0 to 0"),
        ("50mm f/0", "f_number .* runs from 0 to 0"),
    ],
)
def test_errors(name, words):
    with pytest.raises(ValueError, match=words):
        parse_lens_name(name)


@pytest.mark.parametrize("bad", [50, None, b"50mm f/1.8", ["50mm f/1.8"]])
def test_errors_of_type(bad):
    with pytest.raises(TypeError, match="name must be a text, got"):
        parse_lens_name(bad)
