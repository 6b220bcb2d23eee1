import cv2
import numpy as np
import pytest

from course_lib.camera import Camera, image_centre
from course_lib.optics import circle_of_confusion
from course_lib.transforms import rotation_about_axis
from data_generators.defocus import DefocusedView, levels
from data_generators.lens import Lens
from data_generators.quick import QuickRenderer
from data_generators.render import photograph, radiance
from data_generators.scene import Patch, Scene
from data_generators.shot import Shot
from data_generators.targets import checkerboard, dot_grid

PITCH = 0.05  # mm
SIZE = (96, 80)
DISTANCES = (0.5, 1.0, 2.0, 4.0)  # m, of the cards of `steps`
HALVES = ((-4, np.array((0, 0, 0))), (0, np.array((255, 255, 255))))
PLACES = (-0.24, 0.24, -0.1, 0.1)  # to the right, by distance


def card(Z, side, colour=(255, 255, 255), middle=(0, 0)):
    """A square that faces a camera at the origin, its side in m."""
    corner = np.array([middle[0] - side / 2, middle[1] - side / 2, Z])
    return Patch(corner, (side, 0, 0), (0, side, 0), np.array(colour))


def camera_of(lens, size=SIZE, pitch=PITCH):
    return Camera(lens.intrinsics(pitch, size), np.eye(3), np.zeros(3), size)


