import html.parser
import io
import re
import shlex
import shutil
import sys

import numpy as np
import pytest
from PIL import Image
from real_data import fetched

from course_lib import data
from course_lib.calibrating.command import EXAMPLE
from course_lib.calibration_files import read_camera
from course_lib.cli import main


class Tags(html.parser.HTMLParser):
    """Counts tags, and asserts that each is closed."""

    def __init__(self):
        super().__init__()
        self.open, self.seen, self.text = [], [], ""

    def handle_starttag(self, tag, attrs):
        self.seen.append((tag, dict(attrs)))
        if tag not in ("meta", "image", "rect", "path", "circle"):
            self.open.append(tag)

    def handle_endtag(self, tag):
        if self.open and self.open[-1] == tag:
            self.open.pop()

    def handle_data(self, data):
        self.text += data


@pytest.fixture(scope="module")
def output(folder, tmp_path_factory):
    target = tmp_path_factory.mktemp("calibration") / "out"
    arguments = ["calibrate", str(folder), "--board", "7x5", "--square", "30"]
    code = main([*arguments, "--output", str(target), "--coefficients", "k1,k2,p1,p2"])
    return code, target


class TestCalibrate:
    def test_code_says_whether_there_is_something_to_do(self, output):
        code, target = output
        page = (target / "report.html").read_text("utf-8")
        assert code == (1 if "<li class='bad'>" in page else 0)

    def test_every_file_holds_the_same_camera(self, output, truth):
        _, target = output
        names = {p.name for p in target.iterdir()}
        assert names == {"report.html", "camera.yml", "camera.m", "camera.yaml", "camera.json"}
        cameras = [read_camera(target / f"camera.{end}") for end in ("yml", "m", "yaml", "json")]
        for camera in cameras:
            np.testing.assert_allclose(camera.K, cameras[0].K, rtol=1e-12)
            np.testing.assert_allclose(
                camera.coefficients[:4], cameras[0].coefficients[:4], rtol=1e-12
            )
        np.testing.assert_allclose(cameras[0].K, truth.K, rtol=0.02)

    def test_report_tells_how_it_came_about(self, output, folder):
        page = Tags()
        page.feed((output[1] / "report.html").read_text("utf-8"))
        assert f"course calibrate {folder} --board 7x5 --square 30" in page.text
        assert "squares of 30 mm" in page.text
        # True camera: an edge is at 240 / 420 = r (1 - 0.28 r² + 0.1 r⁴), so r = 0.632.
        width = re.search(r"([\d.]+)° across", page.text)
        assert float(width[1]) == pytest.approx(2 * np.degrees(np.arctan(0.632)), abs=0.5)

    def test_the_program_in_the_report_runs(self, output, folder, tmp_path, monkeypatch):
        page = (output[1] / "report.html").read_text("utf-8")
        program = re.search(r"<pre>(.*?)</pre>", page, re.S)[1]
        shutil.copy(output[1] / "camera.json", tmp_path)
        photograph = Image.open(folder / "view1.png")
        photograph.save(tmp_path / "photograph.jpg")
        monkeypatch.chdir(tmp_path)
        exec(program, {})
        straight = Image.open("straight.png")
        assert straight.size == photograph.size
        assert np.abs(np.asarray(straight, float) - np.asarray(photograph, float)).mean() > 1

    def test_a_second_run_leaves_no_old_file(self, output, folder, tmp_path):
        target = tmp_path / "out"
        shutil.copytree(output[1], target)
        typed = ["calibrate", str(folder), "--board", "7x5", "--square", "30"]
        main([*typed, "--output", str(target)])
        names = {p.name for p in target.iterdir()}
        assert names == {"report.html", "camera.yml", "camera.m", "camera.json"}

    def test_report_is_whole_and_names_everything(self, output, folder):
        _, target = output
        page = Tags()
        page.feed((target / "report.html").read_text("utf-8"))
        assert page.open == []
        for path in folder.iterdir():
            assert path.name in page.text
        images = [attrs for tag, attrs in page.seen if tag == "image"]
        assert len(images) >= 11
        assert all(i["href"].startswith("data:image/jpeg;base64,") for i in images)
        pictures = [attrs for tag, attrs in page.seen if tag == "svg"]
        assert all(p["role"] == "img" and p["aria-label"] for p in pictures)
        assert not [a for _, a in page.seen if "src" in a or a.get("href", "").startswith("http")]

    def test_wrong_board_is_told(self, folder, tmp_path, capsys):
        paths = [str(folder / f"view{n}.png") for n in (1, 2, 3, 4)]
        code = main(
            ["calibrate", *paths, "--board", "8x6", "--square", "30", "--output", str(tmp_path)]
        )
        said = capsys.readouterr()
        assert code == 2
        assert "is it --board 7x5?" in said.err
        assert not list(tmp_path.iterdir())

    @pytest.mark.parametrize(
        ("options", "said"),
        [
            (["--board", "5x4"], "is it --board 7x5?"),
            (["--board", "7x5", "--kind", "dots"], "leave --kind out and say --board 7x5"),
        ],
    )
    def test_another_board_is_asked_for_early(self, folder, tmp_path, capsys, options, said):
        target = tmp_path / "out"
        typed = ["calibrate", str(folder), *options, "--square", "30", "--output", str(target)]
        assert main(typed) == 2
        told = capsys.readouterr()
        assert said in told.err
        assert "[ 4/" not in told.out
        assert not target.exists()

    def test_stopped(self, folder, monkeypatch, capsys):
        def stop(*_):
            raise KeyboardInterrupt

        monkeypatch.setattr("course_lib.calibrating.looking.detect_board", stop)
        assert main(["calibrate", str(folder), "--board", "7x5", "--square", "30"]) == 130
        assert capsys.readouterr().err == "course: stopped\n"

    def test_too_few(self, folder, tmp_path, capsys):
        photos = [str(folder / name) for name in ("view1.png", "x_half.jpg")]
        options = ["--board", "7x5", "--square", "30", "--output", str(tmp_path)]
        code = main(["calibrate", *photos, *options])
        said = capsys.readouterr()
        assert code == 2
        assert "1 of 2 photographs; 3 are needed" in said.err
        assert "damaged or cut off" in said.out

    @pytest.mark.parametrize(
        ("options", "said"),
        [
            (["--board", "7x5", "--square", "0"], "--square must be from 0.5 mm"),
            (["--board", "1x5", "--square", "30"], "columns must be a whole number"),
            (["--board", "7x5", "--square", "30", "--coefficients", "k9"], "coefficients must be"),
            (["--board", "7x5", "--square", "30", "--coefficients", ""], "--coefficients none"),
            (["--board", "7x5", "--square", "30", "--kind", "squares"], "need --pitch"),
            (["--board", "7x5", "--square", "30", "--marker", "20"], "is for --kind charuco"),
            (["--board", "7x5", "--square", "2500"], "to 2000 mm, got 2500"),
        ],
    )
    def test_impossible_options(self, folder, options, said, capsys):
        assert main(["calibrate", str(folder), *options]) == 2
        assert said in capsys.readouterr().err

    @pytest.mark.parametrize(
        ("text", "said"),
        [
            ("30,5", "write 30.5 "),
            ("30mm", "write 30.0 "),
            ("3 cm", "write 30.0 "),
            ("nan", "write a number of millimetres"),
        ],
    )
    def test_length_as_people_write_it(self, text, said, capsys):
        with pytest.raises(SystemExit):
            main(["calibrate", "x", "--board", "7x5", "--square", text])
        assert said in capsys.readouterr().err

    def test_board_as_words(self, capsys):
        with pytest.raises(SystemExit):
            main(["calibrate", "x", "--board", "nine by six", "--square", "30"])
        assert "write it like 9x6" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("folder", "board", "focal", "rms"),
    [
        # Bouguet published 533.523, BoofCV 701.01 with two coefficients.
        ("opencv_stereo/left", ["9x6", "--square", "30"], (533.52, 0.5), 0.165),
        (
            "boofcv/Sony_DSC-HX5V_Chess",
            ["4x6", "--square", "30", "--coefficients", "k1,k2"],
            (701.01, 3.0),
            0.16,
        ),
    ],
)
def test_real_photographs(folder, board, focal, rms, tmp_path):
    names = [name for name in data.names(folder) if name.endswith(".jpg")]
    photos = [str(fetched(name)) for name in names]
    assert main(["calibrate", *photos, "--board", *board, "--output", str(tmp_path)]) == 0
    camera = read_camera(tmp_path / "camera.json")
    assert camera.K[0, 0] == pytest.approx(focal[0], abs=focal[1])
    assert camera.rms < rms


