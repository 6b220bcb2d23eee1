"""The report: one file that shows what was measured, and nothing of whoever measured it."""

import base64
import builtins
import re
import sys
from dataclasses import replace
from datetime import date
from types import SimpleNamespace

import cv2
import numpy as np
import pytest

from course_lib import lab
from course_lib.distortion import distort_pixels
from course_lib.lab import supplied
from course_lib.lab.lines import report_lines, who_and_when
from course_lib.lab.report import FILE, MOST, cutting, read_report
from course_lib.measuring import Measured
from data_generators import desk


@pytest.fixture(scope="module")
def results(work):
    one, other = lab.shot(work, "m2.jpg", 0.1), lab.shot(work, "m3.jpg", 0.1)
    ends = np.array([[300.0, 200.0], [380.0, 210.0]])
    card = Measured(85.4, {"pointing": 0.3, "pose": 0.1})
    lid = Measured(121.0, {"pointing": 0.2})
    return [
        lab.Result("card", card, (85.6, 0.5), ((one, ends),)),
        lab.Result("lid", lid, (120.0, 0.5), ((one, ends), (other, ends))),
    ]


def write(work, results, folder, **how):
    folder.mkdir(exist_ok=True)
    return lab.write_report(work, results, folder, pointing=0.6, scale=0.002, **how)


@pytest.fixture(scope="module")
def path(work, results, tmp_path_factory):
    return write(work, results, tmp_path_factory.mktemp("handed"))


def test_agreement_is_judged_by_both_uncertainties(results):
    card, lid = results
    assert card.difference == pytest.approx(-0.2)
    assert card.ratio == pytest.approx(0.2 / np.hypot(1.959964 * np.hypot(0.3, 0.1), 0.5))
    assert lid.ratio > 1 > card.ratio
    assert card.said.startswith("card: 85.4 mm ± 0.6 mm (95 %); ruler 85.6 mm ± 0.5 mm; diff")
    assert card.said.endswith("-0.20 mm, E = 0.25: they agree")
    assert lid.said.endswith("+1.00 mm, E = 1.57: they do not agree")


def test_the_file_holds_picture_and_numbers(path, work):
    assert path.name == FILE
    assert path.stat().st_size < 2_000_000
    held = read_report(path)
    picture = cv2.imdecode(np.frombuffer(base64.b64decode(held["png"]), np.uint8), cv2.IMREAD_COLOR)
    assert picture.shape[1] == 800
    assert picture.std() > 20
    assert held["camera"]["K"] == work.camera.K.tolist()
    assert [length["value"] for length in held["lengths"]] == [85.4, 121.0]
    words = held["words"]
    assert "11 photographs: 7 ✓ calibrate the camera, 3 ↔ are measured in, 1 ✗ are set" in words
    assert "640 × 480 px" in words
    assert "✗ torn.jpg: The file is damaged" in words
    assert (
        "25 mm from corner to corner, σ 0.2 %; σ of a corner of the target 0.1 mm, of a mark 0.6 px"
        in words
    )
    assert held["assumed"] == {"pointing": 0.6, "scale": 0.002}


def test_nothing_of_the_photographs_files_is_in_it(path, folder):
    page = path.read_text(encoding="utf-8")
    assert b"my kitchen" in (folder / "m2.jpg").read_bytes()
    for private in ("kitchen", str(folder), "Exif"):
        assert private not in page
        assert base64.b64encode(private.encode()).decode().rstrip("=")[:-1] not in page


def test_it_says_whose_photographs_they_are(work, results, tmp_path, capsys):
    assert read_report(write(work, results, tmp_path / "a"))["words"].startswith("Lab report\n")
    other = write(replace(work, own=False, instead="There is no folder."), results, tmp_path / "b")
    assert "Lab report, on the supplied photographs" in read_report(other)["words"]
    said = capsys.readouterr().out
    assert "This report is on the supplied photographs: the cell with `look` says why." in said


def test_a_report_on_own_photographs_is_never_replaced(path, work, results, heard):
    before = path.read_bytes()
    assert write(replace(work, own=False), results[:1], path.parent) == path
    assert path.read_bytes() == before
    said = heard()
    assert "lab_report.html stays as it is: it was made with your own photographs" in said


