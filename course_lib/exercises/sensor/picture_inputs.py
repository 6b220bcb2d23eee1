"""Inputs for the exercises of chapter 04 on pictures: noise, colour, shade, silhouettes."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from course_lib.judging import Known
from course_lib.sensor import SensorModel, expose_with_field

Inputs = dict[str, Any]

# --- camera_gain_from_pairs -------------------------------------------------------------------

PIXELS = (24, 32)
SHARES = np.array([0.08, 0.18, 0.3, 0.42, 0.55])


def pairs(rng: Generator, shares: Any) -> Known:
    """Take pairs of pictures with a camera whose gain we choose.

    The surface is not quite even and the pixels differ: 14 %, the same in both pictures of a pair.
    """
    camera = SensorModel(
        quantum_efficiency=0.6,
        full_well=30_000.0,
        read_noise=float(rng.uniform(15, 18)),  # left in, it makes the slope 8 % too steep
        dark_current=0.0,
        gain=float(np.round(rng.uniform(0.15, 0.45), 3)),
        offset=float(rng.integers(90, 140)),
        bits=10,
    )
    uneven = 1 + 0.14 * standardised(rng, 1)[0]
    levels = np.asarray(shares) * camera.saturation / camera.quantum_efficiency
    photons = np.concatenate([levels[:, None, None] * uneven, np.zeros((1, *PIXELS))])
    noise = standardised(rng, 2 * len(photons)).reshape(2, *photons.shape)
    noise[1] = standardised_difference(*noise)
    first, second = (expose_with_field(photons, camera, field) for field in noise)
    inputs = {
        "first": first[:-1],
        "second": second[:-1],
        "dark_first": first[-1],
        "dark_second": second[-1],
        "white": camera.white,
    }
    return Known(inputs, camera.gain)


def standardised(rng: Generator, count: int) -> NDArray[np.float64]:
    """Draw normal numbers for small pictures, each with the mean 0 and the variance 1."""
    fields = rng.standard_normal((count, *PIXELS))
    fields -= fields.mean(axis=(1, 2), keepdims=True)
    return np.asarray(fields / fields.std(axis=(1, 2), keepdims=True))


def standardised_difference(
    first: NDArray[np.float64], second: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Return `second` less its part along `first`: then the difference has the variance 2."""
    along = (first * second).mean(axis=(1, 2), keepdims=True)
    apart = second - along * first
    return np.asarray(apart / apart.std(axis=(1, 2), keepdims=True))


def pairs_within_range(rng: Generator) -> Known:
    return pairs(rng, SHARES)


def some_pairs_saturated(rng: Generator) -> Known:
    return pairs(rng, [*SHARES[1:], 1.0, 1.6])


# --- clipped_fraction -------------------------------------------------------------------------


def clipped(rng: Generator, image: NDArray[Any], black: int, white: int) -> Known:
    """Drive some pixels to the ends and beyond, in one or more of their colours."""
    image = image.astype(np.uint16 if white > 255 else np.uint8)
    lowest, highest = (0, 255) if white == 255 else (black - 16, white + 800)
    rows, columns, _ = image.shape
    places = rng.permutation(rows * columns)
    counts = rng.choice(np.arange(4, 20), 2, replace=False)
    dark, bright = np.split(places[: counts.sum()], counts[:1])
    flat = image.reshape(rows * columns, -1)
    for chosen, end, beyond in ((dark, black, lowest), (bright, white, highest)):
        for place in chosen:
            many = int(rng.integers(1, flat.shape[1] + 1))
            flat[place, rng.permutation(flat.shape[1])[:many]] = rng.choice([end, beyond])
        flat[chosen[0], 0], flat[chosen[1], 0] = end, beyond
    image = flat.reshape(image.shape) if image.shape[2] == 3 else flat.reshape(rows, columns)
    inputs = {"image": image, "black": black, "white": white}
    return Known(inputs, counts / (rows * columns))


def grey_picture(rng: Generator) -> Known:
    return clipped(rng, rng.integers(5, 250, (9, 14, 1)), 0, 255)


def raw_picture(rng: Generator) -> Known:
    """Draw numbers of 14 bits that are black and white long before their ends."""
    black, white = int(rng.integers(400, 700)), int(rng.integers(14_000, 15_500))
    return clipped(rng, rng.integers(black + 20, white - 20, (9, 14, 1)), black, white)


def colour_picture(rng: Generator) -> Known:
    return clipped(rng, rng.integers(5, 250, (9, 14, 3)), 0, 255)


# --- the mosaic -------------------------------------------------------------------------------


def colours(rng: Generator) -> NDArray[Any]:
    rows, columns = (int(size) for size in 2 * rng.integers(2, 5, 2))
    return rng.integers(1, 255, (rows, columns, 3), dtype=np.uint8)


