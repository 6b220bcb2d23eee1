"""Measure everything, or the entries that are named: ``python -m benchmarks [NAME …]``."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from functools import partial

from benchmarks import (
    bundle,
    calibration,
    commands,
    compute,
    convergence,
    corners,
    epipolar,
    estimate,
    grading,
    latency,
    lens,
    lessons,
    photographs,
)
from benchmarks.explorers import EXPLORERS
from benchmarks.table import RESULTS, Row, write_section

#: Every entry is a function that returns rows. Add yours here.
ENTRIES: dict[str, Callable[[], list[Row]]] = {
    **{f"explorers-{chapter}": partial(latency.measure, chapter) for chapter in EXPLORERS},
    "importing": compute.importing,
    "projecting": compute.projecting,
    "bundling": bundle.bundling,
    "rendering": compute.rendering,
    "defocusing": compute.defocusing,
    "calibrating": calibration.calibrating,
    "converging": convergence.converging,
    "distorting": lens.distorting,
    "looking": photographs.looking,
    "trusting": photographs.trusting,
    "refining": corners.refining,
    "estimating": estimate.estimating,
    "epipolar": epipolar.epipolar,
    "starting": commands.starting,
    "building": commands.building,
    "executing": lessons.executing,
    "grading": grading.grading,
}


def main() -> None:
    """Measure and write the results."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks", description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"of {', '.join(ENTRIES)}")
    names = parser.parse_args().names or list(ENTRIES)
    unknown = sorted(set(names) - set(ENTRIES))
    if unknown:
        parser.error(f"there is no entry {', '.join(unknown)}; there are {', '.join(ENTRIES)}")
    for name in names:
        rows = ENTRIES[name]()
        write_section(name, rows)
        for row in rows:
            print("  ".join(cell for cell in row.cells() if cell))
    print(f"written to {RESULTS}")


if __name__ == "__main__":
    main()
