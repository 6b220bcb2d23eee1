"""The epipolar explorer: a point of the left picture, its ray in space, its line on the right."""

from __future__ import annotations

from functools import cache
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.camera import Camera, camera_at
from course_lib.drawing.explorers.frame import Frame, Handle, Label, Line, Picture, Readout
from course_lib.drawing.explorers.pairs import cameras, photographs
from course_lib.drawing.explorers.plot import disc
from course_lib.drawing.explorers.street import corners, renderer
from course_lib.drawing.explorers.trails import Trail

Floats = NDArray[np.float64]

WIDTH = 340
SIZE = (340, 255)
SPACE_SIZE, NEAR_SIZE = (264, 256), (160, 200)
#: How far rays are drawn in space, and cameras, m.
NEAREST, PYRAMID, SHOWN = 0.3, 2.0, 60.0
DEPTHS = (4.0, 6.0, 10.0, 20.0, 50.0)
PATCH = 21  # px that are compared
SIDE = 94  # px of an enlarged patch
ABOVE = 14  # px from an epipole to its name


def epipolar_frame(arrangement: str, u: float, v: float, Z: float) -> Frame:
    """Return a point of the left picture with its ray, and where the right one may show it.

    Parameters
    ----------
    arrangement : str
        A key of `course_lib.drawing.explorers.pairs.EYES`.
    u, v : float
        The point, px.
    Z : float
        A guess of its depth before the left camera, m.

    Returns
    -------
    Frame
        Both pictures, the cameras from outside, and what is at the point and at its candidate.
    """
    one, other = cameras(arrangement, WIDTH)
    at = np.array([u, v])
    ray = one.pixel_ray(at)
    point = one.centre + Z * ray / float(ray @ one.R[2])
    place = other.project(point)
    shown = bool(((place >= 0) & (place <= np.array(SIZE) - 1)).all())  # NaN is not
    patches = _patch(arrangement, 0, at), _patch(arrangement, 1, place) if shown else None
    where = f"({place[0]:.0f}, {place[1]:.0f})" if shown else "outside"
    difference = "–" if patches[1] is None else f"{_difference(patches[0], patches[1]):.0f}"
    readouts = (
        Readout("Point on the left", "(u, v)", f"({u:g}, {v:g})", "px"),
        Readout("Candidate on the right", "", where, "px" if shown else ""),
        Readout("The two patches differ by", "", difference, "grey levels" if shown else ""),
    )
    words = f"at {where} px" if shown else "outside of the picture"
    pictures = (
        _left(arrangement, at),
        _right(arrangement, at, place if shown else None, words),
        _space(arrangement, point, Z),
        _patches(patches[0], patches[1], words),
    )
    return Frame(pictures, readouts)


@cache
def trail(arrangement: str, where: int) -> Trail:
    """Return the trail of a left pixel in the right picture (1) or in the view from above (2)."""
    one, other = cameras(arrangement, WIDTH)
    if where == 1:
        return Trail.between(one, other, 1, NEAREST, DEPTHS)
    return Trail.between(one, _bird()[0], 2, NEAREST)


@cache
def _epipole(arrangement: str, which: int) -> tuple[tuple[Line, ...], tuple[Label, ...]]:
    """Return the other camera's centre in one of the pictures, if it is inside."""
    one, other = cameras(arrangement, WIDTH)
    seer, seen = (one, other)[:: 1 - 2 * which]
    e = seer.P @ np.append(seen.centre, 1.0)
    # The centre may be behind this camera, but the lines still meet there.
    with np.errstate(divide="ignore"):
        at = e[:2] / e[2]
    if not ((at > 20) & (at < np.array(SIZE) - 20)).all():
        return (), ()
    u, v = at.tolist()
    ring = Line(disc(at, 5), "image", 2.5, closed=True)
    return (ring,), (Label("epipole", (u + 9, v - ABOVE), "image"),)


def _left(arrangement: str, at: Floats) -> Picture:
    u, v = at.tolist()
    lines, labels = _epipole(arrangement, 0)
    return Picture(
        "Left: press or drag",
        f"The street through the left camera, with a point at ({u:g}, {v:g}) px.",
        SIZE,
        photographs(arrangement, WIDTH)[0],
        lines=lines,
        labels=labels,
        pixels=True,
        handles=(Handle((u, v), (("u", 0.0, 1.0, 0.0), ("v", 0.0, 0.0, 1.0)), "ray"),),
        trails=(trail(arrangement, 1), trail(arrangement, 2)),
    )


def _right(arrangement: str, at: Floats, place: Floats | None, words: str) -> Picture:
    """Return the right picture with the line of the point, and its candidate."""
    lines, labels = _epipole(arrangement, 1)
    if labels and place is not None and place[1] < labels[0].at[1] + ABOVE:  # keep names apart
        (u, v), name = labels[0].at, labels[0].text
        labels = (Label(name, (u, v + 2 * ABOVE), labels[0].role),)
    lines = (Line(trail(arrangement, 1).path(at), "ray", 2.5), *lines)
    if place is not None:
        lines = (*lines, Line(disc(place, 6), "object", 2.5, closed=True))
        labels = (*labels, _beside(place, "candidate"))
    return Picture(
        "Right: its epipolar line",
        f"The street through the right camera, with the epipolar line; the candidate is {words}.",
        SIZE,
        photographs(arrangement, WIDTH)[1],
        lines=lines,
        labels=labels,
    )


