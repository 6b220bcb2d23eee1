"""The control-point game: where to put a few control points, and what that does to the heights."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from course_lib.drawing.explorers.plot import Plot

Floats = NDArray[np.float64]

#: Columns and rows of the grid of points, and metres between two of them.
COLUMNS, ROWS, STEP = 15, 11, 15.0
#: Where the points of the game stand at first: east and north, m.
START = ((60.0, 60.0), (90.0, 60.0), (90.0, 90.0), (60.0, 90.0), (105.0, 75.0))
#: Standard deviations: of a pixel, px, and of a surveyed coordinate, m.
PIXEL, SURVEY = 0.5, 0.01
#: k1 of the lens that the adjustment does not know of, if the lens is off.
WRONG_K1 = -0.002
#: The gauge is open without control: points may be anywhere within this, m.
ANYWHERE = 100.0
#: Larger errors look alike, mm; where the colours change, mm.
LEVELS = (20, 40, 60, 80, 100, 150, 200, 300)
MAP_SIZE = (560, 430)
MAP = Plot((50, 540, 30, 380), (0, (COLUMNS - 1) * STEP), (0, (ROWS - 1) * STEP))
