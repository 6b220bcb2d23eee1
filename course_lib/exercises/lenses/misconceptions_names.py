"""Wrong ways of reading a lens's name, as students write them."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Any

from course_lib.judging.comparison import Mismatch

#: Patterns for the focal length (right, and without the space before mm) and for the f-number;
#: group 2 is missing for a single one.
FOCAL = r"([\d.]+)(?:-([\d.]+))?\s*mm"
UNSPACED = r"([\d.]+)(?:-([\d.]+))?mm"
STOPS = r"(?:[fF]/?|1:)([\d.]+)(?:-([\d.]+))?"


def read(name: str, focal: str = FOCAL, stops: str = STOPS) -> Any:
    """Return what two patterns find, as a student's function would; None has no groups."""
    pairs = []
    for pattern in (focal, stops):
        match: Any = re.search(pattern, name)
        texts = [text for text in (match[1], match[2]) if text]
        pairs.append((float(texts[0]), float(texts[-1])))
    return {"focal_length": pairs[0], "f_number": pairs[1]}


#: As the lesson counts: group 1 is the sign of the f-number, 3 a second number with its minus.
COUNTED_FOCAL = r"([\d.]+)(-([\d.]+))?\s*mm"
COUNTED_STOPS = r"(f/|F|f|1:)([\d.]+)(-([\d.]+))?"


def search_both(name: str, stops: str = COUNTED_STOPS) -> tuple[Any, Any]:
    """Return both matches, or refuse a name that lacks one, as the lesson asks."""
    focal, stop = re.search(COUNTED_FOCAL, name), re.search(stops, name)
    if focal is None or stop is None:
        raise ValueError(name)
    return focal, stop


def pairs_of(focal: Any, stop: Any, second_focal: int, first: int, second: int) -> Any:
    """Return what these parts of the two matches tell."""
    return {
        "focal_length": (float(focal[1]), float(focal[second_focal] or focal[1])),
        "f_number": (float(stop[first]), float(stop[second] or stop[first])),
    }


def refuse_what_tells_nothing(name: str) -> None:
    if not (re.search(FOCAL, name) and re.search(STOPS, name)):
        raise ValueError(name)


def first_numbers(name):
    numbers = [float(text) for text in re.findall(r"\d+(?:\.\d+)?", name)]
    taken = 2 if re.search(r"\d-\d[\d.]*\s*mm", name) else 1
    focal, stops = numbers[:taken], numbers[taken:]
    return {"focal_length": (focal[0], focal[-1]), "f_number": (stops[0], stops[-1])}


def whole_numbers(name):
    focal = r"(\d+)(?:\.\d+)?(?:-(\d+)(?:\.\d+)?)?\s*mm"
    stops = r"(?:[fF]/?|1:)(\d+)(?:\.\d+)?(?:-(\d+)(?:\.\d+)?)?"
    return read(name, focal, stops)


def digits_after_the_point(name):
    refuse_what_tells_nothing(name)
    return read(name, focal=r"(\d+)(?:-(\d+))?\s*mm")


def no_space_allowed(name):
    try:
        return read(name, focal=UNSPACED)
    except TypeError:
        raise ValueError(name) from None


def no_space_and_no_check(name):
    return read(name, focal=UNSPACED)


def one_way_of_writing(name):
    return read(name, stops=r"f/([\d.]+)(?:-([\d.]+))?")


def first_of_a_range(name):
    return {key: (first, first) for key, (first, _) in read(name).items()}


def texts_for_numbers(name):
    pairs = read(name)
    return {key: tuple(f"{value:g}" for value in pair) for key, pair in pairs.items()}


def every_lens_a_zoom(name):
    return read(name, focal=r"([\d.]+)-([\d.]+)\s*mm")


def answers_anything(name):
    try:
        return read(name)
    except TypeError:
        return None


def search_may_find_nothing(name):
    return read(name)


def first_of_two_numbers(name):
    return pairs_of(*search_both(name), 3, 2, 2)


