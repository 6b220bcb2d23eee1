from datetime import date

import cv2
import numpy as np
import pytest
from PIL import Image, TiffImagePlugin

from course_lib.boards import Checkerboard
from course_lib.calibrating.finding import find_photos, left_out
from course_lib.calibrating.looking import look_at_photo, look_at_photos
from course_lib.calibrating.pictures import (
    SetAside,
    read_grey,
    read_header,
    read_rgb,
    usual_size,
    why_other_size,
)

BOARD = Checkerboard(7, 5, 30)


class TestSetAside:
    @pytest.mark.parametrize(
        ("name", "problem", "said"),
        [
            ("x_blurred.png", "blurred", "Hold the camera still"),
            ("x_empty_table.png", "no board", "No checkerboard was found"),
            ("x_small.png", "size", "240 × 180 px, most pictures 480 × 360: it was made smaller"),
            ("x_turned.png", "size", "a program has turned it"),
            ("x_again.png", "duplicate", "The same file as view3.png"),
            ("x_tripod.png", "duplicate", "The same as view1.png: the board is where"),
            ("x_nothing.jpg", "file", "empty (0 bytes)"),
            ("x_letter.jpg", "file", "no picture that can be read"),
            ("x_half.jpg", "file", "damaged or cut off"),
            ("x_missing.jpg", "file", "no such file"),
        ],
    )
    def test_named_with_a_reason(self, run, name, problem, said):
        photo = run.photos[name]
        assert not photo.used
        assert photo.problem == problem
        assert said in photo.verdict
        assert any(f"- {name}: {photo.verdict}" in line for line in run.lines)

    def test_the_others_are_used(self, run):
        used = [name for name, photo in run.photos.items() if photo.used]
        assert used == [f"view{number}.png" for number in range(1, 9)]

    def test_progress_counts(self, run):
        assert run.lines[0].startswith("[ 1/18] + view1.png: All 7 × 5 corners found.")
        assert len(run.lines) == 18

    def test_those_that_can_be_read_are_shown(self, run):
        shown = ("x_small.png", "x_turned.png", "x_again.png", "x_tripod.png", "x_empty_table.png")
        assert all(run.photos[name].thumbnail is not None for name in shown)

    def test_all_broken(self, tmp_path):
        (tmp_path / "a.jpg").write_bytes(b"")
        photos = look_at_photos([tmp_path / "a.jpg"], BOARD, lambda line: None)
        assert [p.used for p in photos] == [False]


def photograph(path, view, focal, focal_35):
    exif = Image.Exif()
    part = exif.get_ifd(0x8769)
    part[0x920A], part[0xA405] = focal, focal_35
    Image.fromarray(view.picture).save(path, exif=exif, quality=95)
    return path


class TestLenses:
    def test_another_lens_and_digital_zoom_are_set_aside(self, truth, tmp_path):
        lenses = [(4.2, 26), (4.2, 26), (2.2, 13), (4.2, 52)]
        paths = [
            photograph(tmp_path / f"{number}.jpg", view, *lens)
            for number, (view, lens) in enumerate(zip(truth.views[:4], lenses, strict=True))
        ]
        photos = look_at_photos(paths, BOARD, lambda line: None)
        assert [p.problem for p in photos] == ["", "", "zoom", "zoom"]
        assert "at a focal length of 2.2 mm, most pictures 4.2 mm" in photos[2].verdict
        assert "zoomed, to the view of 52 mm, most pictures 26 mm" in photos[3].verdict


def test_one_by_one_as_all_together(folder, run):
    """Pictures that are uploaded get the verdicts that the whole folder gets."""
    names = [n for n in run.photos if n in ("view1.png", "view3.png") or n.startswith("x_")]
    photos = []
    for name in names:
        photos.append(look_at_photo(folder / name, BOARD, photos))
    assert [p.verdict for p in photos] == [run.photos[name].verdict for name in names]


