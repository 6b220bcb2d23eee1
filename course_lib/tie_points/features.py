"""Details of one picture that can be recognised in another.

Use this through `course_lib.tie_points`.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.checks import Array, DegenerateConfigurationError, check_count
from course_lib.detection.result import grey_picture


@dataclass(frozen=True, eq=False)
class Features:
    """Details of a picture.

    Attributes
    ----------
    points : ndarray, shape (N, 2)
        Where they are, ``(u, v)`` in px. A place may be there twice, seen in two directions.
    descriptors : ndarray, shape (N, 128), float32
        How they look: whole numbers from 0 to 255.
    """

    points: Array
    descriptors: NDArray[np.float32]

    def __len__(self) -> int:
        """Return how many details there are."""
        return len(self.points)

    @cached_property
    def places(self) -> NDArray[np.intp]:
        """For each detail the number of the first one at the same place, shape (N,)."""
        _, first, inverse = np.unique(self.points, axis=0, return_index=True, return_inverse=True)
        return np.asarray(first[inverse], np.intp)


def find_features(picture: ArrayLike, most: int = 3000) -> Features:
    """Return the details of a picture that can be recognised in another.

    A detail is a light or dark blob of any size. Its descriptor is a histogram of the directions
    of the edges around it, turned with the detail, so that it stays almost the same if the camera
    comes nearer, is turned, or sees it under up to some 40 degrees from another side.

    Parameters
    ----------
    picture : array_like, shape (height, width) or (height, width, 3)
        Grey or RGB: `uint8`, `uint16`, or `float` from 0 to 1.
    most : int
        How many are kept, those with the highest contrast.

    Returns
    -------
    Features
        Places to a fraction of a pixel, and descriptors.

    Raises
    ------
    TypeError, ValueError
        If it is no picture, or `most` no positive whole number.
    DegenerateConfigurationError
        If there is no detail in it.

    References
    ----------
    D. Lowe, "Distinctive image features from scale-invariant keypoints", IJCV 60 (2004).
    """
    import cv2

    most = check_count(most, "most")
    grey = np.clip(np.rint(grey_picture(picture)), 0, 255).astype(np.uint8)
    # Without precise upscaling every place is a quarter of a pixel off.
    finder = cv2.SIFT.create(nfeatures=most, enable_precise_upscale=True)
    found, descriptors = finder.detectAndCompute(grey, None)
    if not found:
        raise DegenerateConfigurationError(
            f"no detail was found in a picture of {grey.shape[1]} × {grey.shape[0]} px: it has no "
            "texture, is too dark or too blurred; tie points need a surface with a pattern"
        )
    best = np.argsort([-detail.response for detail in found], kind="stable")[:most]
    points = np.array([found[k].pt for k in best], float)
    return Features(points, np.asarray(descriptors)[best])