def test_later_work_replaces_earlier_work(work, results, tmp_path):
    for given in (replace(work, own=False), work, work):
        earlier = write(given, results[:1], tmp_path)
    assert len(read_report(write(work, results, tmp_path))["lengths"]) == 2
    assert read_report(earlier)["own"]


def test_where_it_is_graded_only_what_was_handed_in_counts(
    path, work, results, monkeypatch, tmp_path, heard
):
    before = path.read_bytes()
    shell = SimpleNamespace(display_pub=None)
    monkeypatch.setitem(sys.modules, "IPython", SimpleNamespace(get_ipython=lambda: shell))
    write(work, results[:1], path.parent)
    assert path.read_bytes() == before
    assert not write(work, results, tmp_path).exists()
    assert heard().count("as when it is graded: what was handed in counts.") == 2


def taken_on(work, *days):
    """Return work whose photographs, one after the other, are of these days."""
    photos = [
        replace(photo, header=photo.header and replace(photo.header, taken=days[k % len(days)]))
        for k, photo in enumerate(work.photos)
    ]
    return replace(work, photos=tuple(photos))


class TestWhoAndWhen:
    TODAY = date(2026, 4, 1)

    def test_the_days_of_the_photographs(self, work):
        one, other = date(2026, 3, 20), date(2026, 3, 22)
        lines = who_and_when(taken_on(work, other, one, None), "", self.TODAY)
        assert lines == [
            "photographed on 20 March 2026 to 22 March 2026 (by the camera's clock), written on "
            "1 April 2026"
        ]
        lines = who_and_when(taken_on(work, one), "", self.TODAY)
        assert lines[0].startswith("photographed on 20 March 2026 (by")

    def test_only_photographs_that_are_used_tell_a_day(self, work):
        days = [date(2026, 3, 20) if p.used else date(1970, 1, 1) for p in work.photos]
        (line,) = who_and_when(taken_on(work, *days), "", self.TODAY)
        assert "1970" not in line

    def test_no_day_and_no_name_is_invented(self, work):
        assert who_and_when(work, "", self.TODAY) == ["written on 1 April 2026"]
        assert who_and_when(work, None, self.TODAY) == ["written on 1 April 2026"]
        assert who_and_when(work, " \n ", self.TODAY) == ["written on 1 April 2026"]

    def test_a_name_is_one_short_line(self, work):
        first, _ = who_and_when(work, "Ada\n  Lovelace", self.TODAY)
        assert first == "measured by Ada Lovelace"
        assert len(who_and_when(work, "x" * 1000, self.TODAY)[0]) < 100

    def test_they_are_in_the_file(self, work, results, tmp_path):
        path = write(work, results, tmp_path, name="<b>Ada</b>")
        held, page = read_report(path), path.read_text(encoding="utf-8")
        assert held["words"].splitlines()[1] == "measured by <b>Ada</b>"
        assert "<b>Ada" not in page
        assert held["name"] == "<b>Ada</b>"
        written = date.fromisoformat(held["written"])
        assert abs((date.today() - written).days) <= 1
        assert f"written on {written.day} " in held["words"]


def test_without_a_ruler_there_is_a_report_all_the_same(work, results, tmp_path):
    path = write(work, [replace(results[0], ruler=None), results[1]], tmp_path)
    held = read_report(path)
    assert [length["ruler"] for length in held["lengths"]] == [None, 120.0]
    assert "card: 85.4 mm ± 0.6 mm (95 %); not compared with a ruler." in held["words"]


def test_where_nothing_can_be_written_a_sentence_says_so(work, results, tmp_path, heard):
    (tmp_path / FILE).mkdir()
    write(work, results[:1], tmp_path)
    assert "lab_report.html cannot be written" in heard()


