"""Wrong answers to the exercises of chapter 03 on imaging, as students write them."""

from __future__ import annotations

import re
from typing import Any

import numpy as np

# --- image_distance ---------------------------------------------------------------------------


def powers_added(f, Z):
    return 1 / (1 / f + 1 / Z)


def not_inverted_back(f, Z):
    return 1 / f - 1 / Z


def in_front_of_the_lens(f, Z):
    return 1 / (1 / Z - 1 / f)


def always_at_the_focal_point(f, Z):
    return f + 0 / Z


def from_the_focal_point(f, Z):
    return f**2 / (Z - f)


def nothing_at_infinity(f, Z):
    return f * Z / (Z - f)


# --- object_distance --------------------------------------------------------------------------


def image_side(f, m):
    return f * (1 + m)


def one_forgotten(f, m):
    return f / m


def virtual_image(f, m):
    return f * (1 / m - 1)


def object_to_sensor(f, m):
    return f * (2 + m + 1 / m)


def magnification_alone(f, m):
    return f * m


# --- f_number ---------------------------------------------------------------------------------


def f_number_inverted(f, d):
    return d / f


def radius_for_diameter(f, d):
    return f / (d / 2)


def ratio_squared(f, d):
    return (f / d) ** 2


def rounded_to_a_full_stop(f, d):
    return np.sqrt(2) ** np.round(2 * np.log2(f / d))


# --- lens_system ------------------------------------------------------------------------------


def bend(f: float) -> Any:
    return np.array([[1, 0], [-1 / f, 1]])


def go(d: float) -> Any:
    return np.array([[1, d], [0, 1]])


def read_off(system: Any) -> Any:
    (A, _), (C, D) = system
    return -1 / C, (D - 1) / C, (1 - A) / C


def light_from_behind(f1, f2, d):
    return read_off(bend(f1) @ go(d) @ bend(f2))


def gap_in_the_wrong_place(f1, f2, d):
    return read_off(go(d) @ bend(f2) @ bend(f1))


def element_by_element(f1, f2, d):
    return read_off(bend(f2) * go(d) * bend(f1))


def lenses_touching(f1, f2, d):
    return 1 / (1 / f1 + 1 / f2), 0.0, 0.0


def sign_of_the_power(f1, f2, d):
    f, front, back = read_off(bend(f2) @ go(d) @ bend(f1))
    return -f, front, back


def focal_points_for_planes(f1, f2, d):
    (A, _), (C, D) = bend(f2) @ go(d) @ bend(f1)
    return -1 / C, D / C, -A / C


def planes_exchanged(f1, f2, d):
    f, front, back = read_off(bend(f2) @ go(d) @ bend(f1))
    return f, back, front


# --- parse_lens_name --------------------------------------------------------------------------


def pair_of(texts: list[str]) -> Any:
    return float(texts[0]), float(texts[-1])


def found(pattern: str, name: str) -> Any:
    return re.search(pattern, name)


def first_numbers(name):
    numbers = re.findall(r"\d+(?:\.\d+)?", name)
    zoom = found(r"\d-\d[\d.]*\s*mm", name)
    taken = 2 if zoom else 1
    return {"focal_length": pair_of(numbers[:taken]), "f_number": pair_of(numbers[taken:])}


def whole_numbers(name):
    focal = found(r"(\d+)(?:\.\d+)?(?:-(\d+)(?:\.\d+)?)?\s*mm", name)
    stops = found(r"(?:[fF]/?|1:)(\d+)(?:\.\d+)?(?:-(\d+)(?:\.\d+)?)?", name)
    return {
        "focal_length": pair_of([text for text in focal.groups() if text]),
        "f_number": pair_of([text for text in stops.groups() if text]),
    }


def one_way_of_writing(name):
    focal = found(r"([\d.]+)(?:-([\d.]+))?\s*mm", name)
    stops = found(r"f/([\d.]+)(?:-([\d.]+))?", name)
    return {
        "focal_length": pair_of([text for text in focal.groups() if text]),
        "f_number": pair_of([text for text in stops.groups() if text]),
    }


def first_of_a_range(name):
    focal = found(r"([\d.]+)(?:-[\d.]+)?\s*mm", name)[1]
    stop = found(r"(?:[fF]/?|1:)([\d.]+)", name)[1]
    return {"focal_length": pair_of([focal]), "f_number": pair_of([stop])}


def texts_for_numbers(name):
    focal = found(r"([\d.]+)(?:-([\d.]+))?\s*mm", name)
    stops = found(r"(?:[fF]/?|1:)([\d.]+)(?:-([\d.]+))?", name)
    return {
        "focal_length": (focal[1], focal[2] or focal[1]),
        "f_number": (stops[1], stops[2] or stops[1]),
    }


def every_lens_a_zoom(name):
    focal = found(r"([\d.]+)-([\d.]+)\s*mm", name)
    stops = found(r"(?:[fF]/?|1:)([\d.]+)(?:-([\d.]+))?", name)
    return {
        "focal_length": (float(focal[1]), float(focal[2])),
        "f_number": pair_of([text for text in stops.groups() if text]),
    }


def answers_anything(name):
    focal = found(r"([\d.]+)(?:-([\d.]+))?\s*mm", name)
    stops = found(r"(?:[fF]/?|1:)([\d.]+)(?:-([\d.]+))?", name)
    if not focal or not stops:
        return None
    return {
        "focal_length": pair_of([text for text in focal.groups() if text]),
        "f_number": pair_of([text for text in stops.groups() if text]),
    }
