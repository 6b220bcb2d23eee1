"""Wrong answers to the exercises of chapter 04 on the colour mosaic."""

from __future__ import annotations

from typing import Any

import numpy as np

# --- bayer_mosaic -----------------------------------------------------------------------------


def laid(image: Any, pattern: str) -> Any:
    """Lay the letters of a pattern over a picture."""
    mosaic = np.zeros(image.shape[:2])
    for i, letter in enumerate(pattern):
        row, column = divmod(i, 2)
        mosaic[row::2, column::2] = image[row::2, column::2, "RGB".index(letter)]
    return mosaic


def always_red_first(image, pattern="RGGB"):
    return laid(image, "RGGB")


def red_and_blue_exchanged(image, pattern="RGGB"):
    return laid(image[..., ::-1], pattern)


def columns_before_rows(image, pattern="RGGB"):
    return laid(image, pattern[0] + pattern[2] + pattern[1] + pattern[3])


def mean_of_colours(image, pattern="RGGB"):
    return image.mean(axis=2)


def three_layers(image, pattern="RGGB"):
    layers = np.zeros(image.shape)
    for i, letter in enumerate(pattern):
        place = np.s_[i // 2 :: 2, i % 2 :: 2, "RGB".index(letter)]
        layers[place] = image[place]
    return layers


def one_place_a_square(image, pattern="RGGB"):
    return laid(image[::2, ::2].repeat(2, axis=0).repeat(2, axis=1), pattern)


def one_pixel_a_square(image, pattern="RGGB"):
    return laid(image, pattern)[::2, ::2]


# --- demosaic_bilinear ------------------------------------------------------------------------


def interpolated(
    mosaic: Any, pattern: str = "RGGB", mode: Any = "constant", corner: int = 0, count: bool = True
) -> Any:
    """Interpolate with the neighbours' mean, in one of several ways."""
    image = np.zeros((*mosaic.shape, 3))
    for colour, letter in enumerate("RGB"):
        seen = np.zeros(mosaic.shape)
        for i in range(4):
            seen[i // 2 :: 2, i % 2 :: 2] = pattern[i] == letter
        aside = corner if letter == "G" else 1
        weights = [(aside, 2, aside), (2, 4, 2), (aside, 2, aside)]
        total = around(np.where(seen, mosaic, 0), weights, mode)
        inside = np.where(seen, 4, 8 if letter == "G" else 4)  # away from the picture's edge
        image[..., colour] = total / (around(seen, weights, mode) if count else inside)
    return image


def around(values: Any, weights: Any, mode: Any) -> Any:
    """Sum up the weighted neighbours of each pixel."""
    padded = np.pad(values, 1, mode=mode)
    rows, columns = values.shape
    return sum(
        weights[i][j] * padded[i : i + rows, j : j + columns] for i in range(3) for j in range(3)
    )


def nearest_in_the_square(mosaic):
    red, blue = mosaic[0::2, 0::2], mosaic[1::2, 1::2]
    green = (mosaic[0::2, 1::2] + mosaic[1::2, 0::2]) / 2
    return np.dstack([red, green, blue]).repeat(2, axis=0).repeat(2, axis=1)


def dark_frame(mosaic):
    return interpolated(mosaic, count=False)


def blue_first(mosaic):
    return interpolated(mosaic, "BGGR")


def green_in_the_corner(mosaic):
    return interpolated(mosaic, "GRBG")


def seen_green_smoothed(mosaic):
    return interpolated(mosaic, corner=1)


def seen_green_averaged(mosaic):
    """With the mean of all that is known in the square of 3 × 3 pixels."""
    image = interpolated(mosaic)
    green = np.indices(mosaic.shape).sum(axis=0) % 2
    ones = np.ones((3, 3))
    image[..., 1] = around(mosaic * green, ones, "constant") / around(green, ones, "constant")
    return image


def weights_of_green_for_all(mosaic):
    layers = []
    for row, column in ((0, 0), (0, 1), (1, 1)):
        seen = np.zeros(mosaic.shape)
        seen[row::2, column::2] = 1
        if row != column:
            seen[1::2, 0::2] = 1
        cross = [(0, 1, 0), (1, 4, 1), (0, 1, 0)]
        layers.append(around(mosaic * seen, cross, "constant") / around(seen, cross, "constant"))
    return np.stack(layers, axis=-1)


def layers_first(mosaic):
    return np.moveaxis(interpolated(mosaic), -1, 0)


def other_side_of_the_picture(mosaic):
    return interpolated(mosaic, mode="wrap")


def blue_below_red(mosaic):
    """With the green pixels of the second row taken for blue ones."""
    image = interpolated(mosaic)
    image[..., 2] = interpolated(mosaic, "RGBG")[..., 2]
    return image


def all_colours_summed(mosaic):
    """With the pixels of other colours in the sum, and not in what it is divided by."""
    image = np.zeros((*mosaic.shape, 3))
    for colour, (corner, side) in enumerate([(1, 2), (0, 1), (1, 2)]):
        weights = [(corner, side, corner), (side, 4, side), (corner, side, corner)]
        seen = np.zeros(mosaic.shape)
        for i in range(4):
            seen[i // 2 :: 2, i % 2 :: 2] = "RGB".index("RGGB"[i]) == colour
        image[..., colour] = around(mosaic, weights, "constant") / around(seen, weights, "constant")
    return image


def green_layer_first(mosaic):
    return interpolated(mosaic)[..., [1, 0, 2]]


def grey_three_times(mosaic):
    return np.dstack([mosaic, mosaic, mosaic])
