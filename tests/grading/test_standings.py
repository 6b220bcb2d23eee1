"""Which assignments reports and tables are made of."""

import pytest

from course_lib.grading.standings import Standing, read_classes


def test_what_else_lies_in_release_is_no_assignment(tmp_path):
    (tmp_path / "release/.ipynb_checkpoints").mkdir(parents=True)
    (tmp_path / "release/.DS_Store").touch()
    (tmp_path / "release/notes.txt").touch()
    with pytest.raises(ValueError, match=r"there is no assignment in .*release$"):
        next(read_classes(tmp_path))


@pytest.mark.parametrize(
    ("points", "is_graded", "has_points"),
    [
        ({}, False, False),
        ({"words": None}, True, False),
        ({"words": None, "code": 0.0}, True, True),
        ({"code": 0.0}, True, True),
    ],
)
def test_no_points_are_points_and_words_that_wait_are_none(points, is_graded, has_points):
    student = Standing("ada", points=points)
    assert (student.is_graded, student.has_points) == (is_graded, has_points)
