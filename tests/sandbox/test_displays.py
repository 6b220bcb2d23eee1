"""What a submission's cells show is kept, and pictures where a person must see them."""

import json
import subprocess
import sys

SHOW = """
from IPython.display import display
display({"text/plain": "hi", "image/png": "eA=="}, raw=True)
2 + 2
"""
RUN = f"""
import json
from course_lib.sandbox.notebook import make_shell
shell, kept = make_shell(), []
for draws in (False, True):
    shell.kept, shell.draws = [], draws
    shell.run_cell({SHOW!r})
    kept.append(shell.kept)
print(json.dumps(kept))
"""


def test_displays_and_values_are_kept_not_printed():
    done = subprocess.run([sys.executable, "-c", RUN], capture_output=True, text=True, check=True)
    (printed,) = done.stdout.splitlines()
    value = {"output_type": "execute_result", "data": {"text/plain": "4"}}
    shown = {"output_type": "display_data", "data": {"text/plain": "hi"}}
    picture = {"output_type": "display_data", "data": shown["data"] | {"image/png": "eA=="}}
    assert json.loads(printed) == [[shown, value], [picture, value]]
