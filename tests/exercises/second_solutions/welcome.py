import numpy as np


def image_centre(image_size):
    width, height = image_size
    return np.mean([[0, 0], [width - 1, height - 1]], axis=0)
