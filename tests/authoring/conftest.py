import pytest
from small_course import write_course


@pytest.fixture
def course(tmp_path, monkeypatch):
    """A small course in the working directory."""
    root = write_course(tmp_path / "course")
    monkeypatch.chdir(root)
    return root
