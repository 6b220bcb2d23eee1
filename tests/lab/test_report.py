"""The report: one file that shows what was measured, and nothing of whoever measured it."""

import base64
import builtins
import sys
from dataclasses import replace
from types import SimpleNamespace

import cv2
import numpy as np
import pytest

from course_lib import lab
from course_lib.lab.report import FILE, read_report
from course_lib.measuring import Measured


@pytest.fixture(scope="module")
def results(work):
    one, other = lab.shot(work, "m2.jpg"), lab.shot(work, "m3.jpg")
    ends = np.array([[300.0, 200.0], [380.0, 210.0]])
    card = Measured(85.4, {"pointing": 0.3, "pose": 0.1})
    lid = Measured(121.0, {"pointing": 0.2})
    return [
        lab.Result("card", card, 85.6, 0.5, ((one, ends),)),
        lab.Result("lid", lid, 120.0, 0.5, ((one, ends), (other, ends))),
    ]


@pytest.fixture(scope="module")
def path(work, results, tmp_path_factory):
    return lab.write_report(work, results, tmp_path_factory.mktemp("handed"))


def test_agreement_is_judged_by_both_uncertainties(results):
    card, lid = results
    assert card.difference == pytest.approx(-0.2)
    assert card.ratio == pytest.approx(0.2 / np.hypot(1.959964 * np.hypot(0.3, 0.1), 0.5))
    assert lid.ratio > 1 > card.ratio
    assert card.said.startswith("card: 85.4 mm ± 0.6 mm (95 %); ruler 85.6 mm ± 0.5 mm; diff")


def test_the_file_holds_picture_and_numbers(path, work):
    assert path.name == FILE
    assert path.stat().st_size < 2_000_000
    held = read_report(path)
    picture = cv2.imdecode(np.frombuffer(base64.b64decode(held["png"]), np.uint8), cv2.IMREAD_COLOR)
    assert picture.shape[1] == 800
    assert picture.std() > 20
    assert held["camera"]["K"] == work.camera.K.tolist()
    assert [length["value"] for length in held["lengths"]] == [85.4, 121.0]
    assert "7 of 11 photographs, 640 × 480 px" in held["words"]


def test_nothing_of_the_photographs_files_is_in_it(path, folder):
    page = path.read_text(encoding="utf-8")
    assert b"my kitchen" in (folder / "m2.jpg").read_bytes()
    for private in ("kitchen", str(folder), "Exif"):
        assert private not in page
        assert base64.b64encode(private.encode()).decode().rstrip("=")[:-1] not in page


def test_it_says_whose_photographs_they_are(work, results, tmp_path):
    assert read_report(lab.write_report(work, results, tmp_path))["words"].startswith("Lab report.")
    other = lab.write_report(replace(work, own=False), results, tmp_path)
    assert "Lab report, on the supplied photographs." in read_report(other)["words"]


def test_where_there_is_no_report_a_sentence_says_so(capsys, tmp_path):
    lab.show_report(tmp_path)
    assert capsys.readouterr().out.startswith("There is no lab_report.html beside this notebook")
    blocks = ['{"p', "[1]", '{"png": 3, "words": ""}', '{"png": "a!", "words": ""}']
    begin, end = '<script type="application/json" id="lab-report">', "</script>"
    for broken in ("<h1>Lab report</h1>", *(begin + block + end for block in blocks)):
        (tmp_path / FILE).write_text(broken)
        lab.show_report(tmp_path)
        assert "is no report as write_report makes it" in capsys.readouterr().out


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
