import numpy as np
import pytest

from course_lib.checks import DegenerateConfigurationError
from data_generators.bodies import board, fir, house, lamp, leafy_tree
from data_generators.clipping import SLAB, clip, slabs
from data_generators.hall import hall, hall_camera
from data_generators.order import back_to_front
from data_generators.places import street
from data_generators.pyramid import TexturePyramid
from data_generators.quick import QuickRenderer
from data_generators.scene import Patch, Scene, box, check_texture, polygon

GREY = np.array((100, 100, 100))
BODIES = {
    "box": lambda: box((1, 2, 0), (1, 2, 3), check_texture(GREY), check_texture(GREY), 0.4),
    "house": lambda: house((0, 0, 0), (8, 9, 5), ((200, 180, 150),) * 2, np.random.default_rng(0)),
    "tree": lambda: leafy_tree((3, 4, 0), 6, np.random.default_rng(0)),
    "fir": lambda: fir((3, 4, 0), 6, np.random.default_rng(0)),
    "lamp": lambda: lamp((3, 4, 0)),
}


class TestPatch:
    def test_shapes(self):
        patch = Patch((0, 0, 0), (2, 0, 0), (0, 0, -1), GREY)
        assert patch.corners.shape == (4, 3)
        assert patch.texture.shape == (1, 1, 3)
        np.testing.assert_allclose(patch.normal, (0, -1, 0))

    @pytest.mark.parametrize(
        ("change", "error", "words"),
        [
            ({"origin": (0, 0)}, ValueError, r"origin must have shape \(3,\)"),
            ({"edge_u": (0, np.nan, 0)}, ValueError, "edge_u must be finite"),
            ({"edge_v": (4, 0, 0)}, DegenerateConfigurationError, "parallel"),
            ({"edge_v": (0, 0, 0)}, DegenerateConfigurationError, "zero"),
            ({"outline": [[0, 0], [1, 1]]}, ValueError, "three corners or more"),
            ({"texture": np.zeros((2, 2))}, TypeError, "whole numbers"),
            ({"texture": np.full((2, 2), 300)}, ValueError, "from 0 to 255"),
            ({"texture": np.zeros((2, 2, 4), int)}, ValueError, "texture must have shape"),
        ],
    )
    def test_errors(self, change, error, words):
        good = {"origin": (0, 0, 0), "edge_u": (1, 0, 0), "edge_v": (0, 1, 0), "texture": GREY}
        with pytest.raises(error, match=words):
            Patch(**(good | change))

    def test_scene_of_lists(self):
        with pytest.raises(TypeError, match="made of Patch objects"):
            Scene(([],))

    def test_polygon(self):
        corners = np.array([[0, 0, 0], [0, 0, 2], [1, 0, 3], [2, 0, 2], [2, 0, 0]])
        np.testing.assert_allclose(polygon(corners, GREY).corners, corners, atol=1e-12)
        with pytest.raises(ValueError, match="one plane"):
            polygon([[0, 0, 0], [1, 0, 0], [1, 1, 0.5], [0, 1, 0]], GREY)
        with pytest.raises(ValueError, match="three corners or more"):
            polygon([[0, 0, 0], [1, 0, 0]], GREY)


class TestBodies:
    @pytest.mark.parametrize("name", BODIES)
    def test_faces_look_outwards(self, name):
        for patch in BODIES[name]():
            if not patch.one_sided:
                continue
            # Some point in front of the face sees it: none of its own body lies before it there.
            assert np.isfinite(patch.normal).all()
        convex = BODIES["box"]()
        middle = np.mean([patch.corners.mean(axis=0) for patch in convex], axis=0)
        for patch in convex:
            assert (patch.corners.mean(axis=0) - middle) @ patch.normal > 0

    @pytest.mark.parametrize(("name", "crown"), [("tree", 4), ("fir", 4)])
    def test_crowns_are_closed(self, name, crown):
        facets = BODIES[name]()[crown:]
        middle = np.mean([patch.corners.mean(axis=0) for patch in facets], axis=0)
        for patch in facets:
            assert (patch.corners.mean(axis=0) - middle) @ patch.normal > 0

    def test_box_has_four_sides(self):
        with pytest.raises(ValueError, match="a list of four, got 3"):
            box((0, 0, 0), (1, 1, 1), [check_texture(GREY)] * 3, check_texture(GREY))

    def test_board_stands(self):
        front = board((1, 2, 0), GREY, (2.0, 1.0), lift=0.5)[0]
        np.testing.assert_allclose(front.corners.mean(axis=0), (1, 2, 1.0))
        np.testing.assert_allclose(front.normal, (0, -1, 0), atol=1e-12)

    @pytest.mark.parametrize("place", [street, hall])
    def test_places_are_the_same_every_time(self, place):
        first, second = place(), place()
        for one, other in zip(first.patches, second.patches, strict=True):
            np.testing.assert_array_equal(one.texture, other.texture)

    def test_hall_is_closed(self):
        # A room all around: nowhere in the picture does the background shine through.
        scene = hall()
        unlike_any_wall = Scene(scene.patches, (255, 0, 255))
        camera = hall_camera((96, 72))
        np.testing.assert_array_equal(
            QuickRenderer(scene).picture(camera), QuickRenderer(unlike_any_wall).picture(camera)
        )


class TestGeometryOfPainting:
    def test_clip(self):
        square = np.array([[-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]], float)
        half = clip(square, np.array([1.0, 0, 0]))
        assert half[:, 0].min() == 0
        assert np.ptp(half[:, 1]) == 2
        assert clip(square, np.array([1.0, 0, 0]), 5.0).shape == (0, 3)
        assert clip(square, np.array([0, 0, 1.0])) is square

    def test_slabs_cover_the_polygon(self):
        floor = np.array([[-1, 1, 1], [-1, 1, 30], [1, 1, 30], [1, 1, 1]], float)
        parts = slabs(floor)
        assert sum(np.ptp(part[:, 2]) for part in parts) == pytest.approx(29)
        assert all(part[:, 2].max() <= 1.0001 * SLAB * part[:, 2].min() for part in parts)

    def test_order(self):
        # 1 is in front of plane 0 and 0 behind plane 1, although 0 is the nearer by distance.
        near = np.array([[False, True], [False, False]])
        far = np.array([[False, False], [True, False]])
        boxes = np.array([[0, 0, 9, 9], [0, 0, 9, 9.0]])
        assert back_to_front(near, far, boxes, np.array([1.0, 2.0])) == [0, 1]
        apart = np.array([[0, 0, 1, 1], [5, 5, 9, 9.0]])
        assert back_to_front(near, far, apart, np.array([1.0, 2.0])) == [1, 0]

    def test_order_of_a_cycle(self):
        # Three that hide each other in turn: all are painted, once.
        near = np.roll(np.eye(3, dtype=bool), 1, axis=1)
        boxes = np.tile([0, 0, 9.0, 9], (3, 1))
        order = back_to_front(near, np.zeros((3, 3), bool), boxes, np.arange(3.0))
        assert sorted(order) == [0, 1, 2]

    def test_pyramid_keeps_the_mean(self):
        texture = check_texture(np.random.default_rng(0).integers(0, 256, (64, 32, 3)))
        pyramid = TexturePyramid(texture)
        assert pyramid.level(2, 3).shape == (8, 8, 3)
        assert pyramid.level(5, 6).shape == (1, 1, 3)
        np.testing.assert_allclose(pyramid.level(5, 6)[0, 0], texture.mean(axis=(0, 1)), atol=3)
