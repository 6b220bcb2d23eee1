import cv2
import numpy as np
import pytest

from data_generators import disks


@pytest.mark.parametrize("diameter", [0.4, 1.0, 1.5, 1.7, 3.0, 4.9, 5.1, 9, 15.9, 17, 40, 100])
def test_second_moment(diameter):
    # What a point becomes, averaged over all places that it may have in the reduced picture.
    r, weights = 2 ** disks.reduction(diameter), disks.kernel(diameter)
    side = 256
    widths = []
    for start in range(r):
        point = np.zeros((side, side), np.float32)
        point[side // 2, side // 2 + start] = 1
        small = cv2.resize(point, (side // r, side // r), interpolation=cv2.INTER_AREA)
        small = cv2.filter2D(small, -1, weights)
        seen = cv2.resize(small, (side, side), interpolation=cv2.INTER_LINEAR).sum(axis=0)
        assert seen.sum() == pytest.approx(1, abs=1e-4)
        widths.append((seen * (np.arange(side) - side // 2 - start) ** 2).sum())
    assert 4 * np.sqrt(np.mean(widths)) == pytest.approx(diameter, rel=0.02, abs=0.03)


def test_degenerate():
    assert disks.kernel(0.0) is None
    assert disks.reduction(0.0) == 0
