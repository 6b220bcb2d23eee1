"""Cards one behind the other on a road, to see by eye what a lens shows sharply.

The cards stand at 0.5, 1, 2, 4 and 8 m and are as many times larger, so that a pinhole camera
shows all of them equally large and only sharpness tells them apart.
"""

from __future__ import annotations

from functools import cache

import numpy as np
from numpy.typing import NDArray

from course_lib.camera import Camera, camera_at
from data_generators.bodies import at, solid
from data_generators.lens import Lens
from data_generators.places import painted_ground, shadows, street
from data_generators.quick import QuickRenderer
from data_generators.scene import Colour, Patch, Scene, Texture, check_texture, polygon
from data_generators.targets import bar_target, checkerboard, dot_grid, letter_chart, siemens_star

DISTANCES = (0.5, 1.0, 2.0, 4.0, 8.0)  # m, from the camera
COLOURS: tuple[Colour, ...] = (
    (213, 94, 0),
    (0, 114, 178),
    (0, 158, 115),
    (204, 121, 167),
    (230, 159, 0),
)  # frames of the cards, told apart by colour-blind eyes too (M. Okabe, K. Ito, 2002)
EYE = 0.35  # m: height of the camera above the road
SIDE = 0.14  # width of a card by its distance
PLACES = ((-0.225, -0.02), (0.225, 0.0), (-0.1, 0.03), (0.12, 0.045), (0.0, 0.09))
END = 40.0  # m: everything farther is a picture on a screen
SCREEN = (100.0, 30.0)  # m: its width and height
CARD = 384  # px: side of a card's texture
PLATE = 72  # px of it: the plate with the distance


@cache
def staggered() -> Scene:
    """Return the road with the cards, their distances written below, and the street behind.

    Returns
    -------
    Scene
        World: x right, y along the camera's axis, z up, m; the lens is above the origin, at
        `EYE`, so that the distance Z of a card is its y. The same scene every time.
    """
    rng = np.random.default_rng(2026)
    faces = (
        siemens_star(CARD, 36),
        checkerboard(11, 11, 32),
        letter_chart(CARD, 7, rng=rng),
        bar_target(CARD),
        dot_grid(10, 10, 38),
    )
    bodies = [
        card(Z, place, face, colour)
        for Z, place, face, colour in zip(DISTANCES, PLACES, faces, COLOURS, strict=True)
    ]
    outlines = [outline for body in bodies for outline in shadows(body)]
    near = painted_ground((-4, 0, 4, 10), 96, outlines, rng)
    far = painted_ground((-25, 10, 25, END), 12, outlines, rng)
    sides = [
        Patch(at(west, 10, 0), at(21, 0, 0), at(0, -10, 0), solid((126, 158, 88)))
        for west in (-25.0, 4.0)
    ]
    return Scene(
        (screen(), far, *sides, near, *(patch for body in bodies for patch in body)),
        (196, 216, 232),
    )


def card(
    Z: float, place: tuple[float, float], face: NDArray[np.uint8], colour: Colour
) -> list[Patch]:
    """Return a card that faces the camera, on two legs.

    Parameters
    ----------
    Z : float
        Its distance from the lens, m.
    place : tuple of float
        Where its middle is seen, to the right and up, by distance.
    face : ndarray, shape (h, w), uint8
        What is on it.
    colour : tuple of int
        Of its frame.

    Returns
    -------
    list of Patch
        The card and its legs.
    """
    middle = at(place[0] * Z, Z, EYE + place[1] * Z)
    texture = labelled(face, f"{Z:g} m", colour)
    width = SIDE * Z
    height = width * texture.shape[0] / texture.shape[1]
    corner = middle + at(-width / 2, 0, height / 2)
    patches = [Patch(corner, at(width, 0, 0), at(0, 0, -height), texture)]
    foot = middle[2] - height / 2
    for side in (-0.4, 0.4):
        left, thick = middle[0] + side * width, 0.012 * Z
        legs = [(left, Z, foot), (left + thick, Z, foot), (left + thick, Z, 0), (left, Z, 0)]
        patches += [polygon(legs, (92, 84, 76))] if foot > 0 else []
    return patches


def labelled(face: NDArray[np.uint8], text: str, colour: Colour) -> Texture:
    """Return a card's texture: the face and a plate with a text, in a frame of one colour."""
    import cv2

    side = CARD - 24
    picture = np.empty((CARD + PLATE, CARD, 3), np.uint8)
    picture[:] = linear(colour)
    reduced = cv2.resize(face, (side, side), interpolation=cv2.INTER_AREA)
    picture[12 : 12 + side, 12 : 12 + side] = np.minimum(reduced, 225)[..., None]
    font, size, thick = cv2.FONT_HERSHEY_SIMPLEX, 2.0, 5
    (width, height), _ = cv2.getTextSize(text, font, size, thick)
    start = ((CARD - width) // 2, CARD + (PLATE - 12 + height) // 2 - 4)
    cv2.putText(picture, text, start, font, size, (250, 250, 250), thick, cv2.LINE_AA)
    return check_texture(picture)


def linear(colour: Colour) -> Texture:
    """Return a colour as the light it stands for, by a screen's gamma of 2.2."""
    return check_texture(np.rint(255 * (np.array(colour) / 255) ** 2.2).astype(int))


def screen() -> Patch:
    """Return the street as it looks from the camera, on a screen across the end of the road."""
    columns, rows = 2560, 768
    width, height = SCREEN
    scale = columns / width * END  # px, focal length of the camera that takes it
    horizon = (height - EYE) / height * rows - 0.5
    K = np.array([[scale, 0, (columns - 1) / 2], [0, rows / height * END, horizon], [0, 0, 1]])
    camera = camera_at((0, 0, EYE), (0, 1, EYE), K, (columns, rows))
    picture = QuickRenderer(street(targets=False), subpixels=2).picture(camera)
    corner = at(-width / 2, END, height)
    return Patch(corner, at(width, 0, 0), at(0, 0, -height), picture)


def staggered_camera(lens: Lens, pitch: float, image_size: tuple[int, int] = (640, 480)) -> Camera:
    """Return the camera before the cards, focused as its lens is.

    Parameters
    ----------
    lens : Lens
        Its lens.
    pitch : float
        Size of a pixel, mm.
    image_size : tuple of int
        Width and height, px.

    Returns
    -------
    Camera
        Its axis is level and along y.

    Raises
    ------
    TypeError, ValueError
        As `Lens.intrinsics`.
    """
    return camera_at((0, 0, EYE), (0, 1, EYE), lens.intrinsics(pitch, image_size), image_size)
