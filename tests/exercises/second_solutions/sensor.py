import math

import numpy as np


def exposure_value(N, t, iso=100):
    light_of_settings = t * iso / 100 / np.square(N)
    return -np.log(light_of_settings) / math.log(2)


def equivalent_exposure(t, N, N_new, iso=100, iso_new=100):
    stops = 2 * np.log2(np.asarray(N_new) / N) - math.log2(iso_new / iso)
    return t * 2.0**stops


def sensor_response(photons, camera, exposure_time=0.0):
    numbers = []
    for count in photons:
        electrons = count * camera.quantum_efficiency + exposure_time * camera.dark_current
        if electrons > camera.full_well:
            electrons = camera.full_well
        numbers.append(min(camera.offset + electrons * camera.gain, 2**camera.bits - 1))
    return numbers


def signal_to_noise(photons, camera, exposure_time=0.0):
    """In DN instead of electrons."""
    K = camera.gain
    signal = K * camera.quantum_efficiency * photons
    shot = K * signal
    dark = K**2 * camera.dark_current * exposure_time
    readout = (K * camera.read_noise) ** 2
    return signal / (shot + dark + readout + 1 / 12) ** 0.5


def motion_blur_pixels(speed, exposure_time, pixel_size):
    pixels_per_second = speed / pixel_size
    return exposure_time * pixels_per_second


def rolling_shutter_skew(speed, row_time, rows):
    reading = np.asarray(rows) * row_time
    return reading * speed


def stripe_height(shift, light_angle, camera_angle=0.0):
    """Where the two lines meet: x = z tan(light) and shift - x = z tan(camera)."""
    heights = []
    for s in np.atleast_1d(shift):
        lines = np.array([[1, -math.tan(light_angle)], [1, math.tan(camera_angle)]])
        heights.append(np.linalg.solve(lines, [0, s])[1])
    return np.array(heights) if np.ndim(shift) else heights[0]


def camera_gain_from_pairs(first, second, dark_first, dark_second, white):
    """Fit a line with an intercept, which is the variance of the readout, without dark noise."""
    means, variances = [], []
    offset = np.concatenate([dark_first, dark_second]).astype(float).mean()
    for a, b in zip(first.astype(np.int64), second.astype(np.int64), strict=True):
        if max(np.count_nonzero(a == white), np.count_nonzero(b == white)) < a.size / 1000:
            means.append(np.mean([a, b]) - offset)
            variances.append(np.mean((a - b - np.mean(a - b)) ** 2) / 2)
    weights = 1 / np.array(variances)  # a variance is known the worse, the larger it is
    return np.polyfit(means, variances, 1, w=weights)[0]


def clipped_fraction(image, black=0, white=255):
    dark = bright = 0
    rows, columns = image.shape[:2]
    for pixel in image.reshape(rows * columns, -1).tolist():
        dark += min(pixel) <= black
        bright += max(pixel) >= white
    return [dark / (rows * columns), bright / (rows * columns)]


def bayer_mosaic(image, pattern="RGGB"):
    rows, columns = image.shape[:2]
    numbers = np.array(["RGB".index(letter) for letter in pattern]).reshape(2, 2)
    layer = np.tile(numbers, (rows // 2, columns // 2))
    return np.take_along_axis(image, layer[..., None], axis=2)[..., 0]


def demosaic_bilinear(mosaic):
    """Walk from pixel to pixel, and ask the neighbours that exist."""
    rows, columns = mosaic.shape
    image = np.zeros((rows, columns, 3))
    for row, column in np.ndindex(rows, columns):
        nearest = {0: {}, 1: {}, 2: {}}
        for r in range(max(row - 1, 0), min(row + 2, rows)):
            for c in range(max(column - 1, 0), min(column + 2, columns)):
                distance = abs(r - row) + abs(c - column)
                nearest[r % 2 + c % 2].setdefault(distance, []).append(mosaic[r, c])
        for colour, by_distance in nearest.items():
            image[row, column, colour] = np.mean(by_distance[min(by_distance)])
    return image


def flat_field(image, dark, flat):
    light = np.subtract(flat, dark, dtype=float)
    sensitivity = light / np.mean(np.mean(light, axis=0), axis=0)
    return np.subtract(image, dark, dtype=float) / sensitivity


def silhouette_area(image, threshold, pixel_size):
    size = np.ravel(pixel_size)
    area = size[0] * size[-1]
    return sum(area for grey in image.ravel() if grey < threshold)
