"""A reader's folder with small photographs of the desk."""

from pathlib import Path

import matplotlib as mpl
import numpy as np
import pytest

mpl.use("Agg")  # as a test has no screen

from PIL import Image

from course_lib import lab
from course_lib.lab import supplied
from data_generators import desk

SIZE = (640, 480)
MEASURING = ("m1.jpg", "m2.jpg", "m3.jpg")


def write(path: Path, aim: supplied.Aim, seed: int) -> None:
    """Write a photograph that names its place and owner, as phones do."""
    view = desk.photograph_desk(*desk.pose_towards(*aim), SIZE, np.random.default_rng(seed))
    said = Image.Exif()
    said[0x010E] = "my kitchen"
    Image.fromarray(view.picture).save(path, quality=92, exif=said)


@pytest.fixture(scope="package")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with seven photographs of the target and three to measure in."""
    place = tmp_path_factory.mktemp("mine")
    for number, aim in enumerate(supplied.TARGET_AIMS[:7]):
        write(place / f"t{number}.jpg", aim, number)
    for name, aim in zip(MEASURING, supplied.MEASURING_AIMS, strict=True):
        write(place / name, aim, 50)
    (place / "torn.jpg").write_bytes((place / "t0.jpg").read_bytes()[:4000])
    return place


@pytest.fixture(scope="package")
def work(folder: Path) -> lab.Work:
    """Return the work on that folder, with its camera."""
    return lab.calibrate(lab.look("mine", folder, desk.TARGET, MEASURING))
