"""A reader's photographs: what is said of them, and lengths whose truth is known."""

import os
from dataclasses import replace

import numpy as np
import pytest

from course_lib import lab
from course_lib.boards import Checkerboard
from course_lib.drawing.style import BLUE, rgb
from course_lib.lab import photographs, supplied
from course_lib.measuring import distance_in_space, distance_on_plane, rays_miss
from data_generators import desk

K = desk.intrinsics((640, 480))
MEASURING = ("m1.jpg", "m2.jpg", "m3.jpg")


def truth(aim, points):
    """Return where points are in a photograph of 640 × 480 px."""
    R, t = desk.pose_towards(*aim)
    view = desk.DeskView(np.zeros((1, 1, 3), np.uint8), desk.Camera(K, R, t, (640, 480)))
    return view.project(points)


@pytest.fixture
def no_supplied(monkeypatch, folder):
    """Let the reader's photographs be the supplied ones, which take longer to make."""
    paths = tuple(sorted(folder.glob("t?.jpg")))[:5]
    monkeypatch.setattr(photographs, "supplied_photographs", lambda: paths)
    return paths


def test_the_camera_comes_from_the_others(work):
    assert {photo.name for photo in work.solved.views} == {f"t{n}.jpg" for n in range(7)}
    assert work.own
    np.testing.assert_allclose(work.camera.K, K, atol=0.5)


def test_a_torn_photograph_is_named_with_its_reason(work):
    (torn,) = (photo for photo in work.photos if photo.name == "torn.jpg")
    assert not torn.used
    assert "copy it again" in torn.verdict


def test_corners_are_marked_where_they_count(work):
    photo, torn = work.photos[0], next(p for p in work.photos if p.name == "torn.jpg")
    coloured = lambda picture: (picture[..., 0] != picture[..., 2]).sum()  # noqa: E731
    assert coloured(photographs.marked(photo)) > 54
    assert coloured(photographs.marked(replace(photo, used=False))) == 0
    half = replace(photo, thumbnail=photo.thumbnail[::2, ::2])
    for small in (photographs.marked(photo, 160), photographs.marked(half, 160)):
        assert small.shape == (120, 160, 3)
        for u, v in np.rint((photo.detection.points + 0.5) / 4 - 0.5).astype(int):
            np.testing.assert_allclose(small[v, u], rgb(BLUE), atol=40)
    assert photographs.marked(torn) is None


def test_a_length_on_the_plane_is_right(work):
    shot = lab.shot(work, "m1.jpg", unevenness=0.1)
    assert shot.photograph.shape == (480, 640, 3)
    ends = truth(supplied.MEASURING_AIMS[0], desk.card_corners()[:2])
    length = distance_on_plane(*ends, shot.view, 0.5, 0.001, height=desk.CARD[2])
    assert length.value == pytest.approx(desk.CARD[0], abs=0.05)
    assert length.parts["target"] > 0.1  # unevenness counts


def test_a_length_in_space_is_right(work):
    shots = [lab.shot(work, name) for name in ("m2.jpg", "m3.jpg")]
    lid = desk.box_corners()[4:6]
    pixels = np.stack([truth(aim, lid) for aim in supplied.MEASURING_AIMS[1:]])
    views = [shot.view for shot in shots]
    assert distance_in_space(*pixels.swapaxes(0, 1), views).value == pytest.approx(120, abs=0.1)
    assert rays_miss(pixels, views) < 0.05


def test_without_photographs_the_supplied_ones_take_their_place(heard, tmp_path, no_supplied):
    for place in (tmp_path / "nowhere", tmp_path):
        work = lab.look("mine", place, desk.TARGET)
        said = heard()
        assert not work.own
        assert work.instead
        assert "The supplied photographs take their place." in said
        assert said.startswith(("There is no folder", "No photographs in"))
    assert len(work.photos) == len(no_supplied)


def test_the_same_files_are_looked_at_once(heard, tmp_path, folder, monkeypatch):
    for name in ("t0.jpg", "t1.jpg", "t2.jpg", "t3.jpg"):
        (tmp_path / name).write_bytes((folder / name).read_bytes())
    looked, look = [], photographs.look_at_photos
    monkeypatch.setattr(photographs, "look_at_photos", lambda *a: looked.append(a) or look(*a))
    first = lab.look("mine", tmp_path, desk.TARGET)
    told = heard()
    again = lab.look("mine", tmp_path, desk.TARGET, ("t3.jpg",))
    assert again.photos == first.photos
    assert again.measuring == ("t3.jpg",)
    assert heard() == told
    assert len(looked) == 1
    (tmp_path / "t3.jpg").write_bytes((folder / "t4.jpg").read_bytes())
    assert lab.look("mine", tmp_path, desk.TARGET).photos != first.photos
    os.utime(tmp_path / "t3.jpg", (0, 0))  # written again, of the same size
    lab.look("mine", tmp_path, desk.TARGET)
    lab.look("mine", tmp_path, Checkerboard(9, 6, 24.0))
    assert len(looked) == 4


def test_too_few_photographs_are_counted(heard, tmp_path, folder, no_supplied):
    for name in ("t1.jpg", "t2.jpg", "m1.jpg"):
        (tmp_path / name).write_bytes((folder / name).read_bytes())
    lab.look("mine", tmp_path, desk.TARGET, ("m1.jpg", "m9.jpg"))
    said = heard()
    assert "2 photographs can be used to calibrate, 3 are needed" in said
    assert "those to measure in (1) are not counted" in said
    assert "There is no m9.jpg among them" in said


