"""Which assignments reports and tables are made of."""

import pytest

from course_lib.grading.standings import read_classes


def test_what_else_lies_in_release_is_no_assignment(tmp_path):
    (tmp_path / "release/.ipynb_checkpoints").mkdir(parents=True)
    (tmp_path / "release/.DS_Store").touch()
    (tmp_path / "release/notes.txt").touch()
    with pytest.raises(ValueError, match=r"there is no assignment in .*release$"):
        next(read_classes(tmp_path))
