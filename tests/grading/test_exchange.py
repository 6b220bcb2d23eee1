"""Fetch, submit, collect and get feedback through nbgrader's exchange, as on a shared machine."""

import getpass
import os
import re
import shutil

import nbformat
import pytest
from small_course import run

pytestmark = pytest.mark.slow
ASSIGNMENT = "01_pinhole"


@pytest.fixture
def student(released_term, tmp_path, monkeypatch):
    """A student's folder, set up as the term's README says."""
    readme = (released_term / "README.md").read_text(encoding="utf-8")
    settings = re.search(r"```python\n(.*?)```", readme, re.DOTALL)[1]
    (tmp_path / "nbgrader_config.py").write_text(settings)
    monkeypatch.setenv("JUPYTER_DATA_DIR", str(tmp_path / "data"))
    return tmp_path


def succeed(*command, cwd):
    done = run("nbgrader", *command, ASSIGNMENT, cwd=cwd)
    assert done.returncode == 0, done.stderr
    return done.stderr


def test_there_and_back(released_term, student):
    me = getpass.getuser()
    succeed("release_assignment", cwd=released_term)
    succeed("fetch_assignment", cwd=student)
    mine = student / ASSIGNMENT / f"{ASSIGNMENT}.ipynb"
    assert mine.read_bytes() == (released_term / "release" / ASSIGNMENT / mine.name).read_bytes()
    notebook = nbformat.read(mine, as_version=4)
    for cell in notebook.cells:
        if cell.id == "pinhole-dolly_zoom":
            cell.source = "def dolly_zoom(f, Z, Z_new):\n    return f * Z_new / Z"
    nbformat.write(notebook, mine)
    succeed("submit", cwd=student)
    (sent,) = (released_term / "exchange/camera/inbound").iterdir()
    (sent / "data.txt").symlink_to(released_term / "grading.key")
    (sent / "folder").symlink_to(released_term / "source")
    os.mkfifo(sent / "pipe")
    succeed("collect", cwd=released_term)
    (sent / "pipe").unlink()  # the term is copied by other tests
    taken = released_term / "submitted" / me / ASSIGNMENT
    assert not {"data.txt", "folder", "pipe"} & {path.name for path in taken.iterdir()}
    assert (
        released_term / "submitted" / me / ASSIGNMENT / mine.name
    ).read_bytes() == mine.read_bytes()
    succeed("autograde", cwd=released_term)
    succeed("generate_feedback", cwd=released_term)
    succeed("release_feedback", cwd=released_term)
    succeed("fetch_feedback", cwd=student)
    (page,) = student.glob(f"{ASSIGNMENT}/feedback/*/{ASSIGNMENT}.html")
    assert "4 of 4 points" in page.read_text(encoding="utf-8")


def test_what_has_no_time_or_is_no_folder_stops_nobody(new_term):
    term = new_term("inbound", [])
    inbound, released = term / "exchange/camera/inbound", term / "release" / ASSIGNMENT
    shutil.rmtree(inbound, ignore_errors=True)  # of the other test
    early, late = (f"+{ASSIGNMENT}+2026-11-0{day} 10:00:00.0 UTC+x" for day in (1, 2))
    unusable = [f"named-so+{ASSIGNMENT}+{time}+x" for time in ("no time", f"1:{'9' * 40}.5")]
    for name in ("honest" + early, "timeless" + early, early, *unusable):
        shutil.copytree(released, inbound / name)
        (inbound / name / "timestamp.txt").write_text("2026-11-01 10:00:00.0 UTC")
    (inbound / f"timeless{early}/timestamp.txt").write_text("no time")
    for name, target in (("to-nowhere", term / "nowhere"), ("to-source", term / "source")):
        (inbound / (name + early)).symlink_to(target)
        unusable.append(name + early)
    said = succeed("collect", cwd=term)
    assert all(f"Not collected: {inbound / name} (" in said for name in unusable)
    assert {path.name for path in (term / "submitted").iterdir()} == {"honest", "timeless"}
    (timed,) = term.glob(f"submitted/*/{ASSIGNMENT}/timestamp.txt")
    assert "honest" in timed.parts
    shutil.copytree(inbound / ("honest" + early), inbound / ("honest" + late))
    assert "Updating submission: honest" in succeed("collect", "--update", cwd=term)
