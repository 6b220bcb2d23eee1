"""Photographs as people have them: opened, and set aside with a reason if need be."""

from __future__ import annotations

import hashlib
import math
import warnings
from collections import Counter
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from datetime import date
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from course_lib.calibrating.finding import AS_JPEG
from course_lib.detection.result import grey_picture

#: Phones have up to 200 megapixels, for which a verdict takes 0.8 GB; more is no photograph.
MOST_PIXELS = 220_000_000
#: Tag of Exif's part on the exposure; in it, those of the time, the focal length and its 35 mm
#: equivalent.
EXIF_PART, TAKEN, FOCAL_LENGTH, FOCAL_35 = 0x8769, 0x9003, 0x920A, 0xA405
#: Focal lengths that differ by more are of another lens or zoom.
SAME_FOCAL = 0.01
#: How files begin, after four bytes, that iPhones write unless told otherwise.
HEIC = (b"ftypheic", b"ftypheix", b"ftypmif1", b"ftypmsf1", b"ftyphevc")
Picture = NDArray[Any]


class SetAside(Exception):
    """A picture cannot be used; the message is a sentence for its owner."""


@dataclass(frozen=True)
class Header:
    """What a picture's file says before it is read.

    Attributes
    ----------
    path : Path
        The file.
    size : tuple of int
        Width and height as the sensor has them, px: not turned upright.
    focal : float
        Focal length in mm, 0 if the file does not say.
    digest : str
        Fingerprint of the file.
    focal_35 : float
        Focal length that shows the same on 36 mm × 24 mm, mm; 0 if the file does not say.
    taken : date, optional
        The day of the photograph, by the camera's clock.
    """

    path: Path
    size: tuple[int, int]
    focal: float
    digest: str
    focal_35: float = 0.0
    taken: date | None = None

    @property
    def focal_px(self) -> float:
        """The focal length in px that the equivalent promises, by the diagonals; 0 without."""
        return self.focal_35 * math.hypot(*self.size) / math.hypot(36, 24)


def read_header(path: Path) -> Header:
    """Return what a file says of its picture.

    Raises
    ------
    SetAside
        If it is no picture that can be opened.
    """
    with _opened(path) as picture:
        size, told = picture.size, _exif(picture)
    focal, focal_35 = (_length(told.get(tag)) for tag in (FOCAL_LENGTH, FOCAL_35))
    digest = hashlib.sha256(path.read_bytes()).hexdigest()
    return Header(path, size, focal, digest, focal_35, _day(told.get(TAKEN)))


def _exif(picture: Any) -> dict[int, Any]:
    """Return Exif's part on the exposure; nothing where it is broken."""
    try:
        return dict(picture.getexif().get_ifd(EXIF_PART))
    except Exception:  # a broken Exif part breaks readers in many ways; the picture may be fine
        return {}


def _length(told: Any) -> float:
    """Return a focal length, mm; 0 where Exif is silent or makes no sense."""
    try:
        length = float(told)
    except (TypeError, ValueError, ArithmeticError):
        return 0.0
    return length if math.isfinite(length) and length > 0 else 0.0


def _day(told: Any) -> date | None:
    """Return the day of a time as Exif writes it, 2026:03:20 10:01:00."""
    try:
        year, month, day = map(int, str(told)[:10].split(":"))
        return date(year, month, day)
    except ValueError:
        return None


def read_grey(path: Path) -> Picture:
    """Return a picture in grey, as the sensor has it.

    A camera writes down how it was held (Exif's orientation), and programs turn the picture
    upright; for a calibration, all pictures must stay as they were on the sensor.

    Raises
    ------
    SetAside
        If the file is broken.
    """
    with _opened(path) as picture:
        if picture.mode.startswith("I;16"):
            return np.asarray(picture).astype(np.uint16)
        if picture.mode in ("I", "F"):
            values = np.asarray(picture, np.float32)
            return values / max(float(values.max()), 1.0)
        picture.draft("L", picture.size)  # a JPEG file holds grey levels; no colours are made
        return np.asarray(picture.convert("L"))


