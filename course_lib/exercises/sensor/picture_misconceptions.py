"""Wrong answers to the exercises of chapter 04 on pictures: clipping, shade, silhouettes."""

from __future__ import annotations

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


def colours_counted_thrice(image, black=0, white=255):
    rows, columns = image.shape[:2]
    return np.array([(image <= black).sum(), (image >= white).sum()]) / (rows * columns)


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


def divided_by_all_numbers(image, black=0, white=255):
    pixels = image.reshape(*image.shape[:2], -1)
    return np.array([p.any(axis=2).sum() for p in (pixels <= black, pixels >= white)]) / image.size


def columns_for_colours(image, black=0, white=255):
    return np.array([(p.any(axis=-1)).mean() for p in (image <= black, image >= white)])


# --- flat_field -------------------------------------------------------------------------------


def dark_left_out(image, dark, flat):
    return image / flat * flat.mean(axis=(0, 1))


def dark_left_in_flat(image, dark, flat):
    return (image.astype(float) - dark) / flat * flat.mean(axis=(0, 1))


def scaled_with_dark(image, dark, flat):
    light = flat.astype(float) - dark
    return (image.astype(float) - dark) / light * flat.mean(axis=(0, 1))


def dark_left_in_image(image, dark, flat):
    light = flat.astype(float) - dark
    return image / light * light.mean(axis=(0, 1))


def flat_multiplied(image, dark, flat):
    light = flat.astype(float) - dark
    return (image.astype(float) - dark) * light / light.mean(axis=(0, 1))


def mean_of_rows_only(image, dark, flat):
    light = flat.astype(float) - dark
    return (image.astype(float) - dark) / light * light.mean(axis=0)


def not_scaled_back(image, dark, flat):
    return (image.astype(float) - dark) / (flat.astype(float) - dark)


def flat_subtracted(image, dark, flat):
    return image.astype(float) - flat + flat.mean(axis=(0, 1))


def one_mean_for_all(image, dark, flat):
    light = flat.astype(float) - dark
    return (image.astype(float) - dark) / light * light.mean()


def dark_added_back(image, dark, flat):
    light = flat.astype(float) - dark
    return (image.astype(float) - dark) / light * light.mean(axis=(0, 1)) + dark


def scaled_to_the_image(image, dark, flat):
    scene = image.astype(float) - dark
    return scene / (flat.astype(float) - dark) * scene.mean(axis=(0, 1))


def scaled_to_the_whole_image(image, dark, flat):
    scene = image.astype(float) - dark
    return scene / (flat.astype(float) - dark) * scene.mean()


def scaled_to_brightest(image, dark, flat):
    light = flat.astype(float) - dark
    return (image.astype(float) - dark) / light * light.max(axis=(0, 1))


def clipped_before_the_noise_averages_out(image, dark, flat):
    light = flat.astype(float) - dark
    return np.maximum(image.astype(float) - dark, 0) / light * light.mean(axis=(0, 1))


def magnitude_of_the_noise(image, dark, flat):
    light = flat.astype(float) - dark
    return np.abs(image.astype(float) - dark) / light * light.mean(axis=(0, 1))


def gamma_taken_off_again(image, dark, flat):
    light = flat.astype(float) ** 2.2 - dark.astype(float) ** 2.2
    scene = image.astype(float) ** 2.2 - dark.astype(float) ** 2.2
    return scene / light * light.mean(axis=(0, 1))


def gamma_put_on(image, dark, flat):
    light = flat.astype(float) - dark
    even = np.maximum(image.astype(float) - dark, 0) / light
    return even ** (1 / 2.2) * light.mean(axis=(0, 1))


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


def share_of_the_picture(image, threshold, pixel_size):
    return (image < threshold).mean() * np.prod(np.broadcast_to(pixel_size, 2))


def share_without_a_size(image, threshold, pixel_size):
    return (image < threshold).mean()


def box_around_it(image, threshold, pixel_size):
    rows, columns = np.nonzero(image < threshold)
    return np.ptp(rows) * np.ptp(columns) * np.prod(np.broadcast_to(pixel_size, 2))


def grey_values_added(image, threshold, pixel_size):
    return image[image < threshold].sum() * np.prod(np.broadcast_to(pixel_size, 2))


def width_squared(image, threshold, pixel_size):
    return np.count_nonzero(image < threshold) * np.broadcast_to(pixel_size, 2)[0] ** 2


def sizes_squared(image, threshold, pixel_size):
    return np.count_nonzero(image < threshold) * pixel_size**2
