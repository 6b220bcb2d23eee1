"""Files as they come from a phone: photographs of the desk with Exif, and what comes with them.

For tests of what reads photographs, and for readers without a camera. The camera is that of
`data_generators.desk`; make, model, place and time in the files are invented.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Literal, get_args

import numpy as np

from course_lib.camera import Camera
from course_lib.checks import Array, check_count, check_generator
from data_generators import desk
from data_generators.desk import Aim

if TYPE_CHECKING:
    from PIL import Image

What = Literal[
    "good",
    "upside down",
    "portrait",
    "blurred",
    "cut off",
    "no target",
    "turned",
    "small copy",
    "zoomed",
    "HEIC",
    "letter",
]
#: What is not a good photograph, each once.
TROUBLES: tuple[What, ...] = get_args(What)[1:]
MAKE, MODEL, DATE = "Camera course", "Desk phone", "2026:03:20 10:{:02}:00"
#: Of the lens: mm on the sensor, and what shows the same on 36 mm × 24 mm, in whole mm as in Exif.
FOCAL_MM, FOCAL_35 = 4.15, 25
#: Exif's numbers for pictures that are upright, upside down, and to be turned to the right.
UPRIGHT, UPSIDE_DOWN, TO_THE_RIGHT = 1, 3, 6
#: Numbers of Exif's tags.
TAGS = {"make": 0x010F, "model": 0x0110, "orientation": 0x0112}
DETAILS = {"date": 0x9003, "focal": 0x920A, "focal_35": 0xA405}
EXIF_PART, PLACE_PART = 0x8769, 0x8825
#: Blur of a blurred picture, and of every picture, by the width.
BLURRED, SOFT = 0.006, 0.0007
#: How a phone is held: tilt, distance (mm), turn about the axis, each from to.
TILTS, DISTANCES, ROLLS = (12.0, 40.0), (290.0, 400.0), (-8.0, 8.0)
#: The target comes into these parts of the picture in turn, by its size.
PARTS = [(u, v) for v in (0.5, 0.36, 0.64) for u in (0.5, 0.36, 0.64)]
RIM, TRIES = 0.02, 150
NOISE, QUALITY = 3.0, 90  # grey levels; of the JPEG
#: So the phone is held when the target is cut off, or beside what is seen.
CUT_OFF: Aim = ((-70, 62), 25, 0, 300, 0)
NO_TARGET: Aim = ((700, -300), 20, 0, 420, 0)


@dataclass(frozen=True, eq=False)
class PhoneFile:
    """A file from a phone.

    Attributes
    ----------
    path : Path
        The file.
    what : str
        ``"good"``, or one of `TROUBLES`. Those that are upside down or in portrait are good for
        measuring, as long as nobody turns them.
    camera : Camera, optional
        The truth, for pictures as the sensor had them: its world is the frame of the target.
    """

    path: Path
    what: What
    camera: Camera | None = None


def write_phone_files(
    folder: Path,
    rng: np.random.Generator,
    good: int = 10,
    troubles: Sequence[What] = TROUBLES,
    image_size: tuple[int, int] = (1200, 900),
) -> list[PhoneFile]:
    """Write photographs of the desk, and other files that people drop in with them.

    Parameters
    ----------
    folder : Path
        Where to; it is made if need be.
    rng : numpy.random.Generator
        Decides on poses and noise.
    good : int
        How many photographs there are with nothing special about them.
    troubles : sequence of str
        What comes with them, of `TROUBLES`.
    image_size : tuple of int
        Width and height as the sensor has them, px.

    Returns
    -------
    list of PhoneFile
        In the order of their names. The same arguments (and the same state of `rng`) give the
        same files.

    Raises
    ------
    TypeError, ValueError
        If a trouble is none of these, or there are not so many photographs.
    """
    unknown = sorted(set(troubles) - set(TROUBLES))
    if unknown:
        raise ValueError(f"troubles must be some of {', '.join(TROUBLES)}, got {unknown[0]!r}")
    check_generator(rng)
    folder.mkdir(parents=True, exist_ok=True)
    whats: list[What] = ["good"] * check_count(good, "good", 0)
    return [
        _written(folder, number, what, image_size, rng)
        for number, what in enumerate([*whats, *troubles], 1)
    ]


def _written(
    folder: Path, number: int, what: What, size: tuple[int, int], rng: np.random.Generator
) -> PhoneFile:
    """Write one file."""
    path = folder / f"IMG_{number:04}.{'HEIC' if what == 'HEIC' else 'JPG'}"
    if what == "HEIC":  # its first bytes; the rest stands for a picture that cannot be read
        path.write_bytes(b"\0\0\0\x24ftypheic\0\0\0\0mif1heic" + rng.bytes(4000))
        return PhoneFile(path, what)
    if what == "letter":
        path.write_text("Dear reader, this was called a picture by mistake.", encoding="utf-8")
        return PhoneFile(path, what)
    aim = _aim(number, what, size, rng)
    blur = size[0] * (BLURRED if what == "blurred" else SOFT)
    exif = b"" if what == "small copy" else _exif(what, number)
    change = CHANGES.get(what)
    camera = write_photograph(path, aim, size, rng, blur, NOISE, exif=exif, change=change)
    return PhoneFile(path, what, camera if change is None else None)


def write_photograph(
    path: Path,
    aim: Aim,
    image_size: tuple[int, int],
    rng: np.random.Generator,
    blur: float,
    noise: float,
    *,
    quality: int = QUALITY,
    exif: Image.Exif | bytes = b"",
    change: Callable[[Image.Image], Image.Image] | None = None,
) -> Camera:
    """Photograph the desk, and write the picture as a JPEG.

    Parameters
    ----------
    path : Path
        The file.
    aim : tuple
        How the phone is held: arguments of `data_generators.desk.pose_towards`.
    image_size : tuple of int
        Width and height as the sensor has them, px.
    rng : numpy.random.Generator
        For the noise.
    blur, noise : float
        Standard deviations: of the blur, px, and of a pixel, grey levels.
    quality : int
        Of the JPEG.
    exif : PIL.Image.Exif or bytes
        What else is in the file; nothing unless given.
    change : callable, optional
        What a program makes of the picture before it is written.

    Returns
    -------
    Camera
        The truth about the picture as it was taken; its world is the frame of the target.
    """
    from PIL import Image

    view = desk.photograph_desk(*desk.pose_towards(*aim), image_size, rng, blur, noise)
    picture = Image.fromarray(view.picture)
    picture = picture if change is None else change(picture)
    picture.save(path, format="JPEG", quality=quality, exif=exif)
    return view.camera


def _aim(number: int, what: What, size: tuple[int, int], rng: np.random.Generator) -> Aim:
    """Return how the phone is held."""
    if what in ("cut off", "no target"):
        return CUT_OFF if what == "cut off" else NO_TARGET
    turn = {"upside down": 180.0, "portrait": 90.0}.get(what, 0.0)
    wanted = np.array(PARTS[number % len(PARTS)]) * size
    points = desk.TARGET.points()
    best, least = None, np.inf
    for _ in range(TRIES):
        middle = points.mean(axis=0)[:2] + rng.uniform(-110, 110, 2)
        tilt, distance, roll = (rng.uniform(*range_) for range_ in (TILTS, DISTANCES, ROLLS))
        aim = ((middle[0], middle[1]), tilt, rng.uniform(0, 360), distance, roll + turn)
        seen = Camera(desk.intrinsics(size), *desk.pose_towards(*aim), size).project(points)
        apart = float(np.linalg.norm(seen.mean(axis=0) - wanted))
        if apart < least and _inside(seen, size):
            best, least = aim, apart
    if best is None:
        raise ValueError(f"the target never came wholly into a picture of {size[0]} × {size[1]} px")
    return best


def _inside(pixels: Array, size: tuple[int, int]) -> bool:
    """Return whether a target with these corners is in the picture, its outer squares too."""
    rim = RIM * size[0] + np.ptp(pixels, axis=0) / 8
    return bool(((pixels > rim) & (pixels < np.array(size) - 1 - rim)).all())


def _turned(picture: Image.Image) -> Image.Image:
    return picture.rotate(90, expand=True)


def _smaller(picture: Image.Image) -> Image.Image:
    return picture.resize((picture.width // 2, picture.height // 2))


def _zoomed(picture: Image.Image) -> Image.Image:
    """Return the middle of a picture, as large as the whole."""
    width, height = picture.size
    middle = (width // 4, height // 4, width - width // 4, height - height // 4)
    return picture.resize(picture.size, box=middle)


#: What a program makes of a picture: it is no longer as the sensor had it.
CHANGES = {"turned": _turned, "small copy": _smaller, "zoomed": _zoomed}


def _exif(what: What, number: int) -> Image.Exif:
    """Return what the phone writes into a file."""
    from PIL import Image

    exif = Image.Exif()
    held = {"upside down": UPSIDE_DOWN, "portrait": TO_THE_RIGHT}.get(what, UPRIGHT)
    for name, value in {"make": MAKE, "model": MODEL, "orientation": held}.items():
        exif[TAGS[name]] = value
    details = exif.get_ifd(EXIF_PART)
    details[DETAILS["date"]] = DATE.format(number)
    details[DETAILS["focal"]] = FOCAL_MM
    details[DETAILS["focal_35"]] = 2 * FOCAL_35 if what == "zoomed" else FOCAL_35
    place = exif.get_ifd(PLACE_PART)  # latitude and longitude 0: in the sea
    place.update({1: "N", 2: (0.0, 0.0, 0.0), 3: "E", 4: (0.0, 0.0, 0.0)})
    return exif