def _beside(place: Floats, name: str) -> Label:
    """Return a label beside a point, inside of the picture."""
    u, v = place.tolist()
    left = u > SIZE[0] - 80
    at = (u - 11 if left else u + 11, min(max(v, 9.0), SIZE[1] - 9.0))
    return Label(name, at, "object", "end" if left else "start")


@cache
def _bird() -> tuple[Camera, NDArray[np.uint8]]:
    """Return the camera above the street, and its photograph."""
    K = np.array([[240.0, 0, 131.5], [0, 240, 127.5], [0, 0, 1]])
    view = camera_at((-13, -13, 11), (0.8, 2.0, 1.4), K, SPACE_SIZE)
    return view, renderer().picture(view)


def _seen(view: Camera, points: ArrayLike) -> Floats:
    """Return the image of a path of points, in small pieces, so that a part behind can go."""
    ends = np.asarray(points, dtype=float)
    share = np.linspace(0, 1, 13)[:, None]
    pieces = [a + share * (b - a) for a, b in pairwise(ends)]
    return view.project(np.concatenate(pieces))


@cache
def _pyramids(arrangement: str) -> tuple[tuple[Line, ...], tuple[Label, ...]]:
    """Return both cameras from outside, with their names, and the baseline."""
    view, _ = _bird()
    lines, labels, centres = [], [], []
    names = zip(cameras(arrangement, WIDTH), ("camera", "second"), ("left", "right"), strict=True)
    for camera, role, name in names:
        rays = camera.pixel_ray(corners(camera))
        far = camera.centre + PYRAMID * rays / (rays @ camera.R[2])[:, None]
        lines.append(Line(view.project(far), role, 2.0, closed=True, fill=0.25))
        edges = [view.project(np.array([camera.centre, corner])) for corner in far]
        lines += [Line(edge, role, 1.5) for edge in edges]
        u, v = view.project(camera.centre).tolist()
        left = name == "left"
        at = (u - 8, v + 13) if left else (u + 12, v - 10)
        labels.append(Label(name, at, role, "end" if left else "start"))
        centres.append(camera.centre)
    baseline = Line(view.project(np.array(centres)), "ink", 3.0)
    return (*lines, baseline), tuple(labels)


def _space(arrangement: str, point: Floats, Z: float) -> Picture:
    """Return the street from above with both cameras, the rays, and the plane of both."""
    view, picture = _bird()
    one, other = (camera.centre for camera in cameras(arrangement, WIDTH))
    beyond = one + min(SHOWN / Z, 20) * (point - one)
    lines, labels = _pyramids(arrangement)
    plane = _seen(view, [one, point, other, one])
    rays = (
        Line(plane, "ray", 0.0, closed=True, fill=0.3),
        Line(_seen(view, [one, beyond]), "ray", 1.5, dashed=True),
        Line(_seen(view, [one, point]), "ray", 2.5),
        Line(_seen(view, [other, point]), "second", 2.0),
    )
    seen = view.project(point)
    spot = (Line(disc(seen, 5), "object", 2.0, closed=True, fill=1.0),)
    inside = bool(((seen >= 0) & (seen <= np.array(SPACE_SIZE))).all())
    return Picture(
        "From above",
        f"Both cameras from above, the ray of the left point, and the candidate {Z:g} m in front "
        "of the left camera; both centres and the candidate span the epipolar plane.",
        SPACE_SIZE,
        picture,
        lines=(*rays, *lines, *(spot if inside else ())),
        labels=labels,
    )


def _patch(arrangement: str, which: int, at: Floats) -> NDArray[np.uint8]:
    """Return the surroundings of a point, `PATCH` px wide, between pixels if need be."""
    import cv2

    picture = photographs(arrangement, WIDTH)[which]
    u, v = at.tolist()
    return np.asarray(cv2.getRectSubPix(picture, (PATCH, PATCH), (u, v)), np.uint8)


def _difference(one: NDArray[np.uint8], other: NDArray[np.uint8]) -> float:
    """Return the mean difference of the grey values of two patches."""
    greys = [patch.astype(float).mean(axis=2) for patch in (one, other)]
    return float(np.abs(greys[0] - greys[1]).mean())


def _patches(left: NDArray[np.uint8], right: NDArray[np.uint8] | None, words: str) -> Picture:
    """Return both patches enlarged, one below the other."""
    import cv2

    page = np.full((NEAR_SIZE[1], NEAR_SIZE[0], 3), 235, np.uint8)
    across = (NEAR_SIZE[0] - SIDE) // 2
    for patch, top in ((left, 4), (right, NEAR_SIZE[1] - SIDE - 4)):
        if patch is not None:
            large = cv2.resize(patch, (SIDE, SIDE), interpolation=cv2.INTER_NEAREST)
            page[top : top + SIDE, across : across + SIDE] = large
    middle = NEAR_SIZE[0] / 2
    labels = (
        Label("left", (middle, 16), "ray", "middle"),
        Label("right", (middle, NEAR_SIZE[1] - SIDE + 8), "object", "middle"),
    )
    return Picture(
        "Alike?",
        f"The surroundings of the left point, enlarged, and below those of the candidate {words}.",
        NEAR_SIZE,
        page,
        labels=labels,
    )
