"""The environment check is right about what is here, missing, old or broken."""

import sys

from packaging.requirements import Requirement

from course_lib import environment


def test_this_environment_is_fine(capsys):
    environment.check_environment()
    text = capsys.readouterr().out
    assert text.startswith("Everything is here: Python")
    assert "✗" not in text


def test_needed_packages_leave_the_test_tools_out():
    names = {requirement.name for requirement in environment.needed_packages()}
    assert {"numpy", "nbgrader", "jupyterlab"} <= names
    assert "pytest" not in names


def test_missing_package_says_what_to_do():
    verdict = environment.package_verdict(Requirement("no-such-package>=1"))
    assert not verdict.fine
    assert verdict.found == "not found"
    assert "start the course again" in verdict.advice


def test_old_package_is_not_fine():
    verdict = environment.package_verdict(Requirement("numpy>=99"))
    assert not verdict.fine
    assert "another version" in verdict.advice


def test_package_that_does_not_load_is_named(monkeypatch):
    monkeypatch.setitem(sys.modules, "cv2", None)  # what Python does for a blocked import
    verdict = environment.package_verdict(Requirement("opencv-python-headless"))
    assert not verdict.fine
    assert "does not load" in verdict.advice


def test_headline_names_what_is_wrong():
    verdicts = [environment.package_verdict(Requirement(name)) for name in ("numpy", "nothere")]
    text = environment._text(verdicts)
    assert "nothere must be mended" in text.splitlines()[0]
    assert "python3 start.py" in text
    assert "<td>✗</td>" in environment._html(verdicts)
