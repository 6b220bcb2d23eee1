"""Pointing: the marks are where the frame says, in the whole photograph and in the close-ups."""

from types import SimpleNamespace

import numpy as np
import pytest

from course_lib.drawing.explorers.pointing import CLOSE, MAGNIFIED, REACH, marks
from course_lib.measuring import Measured
from course_lib.widgets.lab import measured, pointer

RNG = np.random.default_rng(2)
PHOTOGRAPH = RNG.integers(0, 256, (600, 800, 3), np.uint8)
CORNERS = np.array([(320.0, 300), (400, 310), (480, 320.5)])
SHOT = SimpleNamespace(name="desk.jpg", photograph=PHOTOGRAPH, corners=CORNERS, own=False)
START = [(100.0, 80.5), (300.2, 310.0)]


def length(ends):
    if np.allclose(*ends):
        raise ValueError("both points are the same: point at two different ones")
    return Measured(float(np.linalg.norm(ends[1] - ends[0])), {"pointing": 0.5})


@pytest.fixture
def explorer(tmp_path):
    return pointer(SHOT, ("left end", "right end"), START, length, tmp_path)


def test_it_starts_where_it_is_told(explorer):
    np.testing.assert_allclose(explorer.ends, START)
    said = [r.value for r in explorer.frame_now().readouts]
    assert said[:2] == ["100.0, 80.5", "300.2, 310.0"]
    assert said[-1] == "304.55 ± 0.98"


def test_in_a_readers_photograph_the_marks_begin_at_the_target():
    own = SimpleNamespace(name="desk.jpg", photograph=PHOTOGRAPH, corners=CORNERS, own=True)
    for explorer in (pointer(SHOT), pointer(own, start=START)):
        np.testing.assert_allclose(explorer.ends, CORNERS[[0, 2]])


def test_a_start_outside_is_moved_into_the_photograph():
    ends = pointer(SHOT, start=[(-50, 3000), (1e6, 5)]).ends
    assert (ends > -REACH - 1).all()
    assert (ends < (799 + REACH + 1, 599 + REACH + 1)).all()


def test_a_spot_of_the_whole_photograph_is_at_its_mark(explorer):
    explorer.set(du1=7.3, dv2=-4.1)
    whole = explorer.frame_now().pictures[0]
    assert whole.size == (480, 360)
    scale = 800 / 480
    for handle, end in zip(whole.handles, explorer.ends, strict=True):
        np.testing.assert_allclose((np.array(handle.at) + 0.5) * scale - 0.5, end)
        moved = {name: a + b * handle.at[0] + c * handle.at[1] for name, a, b, c in handle.moves}
        explorer.set(**moved)  # a spot that is pressed and not moved
    np.testing.assert_allclose(explorer.ends, [(107, 80), (300, 306)], atol=0.51)
    assert explorer.state["du1"] == explorer.state["dv2"] == 0


@pytest.mark.parametrize("which", [1, 2])
def test_a_close_up_is_gripped_beside_its_mark(explorer, which):
    for step in (0.0, 9.5, 19.9, -20.0):
        explorer.set(**{f"du{which}": step, f"dv{which}": -step})
        before = explorer.ends
        (handle,) = explorer.frame_now().pictures[which].handles
        assert 0 <= min(handle.at) <= max(handle.at) < CLOSE
        for name, a, b, c in handle.moves:  # drag it by three pixels of the photograph
            to = np.array(handle.at) + 3 * MAGNIFIED * (-1 if step > 10 else 1)
            value = a + b * to[0] + c * to[1]
            explorer.set(**{name: value})
        moved = explorer.ends[which - 1] - before[which - 1]
        wanted = -3 if step > 10 else 3
        inside = np.abs(before[which - 1] + wanted - [explorer.state[f"{c}{which}"] for c in "uv"])
        np.testing.assert_allclose(moved[inside <= REACH], wanted, atol=0.06)


