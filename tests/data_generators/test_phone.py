from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from course_lib.calibrating.looking import look_at_photos
from course_lib.calibrating.solving import solve
from course_lib.calibration import CameraModel
from data_generators import desk
from data_generators.phone import EXIF_PART, PLACE_PART, TROUBLES, write_phone_files

SIZE = (800, 600)
#: What each trouble is called where photographs are looked at; the others can be used.
PROBLEMS = {
    "good": "",
    "upside down": "",
    "portrait": "",
    "blurred": "blurred",
    "cut off": "cut off",
    "no target": "no board",
    "turned": "size",
    "small copy": "size",
    "zoomed": "zoom",
    "HEIC": "file",
    "letter": "file",
}


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    folder = tmp_path_factory.mktemp("phone")
    return write_phone_files(folder, np.random.default_rng(5), good=5, image_size=SIZE)


def of(files, what):
    return next(file for file in files if file.what == what)


@pytest.fixture(scope="module")
def photos(files):
    return look_at_photos([file.path for file in files], desk.TARGET, lambda line: None)


def test_each_is_what_it_says(files, photos):
    assert [f.what for f in files] == ["good"] * 5 + list(TROUBLES)
    assert [p.problem for p in photos] == [PROBLEMS[f.what] for f in files]


def test_corners_are_where_the_truth_says(files, photos):
    for file, photo in zip(files, photos, strict=True):
        if not photo.used:
            continue
        seen = desk.DeskView(np.zeros((1, 1, 3), np.uint8), file.camera).project(
            desk.TARGET.points()
        )
        apart = np.linalg.norm(photo.detection.points - seen, axis=1)
        assert np.sqrt(np.mean(apart**2)) < 0.1


def test_there_is_a_truth_about_pictures_as_they_were_taken(files):
    without = {"turned", "small copy", "zoomed", "HEIC", "letter"}
    assert {file.what for file in files if file.camera is None} == without


def test_held_in_any_way_it_is_one_camera(photos):
    """Upside down and in portrait, as the sensor had them; Exif says how they were held."""
    camera = solve(photos, desk.TARGET, CameraModel(coefficients=("k1", "k2"))).calibration
    np.testing.assert_allclose(camera.K, desk.intrinsics(SIZE), atol=3)
    assert len(camera.poses) == 7


def test_exif(files):
    with Image.open(of(files, "upside down").path) as picture:
        exif = picture.getexif()
        assert exif[0x0112] == 3
        assert dict(exif.get_ifd(PLACE_PART))[1] == "N"
        assert exif.get_ifd(EXIF_PART)[0xA405] == 25
    with Image.open(of(files, "portrait").path) as picture:
        assert picture.getexif()[0x0112] == 6
    with Image.open(of(files, "small copy").path) as picture:
        assert not picture.getexif()


def test_focal_length_in_exif_is_that_of_the_camera(photos):
    header = photos[0].header
    assert header.focal_px == pytest.approx(desk.intrinsics(SIZE)[0, 0], rel=0.03)
    # A sensor as wide as the focal length says: f / (width of the sensor) = f in px / width.
    assert header.focal / desk.FOCAL == pytest.approx(5.65, abs=0.05)


def test_same_seed_same_files(tmp_path):
    made = [
        write_phone_files(
            tmp_path / name, np.random.default_rng(1), 1, ["small copy"], image_size=(320, 240)
        )
        for name in "ab"
    ]
    for one, other in zip(*made, strict=True):
        assert one.path.read_bytes() == other.path.read_bytes()


def test_unknown_trouble(tmp_path):
    with pytest.raises(ValueError, match="must be some of upside down"):
        write_phone_files(Path(tmp_path), np.random.default_rng(0), troubles=["lost"])
