"""What Python alone takes: importing the course, rendering a picture."""

from __future__ import annotations

import json
import os
import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from functools import partial

from benchmarks.processes import clean_environment
from benchmarks.table import Row
from tests.test_architecture import MATHEMATICS

ALL_OF_IT = "import " + ", ".join(f"course_lib.{package}" for package in sorted(MATHEMATICS))


def importing(rounds: int = 15) -> list[Row]:
    """Measure a fresh interpreter that imports the mathematics, and one that imports NumPy."""
    times: dict[str, list[float]] = {"pass": [], "import numpy": [], ALL_OF_IT: []}
    for turn in range(rounds + 1):
        for code, taken in times.items():
            start = time.perf_counter()
            subprocess.run([sys.executable, "-c", code], check=True, env=clean_environment())
            if turn:
                taken.append(time.perf_counter() - start)
    bare, numpy, ours = (1000 * statistics.median(taken) for taken in times.values())
    what = "import course_lib and all its mathematics"
    return [Row(what, ours - bare, "ms", "import numpy", numpy - bare, "≤ 300 ms")]


def rendering(rounds: int = 15) -> list[Row]:
    """Measure the street, 640 x 480, on one core: by warps, and by rays at one ray a pixel."""
    import cv2

    from data_generators.places import street, street_camera
    from data_generators.quick import QuickRenderer
    from data_generators.render import photograph

    threads = cv2.getNumThreads()
    cv2.setNumThreads(1)
    camera, renderer = street_camera((640, 480)), QuickRenderer(street())
    quick = lambda: renderer.picture(camera)  # noqa: E731
    rays = lambda: photograph(renderer.scene, camera, samples=1)  # noqa: E731
    ours, theirs = alternating(quick, rays, rounds)
    cv2.setNumThreads(threads)
    return [Row("street, 640 × 480, smooth", ours, "ms", "ray casting, jagged", theirs, "≤ 20 ms")]


def projecting() -> list[Row]:
    """Measure the projection of points to equal pixels, with one thread."""
    code = "import json; from benchmarks import compute; print(json.dumps(compute.project_times()))"
    # The number of threads of the BLAS can only be set before NumPy is there.
    alone = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
    output = subprocess.run(
        [sys.executable, "-c", code], check=True, env=alone, capture_output=True
    )
    return [
        Row(f"project {count} points", ours, "ms", "cv2.projectPoints", theirs, "≤ 0.2 ×")
        for count, (ours, theirs) in json.loads(output.stdout).items()
    ]


def project_times(rounds: int = 15) -> dict[str, list[float]]:
    """Return how long we and OpenCV take to project many points, ms, by their number."""
    import cv2
    import numpy as np

    from course_lib.camera import camera_matrix, project

    cv2.setNumThreads(1)
    K = np.array([[1000.0, 0, 640], [0, 1010, 480], [0, 0, 1]])
    turn, t = np.array([0.1, 0.2, 0.3]), np.array([0.1, 0.2, 5.0])
    P, times = camera_matrix(K, cv2.Rodrigues(turn)[0], t), {}
    for count in (10**5, 10**6):
        points = np.random.default_rng(0).uniform(-1, 1, (count, 3))
        ours, theirs = (
            partial(project, points, P),
            partial(cv2.projectPoints, points, turn, t, K, None),
        )
        np.testing.assert_allclose(ours(), theirs()[0][:, 0], rtol=0, atol=1e-9)
        times[f"{count:,}".replace(",", " ")] = alternating(ours, theirs, rounds)
    return times


def defocusing(rounds: int = 41) -> list[Row]:
    """Measure the street with signs, 640 x 480: aperture, focus and noise new in every frame.

    By the processor time of this process, on one core, as others may want the same core.
    """
    import cv2

    threads = cv2.getNumThreads()
    cv2.setNumThreads(1)
    quick, rays = _through_a_lens()
    taken = [processor_time(lambda turn=turn: quick(turn)) for turn in range(rounds)][1:]
    theirs = processor_time(rays)
    cv2.setNumThreads(threads)
    what, peer = "lens and noise, 640 × 480", "4 rays a pixel, grainy"
    return [
        Row(f"{what}: median", statistics.median(taken), "ms", peer, theirs, "≤ 17 ms"),
        Row(f"{what}: fastest of {rounds - 1}", min(taken), "ms"),
        Row(f"{what}: slowest", max(taken), "ms"),
    ]


def _through_a_lens() -> tuple[Callable[[int], object], Callable[[], object]]:
    """Return functions that take a photograph through a lens: a quick one, and one by rays."""
    import numpy as np

    from course_lib.camera import Camera, camera_at
    from course_lib.sensor import SensorModel
    from data_generators.defocus import DefocusedView
    from data_generators.lens import Lens
    from data_generators.quick_sensor import QuickSensor, developed
    from data_generators.render import photograph
    from data_generators.shot import Shot
    from data_generators.signs import VIEWPOINT, street_with_signs

    size, sensor = (640, 480), SensorModel()
    view, grain = DefocusedView(street_with_signs()), QuickSensor(size, np.random.default_rng(1))

    def camera(lens: Lens) -> Camera:
        K = lens.intrinsics(36 / size[0], size)
        return camera_at(VIEWPOINT, VIEWPOINT + np.array([0.0, 1.0, 0.0]), K, size)

    def quick(turn: int) -> object:
        lens = Lens(f=50, N=1.4 * 1.06**turn, focus_distance=500 * 1.09**turn)
        light = view.picture(camera(lens), lens)
        return developed(grain.numbers(light, sensor, 20_000, frame=turn), sensor)

    def rays() -> object:
        lens = Lens(f=50, N=2.8, focus_distance=2000)
        shot, rng = Shot(lens=lens, sensor=sensor), np.random.default_rng(1)
        return photograph(view.renderer.scene, camera(lens), shot=shot, samples=2, rng=rng)

    return quick, rays


def processor_time(function: Callable[[], object]) -> float:
    """Return the processor time that a function takes, ms."""
    start = time.process_time()
    function()
    return 1000 * (time.process_time() - start)


def alternating(one: Callable[[], object], other: Callable[[], object], rounds: int) -> list[float]:
    """Return the medians of two functions that take turns, ms; the first round is dropped."""
    times: list[list[float]] = [[], []]
    for turn in range(rounds + 1):
        for function, taken in zip((one, other), times, strict=True):
            start = time.perf_counter()
            function()
            if turn:
                taken.append(1000 * (time.perf_counter() - start))
    return [statistics.median(taken) for taken in times]
