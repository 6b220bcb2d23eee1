import errno
from pathlib import Path

import pytest

from course_lib.starting.trouble import ADVICE, advice, explain_log, explain_os_error, kind_of

OS_ERROR = "ERROR: Could not install packages due to an OSError"
SHA = "Expected sha256 00\n  Got 11"
# What pip 23.2 to 24.2 and venv print; the last line of each is what a student would see.
LOGS = {
    "disk": f"{OS_ERROR}: [Errno 28] No space left on device",
    "long path": "HINT: This error might have occurred since this system does not have Windows "
    "Long Path support enabled.",
    "separator": "Error: Refusing to create a venv in /a:b/.venv because it contains the PATH "
    "separator :.",
    "hash": f"ERROR: THESE PACKAGES DO NOT MATCH THE HASHES FROM THE REQUIREMENTS FILE.\n{SHA}",
    "permission": f"{OS_ERROR}: [WinError 5] Access is denied",
    "certificate": "WARNING: Retrying (Retry(total=0)) after connection broken by 'SSLError("
    "SSLCertVerificationError(1, '[SSL: CERTIFICATE_VERIFY_FAILED]'))'",
    "network": "WARNING: Retrying (Retry(total=4)) after connection broken by "
    "'NewConnectionError(': Failed to establish a new connection: [Errno -3] Temporary failure in "
    "name resolution')': /simple/alembic/\nERROR: No matching distribution found for alembic",
    "no package": "ERROR: Could not find a version that satisfies the requirement numpy==2.4.6 "
    "(from versions: none)\nERROR: No matching distribution found for numpy==2.4.6",
    "no pip": "The virtual environment was not created successfully because ensurepip is not "
    "available.  On Debian/Ubuntu systems, you need to install the python3-venv",
}


def test_every_kind_has_a_log():
    assert LOGS.keys() == ADVICE.keys()


@pytest.mark.parametrize("kind", LOGS)
def test_log_is_understood(kind):
    assert kind_of(LOGS[kind]) == kind


@pytest.mark.parametrize("kind", ADVICE)
def test_advice_is_complete_sentences(kind, tmp_path):
    text = advice(kind, tmp_path)
    assert "{" not in text
    assert text.endswith(".")


def test_unknown_trouble_shows_the_last_errors_and_the_log(tmp_path):
    log = "Collecting numpy\nERROR: first\nERROR: something new\n"
    text = explain_log(log, "Installing the packages", tmp_path / ".venv.log", tmp_path)
    assert "Installing the packages did not work" in text
    assert "ERROR: something new" in text
    assert str(tmp_path / ".venv.log") in text


def test_silence_is_admitted(tmp_path):
    assert "no reason" in explain_log("", "Installing", Path("log"), tmp_path)


@pytest.mark.parametrize(
    ("number", "words"),
    [(errno.ENOSPC, "disk is full"), (errno.EACCES, "be your own"), (errno.EROFS, "be your own")],
)
def test_refused_file_is_explained(number, words, tmp_path):
    text = explain_os_error(OSError(number, "refused", "the file"), tmp_path)
    assert words in text
    assert "the file" in text