class TestMeeting:
    """Rays of the box's lid: pointed at exactly, at the wrong end, from one side."""

    def seen(self, work, name, aim):
        camera = desk.Camera(work.camera.K, *desk.pose_towards(*aim), (640, 480))
        ideal = camera.project(desk.box_corners()[4:6])
        return distort_pixels(ideal, camera.K, work.camera.coefficients)

    def test_both_pictures_and_the_angle_are_told(self, work):
        names, aims = ("m2.jpg", "m3.jpg"), supplied.MEASURING_AIMS[1:]
        shots = [lab.shot(work, name) for name in names]
        ends = [self.seen(work, *what) for what in zip(names, aims, strict=True)]
        said = lab.meeting(shots, ends, 0.5)
        assert re.fullmatch(r"The rays miss each other by 0\.\d\d px, and meet at 51°\.", said)
        swapped = lab.meeting(shots, [ends[0], ends[1][::-1]], 0.5)
        assert "far more than the 0.5 px that you point to" in swapped
        assert "far more" in lab.meeting(shots, [ends[0], ends[1] + [0, 6]], 0.5)
        pointed = tuple(zip(shots, ends, strict=True))
        edge = lab.Result("lid", Measured(120, {"pointing": 0.1}), (120, 0.5), pointed)
        assert "meet at 51°" in edge.taken(0.5)
        assert re.match(r"The camera was \d{3} and \d{3} mm from the middle", edge.taken(0.5))

    def test_a_narrow_angle_is_told(self, work):
        shots = [lab.shot(work, name) for name in ("m1.jpg", "m2.jpg")]
        aims = supplied.MEASURING_AIMS[:2]
        ends = [self.seen(work, s.name, aim) for s, aim in zip(shots, aims, strict=True)]
        beside = shots[1].view.t + np.array([20, 0, 0])
        near = replace(shots[0], view=replace(shots[1].view, t=beside))
        shifted = ends[1] + [25, 0]
        assert "That angle is small" in lab.meeting([near, shots[1]], [shifted, ends[1]], 0.5)


def test_where_there_is_no_report_a_sentence_says_so(capsys, tmp_path):
    lab.show_report(tmp_path)
    assert capsys.readouterr().out.startswith("There is no lab_report.html beside this notebook")
    blocks = ['{"p', "[1]", '{"png": 3, "words": ""}', '{"png": "a!", "words": ""}']
    begin, end = '<script type="application/json" id="lab-report">', "</script>"
    for broken in ("<h1>Lab report</h1>", *(begin + block + end for block in blocks)):
        (tmp_path / FILE).write_text(broken)
        lab.show_report(tmp_path)
        assert "is no report as write_report makes it" in capsys.readouterr().out


def test_a_file_that_is_too_large_is_not_read(tmp_path):
    with (tmp_path / FILE).open("wb") as file:
        file.truncate(MOST + 1)
    assert read_report(tmp_path / FILE) == f"{FILE} is larger than a report can be."


def test_of_many_photographs_set_aside_a_few_are_told(work):
    torn = next(photo for photo in work.photos if photo.name == "torn.jpg")
    many = replace(work, photos=(*work.photos, *[torn] * 11))
    told = [line for line in report_lines(many, [], 0.5, 0.001) if line.startswith("✗")]
    assert len(told) == 9
    assert told[-1] == "✗ and 4 more"


@pytest.mark.parametrize("away", [(0, 0), (700, 500)])
def test_a_cutting_shows_both_ends_where_they_are(away):
    """A spot of light at each end of a length, in a large photograph and beside its edge."""
    ends = np.array([[60.0, 70], [1030, 400]]) + away
    v, u = np.mgrid[:1000, :1800]
    spots = [np.exp(-((u - x) ** 2 + (v - y) ** 2) / (2 * 12**2)) for x, y in ends]
    photograph = np.repeat((250 * sum(spots)).astype(np.uint8)[..., None], 3, axis=2)
    small, seen = cutting(photograph, ends)
    assert max(small.shape[:2]) == 300
    rows, columns = np.indices(small.shape[:2])
    for x, y in seen:
        light = small[..., 0] * (np.hypot(columns - x, rows - y) < 12)
        centre = [(light * k).sum() / light.sum() for k in (columns, rows)]
        np.testing.assert_allclose(centre, (x, y), atol=0.1)


def test_who_grades_sees_the_picture(path, monkeypatch, capsys):
    """Where submissions run, there is an IPython without a kernel; it keeps pictures only."""
    published = []
    shell = SimpleNamespace(display_pub=SimpleNamespace(publish=published.append))
    monkeypatch.setitem(sys.modules, "IPython", SimpleNamespace(get_ipython=lambda: shell))
    monkeypatch.setattr(builtins, "print", lambda *_, **__: None)
    lab.show_report(path.parent)
    (shown,) = published
    assert shown["image/png"][:4] == b"\x89PNG"
    assert "card: 85.4 mm" in shown["text/plain"]
