import json
import shutil
import sys
import tomllib
from pathlib import Path

import pytest

from course_lib.starting.environment import (
    LOCKS,
    PROJECT,
    Environment,
    found,
    is_foreign,
    needed,
    steps_to,
    variables,
    write_stamp,
)

FROM_NOTHING = ["create", "run", "project"]


@pytest.fixture
def env(tmp_path: Path) -> Environment:
    """Return an environment with real lock files and a living Python, complete for a run."""
    root = tmp_path / "Käme räs 相机"
    for name in (*LOCKS.values(), *PROJECT):
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(f"content of {name}")
    env = Environment(root)
    make_alive(env)
    write_stamp(env, {key: value for key, value in needed(env).items() if key != "test"})
    return env


def make_alive(env: Environment) -> None:
    env.commands.mkdir(parents=True)
    env.python.write_bytes(b"")
    (env.folder / "pyvenv.cfg").write_text(f"home = {Path(sys.executable).parent}\n", "utf-8")


def steps(env: Environment, wanted: str = "run") -> list[str]:
    return steps_to(wanted, found(env), needed(env))


def test_complete_environment_needs_no_step(env):
    assert steps(env) == []


def test_no_environment_needs_every_step(env):
    shutil.rmtree(env.folder)
    assert steps(env) == FROM_NOTHING
    assert steps(env, "test") == ["create", "test", "project"]


def test_tests_add_to_a_run_and_satisfy_it(env):
    assert steps(env, "test") == ["test"]
    write_stamp(env, needed(env))
    assert steps(env, "test") == steps(env, "run") == []


def test_new_lock_file_means_a_new_environment(env):
    (env.root / LOCKS["run"]).write_text("other pins")
    assert steps(env) == FROM_NOTHING


def test_new_lock_file_of_the_tests_leaves_a_run_alone(env):
    write_stamp(env, needed(env))
    (env.root / LOCKS["test"]).write_text("other pins")
    assert steps(env) == []
    assert steps(env, "test") == ["test"]


@pytest.mark.parametrize("name", PROJECT)
def test_new_project_file_installs_the_project_only(env, name):
    (env.root / name).write_text("changed")
    assert steps(env) == ["project"]


def test_killed_between_packages_and_project_goes_on_there(env):
    write_stamp(env, {key: needed(env)[key] for key in ("place", "run")})
    assert steps(env) == ["project"]


def test_killed_before_the_packages_were_complete_starts_anew(env):
    write_stamp(env, {"place": needed(env)["place"]})
    assert steps(env) == FROM_NOTHING


@pytest.mark.parametrize("text", ["", "{", "[]", "null"])
def test_a_broken_stamp_starts_anew(env, text):
    env.stamp.write_text(text)
    assert steps(env) == FROM_NOTHING


def test_moved_with_its_folder_it_is_made_anew(env):
    moved = Environment(env.root.with_name("moved"))
    env.root.rename(moved.root)
    assert steps(moved) == FROM_NOTHING


def test_removed_python_is_noticed(env):
    env.python.unlink()
    assert steps(env) == FROM_NOTHING


def test_removed_home_of_python_is_noticed(env):
    (env.folder / "pyvenv.cfg").write_text("home = /nowhere/bin\n")
    assert steps(env) == FROM_NOTHING


def test_other_python_is_noticed(env, monkeypatch):
    monkeypatch.setattr(sys.implementation, "cache_tag", "cpython-399")
    assert steps(env) == FROM_NOTHING


def test_every_file_that_the_wheel_carries_elsewhere_is_watched():
    wheel = tomllib.loads(
        (Path(__file__).resolve().parents[2] / "pyproject.toml").read_text("utf-8")
    )
    shared = wheel["tool"]["hatch"]["build"]["targets"]["wheel"]["shared-data"]
    assert set(PROJECT) == {"pyproject.toml", *shared}


def test_stamp_holds_any_path(env):
    assert str(env.folder) in json.loads(env.stamp.read_text("utf-8"))["place"]


def test_only_a_folder_without_stamp_is_foreign(env):
    assert not is_foreign(env)
    env.stamp.unlink()
    assert is_foreign(env)
    shutil.rmtree(env.folder)
    assert not is_foreign(env)
    env.folder.mkdir()
    assert not is_foreign(env)


def test_variables_leave_other_pythons_out(env, monkeypatch):
    for name in ("PYTHONPATH", "PYTHONHOME", "PIP_TARGET", "PIP_REQUIRE_VIRTUALENV", "PIP_PREFIX"):
        monkeypatch.setenv(name, "elsewhere")
    monkeypatch.setenv("PIP_USER", "1")
    monkeypatch.setenv("PIP_INDEX_URL", "a mirror")
    monkeypatch.setenv("HTTPS_PROXY", "a proxy")
    given = variables(env)
    assert "elsewhere" not in given.values()
    assert given["PIP_USER"] == "0"
    assert (given["PIP_INDEX_URL"], given["HTTPS_PROXY"]) == ("a mirror", "a proxy")
    assert given["PATH"].startswith(str(env.commands))
    assert given["PYTHONUTF8"] == "1"
