"""Read what is engraved on a lens: focal lengths and widest apertures.

Use this function through `course_lib.optics`.
"""

from __future__ import annotations

import re

NUMBER = r"(\d+(?:[.,]\d+)?)"
TO = r"(?:\s*[-–—]\s*"  # a range; makers write hyphens and dashes
FOCAL = re.compile(rf"{NUMBER}{TO}{NUMBER})?\s*mm\b", re.IGNORECASE)
#: "f/1.8", "F1.8", "ƒ/1.8"; and "1:1.8", which a macro lens may also print for its magnification.
APERTURES = (
    re.compile(rf"(?:\bf|ƒ)\s*/?\s*{NUMBER}{TO}{NUMBER})?", re.IGNORECASE),
    re.compile(rf"\b1\s*:\s*{NUMBER}{TO}{NUMBER})?"),
)


def parse_lens_name(name: str) -> dict[str, tuple[float, float]]:
    """Return the focal lengths and the f-numbers that a lens's name tells.

    Parameters
    ----------
    name : str
        What is printed on the lens: focal length in mm, and the smallest f-number after ``f/``,
        ``F``, ``f`` or ``1:``. A range stands for a zoom. There may be any other words.

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
    focal = FOCAL.search(name)
    rest = name.replace(focal[0], " ", 1) if focal else name
    aperture = next((found for way in APERTURES if (found := way.search(rest))), None)
    if not focal or not aperture:
        missing = "f-number" if focal else "focal length"
        raise ValueError(f'no {missing} in {name!r:.60}; a lens name reads like "50mm f/1.8"')
    pairs = {"focal_length": focal, "f_number": aperture}
    return {key: (_number(found[1]), _number(found[2] or found[1])) for key, found in pairs.items()}


def _number(text: str) -> float:
    return float(text.replace(",", "."))
