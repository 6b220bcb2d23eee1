import subprocess
import sys

from course_lib.starting.single import only_one

HOLD = """
import sys, time
from pathlib import Path
from course_lib.starting.single import only_one
with only_one(Path(sys.argv[1]), print):
    print("held", flush=True)
    time.sleep(10)
"""


def test_the_second_waits_until_the_first_was_killed(tmp_path):
    path = tmp_path / "lock"
    with subprocess.Popen([sys.executable, "-c", HOLD, path], stdout=subprocess.PIPE) as first:
        assert first.stdout.readline().strip() == b"held"
        sayings = []

        def say(sentence: str) -> None:
            sayings.append(sentence)
            first.kill()

        with only_one(path, say):
            assert first.wait() != 0
        assert len(sayings) == 1
        assert "Another start" in sayings[0]


def test_a_lock_that_is_free_is_not_waited_for(tmp_path):
    for _ in range(2):
        with only_one(tmp_path / "lock", lambda sentence: None) as handle:
            assert handle > 0
