import os
import stat

import nbformat
import pytest
from nbformat.v4 import new_code_cell, new_notebook

from course_lib.grading.seeding import ExecuteWithSeed, grading_seed, read_key, write_key
from course_lib.notebook import GRADING_SEED


@pytest.fixture
def key_file(tmp_path):
    write_key(tmp_path / "grading.key")
    return tmp_path / "grading.key"


def test_only_its_owner_can_read_the_key(key_file):
    assert stat.S_IMODE(key_file.stat().st_mode) == 0o600


def test_keys_differ_and_are_never_overwritten(tmp_path, key_file):
    write_key(tmp_path / "other.key")
    assert read_key(key_file) != read_key(tmp_path / "other.key")
    with pytest.raises(FileExistsError):
        write_key(key_file)


@pytest.mark.parametrize("content", [None, "", "short\n"])
def test_without_a_key_nothing_is_graded(tmp_path, content):
    path = tmp_path / "grading.key"
    if content is not None:
        path.write_text(content)
    with pytest.raises(ValueError, match="without it nothing can be graded"):
        read_key(path)


def test_seeds_are_reproducible_and_differ():
    key = b"k" * 64
    seeds = [grading_seed(k, s, a) for k in (key, b"l" * 64) for s in "ab" for a in ("01", "02")]
    assert len(set(seeds)) == 8
    assert seeds[0] == grading_seed(key, "a", "01")
    assert grading_seed(key, "ab", "c") != grading_seed(key, "a", "bc")


@pytest.mark.slow
def test_the_kernel_sees_the_seed_and_nothing_more(key_file):
    peek = new_code_cell("import os, json; print(json.dumps(dict(os.environ)))")
    resources = {"nbgrader": {"student": "ada", "assignment": "01"}, "metadata": {"path": "."}}
    step = ExecuteWithSeed(key_file=str(key_file))
    notebook, _ = step.preprocess(new_notebook(cells=[peek]), resources)
    seen = "".join(output.get("text", "") for output in notebook.cells[0].outputs)
    key = read_key(key_file)
    assert grading_seed(key, "ada", "01") in seen
    assert key.decode() not in seen
    assert GRADING_SEED not in os.environ


def test_the_variable_is_gone_after_a_failure(key_file, monkeypatch):
    def fail(*_):
        assert GRADING_SEED in os.environ
        raise RuntimeError("no kernel")

    monkeypatch.setattr("nbgrader.preprocessors.Execute.preprocess", fail)
    resources = {"nbgrader": {"student": "ada", "assignment": "01"}}
    with pytest.raises(RuntimeError, match="no kernel"):
        ExecuteWithSeed(key_file=str(key_file)).preprocess(nbformat.v4.new_notebook(), resources)
    assert GRADING_SEED not in os.environ
