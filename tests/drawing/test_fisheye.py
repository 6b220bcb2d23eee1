"""The fisheye's pictures: where its circle lies, and what a pinhole sees in it."""

import cv2
import numpy as np

from course_lib import distortion
from course_lib.drawing import distortion as draw
from course_lib.drawing.distortion import fisheye, models, real_fisheye


def test_fisheye_picture_agrees_with_the_pinhole_in_the_middle():
    pinhole, round_picture = fisheye.pinhole_picture(), fisheye.fisheye_picture()
    f = 200 / np.tan(np.radians(55))
    rng = np.random.default_rng(3)
    pixels = rng.uniform(140, 260, (300, 2))
    rays = distortion.fisheye_ray(pixels, fisheye.FISHEYE_K, np.zeros(4))
    there = np.rint(rays[:, :2] / rays[:, 2:] * f + 199.5).astype(int)
    seen = round_picture[np.rint(pixels[:, 1]).astype(int), np.rint(pixels[:, 0]).astype(int)]
    off = np.abs(seen.astype(float) - pinhole[there[:, 1], there[:, 0]]).max(axis=1)
    assert np.median(off) < 8


def test_the_circle_of_the_fisheye_is_filled_and_the_rest_is_black():
    picture = fisheye.fisheye_picture()
    u, v = np.meshgrid(np.arange(400), np.arange(400))
    r = np.hypot(u - 199.5, v - 199.5)
    black = (picture == 0).all(axis=2)
    assert black[r > 201].all()
    assert black[r < 199].mean() < 0.001


def test_a_pinhole_view_looks_along_its_rays():
    picture, K, k, _ = real_fisheye.fisheye_camera()
    view = real_fisheye.pinhole_view(np.radians(100)).astype(float)
    smooth = cv2.blur(np.ascontiguousarray(picture), (3, 3)).astype(float)
    f, middle = 180 / np.tan(np.radians(50)), 179.5
    rng = np.random.default_rng(8)
    pixels = rng.integers(30, 330, (300, 2))
    rays = np.column_stack([(pixels - middle) / f, np.ones(300)])
    u, v = np.rint(distortion.fisheye_project(rays, K, k)).astype(int).T
    off = np.abs(view[pixels[:, 1], pixels[:, 0]] - smooth[v, u]).max(axis=1)
    assert np.median(off) < 10


def test_without_a_network_the_street_is_taken(monkeypatch):
    def gone(name):
        raise real_fisheye.data.Unavailable("not here")

    monkeypatch.setattr(real_fisheye.data, "fetch", gone)
    real_fisheye.fisheye_camera.cache_clear()
    try:
        figure = draw.fisheye_photograph()
    finally:
        real_fisheye.fisheye_camera.cache_clear()
    assert figure.axes[0].get_title(loc="left") == "Fisheye (computed)"


def test_things_are_marked_where_the_street_shows_them():
    """The bulb is bright, its arm dark, before the sky: the mark lies on something, not on sky."""
    places = distortion.fisheye_project(fisheye.things(), fisheye.FISHEYE_K, np.zeros(4))
    picture = fisheye.fisheye_picture().astype(float)
    for u, v in np.rint(places).astype(int):
        around = picture[v - 4 : v + 5, u - 4 : u + 5].reshape(-1, 3)
        assert np.ptp(around, axis=0).max() > 40


def test_grid_of_straight_lines_is_straight():
    for line in models.straight_lines():
        assert distortion.straightness(line) < 1e-9
