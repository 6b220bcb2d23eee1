"""Square markers with a number, as ArUco boards carry them: which cells are dark."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from course_lib.boards import Charuco


def marker_cells(dictionary: str, number: int) -> NDArray[np.bool_]:
    """Return which cells of a marker are dark.

    Parameters
    ----------
    dictionary : str
        A set of markers, as OpenCV calls it, e.g. ``"DICT_5X5_1000"``.
    number : int
        Which of them.

    Returns
    -------
    ndarray of bool, shape (n, n)
        With the dark frame around the bits.

    Raises
    ------
    ValueError
        If there is no such set or no such marker in it.
    """
    import cv2

    if not dictionary.startswith("DICT_") or not hasattr(cv2.aruco, dictionary):
        raise ValueError(f"no markers {dictionary!r}; take one such as DICT_5X5_1000")
    markers = cv2.aruco.getPredefinedDictionary(getattr(cv2.aruco, dictionary))
    if not 0 <= number < len(markers.bytesList):
        raise ValueError(
            f"{dictionary} has markers 0 to {len(markers.bytesList) - 1}, not {number}"
        )
    side = markers.markerSize + 2
    return np.asarray(markers.generateImageMarker(number, side) == 0)


def charuco_markers(board: Charuco) -> Iterator[tuple[int, int, NDArray[np.bool_]]]:
    """Yield the column and row of each light square of a board, and the cells of its marker."""
    number = 0
    for row in range(board.rows + 1):
        for column in range(board.columns + 1):
            if (row + column) % 2:
                yield column, row, marker_cells(board.dictionary, number)
                number += 1
