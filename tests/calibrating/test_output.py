import pytest

from course_lib.calibrating.output import OURS, check_output, written_together


def names(folder):
    return sorted(path.name for path in folder.iterdir())


def write(folder, **files):
    folder.mkdir(exist_ok=True)
    for name, text in files.items():
        (folder / name.replace("__", ".")).write_text(text)


class TestWritten:
    def test_old_files_of_ours_go(self, tmp_path):
        write(tmp_path, report__html=OURS, camera__yaml="old", camera__m="old", photo__jpg="mine")
        with written_together(tmp_path) as draft:
            write(draft, report__html="new", camera__m="new")
        assert names(tmp_path) == ["camera.m", "photo.jpg", "report.html"]
        assert (tmp_path / "camera.m").read_text() == "new"

    def test_files_of_others_stay(self, tmp_path):
        write(tmp_path, camera__yaml="theirs")
        with written_together(tmp_path) as draft:
            write(draft, report__html="new")
        assert names(tmp_path) == ["camera.yaml", "report.html"]

    def test_all_or_nothing(self, tmp_path):
        write(tmp_path, report__html=OURS, camera__m="old")

        def fail():
            with written_together(tmp_path) as draft:
                write(draft, camera__m="new")
                raise KeyboardInterrupt

        with pytest.raises(KeyboardInterrupt):
            fail()
        assert names(tmp_path) == ["camera.m", "report.html"]
        assert (tmp_path / "camera.m").read_text() == "old"


class TestChecked:
    def test_a_file_in_the_way(self, tmp_path):
        write(tmp_path, report="a letter")
        with pytest.raises(OSError, match="is a file, and should be a folder"):
            check_output(tmp_path / "report" / "inside")

    def test_where_nothing_can_be_written(self, tmp_path, monkeypatch):
        def refused(*_, **__):
            raise PermissionError(13, "Permission denied")

        monkeypatch.setattr("tempfile.TemporaryDirectory", refused)
        with pytest.raises(OSError, match=r"can be written in .* \(permission denied\)") as raised:
            check_output(tmp_path / "new")
        assert "Errno" not in str(raised.value)

    def test_leaves_nothing_behind(self, tmp_path):
        check_output(tmp_path / "new" / "inside")
        assert names(tmp_path) == []