def test_a_close_up_shows_the_pixels_around_its_mark(explorer):
    close = explorer.frame_now().pictures[1].image
    step = int(MAGNIFIED)
    centre = close[REACH * step + step // 2, REACH * step + step // 2]
    u, v = (int(explorer.state[c]) for c in ("u1", "v1"))
    np.testing.assert_array_equal(centre, PHOTOGRAPH[v, u])
    np.testing.assert_array_equal(close[2, 2], PHOTOGRAPH[v - REACH, u - REACH])


def test_beyond_the_edge_a_close_up_is_grey(explorer):
    explorer.set(u1=0, v1=0)
    close = explorer.frame_now().pictures[1].image
    assert (close[: REACH * 6 - 1] == 118).all()
    np.testing.assert_array_equal(close[REACH * 6 + 2, REACH * 6 + 2], PHOTOGRAPH[0, 0])


def test_the_cross_is_where_the_mark_is(explorer):
    explorer.set(du1=2.0, dv1=-3.0)
    lines = explorer.frame_now().pictures[1].lines
    cross = next(np.asarray(x.points) for x in lines if np.isnan(np.asarray(x.points)).any())
    at = np.nanmean(cross, axis=0)
    np.testing.assert_allclose((at + 0.5) / MAGNIFIED - 0.5 - REACH, (2.0, -3.0))


def test_marks_on_one_place_say_why_there_is_no_length(explorer):
    explorer.set(u1=300, v1=310, du1=0, dv1=0, u2=300, v2=310, du2=0, dv2=0)
    last = explorer.frame_now().readouts[-1]
    assert (last.label, last.value) == ("No length", "both points are the same")


class TestMeasured:
    """Marks between which there is a length, and marks between which there is none."""

    def test_a_length_comes_with_its_marks(self, explorer, capsys):
        explorer.set(u1=700, du1=-3.4)
        found, ends = measured(length, explorer)
        np.testing.assert_array_equal(ends, explorer.ends)
        assert found == length(explorer.ends)
        assert capsys.readouterr().out == ""

    def test_where_there_is_none_one_is_told_and_the_first_places_are_taken(self, explorer, capsys):
        explorer.set(u1=300, v1=310, du1=0, dv1=0, u2=300, v2=310, du2=0, dv2=0)
        found, ends = measured(length, explorer)
        np.testing.assert_allclose(ends, START)
        assert found == length(ends)
        said = " ".join(capsys.readouterr().out.split())
        assert "no length between these marks (both points are the same: point at two" in said
        assert "do not use what is measured there" in said
        np.testing.assert_array_equal(*explorer.ends)  # the marks stay where they are

    def test_of_two_photographs_the_marks_of_both_are_taken(self, explorer, tmp_path):
        other = pointer(SHOT, ("a", "b"), CORNERS[:2], folder=tmp_path)
        explorer.set(u1=700)
        other.set(u1=300, v1=310)

        def in_two(one, two):
            if one[0, 0] == 700:
                raise ValueError("the rays are parallel")
            return length(np.stack([one[0], two[0]]))

        _, *ends = measured(in_two, explorer, other)
        np.testing.assert_allclose(ends, [START, CORNERS[:2]])


def test_a_phones_photograph_has_a_thousand_places_to_a_slider():
    large = SimpleNamespace(
        name="desk.jpg", photograph=np.zeros((3000, 4000, 3), np.uint8), own=False
    )
    explorer = pointer(large, start=[(3999, 2999), (2001.3, 17.7)])
    assert len(explorer._controls["u1"].positions) == 1000
    np.testing.assert_allclose(explorer.ends, [(3999, 2999), (2001.3, 17.7)])
    np.testing.assert_allclose(marks(explorer.state), explorer.ends)


def test_a_still_says_the_same_in_words(explorer):
    data, _ = explorer._repr_mimebundle_()
    assert "left end is marked at (100.0, 80.5) px" in data["text/plain"]
    assert data["text/html"].startswith('<img alt="')


class TestKept:
    """Marks are where they were left, in another run of the cell or on another day."""

    ENDS = ("left end", "right end")

    def test_a_moved_mark_is_there_again(self, explorer, tmp_path, capsys):
        assert capsys.readouterr().out == ""
        assert not list(tmp_path.iterdir())  # nothing moved, nothing kept
        explorer.set(u1=700, du1=-3.4)
        again = pointer(SHOT, self.ENDS, START, folder=tmp_path)
        np.testing.assert_allclose(again.ends, [(696.6, 80.5), START[1]])
        assert "where you left them (kept in lab_marks.json)" in capsys.readouterr().out
        again.reset()
        np.testing.assert_allclose(again.ends, START)

    def test_other_marks_and_other_photographs_are_apart(self, explorer, tmp_path):
        explorer.set(u1=700)
        own = SimpleNamespace(name="desk.jpg", own=True, photograph=PHOTOGRAPH, corners=CORNERS)
        other = SimpleNamespace(name="b.jpg", own=False, photograph=PHOTOGRAPH, corners=CORNERS)
        for shot, names in ((own, self.ENDS), (other, self.ENDS), (SHOT, ("a", "b"))):
            assert pointer(shot, names, folder=tmp_path).ends[0, 0] == 320
        pointer(own, self.ENDS, folder=tmp_path).set(u2=500)
        assert pointer(SHOT, self.ENDS, START, folder=tmp_path).ends[0, 0] == 700
        assert pointer(own, self.ENDS, START, folder=tmp_path).ends[1, 0] == 500

    def test_in_own_photographs_one_is_told_to_move_them(self, tmp_path, capsys):
        own = SimpleNamespace(name="IMG_1.jpg", own=True, photograph=PHOTOGRAPH, corners=CORNERS)
        pointer(own, self.ENDS, START, folder=tmp_path)
        said = " ".join(capsys.readouterr().out.split())
        assert "nobody has moved the marks yet: drag them to left end and right end." in said

    @pytest.mark.parametrize("mark", ["{", "[]", '"a"', "[[1, 2]]", "[[1, 2], [NaN, 3]]"])
    def test_another_file_of_that_name_does_no_harm(self, explorer, tmp_path, mark):
        explorer.set(u1=700)
        (path,) = tmp_path.iterdir()
        path.write_text(f'{{"supplied desk.jpg: left end, right end": {mark}}}')
        again = pointer(SHOT, self.ENDS, START, folder=tmp_path)
        np.testing.assert_allclose(again.ends, START)

    def test_where_nothing_can_be_written_a_mark_moves_all_the_same(self, tmp_path):
        (tmp_path / "lab_marks.json").mkdir()
        explorer = pointer(SHOT, self.ENDS, START, folder=tmp_path)
        explorer.set(u1=700)
        assert explorer.ends[0, 0] == 700


def test_a_mark_outside_the_photograph_is_told(explorer):
    explorer.set(u1=0, du1=-5)
    said = explorer.frame_now().readouts[-1]
    assert (said.label, said.value) == ("Outside the photograph", "left end")
