"""Real pictures and measurements: where they come from, and how they get here.

They belong to others and are not part of the course. Each is downloaded when it is first asked
for, checked against its sha256, and kept. ``COURSE_DATA_DIR`` names a folder that holds copies.
"""

from __future__ import annotations

import csv
import difflib
import hashlib
import os
from functools import cache
from pathlib import Path
from typing import NamedTuple

REGISTRY = Path(__file__).with_name("data_registry.tsv")
SECONDS = 20  # until a download that brings nothing is given up


class Unavailable(Exception):
    """A picture is not on this computer and could not be downloaded; the message is a sentence."""


class Source(NamedTuple):
    """Whose the files of a folder are, and what may be done with them."""

    credit: str
    licence: str


#: By folder.
SOURCES = {
    "aerial_block": Source("N. Börlin and P. Grussenmeyer, Strasbourg block of DBAT", "BSD style"),
    "boofcv": Source("P. Abeles, BoofCV", "CC BY 4.0"),
    "nikon_raw": Source("M. Alam, Nikon D3200 raw picture", "MIT"),
    "opencv_stereo": Source("OpenCV, sample pictures of calibration and matching", "Apache 2.0"),
    "resection_tables": Source("Wuhan University, textbook example of a resection", "facts"),
    "zhang": Source("Z. Zhang, data of his paper of 2000, as kept by imagingbook", "BSD 2-clause"),
}


class _Entry(NamedTuple):
    sha256: str
    address: str


@cache
def _registry() -> dict[str, _Entry]:
    """Return every file's checksum and address, by its name."""
    with REGISTRY.open(encoding="utf-8", newline="") as table:
        rows = csv.DictReader(table, delimiter="\t")
        return {row["path"]: _Entry(row["sha256"], row["address"]) for row in rows}


def names(folder: str = "") -> list[str]:
    """Return the names of the files that `fetch` knows.

    Parameters
    ----------
    folder : str
        Only those below this folder, e.g. ``"opencv_stereo"``.

    Returns
    -------
    list of str
        In the order of the alphabet.
    """
    return sorted(name for name in _registry() if name.startswith(folder))


def source(name: str) -> Source:
    """Return whose a file is, and its licence.

    Parameters
    ----------
    name : str
        As for `fetch`.

    Returns
    -------
    Source
        Credit and licence.

    Raises
    ------
    ValueError
        If there is no such file.
    """
    _entry(name)
    return SOURCES[name.partition("/")[0]]


def fetch(name: str) -> Path:
    """Return where a real picture or measurement lies on this computer; download it if need be.

    Parameters
    ----------
    name : str
        Folder and file, e.g. ``"opencv_stereo/left01.jpg"``; one of `names`.

    Returns
    -------
    pathlib.Path
        The file: in ``COURSE_DATA_DIR`` if that is set and holds it, otherwise in the cache.

    Raises
    ------
    ValueError
        If there is no such file; the message names similar ones.
    Unavailable
        If it is neither here nor to be had; or if a copy is not what it should be.
    """
    entry = _entry(name)
    folder = os.environ.get("COURSE_DATA_DIR")
    copy = Path(folder, name) if folder else None
    if copy and copy.is_file():
        if hashlib.sha256(copy.read_bytes()).hexdigest() != entry.sha256:
            raise Unavailable(f"{copy} is not the file it should be. Delete it and try again.")
        return copy
    return _downloaded(name, entry)


def _entry(name: str) -> _Entry:
    """Return what the registry says of a file."""
    registry = _registry()
    if name not in registry:
        near = difflib.get_close_matches(name, registry, n=3, cutoff=0.4) or list(registry)[:3]
        raise ValueError(f"no real picture {name!r}; did you mean {' or '.join(near)}?")
    return registry[name]


def _downloaded(name: str, entry: _Entry) -> Path:
    """Return the file in the cache, where it is brought if it is not there."""
    import pooch

    pooch.get_logger().setLevel("WARNING")
    if not entry.address:
        raise Unavailable(f"{name} cannot be downloaded: set COURSE_DATA_DIR to a folder with it.")
    place = Path(pooch.os_cache("camera-course"), name)
    try:
        pooch.retrieve(
            entry.address,
            f"sha256:{entry.sha256}",
            fname=place.name,
            path=place.parent,
            downloader=pooch.HTTPDownloader(timeout=SECONDS),
        )
    except Exception as error:  # no network, no space, a proxy's error page, …
        raise Unavailable(
            f"The picture {name} is not on this computer and could not be downloaded "
            f"({type(error).__name__}). Connect to the internet once and run this cell again."
        ) from error
    return place
