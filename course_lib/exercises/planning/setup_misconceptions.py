"""Set-ups of chapter 11 that miss a demand, and the mistakes that they come from."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from course_lib.exercises.planning.demands import window

Inputs = dict[str, Any]


def nearest(task: Any, camera: Any, f: float, p: float, closest: float, moves: float) -> float:
    """Return the least distance at which the box fits, with so many motions on each side."""
    across = (task["width"] + 2 * moves * task["motion"]) * f / (camera["width"] * p)
    upright = (task["height"] + 2 * moves * task["motion"]) * f / (camera["height"] * p)
    return float(max(across, upright, task["stand_off"], closest))


def longest(task: Any, near: float, f: float, p: float) -> float:
    return float(min(task["blur_px"] * near * p / f / task["speed"], 1 / task["frame_rate"]))


def fits(task: Any, camera: Any, lens: Any, far: float, N: float, most: float, time: float) -> bool:
    """Return whether what is left of the demands is met."""
    coarse = far * camera["pitch_um"] / 1e3 / lens["f_mm"] > task["resolution"]
    closed = min(most, lens["N_most"]) < N
    late = camera["frame_rate"] < task["frame_rate"]
    return not (coarse or closed or late or N**2 * task["exposure_at_f1"] > time)


def search(
    task: Any,
    cameras: Any,
    lenses: Any,
    moves: float = 1.0,
    in_front: bool = False,
    airy: bool = True,
) -> Any:
    """Return the right answer, or one with too little room, too coarse behind, or diffracted."""
    for number, camera in enumerate(cameras):
        for other, lens in enumerate(lenses):
            p, f = camera["pitch_um"] / 1e6, lens["f_mm"] / 1e3
            near = nearest(task, camera, f, p, lens["closest"], moves)
            spot, far = task["blur_px"] * camera["pitch_um"], near + task["depth"]
            least, most = window(lens["f_mm"], near, far, spot)
            most = most if airy else math.inf
            N, time = max(least, lens["N_least"]), longest(task, near, f, p)
            if fits(task, camera, lens, near if in_front else far, N, most, time):
                plan = {"camera": number, "lens": other, "distance": (near + far) / 2}
                return plan | {"N": N, "exposure_time": time}
    return None


def changed(task: Any, cameras: Any, lenses: Any, **settings: Callable[[Inputs], float]) -> Any:
    """Return the right answer, with settings computed from it in another way."""
    plan = search(task, cameras, lenses)
    return plan | {key: change(plan) for key, change in settings.items()}


# --- no set-up, or in other units -------------------------------------------------------------


def nothing_found(task, cameras, lenses):
    return None


def sides_exchanged(task, cameras, lenses):
    turned = [c | {"width": c["height"], "height": c["width"]} for c in cameras]
    return search(task, turned, lenses)


def pitch_in_mm(task, cameras, lenses):
    return search(task, [c | {"pitch_um": 1000 * c["pitch_um"]} for c in cameras], lenses)


def counted_from_one(task, cameras, lenses):
    plan = search(task, cameras, lenses)
    return plan | {"camera": plan["camera"] + 1, "lens": plan["lens"] + 1}


def distance_in_mm(task, cameras, lenses):
    return changed(task, cameras, lenses, distance=lambda plan: 1000 * plan["distance"])


def exposure_in_ms(task, cameras, lenses):
    return changed(task, cameras, lenses, exposure_time=lambda plan: 1000 * plan["exposure_time"])


def one_over_the_exposure(task, cameras, lenses):
    return changed(task, cameras, lenses, exposure_time=lambda plan: 1 / plan["exposure_time"])


# --- in view ----------------------------------------------------------------------------------


def motion_shared(task, cameras, lenses):
    return search(task, cameras, lenses, moves=0.5)


def motion_forgotten(task, cameras, lenses):
    return search(task, cameras, lenses, moves=0)


def height_forgotten(task, cameras, lenses):
    def nearer(plan: Inputs) -> float:
        camera, lens = cameras[plan["camera"]], lenses[plan["lens"]]
        p, f = camera["pitch_um"] / 1e6, lens["f_mm"] / 1e3
        flat = task | {"height": 0.0}
        return nearest(flat, camera, f, p, lens["closest"], 1.0) + float(task["depth"]) / 2

    return changed(task, cameras, lenses, distance=nearer)


def half_the_box(task, cameras, lenses):
    halved = {key: task[key] / 2 for key in ("width", "height", "motion")}
    return search(task | halved, cameras, lenses) or search(task, cameras, lenses)


def front_for_the_middle(task, cameras, lenses):
    front = lambda plan: plan["distance"] - task["depth"] / 2  # noqa: E731
    return changed(task, cameras, lenses, distance=front)


def only_the_middle(task, cameras, lenses):
    thin = task | {"depth": 1e-9}
    plan = search(thin, cameras, lenses)
    return plan | {"distance": plan["distance"] - 5e-10, "N": lenses[plan["lens"]]["N_least"]}


# --- depth of field and diffraction -----------------------------------------------------------


def wide_open(task, cameras, lenses):
    return changed(task, cameras, lenses, N=lambda plan: lenses[plan["lens"]]["N_least"])


def stop_rounded_down(task, cameras, lenses):
    def stop(plan: Inputs) -> float:
        return max(N for N in (1.4, 2, 2.8, 4, 5.6, 8, 11) if plan["N"] > N)

    return changed(task, cameras, lenses, N=stop)


def stopped_down(task, cameras, lenses):
    def smallest(plan: Inputs) -> float:
        by_light = math.sqrt(plan["exposure_time"] / task["exposure_at_f1"])
        return float(min(by_light, lenses[plan["lens"]]["N_most"]))

    return changed(task, cameras, lenses, N=smallest)


def diffraction_not_looked_at(task, cameras, lenses):
    return search(task, cameras, lenses, airy=False)


# --- resolution, distance, frame rate ---------------------------------------------------------


def resolution_not_looked_at(task, cameras, lenses):
    return search(task | {"resolution": math.inf}, cameras, lenses)


def resolution_in_front(task, cameras, lenses):
    return search(task, cameras, lenses, in_front=True)


def stand_off_forgotten(task, cameras, lenses):
    return search(task | {"stand_off": 0.0}, cameras, lenses)


def closest_focus_forgotten(task, cameras, lenses):
    return search(task, cameras, [lens | {"closest": 0.0} for lens in lenses])


def slow_camera(task, cameras, lenses):
    return search(task, [c | {"frame_rate": math.inf} for c in cameras], lenses)


def as_long_as_the_smear_allows(task, cameras, lenses):
    def time(plan: Inputs) -> float:
        near = plan["distance"] - task["depth"] / 2
        camera, lens = cameras[plan["camera"]], lenses[plan["lens"]]
        pixel = near * camera["pitch_um"] / 1000 / lens["f_mm"]
        return float(task["blur_px"] * pixel / task["speed"])

    return changed(task, cameras, lenses, exposure_time=time)


def as_long_as_the_rate_allows(task, cameras, lenses):
    return changed(task, cameras, lenses, exposure_time=lambda _: 1 / task["frame_rate"])


# --- light ------------------------------------------------------------------------------------


def f_number_not_squared(task, cameras, lenses):
    needed = lambda plan: plan["N"] * task["exposure_at_f1"]  # noqa: E731
    return changed(task, cameras, lenses, exposure_time=needed)


def light_not_looked_at(task, cameras, lenses):
    return search(task | {"exposure_at_f1": 0.0}, cameras, lenses)


def light_forgotten(task, cameras, lenses):
    return changed(task, cameras, lenses, exposure_time=lambda plan: plan["exposure_time"] / 3)
