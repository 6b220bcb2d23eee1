"""Wrong answers to the exercises of chapter 04 on pictures: noise, colour, shade, silhouettes."""

from __future__ import annotations

from typing import Any

import numpy as np

# --- clipped_fraction -------------------------------------------------------------------------


def ends_left_out(image, black=0, white=255):
    pixels = image.reshape(*image.shape[:2], -1)
    return np.array([(p.any(axis=2)).mean() for p in (pixels < black, pixels > white)])


def beyond_left_out(image, black=0, white=255):
    pixels = image.reshape(*image.shape[:2], -1)
    return np.array([(p.any(axis=2)).mean() for p in (pixels == black, pixels == white)])


def each_colour_counted(image, black=0, white=255):
    return np.array([(image <= black).mean(), (image >= white).mean()])


def all_colours_at_once(image, black=0, white=255):
    pixels = image.reshape(*image.shape[:2], -1)
    return np.array([(p.all(axis=2)).mean() for p in (pixels <= black, pixels >= white)])


def white_first(image, black=0, white=255):
    pixels = image.reshape(*image.shape[:2], -1)
    return np.array([(p.any(axis=2)).mean() for p in (pixels >= white, pixels <= black)])


def in_percent(image, black=0, white=255):
    pixels = image.reshape(*image.shape[:2], -1)
    return np.array([100 * (p.any(axis=2)).mean() for p in (pixels <= black, pixels >= white)])


def pixels_counted(image, black=0, white=255):
    pixels = image.reshape(*image.shape[:2], -1)
    return np.array([(p.any(axis=2)).sum() for p in (pixels <= black, pixels >= white)])


def always_8_bits(image, black=0, white=255):
    pixels = image.reshape(*image.shape[:2], -1)
    return np.array([(p.any(axis=2)).mean() for p in (pixels <= 0, pixels >= 255)])


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


def other_side_of_the_picture(mosaic):
    return interpolated(mosaic, mode="wrap")


def grey_three_times(mosaic):
    return np.dstack([mosaic, mosaic, mosaic])


# --- flat_field -------------------------------------------------------------------------------


def dark_left_out(image, dark, flat):
    return image / flat * flat.mean(axis=(0, 1))


def dark_left_in_flat(image, dark, flat):
    return (image.astype(float) - dark) / flat * flat.mean(axis=(0, 1))


def not_scaled_back(image, dark, flat):
    return (image.astype(float) - dark) / (flat.astype(float) - dark)


def flat_subtracted(image, dark, flat):
    return image.astype(float) - flat + flat.mean(axis=(0, 1))


def one_mean_for_all(image, dark, flat):
    light = flat.astype(float) - dark
    return (image.astype(float) - dark) / light * light.mean()


def scaled_to_brightest(image, dark, flat):
    light = flat.astype(float) - dark
    return (image.astype(float) - dark) / light * light.max(axis=(0, 1))


def unsigned_difference(image, dark, flat):
    light = flat - dark
    return (image - dark) / light * light.mean(axis=(0, 1))


# --- silhouette_area --------------------------------------------------------------------------


def bright_counted(image, threshold, pixel_size):
    return np.count_nonzero(image >= threshold) * np.prod(np.broadcast_to(pixel_size, 2))


def brighter_counted(image, threshold, pixel_size):
    return np.count_nonzero(image > threshold) * np.prod(np.broadcast_to(pixel_size, 2))


def threshold_included(image, threshold, pixel_size):
    return np.count_nonzero(image <= threshold) * np.prod(np.broadcast_to(pixel_size, 2))


def side_for_area(image, threshold, pixel_size):
    return np.count_nonzero(image < threshold) * np.broadcast_to(pixel_size, 2)[0]


def times_the_sides(image, threshold, pixel_size):
    return np.count_nonzero(image < threshold) * pixel_size


def number_of_pixels(image, threshold, pixel_size):
    return np.count_nonzero(image < threshold)


def box_around_it(image, threshold, pixel_size):
    rows, columns = np.nonzero(image < threshold)
    return np.ptp(rows) * np.ptp(columns) * np.prod(np.broadcast_to(pixel_size, 2))


def grey_values_added(image, threshold, pixel_size):
    return image[image < threshold].sum() * np.prod(np.broadcast_to(pixel_size, 2))


def width_squared(image, threshold, pixel_size):
    return np.count_nonzero(image < threshold) * np.broadcast_to(pixel_size, 2)[0] ** 2
