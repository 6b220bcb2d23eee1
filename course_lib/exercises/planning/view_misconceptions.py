"""Wrong answers to the exercises of chapter 11 on boxes in view."""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np

SIGNS = np.array(list(product((-1, 1), repeat=3)))

# --- box_in_view ------------------------------------------------------------------------------


def corners_of(centre: Any, half: Any) -> Any:
    return centre + half * SIGNS


def seen_by(P: Any, corners: Any) -> Any:
    return P @ np.column_stack([corners, np.ones(len(corners))]).T


def room(seen: Any, image_size: Any) -> Any:
    """Return the right answer for points given by their homogeneous pixels."""
    a, b, w = seen
    if (w <= 0).any():
        return np.full(4, -np.inf)
    u, v = a / w, b / w
    width, height = image_size
    far = width - 0.5 - u.max(), height - 0.5 - v.max()
    return np.array([u.min() + 0.5, far[0], v.min() + 0.5, far[1]])


def room_around(centre: Any, half: Any, P: Any, image_size: Any) -> Any:
    return room(seen_by(P, corners_of(centre, half)), image_size)


def motion_forgotten(size, centre, motion, P, image_size):
    return room_around(centre, size / 2, P, image_size)


def motion_shared(size, centre, motion, P, image_size):
    return room_around(centre, (size + motion) / 2, P, image_size)


def motion_counted_twice(size, centre, motion, P, image_size):
    return room_around(centre, size / 2 + 2 * motion, P, image_size)


def motion_to_one_side(size, centre, motion, P, image_size):
    return room_around(centre + motion / 2, (size + motion) / 2, P, image_size)


def motion_to_the_other_side(size, centre, motion, P, image_size):
    return room_around(centre - motion / 2, (size + motion) / 2, P, image_size)


def motion_taken_off(size, centre, motion, P, image_size):
    return room_around(centre, size / 2 - motion, P, image_size)


def whole_edges_to_each_side(size, centre, motion, P, image_size):
    return room_around(centre, size + motion, P, image_size)


def whole_edges_and_twice_the_motion(size, centre, motion, P, image_size):
    return room_around(centre, size + 2 * motion, P, image_size)


def begins_at_the_middle(size, centre, motion, P, image_size):
    moved = size + 2 * motion
    return room_around(centre + moved / 2, moved / 2, P, image_size)


def only_the_middle(size, centre, motion, P, image_size):
    return room_around(centre, 0 * size, P, image_size)


def two_corners(size, centre, motion, P, image_size):
    half = size / 2 + motion
    return room(seen_by(P, np.array([centre - half, centre + half])), image_size)


def one_face(size, centre, motion, P, image_size):
    corners = corners_of(centre, size / 2 + motion)
    return room(seen_by(P, corners[::2]), image_size)


def other_face(size, centre, motion, P, image_size):
    corners = corners_of(centre, size / 2 + motion)
    return room(seen_by(P, corners[1::2]), image_size)


def place_forgotten(size, centre, motion, P, image_size):
    return room_around(0 * centre, size / 2 + motion, P, image_size)


def pixels_of(size: Any, centre: Any, motion: Any, P: Any, image_size: Any) -> Any:
    a, b, w = seen_by(P, corners_of(centre, size / 2 + motion))
    return None if (w <= 0).any() else (a / w, b / w, *image_size)


def half_pixels_forgotten(size, centre, motion, P, image_size):
    if (found := pixels_of(size, centre, motion, P, image_size)) is None:
        return np.full(4, -np.inf)
    u, v, width, height = found
    return np.array([u.min(), width - u.max(), v.min(), height - v.max()])


def last_pixel_for_the_edge(size, centre, motion, P, image_size):
    if (found := pixels_of(size, centre, motion, P, image_size)) is None:
        return np.full(4, -np.inf)
    u, v, width, height = found
    return np.array([u.min(), width - 1 - u.max(), v.min(), height - 1 - v.max()])