@pytest.mark.parametrize("counts", [(8, 6), (10, 7)])
def test_a_miscounted_board_is_named_once(heard, tmp_path, folder, no_supplied, counts):
    """The reader's photographs show 9 × 6 corners; 10 × 7 are its squares."""
    for name in ("t0.jpg", "t1.jpg", "t2.jpg", "t3.jpg"):
        (tmp_path / name).write_bytes((folder / name).read_bytes())
    work = lab.look("mine", tmp_path, Checkerboard(*counts, 25.0))
    assert not work.own
    said = heard()
    assert said.count("is it Checkerboard(9, 6)?") == 1, said
    assert said.endswith("The supplied photographs take their place."), said


def test_a_board_is_named_though_a_part_of_it_was_taken_for_it(
    heard, folder, work, monkeypatch, no_supplied
):
    first, *others = (photo for photo in work.photos if photo.used)
    seen = [replace(photo.detection, seen=(9, 6)) for photo in others]
    looked = [
        replace(photo, used=False, problem="wrong size", detection=found)
        for photo, found in zip(others, seen, strict=True)
    ]
    monkeypatch.setattr(photographs, "_looked_at", lambda *_: (first, *looked))
    assert not lab.look("mine", folder, Checkerboard(8, 6, 25.0)).own
    assert "not 8 × 6 corners: is it Checkerboard(9, 6)?" in heard()


def test_another_word_means_supplied(heard, no_supplied):
    assert not lab.look("my own", "", desk.TARGET).own
    assert 'photographs is "mine" or "supplied", got \'my own\'' in heard()


def test_photographs_that_tell_no_camera_are_replaced(heard, work, no_supplied):
    level = [p for p in work.photos if p.name in ("t0.jpg", "m1.jpg")]
    alike = [replace(level[0], path=level[0].path.with_name(f"{n}.jpg")) for n in range(3)]
    again = lab.calibrate(replace(work, photos=tuple(alike)))
    assert not again.own
    assert again.camera.rms < 0.1
    assert "The supplied photographs take their place." in heard()
    assert again.instead


def test_a_photograph_that_cannot_be_used_is_replaced(heard, work):
    assert lab.shot(work, "torn.jpg").name == "m1.jpg"
    said = heard()
    assert "torn.jpg cannot be measured in. The file is damaged" in said
    assert "m1.jpg is taken in its place: do not use what is measured there." in said
    lab.shot(work, "m7.jpg")
    assert "There is no such file. m1.jpg is" in heard()
    lab.shot(work, "M3.JPEG")
    assert "There is no such file. Do you mean m3.jpg?" in heard()


def test_a_photograph_that_is_gone_is_replaced(heard, work, tmp_path):
    (lost,) = (photo for photo in work.photos if photo.name == "m2.jpg")
    gone = replace(lost, path=tmp_path / "m2.jpg")
    without = replace(work, photos=tuple(gone if p is lost else p for p in work.photos))
    assert lab.shot(without, "m2.jpg").name in ("m1.jpg", "m3.jpg")
    assert "m2.jpg cannot be measured in. There is no such file." in heard()
    nothing = replace(work, photos=(gone,))
    with pytest.raises(ValueError, match="run the cell with `look` again"):
        lab.shot(nothing, "m2.jpg")


def test_a_length_in_space_gets_two_different_photographs(heard, work):
    first = lab.shot(work, "m2.jpg")
    assert lab.shot(work, "m3.jpg", besides=first).name == "m3.jpg"
    assert heard() == ""
    assert lab.shot(work, "m2.jpg", besides=first).name != "m2.jpg"
    assert "It is the first picture already" in heard()


def test_for_three_wrong_names_there_are_three_photographs(heard, work):
    names = ("desk_15.jpg", "desk_16.jpg", "desk_17.jpg")
    wrong = replace(work, measuring=names)
    assert len({lab.shot(wrong, name).name for name in names}) == 3
    assert heard().count("There is no such file.") == 3


def test_supplied_photographs_stand_in_for_those_to_measure_in(
    heard, tmp_path, monkeypatch, folder
):
    """Also where own photographs are called as supplied ones are."""
    paths = tuple(folder / name for name in (*(f"t{n}.jpg" for n in range(4)), *MEASURING))
    monkeypatch.setattr(photographs, "supplied_photographs", lambda: paths)
    monkeypatch.setattr(photographs, "SUPPLIED", replace(lab.SUPPLIED, measuring=MEASURING))
    names = ("IMG_1.JPG", "m3.jpg", "m1.jpg")
    work = lab.calibrate(lab.look("mine", tmp_path / "nowhere", desk.TARGET, names))
    assert "m1.jpg for IMG_1.JPG, m2.jpg for m3.jpg, m3.jpg for m1.jpg" in heard()
    assert [lab.shot(work, name).name for name in names] == list(MEASURING)
    assert heard() == ""
    same = lab.look("supplied", "", desk.TARGET, MEASURING[::-1])
    assert same.stand_ins == {}  # these are there: each for itself
    own = lab.look("mine", tmp_path / "nowhere", desk.TARGET, MEASURING[::-1])
    assert own.stand_ins == dict(zip(MEASURING[::-1], MEASURING, strict=True))  # by their order


def test_before_it_is_calibrated_there_is_no_camera(work):
    with pytest.raises(ValueError, match="run the cell with `calibrate` first"):
        lab.shot(replace(work, solved=None), "m1.jpg")