def filtered(rng: Generator, pattern: str) -> Known:
    """Lay the filters over a picture pixel by pixel."""
    image = colours(rng)
    truth = np.zeros(image.shape[:2])
    for row, column in np.ndindex(truth.shape):
        letter = pattern[2 * (row % 2) + column % 2]
        truth[row, column] = image[row, column, "RGB".index(letter)]
    return Known({"image": image, "pattern": pattern}, truth)


def red_first(rng: Generator) -> Known:
    return filtered(rng, "RGGB")


def blue_first(rng: Generator) -> Known:
    return filtered(rng, "BGGR")


def green_first(rng: Generator) -> Known:
    return filtered(rng, str(rng.choice(["GRBG", "GBRG"])))


def mosaic_of(image: NDArray[Any]) -> NDArray[Any]:
    """Return what RGGB filters leave of a picture."""
    import scipy.ndimage  # noqa: F401 (an answer that uses it should not load it on its own time)

    mosaic = image[..., 1].astype(np.float64)
    mosaic[0::2, 0::2], mosaic[1::2, 1::2] = image[0::2, 0::2, 0], image[1::2, 1::2, 2]
    return mosaic


def one_colour(rng: Generator) -> Known:
    """Draw a wall of one colour: what is guessed must be right to the last pixel."""
    image = np.zeros((6, 8, 3)) + rng.choice(np.arange(10, 250, 15), 3, replace=False)
    return Known({"mosaic": mosaic_of(image)}, image)


def many_colours(rng: Generator) -> Inputs:
    rows, columns = (int(size) for size in rng.choice([4, 6, 8], 2, replace=False))
    return {"mosaic": mosaic_of(rng.integers(1, 255, (rows, columns, 3)))}


# --- flat_field -------------------------------------------------------------------------------


def uneven(rng: Generator, shape: tuple[int, ...]) -> NDArray[np.float64]:
    """Draw a sensitivity for each pixel, bright in the middle; its mean is exactly 1."""
    rows, columns = np.indices(shape[:2])
    middle = np.array(shape[:2]) / 2 + rng.uniform(-1, 1, 2)
    distance = np.hypot(rows - middle[0], columns - middle[1]) / max(shape)
    share = np.cos(distance) ** 4 * rng.uniform(0.9, 1.1, shape[:2])
    share = share if len(shape) == 2 else share[..., None] * rng.uniform(0.8, 1.2, shape)
    return np.asarray(share / share.mean(axis=(0, 1)))


def shaded(rng: Generator, shape: tuple[int, ...]) -> Known:
    """Shade a picture that we know, on top of a dark picture."""
    truth = rng.uniform(20, 200, shape)
    dark, share = rng.uniform(20, 45, shape), uneven(rng, shape)
    white = rng.uniform(150, 220, shape[2:])  # for each colour its own
    inputs = {"image": dark + share * truth, "dark": dark, "flat": dark + share * white}
    return Known(inputs, truth)


def shaded_greys(rng: Generator) -> Known:
    return shaded(rng, (3, 5))


def shaded_colours(rng: Generator) -> Known:
    return shaded(rng, (3, 4, 3))


def raw_numbers(rng: Generator) -> Inputs:
    """Draw unsigned numbers; in the shadows, noise takes some of them below the dark picture."""
    known = shaded(rng, (4, 5)).inputs
    numbers = {name: np.rint(picture * 4).astype(np.uint16) for name, picture in known.items()}
    places = rng.permutation(numbers["image"].size)[:4]
    numbers["image"].flat[places] = numbers["dark"].flat[places] - rng.integers(1, 6, 4)
    return numbers


# --- silhouette_area --------------------------------------------------------------------------


def silhouetted(rng: Generator, pixel_size: Any) -> Known:
    """Put dark pixels before a bright field; some pixels hold the threshold itself."""
    threshold = int(rng.integers(6, 11))
    image = rng.integers(threshold, 16, (6, 9))
    count = int(rng.integers(12, 30))
    places = rng.permutation(image.size)
    image.flat[places[:count]] = rng.integers(0, threshold, count)
    image.flat[places[count : count + 4]] = threshold
    area = count * np.prod(np.broadcast_to(pixel_size, 2))
    inputs = {"image": image.astype(np.uint8), "threshold": threshold, "pixel_size": pixel_size}
    return Known(inputs, float(area))


def square_pixels(rng: Generator) -> Known:
    return silhouetted(rng, float(np.round(rng.uniform(0.05, 0.8), 3)))


def oblong_pixels(rng: Generator) -> Known:
    width = np.round(rng.uniform(0.05, 0.4), 3)
    height = np.round(width * rng.uniform(1.2, 1.8), 3)
    return silhouetted(rng, np.array([width, height]))
