from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from types import SimpleNamespace

import cv2
import numpy as np
import pytest

from course_lib.boards import Checkerboard
from course_lib.calibrating.finding import find_photos
from course_lib.calibrating.judgement import judge
from course_lib.calibrating.looking import look_at_photos
from course_lib.calibrating.solving import solve
from course_lib.calibration import CameraModel
from data_generators.calibration_sets import calibration_set

BOARD = Checkerboard(7, 5, 30.0)
KEPT = TemporaryDirectory()


@cache
def taken():
    """A folder as people have them: eight good photographs, and one of each kind of trouble."""
    folder = Path(KEPT.name, "photos")
    folder.mkdir()
    pictures = calibration_set(
        9, rng=np.random.default_rng(8), board=BOARD, image_size=(480, 360), flaws={8: "blurred"}
    )
    for number, view in enumerate(pictures.views[:8], 1):
        cv2.imwrite(str(folder / f"view{number}.png"), view.picture)
    first = pictures.views[0].picture
    cv2.imwrite(str(folder / "x_blurred.png"), pictures.views[8].picture)
    cv2.imwrite(str(folder / "x_empty_table.png"), np.full_like(first, 90))
    cv2.imwrite(str(folder / "x_small.png"), cv2.resize(first, (240, 180)))
    cv2.imwrite(str(folder / "x_turned.png"), np.rot90(first))
    (folder / "x_again.png").write_bytes((folder / "view3.png").read_bytes())
    noise = np.random.default_rng(0).normal(0, 2, first.shape)
    cv2.imwrite(str(folder / "x_tripod.png"), np.clip(first + noise, 0, 255).astype(np.uint8))
    (folder / "x_nothing.jpg").write_bytes(b"")
    (folder / "x_letter.jpg").write_text("Dear reader,")
    whole = cv2.imencode(".jpg", first)[1].tobytes()
    (folder / "x_half.jpg").write_bytes(whole[: len(whole) // 2])
    return SimpleNamespace(folder=folder, truth=pictures)


@cache
def calibrated():
    lines = []
    paths = [*find_photos([str(taken().folder)]), taken().folder / "x_missing.jpg"]
    photos = look_at_photos(paths, BOARD, lines.append)
    solved = solve(photos, BOARD, CameraModel())
    return SimpleNamespace(
        photos={p.name: p for p in photos}, lines=lines, solved=solved, judgement=judge(solved)
    )


@pytest.fixture(scope="session")
def folder():
    return taken().folder


@pytest.fixture(scope="session")
def truth():
    return taken().truth


@pytest.fixture(scope="session")
def run():
    """What came out of the whole folder."""
    return calibrated()
