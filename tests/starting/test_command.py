import os
import subprocess
import sys
from pathlib import Path

import pytest

from course_lib.starting import command
from course_lib.starting.environment import Environment
from course_lib.starting.trouble import Trouble

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def handed(monkeypatch, tmp_path):
    """Return what is handed over to; the set-up is taken as complete."""
    calls = []
    monkeypatch.setattr(command, "prepare", lambda env, wanted, say: calls.append(wanted))
    monkeypatch.setattr(
        command, "hand_over", lambda env, arguments, folder: calls.append((arguments, folder)) or 7
    )
    notebook = tmp_path / "notebooks" / command.FIRST
    notebook.parent.mkdir(parents=True)
    notebook.write_text("{}")
    monkeypatch.setattr(command, "ROOT", tmp_path)
    return calls


def test_start_copies_and_opens_the_first_chapter(handed, tmp_path):
    assert command.main(["--work", str(tmp_path / "mine"), "--no-browser", "--port", "9000"]) == 7
    wanted, (arguments, folder) = handed
    assert wanted == "run"
    assert folder == tmp_path / "mine"
    assert (folder / command.FIRST).read_text() == "{}"
    assert arguments[:2] == ["-m", "jupyterlab"]
    assert f"--ServerApp.root_dir={folder}" in arguments
    assert f"--LabApp.default_url=/lab/tree/{command.FIRST}" in arguments
    assert {"--no-browser", "--ServerApp.port=9000"} <= set(arguments)


def test_what_follows_two_dashes_is_for_lab(handed, tmp_path):
    command.main(["--", "--allow-root", "--port", "1"])
    _, (arguments, folder) = handed
    assert arguments[-3:] == ["--allow-root", "--port", "1"]
    assert folder == tmp_path / "work"


def test_test_hands_its_arguments_to_pytest(handed, tmp_path):
    assert command.main(["test", "-k", "pinhole", "-x"]) == 7
    wanted, (arguments, folder) = handed
    assert wanted == "test"
    assert arguments[:3] == ["-m", "pytest", "-n"]
    assert arguments[4:] == ["-k", "pinhole", "-x"]
    assert folder == tmp_path


@pytest.mark.parametrize(
    ("error", "words"),
    [
        (Trouble("a reason"), "a reason"),
        (PermissionError(13, "Permission denied", "x"), "be your own"),
        (KeyboardInterrupt(), "Stopped"),
    ],
)
def test_trouble_is_told_without_a_traceback(error, words, monkeypatch, capfd):
    def fail(*_):
        raise error

    monkeypatch.setattr(command, "prepare", fail)
    monkeypatch.setattr(command.sys, "stdout", sys.__stdout__)
    monkeypatch.setattr(command.sys, "stderr", sys.__stderr__)
    assert command.main([]) == 1
    told = capfd.readouterr().err
    assert words in told
    assert "Traceback" not in told


@pytest.mark.skipif(os.name != "posix", reason="elsewhere the exit code comes from a child")
def test_exit_code_and_arguments_go_through(tmp_path):
    env = Environment(tmp_path)
    env.commands.mkdir(parents=True)
    env.python.symlink_to(sys.executable)
    code = (
        "import sys; from pathlib import Path;"
        "from course_lib.starting import command, environment;"
        "env = environment.Environment(Path(sys.argv[1]));"
        "command.hand_over(env, ['-c', 'import sys; sys.exit(len(sys.argv))', 'ä b'], env.root)"
    )
    done = subprocess.run([sys.executable, "-c", code, tmp_path], cwd=ROOT, check=False)
    assert done.returncode == 2
