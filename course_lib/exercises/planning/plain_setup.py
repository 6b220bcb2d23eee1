"""The set-up of chapter 11, looked for among all pairs of a camera and a lens."""

from __future__ import annotations

from course_lib import planning


def plan_setup(task, cameras, lenses):
    """Return a camera, a lens and their settings that do what a measurement asks for.

    The camera looks straight at the front of a box. Any set-up that meets all demands is right.
    With the pitch p, near and far the distances of the front and the back of the box, all in m:

    - in view: ``width + 2 motion`` is at most ``camera width · p · near / f``; so for the height.
    - resolution: ``far p / f`` is at most `resolution`.
    - depth of field and diffraction: N lies from ``window.least`` to ``window.most``, with
      ``window = planning.aperture_window(f_mm, near, far, spot_um)`` and a spot of `blur_px`
      pixels, in µm; and N is one that the lens has.
    - distance: near is at least `stand_off`, and at least the lens's `closest`.
    - motion blur: ``speed · exposure_time`` is at most ``blur_px · near p / f``.
    - frame rate: the camera's is at least the task's, and ``exposure_time`` is at most one over
      the task's.
    - light: `exposure_time` is at least ``N² · exposure_at_f1``.

    Each demand earns its own points, but nothing is earned where one is missed ten times over.
    The tasks leave some room: the camera may stand 5 % farther off than it must.

    Parameters
    ----------
    task : dict
        width, height and depth of the box, m; motion, how far it moves sideways, up and down, to
        each side, m; speed of its fastest point, m/s; resolution, the most that a pixel may cover,
        m; blur_px, the largest spot and the longest smear, px; frame_rate, pictures a second;
        stand_off, the least distance of the front, m; exposure_at_f1, what f/1 needs of light, s.
    cameras : list of dict
        width and height, px; pitch_um; frame_rate, the most pictures a second.
    lenses : list of dict
        f_mm; N_least and N_most, the range of f-numbers; closest, the least focus distance, m.

    Returns
    -------
    dict
        camera and lens, their numbers in the lists, from 0; distance from the lens to the middle
        of the box, m; N, the f-number; exposure_time, s. There is always a set-up.

    Examples
    --------
    >>> task = {"width": 0.4, "height": 0.3, "depth": 0.05, "motion": 0.01, "speed": 0.1}
    >>> task |= {"resolution": 4e-4, "blur_px": 2, "frame_rate": 50, "stand_off": 0.5}
    >>> task |= {"exposure_at_f1": 1e-4}
    >>> cameras = [{"width": 1280, "height": 1024, "pitch_um": 5, "frame_rate": 100}]
    >>> lenses = [{"f_mm": 12, "N_least": 1.4, "N_most": 16, "closest": 0.1}]
    >>> {key: round(value, 4) for key, value in plan_setup(task, cameras, lenses).items()}
    {'camera': 0, 'lens': 0, 'distance': 0.8125, 'N': 1.4, 'exposure_time': 0.0066}
    """
    for number, camera in enumerate(cameras):
        for other, lens in enumerate(lenses):
            p, f = camera["pitch_um"] / 1e6, lens["f_mm"] / 1e3
            across = (task["width"] + 2 * task["motion"]) * f / (camera["width"] * p)
            upright = (task["height"] + 2 * task["motion"]) * f / (camera["height"] * p)
            near = max(across, upright, task["stand_off"], lens["closest"])
            far = near + task["depth"]
            spot = task["blur_px"] * camera["pitch_um"]
            window = planning.aperture_window(lens["f_mm"], near, far, spot)
            N = max(window.least, lens["N_least"])
            longest = min(
                task["blur_px"] * near * p / f / task["speed"],
                1 / task["frame_rate"],
            )
            if (
                far * p / f <= task["resolution"]
                and min(window.most, lens["N_most"]) >= N
                and camera["frame_rate"] >= task["frame_rate"]
                and N**2 * task["exposure_at_f1"] <= longest
            ):
                plan = {"camera": number, "lens": other, "distance": (near + far) / 2}
                return plan | {"N": N, "exposure_time": longest}
