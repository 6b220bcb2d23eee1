import os
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

from course_lib.starting import installing
from course_lib.starting.environment import LOCKS, PROJECT, Environment, found, needed, write_stamp
from course_lib.starting.installing import create, discard, prepare, run_logged
from course_lib.starting.locks import BUILD
from course_lib.starting.trouble import Trouble

ROOT = Path(__file__).resolve().parents[2]
PIN = re.compile(
    r"^(?P<pin>[^\s\\]+(?: ; [^\\]+?)?) \\\n(?: {4}--hash=sha256:[0-9a-f]{64}(?: \\)?\n)+",
    re.MULTILINE,
)


@pytest.fixture
def env(tmp_path: Path) -> Environment:
    root = tmp_path / "Käme räs 相机"
    for name in (*LOCKS.values(), *PROJECT):
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(f"content of {name}")
    return Environment(root)


def pins(wanted: str) -> dict[str, list[str]]:
    """Return the pinned requirements of a lock file, by the package's name."""
    text = (ROOT / LOCKS[wanted]).read_text("utf-8")
    assert PIN.sub("", text) == ""
    by_name: dict[str, list[str]] = {}
    for match in PIN.finditer(text):
        by_name.setdefault(Requirement(match["pin"]).name, []).append(match["pin"])
    return by_name


def versions(wanted: str) -> dict[str, set[str]]:
    """Return the pinned versions; what only tests need may need a package on more systems."""
    return {
        name: {str(Requirement(pin).specifier) for pin in pinned}
        for name, pinned in pins(wanted).items()
    }


def project() -> dict:
    return tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]


@pytest.mark.parametrize("wanted", LOCKS)
def test_lock_file_is_pins_and_hashes_and_no_addresses(wanted):
    text = (ROOT / LOCKS[wanted]).read_text("utf-8")
    assert len(pins(wanted)) > 100
    assert "://" not in text
    assert "--index" not in text


def test_lock_file_of_the_tests_only_adds():
    run, test = versions("run"), versions("test")
    assert {name: test.get(name) for name in run} == run
    assert len(test) > len(run)


@pytest.mark.parametrize("wanted", LOCKS)
def test_lock_file_keeps_the_bounds_of_pyproject(wanted):
    stated = project()
    bounds = stated["dependencies"] + BUILD.split()
    if wanted == "test":  # which takes the other extras in by naming the project itself
        bounds += [b for extra in stated["optional-dependencies"].values() for b in extra]
    pinned = pins(wanted)
    for bound in map(Requirement, bounds):
        if bound.name == stated["name"]:
            continue
        for pin in pinned[canonicalize_name(bound.name)]:
            (version,) = Requirement(pin).specifier
            assert bound.specifier.contains(version.version), f"{pin} is outside {bound}"


def test_a_folder_of_someone_else_is_not_touched(env):
    (env.folder / "theirs").mkdir(parents=True)
    with pytest.raises(Trouble, match="did not make"):
        prepare(env, "run", print)
    assert (env.folder / "theirs").is_dir()


def test_new_environment_has_a_python_and_takes_the_place_of_an_unfinished_one(env):
    env.folder.mkdir()
    env.stamp.write_text("{}")
    (env.folder / "half").write_text("done")
    create(env, lock=os.open(os.devnull, os.O_RDONLY))
    run_logged(env, [str(env.python), "-c", "import pip, encodings"], "Looking", lock=0)
    assert not (env.folder / "half").exists()
    assert found(env) == {}


def test_failed_packages_leave_nothing(env, monkeypatch):
    monkeypatch.setattr(installing, "create", pretend_to_create)
    with pytest.raises(Trouble, match="Installing the packages did not work"):
        prepare(env, "run", lambda sentence: None)
    assert not env.folder.exists()
    assert not (env.root / ".venv.old").exists()
    assert env.log.exists()


def pretend_to_create(env: Environment, lock: int) -> None:
    """Make an environment around the Python of the tests, which reads the broken lock file."""
    env.commands.mkdir(parents=True)
    env.python.symlink_to(sys.executable)
    (env.folder / "pyvenv.cfg").write_text(f"home = {Path(sys.executable).parent}\n", "utf-8")


def test_failed_addition_keeps_what_was_complete(env):
    pretend_to_create(env, lock=0)
    complete = {key: value for key, value in needed(env).items() if key != "test"}
    write_stamp(env, complete)
    with pytest.raises(Trouble, match="Installing the packages did not work"):
        prepare(env, "test", lambda sentence: None)
    assert found(env) == complete


def test_failure_shows_the_reason_and_keeps_the_log(env):
    env.folder.mkdir()
    program = [sys.executable, "-c", "raise SystemExit('ERROR: No space left on device')"]
    with pytest.raises(Trouble, match=r"Looking did not work.\nThe disk is full"):
        run_logged(env, program, "Looking", lock=0)
    assert "No space left" in env.log.read_text()


def test_discard_also_removes_what_an_earlier_one_left(env):
    for folder in (env.folder, env.root / ".venv.old"):
        (folder / "lib").mkdir(parents=True)
    discard(env)
    assert not env.folder.exists()
    assert not (env.root / ".venv.old").exists()


def test_link_to_the_course_is_relative_where_start_made_it():
    # Where start.py made the environment of this test run, its link must not name a place.
    here = Environment(ROOT)
    if not found(here) or Path(sys.prefix) != here.folder:
        pytest.skip("these tests do not run in the environment of start.py")
    (link,) = here.packages.glob("*camera_course.pth")
    assert (here.packages / link.read_text("ascii").strip()).resolve() == ROOT
    assert ROOT.name not in link.read_text("ascii")


def test_setup_opens_nothing():
    here = Environment(ROOT)
    if not found(here) or Path(sys.prefix) != here.folder:
        pytest.skip("these tests do not run in the environment of start.py")
    command = [sys.executable, "-S", str(ROOT / "start.py"), "setup"]
    done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=60)
    assert done.stdout == f"The course is set up in {here.folder}.\n"
