"""Wrong answers to the exercise of chapter 11 on what a pixel covers of a surface."""

from __future__ import annotations

from typing import Any

import numpy as np


def on_the_object(Z: Any, f_mm: Any, pitch_um: Any) -> Any:
    return Z * pitch_um * 1e-3 / f_mm


def millimetres(Z, f_mm, pitch_um, tilt):
    finest = 1e3 * on_the_object(Z, f_mm, pitch_um)
    return finest, finest / np.cos(tilt)


def micrometres(Z, f_mm, pitch_um, tilt):
    finest = 1e6 * on_the_object(Z, f_mm, pitch_um)
    return finest, finest / np.cos(tilt)


def focal_length_in_mm(Z, f_mm, pitch_um, tilt):
    finest = 1e-3 * on_the_object(Z, f_mm, pitch_um)
    return finest, finest / np.cos(tilt)


def brackets_left_out(Z, f_mm, pitch_um, tilt):
    finest = 1e-6 * on_the_object(Z, f_mm, pitch_um)
    return finest, finest / np.cos(tilt)


def pitch_upside_down(Z, f_mm, pitch_um, tilt):
    finest = Z * f_mm * 1e-3 / (pitch_um * 1e-6)
    return finest, finest / np.cos(tilt)


def pixels_per_metre(Z, f_mm, pitch_um, tilt):
    most = 1 / on_the_object(Z, f_mm, pitch_um)
    return most, most * np.cos(tilt)


def pixels_per_metre_tilted(Z, f_mm, pitch_um, tilt):
    most = 1 / on_the_object(Z, f_mm, pitch_um)
    return most, most / np.cos(tilt)


def distance_below(Z, f_mm, pitch_um, tilt):
    finest = f_mm * pitch_um * 1e-9 / Z
    return finest, finest / np.cos(tilt)


def distance_left_out(Z, f_mm, pitch_um, tilt):
    finest = pitch_um * 1e-3 / f_mm
    return finest, finest / np.cos(tilt)


def lens_left_out(Z, f_mm, pitch_um, tilt):
    finest = Z * pitch_um * 1e-6
    return finest, finest / np.cos(tilt)


def tilt_forgotten(Z, f_mm, pitch_um, tilt):
    finest = on_the_object(Z, f_mm, pitch_um)
    return finest, finest


def times_the_cosine(Z, f_mm, pitch_um, tilt):
    finest = on_the_object(Z, f_mm, pitch_um)
    return finest, finest * np.cos(tilt)


def coarsest_first(Z, f_mm, pitch_um, tilt):
    finest = on_the_object(Z, f_mm, pitch_um)
    return finest / np.cos(tilt), finest


def finer_by_a_tilt(Z, f_mm, pitch_um, tilt):
    finest = on_the_object(Z, f_mm, pitch_um)
    return finest * np.cos(tilt), finest


def both_tilted(Z, f_mm, pitch_um, tilt):
    coarsest = on_the_object(Z, f_mm, pitch_um) / np.cos(tilt)
    return coarsest, coarsest


def sine_for_cosine(Z, f_mm, pitch_um, tilt):
    finest = on_the_object(Z, f_mm, pitch_um)
    return finest, finest / np.sin(tilt)


def tangent_for_cosine(Z, f_mm, pitch_um, tilt):
    finest = on_the_object(Z, f_mm, pitch_um)
    return finest, finest / np.tan(tilt)


def radians_of_radians(Z, f_mm, pitch_um, tilt):
    finest = on_the_object(Z, f_mm, pitch_um)
    return finest, finest / np.cos(np.radians(tilt))


def degrees_of_radians(Z, f_mm, pitch_um, tilt):
    finest = on_the_object(Z, f_mm, pitch_um)
    return finest, finest / np.cos(np.degrees(tilt))


def cosine_twice(Z, f_mm, pitch_um, tilt):
    finest = on_the_object(Z, f_mm, pitch_um)
    return finest, finest / np.cos(tilt) ** 2


def one_number_only(Z, f_mm, pitch_um, tilt):
    return on_the_object(Z, f_mm, pitch_um) / np.cos(tilt)


def finest_only(Z, f_mm, pitch_um, tilt):
    return on_the_object(Z, f_mm, pitch_um)