class TestFinding:
    def test_folder_in_counting_order(self, tmp_path):
        for name in ("v10.jpg", "v2.JPG", "notes.txt", "v1.png"):
            (tmp_path / name).touch()
        assert [p.name for p in find_photos([str(tmp_path)])] == ["v1.png", "v2.JPG", "v10.jpg"]

    def test_pattern_and_file_once(self, tmp_path):
        for name in ("a.jpg", "b.jpg"):
            (tmp_path / name).touch()
        found = find_photos([str(tmp_path / "b.jpg"), str(tmp_path / "*.jpg")])
        assert [p.name for p in found] == ["b.jpg", "a.jpg"]

    def test_only_what_is_a_photograph(self, tmp_path):
        for name in ("a.jpg", "._a.jpg", "IMG_1.HEIC", "notes.txt"):
            (tmp_path / name).touch()
        (tmp_path / "b.jpg").mkdir()
        assert [p.name for p in find_photos([str(tmp_path)])] == ["a.jpg"]
        said = " ".join(left_out([str(tmp_path)]))
        assert "not looked into: b.jpg/" in said
        assert "Cannot be read: IMG_1.HEIC. Export as JPEG" in said
        assert "Most Compatible" in said
        assert "by their names: notes.txt" in said

    @pytest.mark.parametrize("name", ["foto/", "foto"])
    def test_no_such_folder(self, name):
        with pytest.raises(ValueError, match=f"no folder {name}"):
            find_photos([name])

    def test_nothing(self, tmp_path):
        with pytest.raises(ValueError, match="name files or a folder"):
            find_photos([str(tmp_path)])


