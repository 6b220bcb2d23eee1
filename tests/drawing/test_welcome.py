"""The figures of chapter 00 say what the course is like."""

import numpy as np
import pytest

from course_lib.drawing import welcome
from course_lib.exercises import CHAPTERS as WITH_EXERCISES

PICTURE = np.full((48, 64, 3), 128, np.uint8)


def test_map_has_a_box_for_each_chapter_and_marks_one():
    texts = [text.get_text() for text in welcome.course_map(here=3).axes[0].texts]
    for number, chapter in welcome.CHAPTERS.items():
        assert f"{number:02d} {chapter.title}" in texts
    widths = [patch.get_linewidth() for patch in welcome.course_map(here=3).axes[0].patches]
    assert sum(width > 2 for width in widths if width) == 1


def test_map_has_no_two_chapters_in_one_place_and_no_way_back():
    places = [(chapter.column, chapter.row) for chapter in welcome.CHAPTERS.values()]
    assert len(set(places)) == len(places)
    for (needed, chapter), way in welcome.ARROWS.items():
        assert needed < chapter
        end = welcome.CHAPTERS[chapter]
        assert way[-1] == (end.column, end.row)


def test_every_chapter_with_exercises_is_on_the_map():
    numbers = {int(name[:2]) for name in WITH_EXERCISES.values()} - {0}
    assert numbers <= set(welcome.CHAPTERS)


def test_frames_name_all_axes():
    left, right = welcome.frames().axes
    names = {text.get_text() for text in left.texts}
    assert {"$x$", "$y$", "$z$", "$X$", "$Y$", "$Z$"} <= names
    assert "px" in right.get_xlabel()


@pytest.mark.parametrize(("pixel", "words"), [((10, 20), "(10, 20)"), ((-5, 20), "outside")])
def test_point_is_marked_where_it_lands(pixel, words):
    axes = welcome.point_in_picture(PICTURE, pixel).axes[0]
    assert words in axes.get_title(loc="left")
    assert tuple(axes.lines[-1].get_xydata()[0]) == pixel
