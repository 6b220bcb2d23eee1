"""The whole camera: eleven numbers, the picture they make and the matrix they become."""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.camera import Camera, camera_at, first_guess_intrinsics
from course_lib.drawing.explorers.frame import Frame, Label, Line, Picture, Readout, matrix
from course_lib.drawing.explorers.street import frustum, renderer
from course_lib.transforms import gimbal_pose, rotation_z

Floats = NDArray[np.float64]

SIZE = (480, 360)
VIEW_SIZE = (400, 360)
DEPTH = 5.0  # m: how far the frustum is drawn
AXIS = 2.0  # m: how long the camera's axes are drawn
#: The bulb of the first street lamp, m in the world.
LAMP = np.array([2.7, 9.0, 4.94])
#: Where the sliders stand at first; lengths in px and m, angles in degrees.
FIRST = {
    "f": 400.0,
    "aspect": 1.0,
    "skew": 0.0,
    "cx": 239.5,
    "cy": 179.5,
    "x": 0.5,
    "y": -3.5,
    "z": 1.6,
    "pan": 0.0,
    "tilt": 5.0,
    "roll": 0.0,
}


def turned(pan: float, tilt: float, roll: float) -> Floats:
    """Return the rotation, world to camera, of a camera that looked north before it was turned.

    Parameters
    ----------
    pan, tilt, roll : float
        To the left, upwards, and clockwise as the photographer sees it, rad; in this order,
        about axes that turn with the camera.

    Returns
    -------
    ndarray, shape (3, 3)
        That of `gimbal_pose`, and then the roll about the optical axis.
    """
    R, _ = gimbal_pose(pan, tilt, (0, 0, 0), (0, 0, 0))
    return rotation_z(-roll) @ R


def whole_camera(
    f: float,
    aspect: float,
    skew: float,
    cx: float,
    cy: float,
    x: float,
    y: float,
    z: float,
    pan: float,
    tilt: float,
    roll: float,
) -> Camera:
    """Return the camera of eleven numbers, in the units of `FIRST`."""
    K = np.array([[f, skew, cx], [0, aspect * f, cy], [0, 0, 1]])
    R = turned(*np.radians([pan, tilt, roll]))
    return Camera(K, R, -R @ np.array([x, y, z]), SIZE)


def whole_camera_frame(**numbers: float) -> Frame:
    """Return the street through any pinhole camera, the camera in the street, and its matrices.

    Parameters
    ----------
    **numbers
        One for each key of `FIRST`.

    Returns
    -------
    Frame
        The photograph, the view from outside, and K, [R | t] and P as readouts.
    """
    camera = whole_camera(**numbers)
    P = camera.P
    image = P @ np.append(LAMP, 1.0)
    pixel = image[:2] / image[2] if image[2] > 0 else None
    words = "nowhere: it is behind the camera"
    if pixel is not None:
        words = f"({round(pixel[0])}, {round(pixel[1])})"
    readouts = (
        matrix("Camera matrix", "P = K [R | t]", P, (1, 1, 3)),
        matrix("Intrinsics", "K", camera.K, 1),
        matrix("Extrinsics", "[R | t]", np.column_stack([camera.R, camera.t]), 3),
        Readout("Lamp times P", "(x, y, w)", _numbers(image, (0, 0, 2))),
        Readout("Lamp in the picture", "(u, v)", words, "px" if pixel is not None else ""),
    )
    return Frame((_photograph(camera, pixel, words), _outside(camera)), readouts)


def _photograph(camera: Camera, pixel: Floats | None, words: str) -> Picture:
    """Return what the camera sees, with the lamp in a ring."""
    where = words if pixel is None else f"at {words}"
    return Picture(
        "What the camera sees",
        f"Photograph of a street from {_numbers(camera.centre)} m. The lamp is {where}.",
        SIZE,
        renderer().picture(camera),
        lines=() if pixel is None else (_ring(pixel, 9.0),),
        labels=() if pixel is None else _near(pixel, "lamp", SIZE),
        pixels=True,
    )


def _outside(camera: Camera) -> Picture:
    """Return the street from above, with the camera, its axes and its frustum."""
    view, picture, lamp = _bird()
    centre = camera.centre
    origin, *tips = view.project(np.vstack([centre, centre + AXIS * camera.R]))
    axes = tuple(Line(np.array([origin, tip]), "second", 2.0) for tip in tips)
    named = {name: tip + 0.35 * (tip - origin) for name, tip in zip("xyz", tips, strict=True)}
    names = tuple(
        Label(name, _pair(at), "second", "middle")
        for name, at in named.items()
        if ((at > 0) & (at < view.image_size)).all()
    )
    return Picture(
        "The camera from outside",
        f"The street from above, with the camera at {_numbers(centre)} m, its axes and what it "
        "sees.",
        VIEW_SIZE,
        picture,
        lines=(*frustum(camera, DEPTH, view), *axes, _ring(lamp, 6.0)),
        labels=(*names, *_near(lamp, "lamp", VIEW_SIZE)),
    )


def _numbers(values: Floats, digits: tuple[int, int, int] = (1, 1, 1)) -> str:
    """Return three numbers as text, never -0."""
    pairs = zip(values.tolist(), digits, strict=True)
    return "({})".format(", ".join(f"{round(x, d) + 0.0:.{d}f}" for x, d in pairs))


def _ring(pixel: Floats, radius: float) -> Line:
    """Return a circle around a pixel."""
    turn = np.linspace(0, 2 * np.pi, 25)[:-1]
    circle = pixel + radius * np.stack([np.cos(turn), np.sin(turn)], axis=1)
    return Line(circle, "object", 2.5, closed=True)


def _near(pixel: Floats, text: str, size: tuple[int, int]) -> tuple[Label, ...]:
    """Return a label to the right of a pixel, if that is inside of the picture."""
    inside = bool((pixel > 0).all() and (pixel < np.subtract(size, (40, 1))).all())
    return (Label(text, (float(pixel[0]) + 13, float(pixel[1])), "object"),) if inside else ()


def _pair(pixel: ArrayLike) -> tuple[float, float]:
    u, v = np.asarray(pixel, dtype=float)
    return float(u), float(v)


@cache
def _bird() -> tuple[Camera, NDArray[np.uint8], Floats]:
    """Return the camera above the street, its photograph and the lamp in it: they stay the same."""
    K = first_guess_intrinsics(37, (36, 36 * VIEW_SIZE[1] / VIEW_SIZE[0]), VIEW_SIZE)
    view = camera_at((-11, -17, 11), (0.2, 2.5, 1.4), K, VIEW_SIZE)
    return view, renderer().picture(view), view.project(LAMP)
