"""A reader's folder with small photographs of the desk."""

from collections.abc import Callable
from pathlib import Path

import matplotlib as mpl
import numpy as np
import pytest

mpl.use("Agg")  # as a test has no screen

from PIL import Image

from course_lib import lab
from course_lib.lab import supplied
from data_generators import desk
from data_generators.phone import write_photograph

SIZE = (640, 480)
MEASURING = ("m1.jpg", "m2.jpg", "m3.jpg")


def write(path: Path, aim: desk.Aim, seed: int) -> None:
    """Write a photograph that names its place and owner, as phones do."""
    said = Image.Exif()
    said[0x010E] = "my kitchen"
    rng = np.random.default_rng(seed)
    write_photograph(path, aim, SIZE, rng, 0.6, 2.0, quality=92, exif=said)


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


@pytest.fixture
def heard(capsys: pytest.CaptureFixture[str]) -> Callable[[], str]:
    """Return what tells what was said since, however its lines are folded."""
    return lambda: " ".join(capsys.readouterr().out.split())