def steps():
    """Checkered cards at several distances, equally large in the picture, in a hall."""
    board = checkerboard(6, 6, 32)
    cards = [
        Patch(((x - 0.08) * Z, -0.08 * Z, Z), (0.16 * Z, 0, 0), (0, 0.16 * Z, 0), board)
        for x, Z in zip(PLACES, DISTANCES, strict=True)
    ]
    wall = Patch((-9, -9, 12), (18, 0, 0), (0, 18, 0), dot_grid(24, 24, 32))
    floor = Patch((-9, 0.4, 12), (18, 0, 0), (0, 0, -11.8), board // 2, repeat=(18.0, 12.0))
    return Scene((wall, floor, *cards), (40, 60, 80))


def take(engine, scene, camera, lens, samples=6):
    if engine == "quick":
        return DefocusedView(scene, subpixels=8).picture(camera, lens) / 255
    return radiance(scene, camera, samples, Shot(lens=lens))


def spread(light, side):
    """Diameter of a uniform disk from its second moment, D = 4 sigma; the lamp's taken off, px."""
    grey = light.sum(axis=2)
    variances = []
    for axis in np.indices(grey.shape):
        mean = (grey * axis).sum() / grey.sum()
        variances.append((grey * (axis - mean) ** 2).sum() / grey.sum())
    return 4 * np.sqrt(max(0, np.mean(variances) - side**2 / 12 - 1 / 12))


@pytest.mark.parametrize("engine", ["quick", "rays"])
class TestBothEngines:
    @pytest.mark.parametrize(
        ("focus", "N", "Z"), [(2000, 2, 1.0), (1000, 4, 3.0), (1000, 1.4, 1.3), (np.inf, 2, 0.9)]
    )
    def test_disk_of_a_point(self, engine, focus, N, Z):
        lens = Lens(50, N, focus)
        camera, side = camera_of(lens), 3  # px
        scene = Scene((card(Z, side * Z / camera.K[0, 0]),), (0, 0, 0))
        expected = float(circle_of_confusion(1000 * Z, focus, 50, N)) / PITCH
        assert 3 < expected < 30
        light = take(engine, scene, camera, lens)
        assert spread(light, side) == pytest.approx(expected, rel=0.04)
        # Spread out, but not lost.
        sharp = take(engine, scene, camera, Lens(50, 1000, focus))
        assert light.sum() == pytest.approx(sharp.sum(), rel=0.05)

    @pytest.mark.parametrize("Z", [0.8, 3.0])
    def test_edge(self, engine, Z):
        # An edge seen through a disk rises from 0 to 1 over its diameter, half of it in the middle.
        lens = Lens(50, 1.4, 1200)
        camera = camera_of(lens)
        scene = Scene((card(Z, 2.0, middle=(1, 0)),), (0, 0, 0))
        row = take(engine, scene, camera, lens)[38:42, :, 0].mean(axis=0)
        D = float(circle_of_confusion(1000 * Z, 1200, 50, 1.4)) / PITCH
        x = np.arange(SIZE[0]) - image_centre(SIZE)[0]
        s = np.clip(2 * x / D, -1, 1)
        expected = 0.5 + (np.arcsin(s) + s * np.sqrt(1 - s**2)) / np.pi  # share of a disk
        assert D > 7
        np.testing.assert_allclose(row, expected, atol=0.05)
        # The quick engine's disks have soft rims: the same second moment, a steeper middle.
        rel = {"rays": 0.05, "quick": 0.13}[engine]
        middle = np.abs(x) < 0.3 * D
        slope = np.polyfit(x[middle], row[middle], 1)[0]
        assert slope == pytest.approx(np.polyfit(x[middle], expected[middle], 1)[0], rel=rel)

    def test_slanted_surface(self, engine):
        # A floor, black to the left and white to the right: the border runs away from the camera
        # and is blurred by another disk in each row. Its derivative has the disk's variance.
        lens, size, height = Lens(50, 1.4, 1000), (96, 128), 0.05
        camera = camera_of(lens, size)
        halves = [Patch((x, height, 9), (4, 0, 0), (0, 0, -8.6), c) for x, c in HALVES]
        light = take(engine, Scene((*halves,), (0, 0, 0)), camera, lens)[..., 1]
        rows = np.array([78, 88, 98, 108, 118])
        Z = camera.K[1, 1] * height / (rows - camera.K[1, 2])
        D = lens.disks(Z, camera)
        x = np.arange(size[0] - 1) - (size[0] - 2) / 2
        for row, expected in zip(rows, D, strict=True):
            slope = np.diff(light[row - 1 : row + 2].mean(axis=0))
            slope[np.abs(x) > 24] = 0
            variance = (slope * x**2).sum() / slope.sum()
            measured = 4 * np.sqrt(max(0, variance - 1 / 12))
            assert measured == pytest.approx(expected, rel=0.12, abs=0.7)
        assert D.min() < 4
        assert D.max() > 14

    def test_looks_past_a_near_edge(self, engine):
        # Sharp stripes behind a near edge: each point of them is seen by the part of the lens
        # that the near card leaves free, also beyond the edge that a pinhole sees.
        lens = Lens(50, 1.4, 2000)
        camera = camera_of(lens)
        side = 4 * 2 / camera.K[0, 0]  # 4 px
        stripes = [
            Patch((k * side, -1, 2), (side, 0, 0), (0, 2, 0), np.array((200, 200, 200)))
            for k in range(-12, 12, 2)
        ]
        near = card(0.8, 2, (80, 0, 0), (1, 0))
        light = take(engine, Scene((*stripes, near), (0, 0, 0)), camera, lens)
        row = light[36:44, :, 1].mean(axis=0)
        x = np.arange(SIZE[0]) - image_centre(SIZE)[0]
        s = np.clip(2 * x / float(lens.disks(0.8, camera)), -1, 1)
        free = 0.5 - (np.arcsin(s) + s * np.sqrt(1 - s**2)) / np.pi
        seen = np.isin(x % 8, (1.5, 2.5)) & (np.abs(x) < 40)
        np.testing.assert_allclose(row[seen], (free * 200 / 255)[seen], atol=0.06)
        assert row[seen & (x > 0)].max() > 0.05
        between = np.isin(x % 8, (5.5, 6.5)) & (np.abs(x) < 40)
        assert row[between].max() < 0.06

    def test_sharp_where_focused(self, engine):
        lens = Lens(50, 1.4, 2000)
        camera = camera_of(lens)
        scene = Scene((card(2, 20 * 2 / camera.K[0, 0]),), (0, 0, 0))
        row = take(engine, scene, camera, lens)[40, :, 0]
        assert row[:36].max() < 0.03
        assert row[40:56].min() > 0.97

    def test_determinism(self, engine):
        lens = Lens(50, 2, 1000)
        camera = camera_of(lens, (64, 48), 0.5)
        one, other = (take(engine, steps(), camera, lens, 2) for _ in range(2))
        np.testing.assert_array_equal(one, other)


class TestQuick:
    def test_levels(self):
        assert levels(3.0, 3.2) == pytest.approx([3.1])
        many = levels(0.0, 40.0)
        assert many[0] == 0
        assert many[-1] == pytest.approx(40)
        assert ((many[1:] + 2) / (many[:-1] + 2)).max() < 1.5

    @pytest.mark.parametrize(("focus", "rms", "rms_of_means"), [(600, 10, 3.5), (3000, 14, 2.6)])
    def test_is_the_picture_of_the_rays(self, focus, rms, rms_of_means):
        # Disks that are 30 % too large or too small would be beyond both, or one, of the limits.
        lens, size = Lens(50, 2, focus), (120, 90)
        camera = camera_of(lens, size, 0.3)
        view = DefocusedView(steps(), subpixels=4, breathes=False)
        rays = photograph(steps(), camera, shot=Shot(lens=lens), samples=5)
        error = view.picture(camera, lens).astype(float) - rays  # grey levels of 255
        # Where it is sharp, the quick texture differs as in QuickRenderer: look at means, too.
        assert np.sqrt(np.mean(error**2)) < rms
        means = cv2.blur(error, (7, 7))
        assert np.sqrt(np.mean(means**2)) < rms_of_means
        assert np.abs(means).max() < 22
        assert np.abs(error.mean()) < 1

    def test_another_camera_another_picture(self):
        # Layers are kept from picture to picture: the order of pictures must not matter.
        view = DefocusedView(steps())
        lenses = [Lens(50, 2, 1000), Lens(35, 2, 1000), Lens(50, 8, 3000)]
        cameras = [camera_of(lens, (96, 72), 0.4) for lens in lenses]
        K, size, turn = cameras[0].K, (96, 72), rotation_about_axis((0, 1, 0), 0.2)
        cameras += [Camera(K, turn, np.zeros(3), size), Camera(K, np.eye(3), [0.2, 0, 0], size)]
        lenses += [lenses[0]] * 2
        first = [view.picture(c, lens) for c, lens in zip(cameras, lenses, strict=True)]
        assert view.picture(cameras[0], lenses[0]).shape == (72, 96, 3)
        for camera, lens, picture in zip(cameras, lenses, first, strict=True):
            fresh = DefocusedView(steps()).picture(camera, lens)
            np.testing.assert_array_equal(picture, fresh)

    def test_breathing(self):
        # Magnified from the view at infinity, or drawn anew: the same but for the resampling.
        lens = Lens(50, 11, 500)
        camera = camera_of(lens, (240, 180), 0.15)
        magnified = DefocusedView(steps()).picture(camera, lens).astype(float)
        anew = DefocusedView(steps(), breathes=False).picture(camera, lens)
        difference = cv2.blur(magnified - anew, (5, 5))
        assert np.sqrt(np.mean(difference**2)) < 4

    def test_zooming(self):
        # Whatever the focal length and the pitch: the picture of a view that is drawn for it,
        # and not that of the views before it.
        zooming, anew = (
            DefocusedView(steps(), zooms=True, margin=2),
            DefocusedView(steps(), breathes=False),
        )
        pictures = []
        for f, pitch in ((53, 0.15), (57, 0.15), (35, 0.2), (53, 0.15)):
            lens = Lens(f, 11, 700)
            camera = camera_of(lens, (240, 180), pitch)
            pictures.append(zooming.picture(camera, lens))
            difference = cv2.blur(pictures[-1].astype(float) - anew.picture(camera, lens), (5, 5))
            assert np.sqrt(np.mean(difference**2)) < 6  # corners half a pixel away
        np.testing.assert_array_equal(pictures[0], pictures[-1])

    def test_a_zooming_view_is_seldom_drawn(self, monkeypatch):
        drawn, draw = [], QuickRenderer.pieces
        monkeypatch.setattr(
            QuickRenderer, "pieces", lambda *given: drawn.append(given) or draw(*given)
        )
        view = DefocusedView(steps(), zooms=True)
        for f in [*range(40, 80, 2), *range(40, 80, 2)]:
            lens = Lens(f, 4, 1000)
            view.picture(camera_of(lens, (96, 72), 0.4), lens)
        assert len(drawn) <= 6  # 1.15 ** 5 > 2

    def test_nothing_to_see(self):
        lens = Lens(50, 2, 1000)
        picture = DefocusedView(Scene((), (1, 2, 3))).picture(camera_of(lens), lens)
        assert (picture == (1, 2, 3)).all()

    def test_closed_scene_has_no_seams(self):
        # Floor and wall of one grey, cut into many layers: nothing of the background shines
        # through, however much they are blurred.
        grey = np.array((90, 90, 90))
        floor = Patch((-50, 0.4, 0), (100, 0, 0), (0, 0, 60), grey)
        wall = Patch((-50, -50, 40), (100, 0, 0), (0, 100, 0), grey)
        for focus, N in ((400, 1.4), (3000, 1.4), (np.inf, 4)):
            lens = Lens(50, N, focus)
            view = DefocusedView(Scene((floor, wall), (255, 255, 255)))
            picture = view.picture(camera_of(lens, (160, 128)), lens)
            assert np.abs(picture[8:-8, 8:-8].astype(int) - 90).max() <= 6

    def test_only_the_focused_card_is_sharp(self):
        def contrast(focus, Z):
            lens = Lens(50, 2, 1000 * focus)
            camera = camera_of(lens, (320, 240), 0.12)
            picture = view.picture(camera, lens)[..., 1].astype(float)
            u, v = camera.K[:2, 2] + camera.K[0, 0] * np.array([PLACES[DISTANCES.index(Z)], 0])
            part = picture[int(v) - 20 : int(v) + 20, int(u) - 20 : int(u) + 20]
            return np.abs(np.diff(part, axis=1)).mean()

        view = DefocusedView(steps())
        for Z in DISTANCES:
            seen = {focus: contrast(focus, Z) for focus in (*DISTANCES, 8.0)}
            assert max(seen, key=seen.get) == Z
