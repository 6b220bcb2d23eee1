"""White things before black, as cameras see them: what is light can be counted."""

import numpy as np

from data_generators.quick import QuickRenderer

WHITE = np.array((255, 255, 255))


def light(scene, camera):
    """A picture of white things on black, 0 to 1."""
    return QuickRenderer(scene, subpixels=8).picture(camera)[..., 1] / 255