def half_pixel_on_one_side(size, centre, motion, P, image_size):
    if (found := pixels_of(size, centre, motion, P, image_size)) is None:
        return np.full(4, -np.inf)
    u, v, width, height = found
    return np.array([u.min() + 0.5, width - u.max(), v.min() + 0.5, height - v.max()])


def half_pixel_the_other_way(size, centre, motion, P, image_size):
    if (found := pixels_of(size, centre, motion, P, image_size)) is None:
        return np.full(4, -np.inf)
    u, v, width, height = found
    far = width + 0.5 - u.max(), height + 0.5 - v.max()
    return np.array([u.min() - 0.5, far[0], v.min() - 0.5, far[1]])


def nearest_to_the_wrong_edge(size, centre, motion, P, image_size):
    if (found := pixels_of(size, centre, motion, P, image_size)) is None:
        return np.full(4, -np.inf)
    u, v, width, height = found
    far = width - 0.5 - u.min(), height - 0.5 - v.min()
    return np.array([u.max() + 0.5, far[0], v.max() + 0.5, far[1]])


def far_sides_negative(size, centre, motion, P, image_size):
    left, right, top, bottom = room_around(centre, size / 2 + motion, P, image_size)
    return np.array([left, -right, top, -bottom])


def size_exchanged(size, centre, motion, P, image_size):
    return room_around(centre, size / 2 + motion, P, image_size[::-1])


def top_and_bottom_exchanged(size, centre, motion, P, image_size):
    left, right, top, bottom = room_around(centre, size / 2 + motion, P, image_size)
    return np.array([left, right, bottom, top])


def left_and_right_exchanged(size, centre, motion, P, image_size):
    left, right, top, bottom = room_around(centre, size / 2 + motion, P, image_size)
    return np.array([right, left, top, bottom])


def order_of_a_frame(size, centre, motion, P, image_size):
    left, right, top, bottom = room_around(centre, size / 2 + motion, P, image_size)
    return np.array([left, top, right, bottom])


def division_forgotten(size, centre, motion, P, image_size):
    a, b, w = seen_by(P, corners_of(centre, size / 2 + motion))
    return room((a, b, np.where(w > 0, 1, -1)), image_size)


def yes_or_no(size, centre, motion, P, image_size):
    return bool((room_around(centre, size / 2 + motion, P, image_size) >= 0).all())


def smallest_only(size, centre, motion, P, image_size):
    return float(room_around(centre, size / 2 + motion, P, image_size).min())


def room_not_below_zero(size, centre, motion, P, image_size):
    return np.maximum(room_around(centre, size / 2 + motion, P, image_size), 0)


def behind_is_before(size, centre, motion, P, image_size):
    a, b, w = seen_by(P, corners_of(centre, size / 2 + motion))
    return room((a / w, b / w, np.ones(8)), image_size)


def behind_left_out(size, centre, motion, P, image_size):
    a, b, w = seen_by(P, corners_of(centre, size / 2 + motion))
    before = w > 0
    return room((a[before], b[before], w[before]), image_size)


def behind_turned_round(size, centre, motion, P, image_size):
    a, b, w = seen_by(P, corners_of(centre, size / 2 + motion))
    return room((a, b, np.abs(w)), image_size)


def nan_for_behind(size, centre, motion, P, image_size):
    found = room_around(centre, size / 2 + motion, P, image_size)
    return found if np.isfinite(found).all() else np.full(4, np.nan)


def below_the_ground(size, centre, motion, P, image_size):
    corners = corners_of(centre, size / 2 + motion)
    if (corners[:, 2] <= 0).any():
        return np.full(4, -np.inf)
    a, b, w = seen_by(P, corners)
    return room((a / w, b / w, np.ones(8)), image_size)


def one_number_for_behind(size, centre, motion, P, image_size):
    found = room_around(centre, size / 2 + motion, P, image_size)
    return found if np.isfinite(found).all() else -np.inf