class TestReading:
    def test_stays_as_on_the_sensor(self, tmp_path):
        picture = np.arange(12, dtype=np.uint8).reshape(3, 4) * 20
        exif = Image.Exif()
        exif[0x0112] = 6  # "turn by a quarter to the right"
        Image.fromarray(picture).save(tmp_path / "a.png", exif=exif)
        assert read_header(tmp_path / "a.png").size == (4, 3)
        np.testing.assert_array_equal(read_grey(tmp_path / "a.png"), picture)

    def test_focal_length(self, tmp_path):
        exif = Image.Exif()
        exif.get_ifd(0x8769)[0x920A] = 24.5
        Image.new("RGB", (4, 3)).save(tmp_path / "a.jpg", exif=exif)
        assert read_header(tmp_path / "a.jpg").focal == 24.5

    def test_equivalent_focal_length(self, tmp_path):
        exif = Image.Exif()
        exif.get_ifd(0x8769)[0xA405] = 26
        Image.new("RGB", (400, 300)).save(tmp_path / "a.jpg", exif=exif)
        header = read_header(tmp_path / "a.jpg")
        # 26 mm of a diagonal of 43.27 mm, and the picture's diagonal has 500 px.
        assert header.focal_px == pytest.approx(26 / 43.267 * 500, rel=1e-4)

    @pytest.mark.parametrize(
        ("told", "day"),
        [
            ("2026:03:20 23:59:59", date(2026, 3, 20)),
            ("0000:00:00 00:00:00", None),
            ("2026-03-20", None),
            ("   ", None),
        ],
    )
    def test_day(self, tmp_path, told, day):
        exif = Image.Exif()
        exif.get_ifd(0x8769)[0x9003] = told
        exif.get_ifd(0x8769)[0x920A] = 24.5
        Image.new("RGB", (4, 3)).save(tmp_path / "a.jpg", exif=exif)
        header = read_header(tmp_path / "a.jpg")
        assert header.taken == day
        assert header.focal == 24.5

    def test_in_colour_as_on_the_sensor(self, tmp_path):
        picture = np.zeros((3, 4, 3), np.uint8)
        picture[0, 1] = 10, 200, 90
        exif = Image.Exif()
        exif[0x0112] = 6
        Image.fromarray(picture).save(tmp_path / "a.png", exif=exif)
        np.testing.assert_array_equal(read_rgb(tmp_path / "a.png"), picture)
        deep = (np.arange(12, dtype=np.uint16).reshape(3, 4) * 257 * 20).astype(np.uint16)
        Image.fromarray(deep).save(tmp_path / "deep.png")
        seen = read_rgb(tmp_path / "deep.png")
        np.testing.assert_array_equal(seen, np.repeat(deep[..., None] // 257, 3, axis=2))

    def test_a_picture_of_many_pixels_is_read_without_a_warning(self, tmp_path, monkeypatch):
        Image.new("RGB", (400, 300)).save(tmp_path / "large.png")
        monkeypatch.setattr(Image, "MAX_IMAGE_PIXELS", 1000)  # Pillow refuses twice as many
        assert read_rgb(tmp_path / "large.png").shape == (300, 400, 3)
        assert Image.MAX_IMAGE_PIXELS == 1000

    def test_exif_that_makes_no_sense(self, tmp_path):
        exif = Image.Exif()
        exif.get_ifd(0x8769)[0x920A] = TiffImagePlugin.IFDRational(0, 0)
        Image.new("RGB", (4, 3)).save(tmp_path / "a.jpg", exif=exif)
        assert read_header(tmp_path / "a.jpg").focal == 0

    def test_heic(self, tmp_path):
        path = tmp_path / "IMG_1.jpg"  # whatever its name
        path.write_bytes(b"\0\0\0\x24ftypheic" + bytes(300))
        with pytest.raises(SetAside, match=r"HEIC.*Most Compatible"):
            read_header(path)

    @pytest.mark.parametrize("kind", [np.uint16, np.float32])
    def test_many_grey_levels(self, tmp_path, kind):
        picture = (np.arange(12).reshape(3, 4) / 11 * (65535 if kind == np.uint16 else 1)).astype(
            kind
        )
        cv2.imwrite(str(tmp_path / "a.tif"), picture)
        np.testing.assert_array_equal(read_grey(tmp_path / "a.tif"), picture)

    def test_too_many_pixels(self, tmp_path):
        Image.new("1", (16000, 15000)).save(tmp_path / "a.png", compress_level=1)
        with pytest.raises(SetAside, match="240 megapixels are too many"):
            read_header(tmp_path / "a.png")
        photo = look_at_photo(tmp_path / "a.png", BOARD)
        assert (photo.used, photo.problem) == (False, "file")

    def test_as_many_pixels_as_phones_have(self, tmp_path):
        Image.new("1", (16320, 12240)).save(tmp_path / "a.png", compress_level=1)
        assert read_header(tmp_path / "a.png").size == (16320, 12240)

    def test_a_phone_of_a_hundred_megapixels(self, tmp_path):
        dark = np.indices((6, 8)).sum(axis=0) % 2 == 0
        squares = np.pad(
            np.kron(np.where(dark, 20, 220), np.ones((20, 20))), 40, constant_values=220
        )
        small = Image.fromarray(squares.astype(np.uint8))
        large = small.resize((11600, 8700), Image.Resampling.BILINEAR)
        large.save(tmp_path / "a.jpg", quality=80)
        photo = look_at_photo(tmp_path / "a.jpg", BOARD)
        assert photo.used
        assert photo.verdict == "All 7 × 5 corners found."
        scale = np.divide(large.size, small.size)  # the first corner is 60 px from the edges
        np.testing.assert_allclose(photo.detection.points[0], 60 * scale - 0.5, atol=1)

    def test_more_pixels_than_pillow_likes(self, tmp_path, monkeypatch):
        Image.new("L", (40, 30)).save(tmp_path / "a.png")
        monkeypatch.setattr(Image, "MAX_IMAGE_PIXELS", 100)
        assert read_grey(tmp_path / "a.png").shape == (30, 40)
        assert Image.MAX_IMAGE_PIXELS == 100


class TestSizes:
    def headers(self, tmp_path, *sizes):
        found = []
        for number, size in enumerate(sizes):
            Image.new("L", size).save(tmp_path / f"{number}.png")
            found.append(read_header(tmp_path / f"{number}.png"))
        return found

    def test_most(self, tmp_path):
        assert usual_size(self.headers(tmp_path, (4, 3), (8, 6), (4, 3))) == (4, 3)

    def test_of_as_many_the_larger(self, tmp_path):
        assert usual_size(self.headers(tmp_path, (4, 3), (8, 6))) == (8, 6)

    def test_another_camera(self):
        assert "another camera" in why_other_size((500, 360), (480, 360))
