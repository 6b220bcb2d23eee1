"""A frame as a message to the browser: words and numbers as JSON, arrays as binary buffers."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from course_lib.drawing.explorers.frame import Frame, Picture
from course_lib.drawing.explorers.marks import Marks

JPEG_QUALITY = 90
LUMA = np.array([0.299, 0.587, 0.114])  # brightness from R, G, B
#: U and V from R, G, B and 1, under a row of zeros: OpenCV is fast with three rows.
CHROMA = np.zeros((3, 4))
for row, colour in ((1, 2), (2, 0)):
    CHROMA[row, :3] = 112 / 255 * (np.eye(3)[colour] - LUMA) / (1 - LUMA[colour])
    CHROMA[row, 3] = 128


def encode_frame(
    frame: Frame, raw: bool = False, before: Frame | None = None
) -> tuple[dict[str, Any], list[bytes]]:
    """Encode a frame for the browser.

    Parameters
    ----------
    frame : Frame
        What to show.
    raw : bool
        Send photographs as plain bytes, not JPEG: more to carry, nothing to decode, so faster
        when the browser is on the same machine. Pictures of odd width or height stay JPEG.
    before : Frame, optional
        What the browser already shows; a photograph that is the same array is not sent again.

    Returns
    -------
    message : dict
        JSON. ``start`` counts in the numbers of ``buffers[0]``, ``image`` in `buffers`; it is
        ``"same"`` for a photograph that is there already.
    buffers : list of bytes
        First every point and grid, ``float32``; then the photographs.
    """
    numbers = _Numbers()
    photographs: list[NDArray[np.uint8]] = []
    pictures = []
    for place, picture in enumerate(frame.pictures):
        image: int | str | None = None
        if picture.image is not None:
            image = "same" if _shown(picture, before, place) else len(photographs) + 1
            photographs += [] if image == "same" else [picture.image]
        pictures.append(_encode_picture(picture, image, numbers))
    raw = raw and all(length % 2 == 0 for p in frame.pictures for length in p.size)
    message = {
        "pictures": pictures,
        "readouts": [vars(r) | {"quantity": r.quantity} for r in frame.readouts],
        "follows": dict(frame.follows),
        "raw": raw,
    }
    return message, [numbers.packed(), *map(i420 if raw else jpeg, photographs)]


def _shown(picture: Picture, before: Frame | None, place: int) -> bool:
    """Return whether the picture at this place of the frame before is the same array."""
    if before is None or place >= len(before.pictures):
        return False
    return before.pictures[place].image is picture.image


class _Numbers:
    """Arrays behind one another, so that a frame needs one buffer for all of them."""

    def __init__(self) -> None:
        self._arrays: list[NDArray[np.float32]] = []
        self._length = 0

    def add(self, values: ArrayLike) -> dict[str, int]:
        """Append an array; return where it starts and how many numbers it has."""
        array = np.asarray(values, dtype="<f4").ravel()
        place = {"start": self._length, "count": array.size}
        self._arrays.append(array)
        self._length += array.size
        return place

    def packed(self) -> bytes:
        """Return all arrays as one."""
        return b"".join(array.tobytes() for array in self._arrays)


def _encode_picture(picture: Picture, image: int | str | None, numbers: _Numbers) -> dict[str, Any]:
    """Encode one picture whose photograph is buffer number `image`."""
    return {
        "title": picture.title,
        "alt": picture.alt,
        "size": list(picture.size),
        "pixels": picture.pixels,
        "image": image,
        "lines": [vars(line) | {"points": numbers.add(line.points)} for line in picture.lines],
        "labels": [vars(label) for label in picture.labels],
        "handles": [vars(handle) for handle in picture.handles],
        "marks": picture.marks and _encode_marks(picture.marks, numbers),
        "trails": [
            vars(trail) | {"A": trail.A.tolist(), "e": trail.e.tolist()} for trail in picture.trails
        ],
        "probes": [
            vars(probe)
            | {
                "values": numbers.add(probe.values),
                "shape": list(probe.values.shape),
                "gap": "" if probe.unit == "°" else " ",
            }
            for probe in picture.probes
        ],
    }


def _encode_marks(marks: Marks, numbers: _Numbers) -> dict[str, Any]:
    """Encode points that say what they are."""
    return vars(marks) | {
        "points": numbers.add(marks.points),
        "values": numbers.add(marks.values),
        "gaps": ["" if unit in ("", "°") else " " for unit in marks.units],
    }


def i420(image: NDArray[np.uint8]) -> bytes:
    """Return an RGB picture as brightness of every pixel and colour of every 2 x 2 pixels.

    Parameters
    ----------
    image : ndarray, shape (height, width, 3), uint8
        RGB; width and height even.

    Returns
    -------
    bytes
        Planes Y, U and V, 3 / 2 bytes a pixel. A colour is the mean of its four pixels.

    References
    ----------
    ITU-R BT.601, limited range; I420 of the WebCodecs specification.
    """
    import cv2

    height, width, _ = image.shape
    planes = cv2.cvtColor(image, cv2.COLOR_RGB2YUV_I420)  # each colour that of one pixel
    means = cv2.resize(image, (width // 2, height // 2), interpolation=cv2.INTER_AREA)
    _, *colours = cv2.split(cv2.transform(means, CHROMA))
    planes[height:] = np.reshape(colours, (-1, width))
    return bytes(planes.tobytes())


def jpeg(image: NDArray[np.uint8]) -> bytes:
    """Return an RGB picture as JPEG.

    Parameters
    ----------
    image : ndarray, shape (height, width, 3), uint8
        RGB.

    Returns
    -------
    bytes
        The file.
    """
    import cv2

    bgr = cv2.cvtColor(image, cv2.COLOR_RGB2BGR)
    done, data = cv2.imencode(".jpg", bgr, [cv2.IMWRITE_JPEG_QUALITY, JPEG_QUALITY])
    if not done:
        raise ValueError(f"OpenCV could not encode a picture of shape {image.shape} as JPEG")
    return bytes(data.tobytes())
