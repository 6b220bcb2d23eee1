"""Inputs for the exercises of chapter 09: rays, cameras that look at one point, stereo pairs."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.random import Generator
from numpy.typing import NDArray

from course_lib.judging import Known, Raises
from course_lib.transforms import rotation_from_vector

Inputs = dict[str, Any]
Floats = NDArray[np.float64]


def sign(rng: Generator) -> float:
    return float(rng.choice([-1, 1]))


def unit(vector: Floats) -> Floats:
    return np.asarray(vector / np.linalg.norm(vector))


# --- two rays ---------------------------------------------------------------------------------


def rays_that_miss(rng: Generator, stretch1: float, stretch2: float) -> Known:
    """Choose both closest points; the gap between them is perpendicular to both rays."""
    angle = rng.uniform(0.3, 0.9)
    turn = rotation_from_vector(rng.uniform(-0.5, 0.5, 3))
    d1 = turn @ [np.sin(angle), 0, np.cos(angle)]
    d2 = turn @ [-np.sin(angle), 0, np.cos(angle)]
    one = rng.uniform((-1, -1, 2), (1, 1, 4)).round(2)
    other = one + sign(rng) * rng.uniform(0.1, 0.4) * unit(np.cross(d1, d2))
    o1, o2 = one - rng.uniform(1.2, 2) * d1, other - rng.uniform(2.5, 4) * d2
    rays = {"origin1": o1, "direction1": stretch1 * d1, "origin2": o2, "direction2": stretch2 * d2}
    return Known(rays, (one, other))


def unit_rays(rng: Generator) -> Known:
    return rays_that_miss(rng, 1, 1)


def rays_of_any_length(rng: Generator) -> Known:
    return rays_that_miss(rng, rng.uniform(1.5, 3), rng.uniform(0.2, 0.6))


# --- cameras that look at one point -----------------------------------------------------------


def camera_towards(rng: Generator, X: Floats, azimuth: float) -> Floats:
    """Draw the matrix of a camera 3 to 5 m from a point, in a direction given by an angle."""
    back = np.array([np.sin(azimuth), rng.uniform(-0.3, 0.3), -np.cos(azimuth)])
    centre = X + rng.uniform(3, 5) * unit(back)
    z = unit(X - centre + rng.uniform(-0.3, 0.3, 3))
    x = unit(np.cross([0.2, 1, 0.1], z))
    R = np.array([x, np.cross(z, x), z])
    fx = rng.uniform(600, 900)
    fy = fx * rng.uniform(1.03, 1.1)
    K = np.array([[fx, 0, rng.uniform(300, 340)], [0, fy, rng.uniform(220, 260)], [0, 0, 1]])
    return np.asarray(K @ np.column_stack([R, -R @ centre]))


def cameras_around(rng: Generator, count: int) -> tuple[Floats, Floats]:
    """Draw a point, and cameras that see it from a wide arc."""
    X = rng.uniform((0.5, 0.5, 1.5), (1.5, 1.5, 2.5)) * [sign(rng), sign(rng), 1]
    azimuths = np.linspace(-0.7, 0.7, count) + rng.uniform(-0.1, 0.1, count)
    cameras = [camera_towards(rng, X, azimuth) for azimuth in rng.permutation(azimuths)]
    return X, np.array(cameras)


def images(X: Floats, cameras: Floats) -> Floats:
    seen = cameras @ np.append(X, 1)
    return np.asarray(seen[:, :2] / seen[:, 2:])


def misses(rng: Generator, count: int, size: float) -> Floats:
    """Draw noise that is never small: no ray of a pair is right by chance."""
    return np.asarray(rng.uniform(0.5, 1, (count, 2)) * rng.choice([-size, size], (count, 2)))


def pair(rng: Generator, size: float) -> Known:
    """Draw a pair of pixels whose rays miss each other by a noise of opposite sign in v."""
    X, (P1, P2) = cameras_around(rng, 2)
    noise = misses(rng, 1, size)[0]
    pixel1, pixel2 = images(X, np.array([P1, P2])) + np.outer([1, -1], noise)
    return Known({"pixel1": pixel1, "pixel2": pixel2, "P1": P1, "P2": P2}, X)


def rays_meet(rng: Generator) -> Known:
    return pair(rng, 0)


def rays_miss(rng: Generator) -> Inputs:
    return pair(rng, 8).inputs


def views(rng: Generator, count: int, size: float) -> Known:
    X, cameras = cameras_around(rng, count)
    pixels = images(X, cameras) + misses(rng, count, size)
    return Known({"pixels": pixels, "cameras": cameras}, X)


def two_cameras(rng: Generator) -> Known:
    return views(rng, 2, 0)


def five_cameras(rng: Generator) -> Inputs:
    return views(rng, 5, 1).inputs


def guessed(rng: Generator, count: int, size: float) -> Inputs:
    """Draw views, and a guess a quarter of a metre from the point."""
    drawn = views(rng, count, size)
    aside = rng.uniform(0.12, 0.2, 3) * rng.choice([-1, 1], 3)
    return {"point": drawn.truth + aside, **drawn.inputs}


def guess_from_two(rng: Generator) -> Inputs:
    return guessed(rng, 2, 0)


def guess_from_four(rng: Generator) -> Inputs:
    return guessed(rng, 4, 3)


def uncertain(rng: Generator, count: int) -> Inputs:
    """Draw a point in mm, that variances are no tiny numbers, and cameras that see it."""
    X, cameras = cameras_around(rng, count)
    cameras[:, :, 3] *= 1000
    return {"point": 1000 * X, "cameras": cameras, "sigma": round(rng.uniform(0.2, 0.6), 2)}


def uncertain_from_two(rng: Generator) -> Inputs:
    return uncertain(rng, 2)


def uncertain_from_five(rng: Generator) -> Inputs:
    return uncertain(rng, 5)


# --- rectified pairs --------------------------------------------------------------------------


def rectified(rng: Generator, offset: float, sums: Floats) -> Inputs:
    """Draw a pair whose points are so far apart that disparity and offset have given sums."""
    return {
        "disparity": sums - offset,
        "f": round(rng.uniform(700, 1200), 1),
        "baseline": round(rng.uniform(60, 250), 1),
        "offset": offset,
    }


def some_offset(rng: Generator) -> float:
    return float(rng.integers(80, 160)) / 4


def apart(rng: Generator, count: int) -> Floats:
    """Draw sums of disparity and offset, in quarters of a pixel: no rounding is in the way."""
    return rng.integers(340, 720, count) / 4


def same_principal_points(rng: Generator) -> Inputs:
    return rectified(rng, 0.0, apart(rng, 5))


def with_offset(rng: Generator) -> Inputs:
    return rectified(rng, some_offset(rng), apart(rng, 5))


def one_among(rng: Generator, apart_only: float) -> Inputs:
    """Draw a pair with an offset in which one point has a given sum."""
    return rectified(rng, some_offset(rng), rng.permutation([*apart(rng, 4), apart_only]))


def negative_disparity(rng: Generator) -> Inputs:
    """Draw points of which one is so far away that only the offset makes its sum positive."""
    return one_among(rng, rng.integers(12, 40) / 4)


def infinitely_far(rng: Generator) -> Known:
    return Known(one_among(rng, 0), Raises("ValueError"))


def wrong_match(rng: Generator) -> Known:
    return Known(one_among(rng, -rng.integers(8, 40) / 4), Raises("ValueError"))


def stereo_rig(rng: Generator, Z: Any) -> Inputs:
    f, baseline = round(rng.uniform(700, 1200), 1), round(rng.uniform(60, 250), 1)
    return {"Z": Z, "f": f, "baseline": baseline, "sigma": round(rng.uniform(0.2, 0.8), 2)}


def one_depth(rng: Generator) -> Inputs:
    return stereo_rig(rng, round(rng.uniform(1500, 4000), 0))


def many_depths(rng: Generator) -> Inputs:
    return stereo_rig(rng, rng.uniform(800, 6000, 6).round(0))


# --- a ray and a plane ------------------------------------------------------------------------


def rays_and_plane(rng: Generator, towards: Floats, side: float) -> Known:
    """Choose points of a plane, and the rays that lead there, or away where `towards` is -1.

    The camera is on the side to which the normal points, or (-1) on the other one.
    """
    normal = unit(rng.uniform((0.4, 0.3, -0.5), (0.8, 0.6, 0.5))) * rng.uniform(1.5, 3) * sign(rng)
    origin = rng.uniform(0.5, 1.5, 3) * rng.choice([-1, 1], 3)
    foot = origin - side * rng.uniform(1.5, 3) * unit(normal)
    along = rng.uniform(-1, 1, (len(towards), 3))
    points = foot + along - np.outer(along @ unit(normal), unit(normal))
    directions = (points - origin) * (rng.uniform(0.3, 0.8, len(towards)) * towards)[:, None]
    inputs = {
        "origin": origin,
        "directions": directions,
        "plane": np.append(normal, -normal @ foot),
    }
    return Known(inputs, np.where(towards[:, None] > 0, points, np.nan))


def of_both_signs(rng: Generator, towards: Floats, side: float) -> Known:
    """Draw rays that meet a plane in points of which some have negative numbers, and some not."""
    while True:
        drawn = rays_and_plane(rng, towards, side)
        met = drawn.truth[towards > 0]
        if (met < 0).any() and (met > 0).any():
            return drawn


def light_before_the_camera(rng: Generator) -> Known:
    return of_both_signs(rng, np.ones(5), 1)


def some_rays_go_away(rng: Generator) -> Known:
    return of_both_signs(rng, rng.permutation([1.0, 1, 1, -1, -1, 1]), -1)
