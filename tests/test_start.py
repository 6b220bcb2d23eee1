"""start.py and the files beside it that other tools read."""

import ast
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
import yaml
from packaging.requirements import Requirement

ROOT = Path(__file__).resolve().parents[1]
OLD = ["python2", "python2.7", "python3.6", "python3.7", "python3.8", "python3.9", "python3.10"]
#: What conda-forge calls a package by another name.
CONDA_NAMES = {"matplotlib": "matplotlib-base"}


def old_pythons() -> list[str]:
    """Return the Pythons of this machine that are too old, as commands that do start."""
    asked = 'import sys; sys.exit(0 if sys.version_info < (3, 11) else "new")'
    installed = [path for name in OLD if (path := shutil.which(name))]
    installed += map(str, Path.home().glob(".pyenv/versions/*/bin/python"))
    return [
        path
        for path in installed
        if subprocess.run([path, "-c", asked], capture_output=True, check=False).returncode == 0
    ]


def start(*arguments: str) -> subprocess.CompletedProcess:
    """Run start.py with a Python that sees no installed package."""
    command = [sys.executable, "-S", ROOT / "start.py", *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def environment_yml() -> dict:
    return yaml.safe_load((ROOT / "environment.yml").read_text("utf-8"))


def test_old_python_can_read_it():
    source = (ROOT / "start.py").read_text("ascii")
    tree = ast.parse(source, feature_version=(3, 4))
    modern = (ast.JoinedStr, ast.AnnAssign, ast.NamedExpr, ast.Nonlocal, ast.YieldFrom, ast.Await)
    nodes = list(ast.walk(tree))
    assert not any(isinstance(node, (*modern, ast.AsyncFunctionDef)) for node in nodes)
    # Python 2: no keyword-only arguments, no annotations, stars only in calls, no raise ... from
    arguments = [node for node in nodes if isinstance(node, ast.arguments)]
    assert not any(each.kwonlyargs or each.posonlyargs for each in arguments)
    assert not any(node.annotation for node in nodes if isinstance(node, ast.arg))
    displays = [node for node in nodes if isinstance(node, ast.List | ast.Tuple | ast.Set)]
    assert not any(isinstance(item, ast.Starred) for each in displays for item in each.elts)
    assert not any(node.cause for node in nodes if isinstance(node, ast.Raise))


@pytest.mark.parametrize("python", old_pythons())
def test_old_python_says_what_is_needed(python):
    done = subprocess.run(
        [python, "start.py"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert done.returncode == 1
    assert done.stderr.startswith("The course needs Python 3.11 or newer; this is Python ")
    assert "Type:  " in done.stderr or "Install Python" in done.stderr
    assert "Traceback" not in done.stderr


def test_it_needs_no_installed_package():
    # -I and -S: no site-packages, no environment variables, nothing of the current folder
    code = (
        f"import sys; sys.path.insert(0, {str(ROOT)!r});"
        "import course_lib.starting.command;"
        "ours = {'course_lib', '__main__'};"
        "names = {name.partition('.')[0] for name in sys.modules} - ours;"
        "print(*(names - sys.stdlib_module_names))"
    )
    done = subprocess.run([sys.executable, "-I", "-S", "-c", code], capture_output=True, text=True)
    assert (done.stdout.strip(), done.stderr) == ("", "")


def test_help_names_every_command_and_option():
    done = start("--help")
    assert done.returncode == 0
    for word in ("start.py test", "start.py lock", "--work", "--no-browser", "--port", "pytest"):
        assert word in done.stdout


def test_wrong_option_is_refused_before_anything_is_made():
    done = start("--wrok", "x")
    assert done.returncode == 2
    assert "--wrok" in done.stderr


def test_environment_yml_states_the_bounds_of_pyproject():
    stated = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]["dependencies"]
    expected = set()
    for bound in map(Requirement, stated):
        expected.add(f"{CONDA_NAMES.get(bound.name, bound.name)}{bound.specifier}")
    *conda, last = environment_yml()["dependencies"]
    assert {*conda, *last["pip"]} - expected == {"python=3.12", "pip", "--editable ."}
    assert expected <= {*conda, *last["pip"]}


def test_environment_yml_has_a_python_that_the_course_knows():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    (python,) = (
        each for each in environment_yml()["dependencies"] if str(each).startswith("python=")
    )
    assert Requirement(f"python{project['requires-python']}").specifier.contains(python[7:])
