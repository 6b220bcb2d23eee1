"""Explorers in a page of JupyterLab, and what a reader does with them."""

import cv2
import numpy as np
from explorer_list import EXPLORERS


def cells_with(keys):
    """Return one cell of a notebook for each explorer."""
    found = ((key, *EXPLORERS[key][:2]) for key in keys)
    return [
        f"from course_lib.widgets.{chapter} import {make}\n{key} = {make}()\n{key}"
        for key, chapter, make in found
    ]


def explorer_in(page, key):
    """Return an explorer, in sight."""
    root = page.get_by_role("region", name=EXPLORERS[key][2])
    root.scroll_into_view_if_needed()
    return root


def reset(root):
    """Bring an explorer back to where it starts."""
    root.get_by_role("button", name="Reset").click()
    settle(root)


def settle(root):
    """Wait until no new frame arrives for a moment."""
    page = root.page
    while True:
        frame = root.get_attribute("data-frame")
        page.wait_for_timeout(200)
        if root.get_attribute("data-frame") == frame:
            return


def pixels(picture):
    png = np.frombuffer(picture.screenshot(), np.uint8)
    return cv2.imdecode(png, cv2.IMREAD_COLOR).astype(int)


def photograph(root):
    settle(root)
    return pixels(root.get_by_role("img").first)


def number(text):
    """The number of a text that is typeset: with a minus sign and groups of three."""
    return float(text.replace("\N{MINUS SIGN}", "-").replace("\N{NARROW NO-BREAK SPACE}", ""))


def drag(slider, *stops):
    """Drag a slider's thumb from where it is over places of its track, 0 to 1; let go there."""
    box = slider.bounding_box()
    share = slider.evaluate("(s) => (s.value - s.min) / (s.max - s.min)")
    mouse, middle = slider.page.mouse, box["y"] + box["height"] / 2
    mouse.move(box["x"] + 9 + share * (box["width"] - 18), middle)
    mouse.down()
    for stop in stops:
        mouse.move(box["x"] + stop * box["width"], middle, steps=25)
    mouse.up()