def test_a_terminal_that_lacks_characters(tmp_path, monkeypatch):
    old = io.TextIOWrapper(io.BytesIO(), encoding="ascii")
    monkeypatch.setattr(sys, "stdout", old)
    assert main(["target", str(tmp_path / "b.pdf"), "--board", "9x6", "--square", "25"]) == 0
    old.seek(0)
    assert "9 ? 6 corners" in old.read()


class TestTarget:
    @pytest.mark.parametrize("kind", ["checkerboard", "dots", "charuco"])
    def test_writes_a_page(self, kind, tmp_path, capsys):
        path = tmp_path / "board.pdf"
        options = ["--board", "9x6", "--square", "25", "--kind", kind]
        assert main(["target", str(path), *options]) == 0
        assert path.read_bytes().startswith(b"%PDF")
        assert "Print it at 100 %" in capsys.readouterr().out

    def test_another_ending(self, tmp_path, capsys):
        path = tmp_path / "board.png"
        assert main(["target", str(path), "--board", "9x6", "--square", "25"]) == 2
        assert "must end in .pdf" in capsys.readouterr().err
        assert not path.exists()

    def test_the_help_shows_boards_that_fit(self, tmp_path):
        boards = re.findall(r"--board \d.*", EXAMPLE)
        assert len(boards) == 4
        for number, line in enumerate(boards):
            options = shlex.split(line.split("  ")[0])
            assert main(["target", str(tmp_path / f"{number}.pdf"), *options]) == 0

    def test_too_large(self, tmp_path, capsys):
        code = main(["target", str(tmp_path / "b.pdf"), "--board", "9x6", "--square", "40"])
        assert code == 2
        assert "or --page A2" in capsys.readouterr().err
