"""Inputs for the exercise of chapter 03 on the names of lenses."""

from __future__ import annotations

from typing import Any

from numpy.random import Generator

from course_lib.judging import Known, Raises

MAKERS = ("AF-S NIKKOR", "EF", "Nikkor", "FE", "XF", "Sonnar T*", "Lumix G X", "Fujinon", "SP")
ENDINGS = ("", " ED VR", " G", " STM", " Macro", " IS II USM", " DC DN", " Di III")
WIDE, LONG = (14, 16, 18, 24, 28), (55, 70, 85, 105, 140, 200, 300)
BETWEEN = (10.5, 12.5, 17.5)  # mm: focal lengths with a point
FAST, SLOW = (2.8, 3.5, 4.0), (4.5, 5.6, 6.3)
PRIMES, PRIME_STOPS = (8, 35, 50, 85, 100, 400), (1.2, 1.4, 1.8, 2.8, 4.5)


def number(value: float) -> str:
    return f"{value:g}"


def named(rng: Generator, focal: tuple[Any, ...], stops: tuple[Any, ...], style: str) -> Known:
    """Write a lens's name in a style, ``{f}`` for the focal length and ``{N}`` for the f-number."""
    texts = {
        "f": "-".join(map(number, dict.fromkeys(focal))),
        "N": "-".join(map(number, dict.fromkeys(stops))),
    }
    words = {"maker": str(rng.choice(MAKERS)), "end": str(rng.choice(ENDINGS))}
    truth = {
        "focal_length": tuple(map(float, focal)),
        "f_number": tuple(map(float, stops)),
    }
    return Known({"name": style.format(**texts, **words)}, truth)


def one_focal_length(rng: Generator, style: str) -> Known:
    f, N = rng.choice(PRIMES), rng.choice(PRIME_STOPS)
    return named(rng, (f, f), (N, N), style)


def prime(rng: Generator) -> Known:
    return one_focal_length(rng, "{maker} {f}mm f/{N}{end}")


def zoom(rng: Generator) -> Known:
    focal, stops = (rng.choice(WIDE), rng.choice(LONG)), (rng.choice(FAST), rng.choice(SLOW))
    return named(rng, focal, stops, "{maker} {f}mm f/{N}{end}")


def zoom_of_one_aperture(rng: Generator) -> Known:
    focal, N = (rng.choice(WIDE), rng.choice(LONG)), rng.choice((2.8, 4.5))
    return named(rng, focal, (N, N), "{maker} {f}mm f/{N}{end}")


def with_a_point(rng: Generator) -> Known:
    """Write a focal length with a decimal."""
    focal, N = (rng.choice(BETWEEN), rng.choice(LONG)), rng.choice(PRIME_STOPS)
    return named(rng, focal, (N, N), "{maker} {f}mm f/{N}{end}")


def ratio_notation(rng: Generator) -> Known:
    """Write the f-number as a ratio, after a mount whose name has numbers, too."""
    focal, stops = (rng.choice(WIDE), rng.choice(LONG)), (rng.choice(FAST), rng.choice(SLOW))
    return named(rng, focal, stops, "Zuiko 4/3 {f}mm 1:{N}{end}")


def capital_letter(rng: Generator) -> Known:
    return one_focal_length(rng, "{maker} {f}mm F{N}{end}")


def small_letter(rng: Generator) -> Known:
    return one_focal_length(rng, "{maker} {f}mm f{N}{end}")


def space_before_mm(rng: Generator) -> Known:
    return one_focal_length(rng, "{maker} {f} mm f/{N}{end}")


def parts_of_a_name(rng: Generator) -> tuple[str, str, str]:
    """Return what stands before a focal length, the focal length, and what stands behind it."""
    before, _, behind = prime(rng).inputs["name"].partition("mm")
    maker, _, focal = before.rpartition(" ")
    return maker, focal, behind


def refused(name: str) -> Known:
    return Known({"name": name}, Raises("ValueError"))


def no_focal_length(rng: Generator) -> Known:
    maker, _, behind = parts_of_a_name(rng)
    return refused(maker + behind)


def no_f_number(rng: Generator) -> Known:
    maker, focal, _ = parts_of_a_name(rng)
    return refused(f"{maker} {focal}mm")


def neither(rng: Generator) -> Known:
    maker, focal, _ = parts_of_a_name(rng)
    return refused(f"a box for {maker} {focal} lenses")
