"""Boards whose corners have numbers: OpenCV reads the markers, `corner_fit` places the corners."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from course_lib.boards import Charuco
from course_lib.checks import Array
from course_lib.detection.checkerboards import fit_in_suitable_size
from course_lib.detection.reasons import too_blurred
from course_lib.detection.result import (
    Detection,
    Picture,
    grey_picture,
    in_full_size,
    nothing,
    smaller_pictures,
)

#: Fewer corners in a picture do not tell a pose and are not worth a fit.
FEWEST = 6


def detect_charuco(image: ArrayLike, board: Charuco) -> Detection:
    """Return the corners whose numbers can be read; see `course_lib.detection.detect_board`."""
    grey = grey_picture(image)
    corners, ids, markers = _most_corners(grey, board)
    if len(ids) < FEWEST:
        return nothing("no board", _why_not(markers, len(ids), board))
    # A window must not reach the marker: that is half the free rim away, along the diagonal.
    rim = (board.square - board.marker) / 2 / board.square
    fit = fit_in_suitable_size(grey, corners, share=0.9 * rim * np.sqrt(2))
    ids, count = ids[fit.good], board.columns * board.rows
    if len(ids) < FEWEST:
        return nothing("no board", _why_not(markers, len(ids), board))
    blur = float(np.median(fit.blur[fit.good]))
    square = _square_in_picture(corners)
    if too_blurred(blur, square, grey.shape):
        said = f"{len(ids)} of {board.name} found, but blurred over {2.5 * blur:.0f} px. Hold the "
        said += "camera still, focus, and take it again."
        return Detection(True, fit.points[fit.good], ids, "blurred", said, blur)
    said = f"All {board.name} found." if len(ids) == count else f"{len(ids)} of {board.name} found."
    return Detection(True, fit.points[fit.good], ids, "", said, blur)


def _most_corners(grey: Picture, board: Charuco) -> tuple[Array, Any, int]:
    """Return the corners of the picture size that shows most, their numbers, and the markers."""
    best: tuple[Array, Any, int] = np.empty((0, 2)), np.empty(0, np.intp), 0
    for picture, ratio in smaller_pictures(grey):
        for old in (False, True):  # boards made before 2022 begin with a light square
            corners, ids, _, numbers = _detector(board, old).detectBoard(picture)
            markers = 0 if numbers is None else len(numbers)
            if ids is not None and len(ids) > len(best[1]):
                points = in_full_size(np.asarray(corners, float).reshape(-1, 2), ratio)
                best = points, np.asarray(ids, np.intp).ravel(), markers
            elif markers > best[2]:
                best = best[0], best[1], markers
        if len(best[1]) == board.columns * board.rows:
            break
    return best


def _detector(board: Charuco, old: bool) -> Any:
    """Return OpenCV's detector of a board."""
    import cv2

    if not hasattr(cv2.aruco, board.dictionary):
        raise ValueError(f"no markers {board.dictionary!r}; take one such as DICT_5X5_1000")
    markers = cv2.aruco.getPredefinedDictionary(getattr(cv2.aruco, board.dictionary))
    size = board.columns + 1, board.rows + 1
    opencv = cv2.aruco.CharucoBoard(size, float(board.square), float(board.marker), markers)
    opencv.setLegacyPattern(old)
    return cv2.aruco.CharucoDetector(opencv)


def _square_in_picture(corners: Array) -> float:
    """Return the usual distance to the nearest corner, px."""
    apart = np.linalg.norm(corners[:, None] - corners, axis=2)
    return float(np.median(np.sort(apart, axis=1)[:, 1]))


def _why_not(markers: int, corners: int, board: Charuco) -> str:
    """Return a sentence on a board that was not found."""
    if markers:
        return (
            f"Saw {markers} markers, but only {corners} of {board.name}. Are the counts, the "
            f"dictionary ({board.dictionary}) and the sizes those of the board?"
        )
    return (
        f"No markers of {board.dictionary} were found. The board must be sharp, evenly lit and "
        "large enough; or it has other markers."
    )