def read_rgb(path: Path) -> NDArray[np.uint8]:
    """Return a picture in colour, as the sensor has it, like `read_grey`.

    Raises
    ------
    SetAside
        If the file is broken.
    """
    with _opened(path) as picture:
        if not picture.mode.startswith(("I", "F")):
            return np.asarray(picture.convert("RGB"), np.uint8)
    grey = np.rint(grey_picture(read_grey(path))).astype(np.uint8)
    return np.repeat(grey[..., None], 3, axis=2)


@contextmanager
def _opened(path: Path) -> Iterator[Any]:
    """Open a picture; whatever goes wrong becomes a sentence."""
    from PIL import Image, UnidentifiedImageError

    _check_file(path)
    limit, Image.MAX_IMAGE_PIXELS = Image.MAX_IMAGE_PIXELS, None
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            with Image.open(path) as picture:
                pixels = picture.size[0] * picture.size[1]
                if pixels > MOST_PIXELS:
                    raise SetAside(f"{pixels / 1e6:.0f} megapixels are too many: make it smaller")
                yield picture
    except SetAside:
        raise
    except UnidentifiedImageError:
        if path.read_bytes()[4:12] in HEIC:
            raise SetAside(f"a HEIC picture cannot be read here: {AS_JPEG}") from None
        raise SetAside("this is no picture that can be read: save it as JPEG or PNG") from None
    except MemoryError:
        raise SetAside("there is not enough memory for it: make it smaller") from None
    except Exception as error:  # broken files break readers of pictures in many ways
        raise SetAside(f"the file is damaged or cut off ({error}): copy it again") from None
    finally:
        Image.MAX_IMAGE_PIXELS = limit


def _check_file(path: Path) -> None:
    """Raise unless there is something to read."""
    try:
        if path.is_dir():
            raise SetAside("this is a folder")
        if path.stat().st_size == 0:
            raise SetAside("the file is empty (0 bytes): copy it again")
        with path.open("rb"):
            pass
    except FileNotFoundError:
        raise SetAside("there is no such file") from None
    except OSError as error:
        raise SetAside(f"it cannot be read ({error.strerror})") from None


def usual_size(headers: Sequence[Header]) -> tuple[int, int]:
    """Return the size that most pictures have; of equally many, the larger."""
    sizes = Counter(header.size for header in headers)
    return max(sizes, key=lambda size: (sizes[size], size[0] * size[1]))


def why_other_size(size: tuple[int, int], usual: tuple[int, int]) -> str:
    """Return a sentence on a picture whose size is not that of most."""
    told = f"it has {size[0]} × {size[1]} px, most pictures {usual[0]} × {usual[1]}"
    if size == usual[::-1]:
        return f"{told}: a program has turned it. Turn it back to how the camera took it"
    if abs(size[0] / size[1] - usual[0] / usual[1]) < 0.01:
        return f"{told}: it was made smaller or larger. Use the original"
    return f"{told}: it is of another camera, or cropped. Use the original"


def usual_lens(headers: Sequence[Header]) -> Header:
    """Return the header of a picture with the focal length that most pictures have."""
    told = Counter((h.focal, h.focal_35) for h in headers if h.focal or h.focal_35)
    if not told:
        return headers[0]
    usual = told.most_common(1)[0][0]
    return next(h for h in headers if (h.focal, h.focal_35) == usual)


def why_other_lens(header: Header, usual: Header) -> str:
    """Return a sentence on a picture taken with another lens or zoom than most, or nothing."""
    for what, mine, theirs in (
        ("at a focal length of", header.focal, usual.focal),
        ("zoomed, to the view of", header.focal_35, usual.focal_35),
    ):
        if mine and theirs and abs(mine / theirs - 1) > SAME_FOCAL:
            return (
                f"it was taken {what} {mine:.3g} mm, most pictures {theirs:.3g} mm: another lens "
                "or zoom is another camera. Take all with one, and calibrate each by itself"
            )
    return ""
