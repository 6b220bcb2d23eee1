"""The catalogue of cameras and lenses: published figures, to which a reader adds a line.

Use these functions through `course_lib.planning`.
"""

from __future__ import annotations

import csv
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from course_lib.camera import first_guess_intrinsics
from course_lib.checks import Array, check_length, check_size

HERE = Path(__file__).parent


@dataclass(frozen=True)
class CameraModel:
    """A camera as its maker describes it.

    Attributes
    ----------
    name : str
        Its name.
    image_size : tuple of int
        Width and height, px.
    pitch_um : float
        Pixel pitch, µm.
    frame_rate : float
        Most pictures a second at this size, 1/s.
    shutter : str
        ``"global"`` or ``"rolling"``.
    mount : str
        What its lens is fixed with; a lens fits only on the same.
    source : str
        Where the figures are published, and which of them could not be confirmed.
    """

    name: str
    image_size: tuple[int, int]
    pitch_um: float
    frame_rate: float
    shutter: str
    mount: str
    source: str

    def __post_init__(self) -> None:
        width, height = check_size(self.image_size, "image_size")
        object.__setattr__(self, "image_size", (int(width), int(height)))
        for name in ("pitch_um", "frame_rate"):
            object.__setattr__(self, name, check_length(getattr(self, name), name))
        if self.shutter not in ("global", "rolling"):
            raise ValueError(f"shutter must be global or rolling, got {self.shutter!r}")

    @property
    def sensor_size(self) -> tuple[float, float]:
        """Width and height of the sensor, mm."""
        width, height = self.image_size
        return width * self.pitch_um / 1000, height * self.pitch_um / 1000

    def intrinsics(self, lens: LensModel) -> Array:
        """Return the first guess of K with a lens, focused on infinity, shape (3, 3), px."""
        return first_guess_intrinsics(lens.f_mm, self.sensor_size, self.image_size)


@dataclass(frozen=True)
class LensModel:
    """A lens as its maker describes it.

    Attributes
    ----------
    name : str
        Its name.
    f_mm : float
        Focal length, mm.
    N_least, N_most : float
        Range of its f-numbers.
    closest : float
        Shortest distance that it can be focused on, m. Makers of photographic lenses count it from
        the sensor, others from the front of the lens; here it is compared with the distance from
        the lens.
    image_circle_mm : float
        Diameter of the circle that it draws; where its maker names a format only, that format's
        diagonal (2/3 inch: 11 mm; 24 x 36 mm: 43.3 mm). Focused near, it draws a larger one.
    mount : str
        What it is fixed with.
    source : str
        Where the figures are published, and which of them could not be confirmed.
    """

    name: str
    f_mm: float
    N_least: float
    N_most: float
    closest: float
    image_circle_mm: float
    mount: str
    source: str

    def __post_init__(self) -> None:
        for name in ("f_mm", "N_least", "N_most", "closest", "image_circle_mm"):
            object.__setattr__(self, name, check_length(getattr(self, name), name))
        if self.N_least > self.N_most:
            got = f"got {self.N_least} and {self.N_most}"
            raise ValueError(f"N_least must not be above N_most, {got}: exchange them")


def read_cameras(path: str | Path = HERE / "cameras.tsv") -> dict[str, CameraModel]:
    """Return the cameras of a catalogue by name.

    Parameters
    ----------
    path : str or Path
        A table with tabs: name, width, height (px), pitch_um, frame_rate (1/s), shutter, mount,
        source. The course's own unless given.

    Returns
    -------
    dict of str to CameraModel
        In the order of the table.

    Raises
    ------
    ValueError
        If a column is missing or a value cannot be read; names the line.
    FileNotFoundError
        If there is no such table.
    """
    return {c.name: c for c in _rows(path, _camera)}


def read_lenses(path: str | Path = HERE / "lenses.tsv") -> dict[str, LensModel]:
    """Return the lenses of a catalogue by name.

    Parameters
    ----------
    path : str or Path
        A table with tabs: name, f_mm, N_least, N_most, closest (m), image_circle_mm, mount,
        source. The course's own unless given.

    Returns
    -------
    dict of str to LensModel
        In the order of the table.

    Raises
    ------
    ValueError
        If a column is missing or a value cannot be read; names the line.
    FileNotFoundError
        If there is no such table.
    """
    return {lens.name: lens for lens in _rows(path, _lens)}


def own_cameras(given: object) -> dict[str, CameraModel]:
    """Return a reader's own cameras by name.

    Parameters
    ----------
    given : CameraModel, iterable of CameraModel, mapping to CameraModel, str or Path
        A camera, several of them, what `read_cameras` returned, or a table for it to read.

    Raises
    ------
    TypeError, ValueError
        If it is none of these, or the table cannot be read.
    FileNotFoundError
        If there is no such table.
    """
    table = read_cameras(given) if isinstance(given, str | Path) else given
    return {c.name: c for c in _all_of(table, CameraModel, "cameras")}


def own_lenses(given: object) -> dict[str, LensModel]:
    """Return a reader's own lenses by name.

    Parameters
    ----------
    given : LensModel, iterable of LensModel, mapping to LensModel, str or Path
        A lens, several of them, what `read_lenses` returned, or a table for it to read.

    Raises
    ------
    TypeError, ValueError
        If it is none of these, or the table cannot be read.
    FileNotFoundError
        If there is no such table.
    """
    table = read_lenses(given) if isinstance(given, str | Path) else given
    return {lens.name: lens for lens in _all_of(table, LensModel, "lenses")}


def _all_of(given: object, kind: type, name: str) -> list[Any]:
    """Return one thing or several of a kind as a list."""
    if isinstance(given, kind):
        return [given]
    several = given.values() if isinstance(given, Mapping) else given
    found = list(several) if isinstance(several, Iterable) else [given]
    for one in found:
        if not isinstance(one, kind):
            raise TypeError(
                f"{name} must be of {kind.__name__} or a table's file name, "
                f"got {type(one).__name__}: write planning.{kind.__name__}(...)"
            )
    return found


def _camera(row: dict[str, str]) -> CameraModel:
    size = int(row["width"]), int(row["height"])
    numbers = float(row["pitch_um"]), float(row["frame_rate"])
    return CameraModel(row["name"], size, *numbers, row["shutter"], row["mount"], row["source"])


def _lens(row: dict[str, str]) -> LensModel:
    names = ("f_mm", "N_least", "N_most", "closest", "image_circle_mm")
    numbers = {name: float(row[name]) for name in names}
    return LensModel(name=row["name"], mount=row["mount"], source=row["source"], **numbers)


def _rows(path: str | Path, read: Any) -> list[Any]:
    """Return a table's lines, each made into what it describes."""
    found = []
    if not Path(path).is_file():
        raise FileNotFoundError(f"there is no table {Path(path).absolute()}: write where yours is")
    # Excel writes a mark before the first name, which utf-8-sig leaves out.
    with Path(path).open(encoding="utf-8-sig", newline="") as file:
        for number, row in enumerate(csv.DictReader(file, delimiter="\t"), start=2):
            try:
                found.append(read(row))
            except KeyError as missing:
                raise ValueError(
                    f"{Path(path).name} has no column {missing}: its first line names the columns, "
                    "with tabs between them"
                ) from missing
            except (ValueError, TypeError) as wrong:
                raise ValueError(f"{Path(path).name}, line {number}: {wrong}") from wrong
    return found
