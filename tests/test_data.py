"""Real pictures: found, checked, and missed with a sentence."""

import hashlib
import http.server
import os
import threading
from pathlib import Path

import pytest

from course_lib import data

RAW = "nikon_raw/DSC_1339_768x512_rggb.raw"
CONTENT = b"a picture"


@pytest.fixture
def cache(tmp_path, monkeypatch):
    """An empty cache, and no folder of copies."""
    monkeypatch.delenv("COURSE_DATA_DIR", raising=False)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.setenv("LOCALAPPDATA", str(tmp_path / "cache"))
    monkeypatch.setenv("HOME", str(tmp_path))
    return tmp_path


@pytest.fixture
def server(cache, monkeypatch):
    """A server on this machine that has the raw picture, and counts how often it is asked."""
    asked = []

    class Handler(http.server.BaseHTTPRequestHandler):
        def do_GET(self):
            asked.append(self.path)
            self.send_response(200)
            self.end_headers()
            self.wfile.write(CONTENT)

        def log_message(self, *_):
            pass

    with http.server.HTTPServer(("127.0.0.1", 0), Handler) as listening:
        threading.Thread(target=listening.serve_forever, daemon=True).start()
        address = f"http://127.0.0.1:{listening.server_port}/raw"
        entry = data._Entry(hashlib.sha256(CONTENT).hexdigest(), address)
        monkeypatch.setitem(data._registry(), RAW, entry)
        yield asked
        listening.shutdown()


def test_every_file_has_a_source_and_a_checksum():
    for name in data.names():
        credit, licence = data.source(name)
        assert credit, name
        assert licence, name
        assert len(data._registry()[name].sha256) == 64, name


def test_every_address_is_pinned_to_a_commit_or_a_tag():
    for name, entry in data._registry().items():
        if entry.address:
            commit = entry.address.split("/")[5]
            assert len(commit) == 40 or commit == "4.6.0", name


def test_names_of_a_folder():
    assert data.names("nikon_raw") == [RAW]


def test_unknown_name_names_similar_ones():
    with pytest.raises(ValueError, match=r"did you mean opencv_stereo/left"):
        data.fetch("opencv_stereo/left1.jpg")


def test_downloads_once(server, cache):
    first = data.fetch(RAW)
    assert first.read_bytes() == CONTENT
    assert data.fetch(RAW) == first
    assert server == ["/raw"]


def test_what_is_not_the_file_is_refused(server, monkeypatch):
    wrong = data._registry()[RAW]._replace(sha256="0" * 64)
    monkeypatch.setitem(data._registry(), RAW, wrong)
    with pytest.raises(data.Unavailable, match="could not be downloaded"):
        data.fetch(RAW)


def test_no_network_is_one_sentence(cache, monkeypatch):
    nobody = data._registry()[RAW]._replace(address="http://127.0.0.1:9/raw")
    monkeypatch.setitem(data._registry(), RAW, nobody)
    with pytest.raises(data.Unavailable, match="Connect to the internet once"):
        data.fetch(RAW)


def test_copy_comes_first(cache, monkeypatch):
    copy = cache / "copies" / RAW
    copy.parent.mkdir(parents=True)
    copy.write_bytes(CONTENT)
    monkeypatch.setenv("COURSE_DATA_DIR", str(cache / "copies"))
    entry = data._registry()[RAW]._replace(sha256=hashlib.sha256(CONTENT).hexdigest())
    monkeypatch.setitem(data._registry(), RAW, entry)
    assert data.fetch(RAW) == copy


def test_spoilt_copy_is_named(cache, monkeypatch):
    copy = cache / "copies" / RAW
    copy.parent.mkdir(parents=True)
    copy.write_bytes(b"something else")
    monkeypatch.setenv("COURSE_DATA_DIR", str(cache / "copies"))
    with pytest.raises(data.Unavailable, match="is not the file it should be"):
        data.fetch(RAW)


def test_file_without_address_says_what_to_do(cache):
    with pytest.raises(data.Unavailable, match="set COURSE_DATA_DIR"):
        data.fetch("resection_tables/wuhan_resection.txt")


def test_the_copies_of_the_tests_are_complete():
    folder = os.environ.get("COURSE_DATA_DIR")
    if not folder and not os.environ.get("CI"):
        pytest.skip("COURSE_DATA_DIR is not set")
    assert folder, "set COURSE_DATA_DIR to the folder with the real pictures"
    for name in data.names():
        assert data.fetch(name) == Path(folder, name)
