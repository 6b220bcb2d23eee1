"""How long photographs of a phone wait for their verdicts, and whether the lab's ± is honest."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

from benchmarks.table import Row

#: So many good ones; the others are all that people drop in with them.
GOOD, SIZE = 10, (4000, 3000)
MOST_SECONDS, MOST_MB = 1.5, 1000


def looking() -> list[Row]:
    """Measure the verdicts of 20 files by processor time, with one thread, and the memory."""
    with tempfile.TemporaryDirectory() as folder:
        # Drawing them takes more memory than looking at them, so it is done elsewhere.
        _alone("write", folder)
        return [Row(*cells) for cells in json.loads(_alone("measured", folder))]


def trusting() -> list[Row]:
    """Count how often the truth, or another camera, lies within the ± on real photographs."""
    import numpy as np

    from course_lib import lab

    lengths, shifts, apart = lab.measure_real_pairs(), lab.measure_shifts(), lab.measure_baselines()
    counted = {
        f"{len(lengths)} diagonals of a real board: truth within ±": [c.holds for c in lengths],
        f"{len(shifts)} ways of the board: both cameras agree": [c.ratio < 1 for c in shifts],
        f"{len(apart)} baselines: board and rig agree": [c.ratio < 1 for c in apart],
    }
    rows = [Row(what, 100 * float(np.mean(h)), "%", goal="≥ 90 %") for what, h in counted.items()]
    ways = [c.one.value for c in shifts]
    differ = np.median([abs(c.one.value - c.other.value) for c in shifts])
    joint = np.median([np.hypot(c.one.plus_minus, c.other.plus_minus) for c in shifts])
    what = f"ways of {min(ways):.0f} to {max(ways):.0f} mm: cameras differ by (median)"
    return [
        *rows,
        Row(what, float(differ), "mm"),
        Row("their joint ± (median)", float(joint), "mm"),
    ]


def _alone(what: str, folder: str) -> bytes:
    """Run a function of this module in a process of its own; return what it prints."""
    code = f"from benchmarks import photographs as p; p.{what}({folder!r})"
    alone = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
    command = [sys.executable, "-c", code]
    return subprocess.run(command, check=True, env=alone, capture_output=True).stdout


def write(folder: str) -> None:
    """Draw the files in full size, with the noise of their own pixels: a minute and 1.6 GB."""
    import numpy as np

    from data_generators.phone import write_phone_files

    write_phone_files(Path(folder), np.random.default_rng(0), good=GOOD, image_size=SIZE)


def measured(folder: str) -> None:
    """Print the rows: the slowest verdict and the usual one, and the memory of all."""
    import resource
    import statistics
    import time

    import cv2

    from course_lib.calibrating.looking import Photo, look_at_photo
    from data_generators.desk import TARGET

    cv2.setNumThreads(1)
    seconds, photos = [], list[Photo]()
    for path in sorted(Path(folder).iterdir()):
        start = time.process_time()
        photos.append(look_at_photo(path, TARGET, photos))
        seconds.append(time.process_time() - start)
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    used = sum(photo.used for photo in photos)
    what = f"a verdict, of {len(photos)} files of 12 Mpx as they come ({used} are used)"
    rows: list[list[Any]] = [
        [f"{what}: the slowest", max(seconds), "s", "", None, f"≤ {MOST_SECONDS:g} s"],
        [f"{what}: median", statistics.median(seconds), "s"],
        ["memory of the process after all of them", memory, "MB", "", None, f"≤ {MOST_MB} MB"],
    ]
    print(json.dumps(rows))