def second_number_with_its_minus(name):
    return pairs_of(*search_both(name), 3, 2, 3)


def focal_length_with_its_minus(name):
    return pairs_of(*search_both(name), 2, 2, 4)


def sign_for_a_number(name):
    return pairs_of(*search_both(name), 3, 1, 3)


def sign_for_a_number_and_no_check(name):
    focal, stop = re.search(COUNTED_FOCAL, name), re.search(COUNTED_STOPS, name)
    return pairs_of(focal, stop, 3, 1, 3)


def millimetres_behind_the_f_number(name):
    focal, stop = re.search(COUNTED_FOCAL, name), re.search(COUNTED_STOPS + r"\s*mm", name)
    return pairs_of(focal, stop, 3, 2, 4)


def millimetres_behind_the_f_number_and_a_check(name):
    return pairs_of(*search_both(name, COUNTED_STOPS + r"\s*mm"), 3, 2, 4)


def no_capital_letter(name):
    return pairs_of(*search_both(name, r"(f/|f|1:)([\d.]+)(-([\d.]+))?"), 3, 2, 4)


def one_way_of_writing_and_a_check(name):
    return pairs_of(*search_both(name, r"(f/)([\d.]+)(-([\d.]+))?"), 3, 2, 4)


def no_capital_letter_and_no_check(name):
    return read(name, stops=r"(?:f/?|1:)([\d.]+)(?:-([\d.]+))?")


def no_small_letter(name):
    return pairs_of(*search_both(name, r"(f/|F|1:)([\d.]+)(-([\d.]+))?"), 3, 2, 4)


def any_number(name):
    return pairs_of(*search_both(name, r"()([\d.]+)(-([\d.]+))?"), 3, 2, 4)


def no_capital_letter_and_half_a_check(name):
    if not re.search(COUNTED_FOCAL, name):
        raise ValueError(name)
    return read(name, stops=r"(?:f/?|1:)([\d.]+)(?:-([\d.]+))?")


def two_numbers_each(focal: Any, stop: Any) -> Any:
    return {
        "focal_length": (float(focal[1]), float(focal[3])),
        "f_number": (float(stop[2]), float(stop[4])),
    }


def second_number_taken_for_granted(name):
    return two_numbers_each(*search_both(name))


def second_number_taken_for_granted_and_no_check(name):
    return two_numbers_each(re.search(COUNTED_FOCAL, name), re.search(COUNTED_STOPS, name))


def none_for_the_second_number(name):
    first, second = search_both(name)
    return {
        "focal_length": (float(first[1]), first[3] and float(first[3])),
        "f_number": (float(second[2]), second[4] and float(second[4])),
    }


def signs_without_their_bracket(name):
    return pairs_of(*search_both(name, r"f/|F|f|1:([\d.]+)(-([\d.]+))?"), 3, 1, 3)


def number_without_its_bracket(name):
    return pairs_of(*search_both(name, r"(f/|F|f|1:)[\d.]+(-([\d.]+))?"), 3, 2, 3)


# --- names that tell nothing ------------------------------------------------------------------


@dataclass(frozen=True)
class BothTexts:
    """Two texts instead of a refusal: everyone writes other words."""

    def __call__(self, got: Any, expected: Any) -> Mismatch | None:
        """Return None where both are texts."""
        texts = isinstance(got, str) and isinstance(expected, str)
        return None if texts else Mismatch("type", "This is no text.")


def f_number_taken_for_granted(name):
    if re.search(FOCAL, name) is None:
        raise ValueError(name)
    return read(name)


def focal_length_taken_for_granted(name):
    if re.search(STOPS, name) is None:
        raise ValueError(name)
    return read(name)


def refuses_what_lacks_both(name):
    if re.search(FOCAL, name) is None and re.search(STOPS, name) is None:
        raise ValueError(name)
    return read(name)


def returns_the_error(name):
    try:
        return read(name)
    except TypeError:
        return ValueError(name)


def returns_a_text(name):
    try:
        return read(name)
    except TypeError:
        return "no focal length"
