"""Read what is engraved on a lens: focal lengths and widest apertures.

Use this function through `course_lib.optics`.
"""

from __future__ import annotations

import re


def parse_lens_name(name: str) -> dict[str, tuple[float, float]]:
    """Return the focal lengths and the f-numbers that a lens's name tells.

    A name that lacks one of the two raises a `ValueError`.

    Parameters
    ----------
    name : str
        What is printed on the lens, with any other words: focal length in mm, and the smallest
        f-number after ``f/``, ``F``, ``f`` or ``1:``. A range such as 18-140 belongs to a zoom.

    Returns
    -------
    dict
        ``"focal_length"``: shortest and longest focal length in mm, equal for a prime lens;
        ``"f_number"``: smallest f-number at the shortest and at the longest focal length.

    Raises
    ------
    TypeError, ValueError
        If the name is not a text, or tells no focal length or no f-number.

    References
    ----------
    ISO 517, Photography: apertures and related properties of photographic lenses.

    Examples
    --------
    >>> parse_lens_name("AF-S NIKKOR 18-140mm 1:3.5-5.6 G ED VR")
    {'focal_length': (18.0, 140.0), 'f_number': (3.5, 5.6)}
    """
    if not isinstance(name, str):
        raise TypeError(f"name must be a text, got {name!r:.60}")
    number = r"([0-9]+(?:[.,][0-9]+)?)"
    one_or_two = rf"{number}(?:\s*[-–—]\s*{number})?"
    focal = re.search(rf"{one_or_two}\s*mm\b", name, re.IGNORECASE)
    rest = name.replace(focal[0], " ", 1) if focal else name
    # A macro lens may print its magnification as 1:1, so f/ comes first.
    aperture = re.search(rf"(?:\bf|ƒ)\s*/?\s*{one_or_two}", rest, re.IGNORECASE)
    aperture = aperture or re.search(rf"\b1\s*:\s*{one_or_two}", rest)
    if not focal or not aperture:
        missing = "f-number" if focal else "focal length"
        raise ValueError(f'no {missing} in {name!r:.60}; a lens name reads like "50mm f/1.8"')
    found = {}
    for key, match in (("focal_length", focal), ("f_number", aperture)):
        first, last = (float(text.replace(",", ".")) for text in (match[1], match[2] or match[1]))
        if not 0 < first <= last < float("inf"):
            raise ValueError(f"the {key} in {name!r:.60} runs from {first:g} to {last:g}")
        found[key] = (first, last)
    return found
