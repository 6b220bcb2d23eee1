"""The explorers of chapter 11."""

from __future__ import annotations

from functools import partial

from course_lib.drawing.explorers import setup_planner as bench
from course_lib.drawing.explorers.flight_planner import START, flight_frame
from course_lib.drawing.planning.site import EXTENT, drones, with_lenses
from course_lib.planning.catalogue import own_cameras, own_lenses
from course_lib.widgets.controls import Choice, Slider, Switch
from course_lib.widgets.explorer import Explorer

STOPS = (1.4, 2, 2.8, 4, 5.6, 8, 10, 11, 14, 16)
TIMES = (50, 125, 200, 250, 500, 1000)  # µs


def setup_planner(cameras: object = (), lenses: object = ()) -> Explorer:
    """Return the set-up planner: two cameras before the panel, and verdicts on them.

    Parameters
    ----------
    cameras, lenses : CameraModel, LensModel, iterable of them, mapping to them, str or Path
        Your own, beside those of the catalogue: one, several, or a table.

    Raises
    ------
    TypeError, ValueError
        If they are none of these, or the table cannot be read.
    """
    bodies = bench.cameras() | bench.short_names(own_cameras(cameras).values())
    glasses = bench.lenses() | own_lenses(lenses)
    first_body, first_glass = next(iter(bodies)), next(iter(glasses))
    distances = (1.25, 1.4, 1.6, 2, 2.2)
    return Explorer(
        "Plan a set-up",
        [
            Choice("camera", "Camera", tuple(bodies), first_body),
            Choice("lens", "Lens", tuple(glasses), first_glass),
            Slider("Z", "Distance", "Z", "m", 0.6, 6, 2.2, steps=60, digits=3, landmarks=distances),
            Slider("turn_deg", "Turn of each camera", "", "°", 2, 40, 15, step=1),
            Slider("N", "f-number", "N", "", 1.4, 16, 10, steps=30, landmarks=STOPS),
            Slider("t", "Exposure time", "t", "µs", 20, 4000, 250, steps=50, landmarks=TIMES),
        ],
        partial(bench.setup_frame, bodies=bodies, glasses=glasses),
    )


def flight_planner(cameras: object = (), lenses: object = ()) -> Explorer:
    """Return the flight planner: an area whose corners are dragged, and a flight over it.

    Parameters
    ----------
    cameras, lenses : CameraModel, LensModel, iterable of them, mapping to them, str or Path
        Your own flying cameras, beside those of the catalogue, and what they look through. A
        camera flies with the first lens that has its mount.

    Raises
    ------
    TypeError, ValueError
        If they are none of these, a table cannot be read, or a camera has no lens.
    """
    flying = drones() | with_lenses(own_cameras(cameras), own_lenses(lenses))
    names = tuple(flying)
    controls: list[Choice | Slider | Switch] = [
        Choice("camera", "Camera", names, names[0]),
        Slider("gsd", "Ground sampling distance", "GSD", "cm", 1, 4, 2, step=0.5, digits=1),
        Slider("forward", "Forward overlap", "", "%", 50, 90, 80, step=2),
        Slider("side", "Side overlap", "", "%", 20, 80, 60, step=5),
        Slider("heading", "Direction of the lines", "", "°", 0, 175, 90, step=5),
        Switch("hilly", "The ground has its pit and its heap", True),
    ]
    for i, place in enumerate(START, 1):
        for name, label, reach, value in zip("xy", ("east", "north"), EXTENT, place, strict=True):
            controls.append(
                Slider(f"{name}{i}", f"Corner {i} {label}", "", "m", 0, reach, value, step=5)
            )
    return Explorer("Plan a flight", controls, partial(flight_frame, drones=flying))
