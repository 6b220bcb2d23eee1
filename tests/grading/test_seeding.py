import stat

import pytest

from course_lib.grading.seeding import grading_seed, read_key, write_key


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
