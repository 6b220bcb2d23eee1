"""Textures reduced beforehand, so that small pictures of them do not alias."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from data_generators.scene import Texture


class TexturePyramid:
    """One texture at all its resolutions, each axis for itself.

    Level (i, j) has about ``2**-i`` of the columns and ``2**-j`` of the rows, so that a floor seen
    at a flat angle stays sharp across the line of sight. Levels are made when first asked for.

    Parameters
    ----------
    texture : ndarray, shape (h, w, 3), uint8
        The full resolution.

    References
    ----------
    R. L. Larson, M. S. Shah, "Method for generating addresses to textured graphics primitives
    stored in RIP maps", US patent 5222205 (1993).
    """

    def __init__(self, texture: Texture) -> None:
        self._levels: dict[tuple[int, int], Texture] = {(0, 0): texture}
        self._in_fours: dict[tuple[int, int], Texture] = {}
        height, width = texture.shape[:2]
        self.highest = np.array([int(width).bit_length() - 1, int(height).bit_length() - 1])
        self.size = np.array([width, height])

    def level(self, i: int, j: int) -> Texture:
        """Return the texture with columns reduced `i` times and rows `j` times."""
        if (i, j) not in self._levels:
            self._levels[i, j] = (
                _halved(self.level(i - 1, j), 1) if i else _halved(self.level(i, j - 1), 0)
            )
        return self._levels[i, j]

    def in_fours(self, i: int, j: int) -> Texture:
        """Return a level with a fourth channel: OpenCV warps it in less than half the time."""
        import cv2

        if (i, j) not in self._in_fours:
            level = cv2.cvtColor(self.level(i, j), cv2.COLOR_RGB2RGBA)
            self._in_fours[i, j] = np.asarray(level, np.uint8)
        return self._in_fours[i, j]


def levels_for(footprint: NDArray[np.float64], highest: NDArray[np.int_]) -> NDArray[np.int_]:
    """Return the levels whose texels are nearest in size to a pixel.

    Parameters
    ----------
    footprint : ndarray, shape (N, 2)
        Texels of the full texture that one pixel spans along u and v.
    highest : ndarray, shape (N, 2)
        The last level of each axis.

    Returns
    -------
    ndarray, shape (N, 2), int
        Levels (i, j).
    """
    levels = np.rint(np.log2(np.maximum(footprint, 1e-9)))
    return np.asarray(np.clip(levels, 0, highest).astype(int))


def _halved(texture: Texture, axis: int) -> Texture:
    """Return the texture with half the pixels along `axis`, each the mean of those it covers."""
    import cv2

    size = [texture.shape[1], texture.shape[0]]
    size[1 - axis] = max(1, size[1 - axis] // 2)
    return np.asarray(cv2.resize(texture, size, interpolation=cv2.INTER_AREA), np.uint8)
