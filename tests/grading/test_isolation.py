"""What is promised of the walls is tried out, as root and as an ordinary user."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from walls import walled

from course_lib.grading import isolation
from course_lib.grading.answering_library import make_library
from course_lib.grading.explaining import TRIALS, explain_isolation, try_out
from course_lib.grading.isolation import NoIsolationError, build_walls, demand, why_not
from course_lib.grading.servers import Job, Server
from course_lib.sandbox.limits import Allowance

ROOT = Path(__file__).resolve().parents[2]
SMALL = Allowance(memory=1_500_000_000, processes=30, files=50_000_000)
ANYBODY = 60_400


@pytest.mark.slow
@walled
@pytest.mark.parametrize("nests", [True, False])  # some systems forbid walls inside the walls
def test_everything_holds_here(nests):
    assert try_out(SMALL, nests) == [(name, True) for name, *_ in TRIALS]


def test_a_python_in_a_temporary_folder_is_moved_out_of_it(monkeypatch):
    """Each submission has a /tmp of its own, in which a Python could not be seen."""
    monkeypatch.setattr(isolation, "_python_folders", lambda: ["/opt/python", "/tmp/here/.venv"])
    assert isolation.behind("/tmp/here/.venv/bin/python") == "/python1/bin/python"
    assert isolation.behind("/tmp/here/.venv") == "/python1"
    assert isolation.behind("/opt/python/bin/python") == "/opt/python/bin/python"
    assert isolation.behind("/tmp/here/.venv2/bin/python") == "/tmp/here/.venv2/bin/python"


@pytest.mark.slow
@walled
@pytest.mark.parametrize("nests", [True, False])
def test_nothing_is_left_for_the_next_submission(nests, tmp_path):
    tmp_path.chmod(0o755)
    leave = (
        "import os, time\nopen('/tmp/left', 'w').close()\n"
        "if os.fork() == 0:\n    os.setsid()\n    time.sleep(60)"
    )
    look = "import os\nprint(os.path.exists('/tmp/left'), os.popen('ls /proc').read().split())"
    library = make_library(tmp_path, frozenset())
    with Server(library, [], "bubblewrap", 0, nests) as server:
        with server.run(Job([{"cell": 0, "source": leave}]), SMALL) as first:
            assert first.finished
        assert server.nests == nests
        with server.run(Job([{"cell": 0, "source": look}]), SMALL) as second:
            (said,) = second.outputs[0]["outputs"]
    assert said["text"].startswith("False")
    processes = [name for name in said["text"].split("'") if name.isdecimal()]
    assert len(processes) <= (4 if nests else 7)


def shared_with_all(folders: list[Path]) -> list[str]:
    """Return bubblewrap's options that show folders to all, also below private ones."""
    above = sorted({parent for folder in folders for parent in folder.parents})
    private = [path for path in above if path.stat().st_mode & 0o005 != 0o005]
    options = []
    for path in private:
        if not set(path.parents) & set(private):  # what is below is hidden with it
            options += ["--perms", "0755", "--tmpfs", str(path)]
    for path in above:
        options += ["--perms", "0755", "--dir", str(path)]
    for folder in folders:
        options += ["--ro-bind", str(folder), str(folder)]
    return options


@pytest.mark.slow
@walled
@pytest.mark.skipif(os.getuid() != 0, reason="an ordinary user is the one of the other tests")
def test_everything_holds_for_an_ordinary_user():
    shown = shared_with_all(sorted({Path(sys.base_prefix).resolve(), Path(sys.prefix), ROOT}))
    code = (
        "import os\nassert os.getuid() == 60400\n"
        "from course_lib.grading.explaining import explain_isolation\nprint(explain_isolation())"
    )
    person = ["setpriv", f"--reuid={ANYBODY}", f"--regid={ANYBODY}", "--clear-groups"]
    command = ["bwrap", "--dev-bind", "/", "/", *shown, *person, sys.executable, "-c", code]
    environment = os.environ | {"HOME": "/tmp", "PYTHONPATH": str(ROOT)}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, cwd="/")
    assert done.returncode == 0, done.stderr
    assert "as your user, in a namespace" in done.stdout
    assert done.stdout.count("  held  ") == len(TRIALS)
    assert "BROKEN" not in done.stdout


@walled
def test_nothing_but_the_system_python_and_the_library_is_in_sight(tmp_path):
    command = build_walls("bubblewrap", tmp_path, 9, 0).command
    places = {command[k + 1] for k, word in enumerate(command) if word.endswith("bind")}
    own = {sys.prefix, sys.base_prefix, str(Path(sys.executable).resolve().parents[1])}
    fonts = {place for place in places if "fontlist" in place}
    assert places - {str(tmp_path)} - own - fonts <= {*isolation.SYSTEM, *isolation.SYSTEM_TOO}
    assert "--bind" not in command
    assert "--unshare-net" in command


def test_without_bubblewrap_it_says_so_and_refuses(monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", str(tmp_path))
    why_not.cache_clear()
    try:
        with pytest.raises(NoIsolationError, match=r"apt install bubblewrap.*--isolation none"):
            demand("bubblewrap")
        demand("none")
        assert explain_isolation().startswith("Nothing holds here: bubblewrap is not installed")
    finally:
        why_not.cache_clear()


def test_a_bubblewrap_that_does_not_work_is_refused(monkeypatch, tmp_path):
    broken = tmp_path / "bwrap"
    broken.write_text("#!/bin/sh\necho no namespaces here >&2\nexit 1\n")
    broken.chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}:/usr/bin:/bin")
    why_not.cache_clear()
    try:
        assert why_not() == "bubblewrap does not work here: no namespaces here"
    finally:
        why_not.cache_clear()


def test_a_term_can_be_set_up_where_nothing_can_be_isolated():
    """On Windows there is no `resource` and no `fcntl`; nbgrader's settings must load there."""
    code = (
        "import sys\nsys.modules.update(resource=None, fcntl=None)\n"
        "import course_lib.grading.configuration\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT)
    assert done.returncode == 0, done.stderr


def test_nothing_of_the_graders_environment_goes_in_but_how_to_compute(monkeypatch, tmp_path):
    monkeypatch.setenv("PGPASSWORD", "secret")
    monkeypatch.setenv("OPENBLAS_CORETYPE", "Haswell")
    for way in ("bubblewrap", "none"):
        environment = build_walls(way, tmp_path, 3, 0).environment
        assert environment["OPENBLAS_CORETYPE"] == "Haswell"
        assert "secret" not in environment.values()
