"""The box for photographs: parts become files, and every file gets a sentence."""

import numpy as np
import pytest

from course_lib.widgets.upload import MOST, UploadBox, Verdict, plain_name

SMALL = np.full((6, 8, 3), 90, np.uint8)


def look(path):
    content = path.read_bytes()
    if not content.startswith(b"picture"):
        return Verdict(path.name, "This is no picture.", False)
    return Verdict(path.name, f"Fine, {len(content)} bytes.", True, SMALL)


class Heard(UploadBox):
    """A box that keeps what it answers."""

    def __init__(self, *args):
        self.sent = []
        super().__init__(*args)

    def send(self, content, buffers=None):
        self.sent.append(content)

    def hear(self, buffer, **content):
        self._handle_custom_msg(content, [memoryview(buffer)])


@pytest.fixture
def box(tmp_path):
    return Heard("Your photographs", tmp_path / "deep" / "mine", look)


def drop(box, name, content, part=4, view="a"):
    for start in range(0, max(len(content), 1), part):
        last = start + part >= len(content)
        box.hear(
            content[start : start + part],
            view=view, name=name, size=len(content), start=start, last=last,
        )  # fmt: skip


def test_parts_become_a_file_with_its_verdict(box, tmp_path):
    drop(box, "IMG_1.jpg", b"picture of a board")
    (row,) = box.rows
    assert (row["sign"], row["name"], row["words"]) == ("✓", "IMG_1.jpg", "Fine, 18 bytes.")
    assert row["picture"].startswith("data:image/jpeg;base64,")
    assert (tmp_path / "deep/mine/IMG_1.jpg").read_bytes() == b"picture of a board"


def test_every_part_is_answered_before_the_next_one_leaves(box):
    drop(box, "IMG_1.jpg", b"picture 123456")
    assert box.sent == [{"view": "a", "taken": start} for start in (0, 4, 8, 12)]


def test_two_pages_can_drop_at_the_same_time(box):
    for start in (0, 4):
        for view in "ab":
            content = {"a": b"picture1", "b": b"picture2"}[view][start : start + 4]
            box.hear(content, view=view, name=f"{view}.jpg", size=8, start=start, last=start == 4)
    assert [row["name"] for row in box.rows] == ["a.jpg", "b.jpg"]
    assert all(row["used"] for row in box.rows)


def test_what_is_no_photograph_is_named_and_not_kept(box, tmp_path):
    drop(box, "letter.txt", b"dear all")
    assert [(r["sign"], r["words"]) for r in box.rows] == [("✗", "This is no picture.")]
    assert not list((tmp_path / "deep/mine").iterdir())
    drop(box, "empty.jpg", b"")
    assert len(box.rows) == 2


def test_a_part_that_is_lost_is_told(box, tmp_path):
    box.hear(b"pict", view="a", name="x.jpg", size=8, start=0, last=False)
    box.hear(b"ure!", view="a", name="x.jpg", size=12, start=8, last=True)
    assert "did not arrive whole" in box.rows[0]["words"]
    assert not (tmp_path / "deep").exists()
    for start in (0, 4, 4):  # one of them twice
        box.hear(b"four", view="a", name="z.jpg", size=12, start=start, last=False)
    box.hear(b"", view="a", name="z.jpg", size=12, start=12, last=True)
    assert "did not arrive whole" in box.rows[1]["words"]
    drop(box, "y.jpg", b"picture")
    assert box.rows[2]["used"]


def test_the_same_file_again_replaces_its_row(box):
    drop(box, "x.jpg", b"a letter")
    drop(box, "x.jpg", b"picture")
    assert [(row["name"], row["used"]) for row in box.rows] == [("x.jpg", True)]


def test_two_photographs_of_one_name_are_both_kept(box, tmp_path):
    for content in (b"picture one", b"picture two", b"picture one", b"picture two", b"a letter"):
        drop(box, "image0.jpeg", content)
    kept = {path.name: path.read_bytes() for path in (tmp_path / "deep/mine").iterdir()}
    assert kept == {"image0.jpeg": b"picture one", "image0 (2).jpeg": b"picture two"}
    said = {row["name"]: row["words"] for row in box.rows}
    assert "both are kept" in said["image0 (2).jpeg"]
    assert "both are kept" not in said["image0.jpeg"]


def test_a_file_that_was_there_is_never_taken_away(box, tmp_path):
    mine = tmp_path / "deep/mine/notes.txt"
    mine.parent.mkdir(parents=True)
    mine.write_bytes(b"dear all")
    drop(box, "notes.txt", b"dear all")
    assert mine.read_bytes() == b"dear all"


def test_a_folder_that_cannot_be_written_is_told(box, tmp_path):
    (tmp_path / "deep").write_text("a file where a folder should be")
    drop(box, "x.jpg", b"picture")
    assert "cannot be written into" in box.rows[0]["words"]
    assert not box.rows[0]["used"]


def test_nonsense_from_a_browser_changes_nothing(box):
    for content in (
        {},
        {"view": 3, "name": "x", "size": 1},
        {"view": "a", "name": "x", "size": "1"},
    ):
        box.hear(b"picture", **content)
    assert box.rows == []
    assert box.sent == []


@pytest.mark.parametrize(
    ("name", "plain"),
    [
        ("IMG 1.jpg", "IMG 1.jpg"),
        ("../../etc/passwd", "passwd"),
        ("C:\\Users\\me\\a.jpg", "a.jpg"),
        (".hidden.jpg", "hidden.jpg"),
        ("a\x00b\n.jpg", "ab.jpg"),
        ("..", "photograph"),
        ("", "photograph"),
    ],
)
def test_a_name_leads_nowhere_else(name, plain):
    assert plain_name(name) == plain


def test_readers_without_a_kernel_see_what_came(box):
    assert "photographs are dropped" in box._repr_mimebundle_()[0]["text/html"]
    drop(box, "<b>.txt", b"letter")
    html = box._repr_mimebundle_()[0]["text/html"]
    assert "<li>✗ b.txt: This is no picture.</li>" in html
    assert box.spec["most"] == MOST
