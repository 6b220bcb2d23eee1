import numpy as np
import pytest

from course_lib.camera import Camera, camera_at
from course_lib.checks import DegenerateConfigurationError
from course_lib.distortion import distort_pixels
from course_lib.planning import Box, box_in_view, depth_range, object_resolution
from course_lib.transforms import rotation_from_vector

K = np.array([[1000.0, 0, 319.5], [0, 1000, 239.5], [0, 0, 1]])
BARREL = (-0.3, 0.1, 0, 0, 0)


@pytest.fixture(params=range(6))
def rng(request):
    return np.random.default_rng(request.param)


@pytest.fixture
def camera():
    return camera_at([0, -2, 0], [0, 0, 0], K, (640, 480))


class TestBox:
    def test_has_eight_corners_around_its_centre(self):
        box = Box([2, 4, 6], [1, 1, 1])
        assert sorted(map(tuple, box.corners)) == [
            (x, y, z) for x in (0, 2) for y in (-1, 3) for z in (-2, 4)
        ]

    def test_outline_runs_along_its_twelve_edges(self, rng):
        box = Box(
            rng.uniform(0.5, 3, 3), rng.normal(size=3), rotation_from_vector(rng.normal(size=3))
        )
        local = (box.outline - box.centre) @ box.R / (box.size / 2)
        assert len(local) == 12 * 33
        np.testing.assert_array_equal((np.abs(np.abs(local) - 1) < 1e-9).sum(axis=1) >= 2, True)

    def test_edges_have_the_lengths_of_the_box(self):
        start, end = Box([1, 2, 3]).edges.swapaxes(0, 1)
        lengths = np.linalg.norm(end - start, axis=1)
        np.testing.assert_allclose(sorted(lengths), [1] * 4 + [2] * 4 + [3] * 4)

    def test_with_motion_grows_to_both_sides(self):
        np.testing.assert_array_equal(Box([1, 1, 1]).with_motion([0.1, 0, 0.2]).size, [1.2, 1, 1.4])

    @pytest.mark.parametrize(
        ("arguments", "message"),
        [
            (([1, 0, 1],), "size must be positive"),
            (([1, 1],), r"size must have shape \(3,\)"),
            (([1, 1, 1], [0, 0]), r"centre must have shape \(3,\)"),
            (([1, 1, 1], [0, 0, 0], np.ones((3, 3))), "R"),
        ],
    )
    def test_says_what_is_wrong(self, arguments, message):
        with pytest.raises(ValueError, match=message):
            Box(*arguments)


class TestBoxInView:
    def test_margins_are_those_of_points_all_over_the_box(self, rng):
        box = Box(rng.uniform(0.2, 0.8, 3), rng.uniform(-0.2, 0.2, 3))
        camera = camera_at(rng.uniform([-1, -3, -1], [1, -2, 1]), [0, 0, 0], K, (640, 480))
        seen = box_in_view(box, camera, BARREL)
        inner = box.centre + (rng.uniform(-0.5, 0.5, (200_000, 3)) * box.size)
        side = rng.integers(3, size=len(inner))
        inner[np.arange(len(inner)), side] = (
            box.centre[side] + (rng.integers(2, size=len(inner)) - 0.5) * box.size[side]
        )
        pixels = distort_pixels(camera.project(inner), K, BARREL)
        room = [*(pixels.min(axis=0) + 0.5), *([639.5, 479.5] - pixels.max(axis=0))]
        left, top, right, bottom = room
        found = np.array([left, right, top, bottom])
        assert (seen.margins <= found + 1e-9).all()
        np.testing.assert_allclose(seen.margins, found, atol=0.5)
        assert seen.inside == bool(found.min() >= 0) or abs(found.min()) < 0.5

    def test_edges_bend_out_of_the_picture_between_corners_that_are_in_it(self, camera):
        """A barrel lens pulls the corners in, more than the middles of the sides."""
        box = Box([1.0, 0.001, 0.968])
        K_short = np.array([[500, 0, 319.5], [0, 500, 239.5], [0, 0, 1]])
        near = camera_at([0, -1, 0], [0, 0, 0], K_short, (640, 480))
        seen = box_in_view(box, near, (-0.1, 0, 0, 0, 0))
        inside = ((seen.pixels >= -0.5) & (seen.pixels <= [639.5, 479.5])).all()
        middle = distort_pixels(near.project([0, 0, 0.484]), K_short, (-0.1, 0, 0, 0, 0))
        assert inside
        assert middle[1] < seen.pixels[:, 1].min()
        assert seen.margins[2] == pytest.approx(middle[1] + 0.5, abs=0.5)

    def test_says_where_it_is_cut_off(self, camera):
        seen = box_in_view(Box([1, 0.1, 0.1], [0.5, 0, 0]), camera)
        assert not seen.inside
        assert seen.reason.startswith("Cut off by")
        assert seen.reason.endswith("on the right.")

    def test_a_box_around_the_camera_is_not_in_view(self, camera):
        seen = box_in_view(Box([1, 6, 1]), camera)
        assert not seen.inside
        assert "4 of 8 corners have no image" in seen.reason
        assert (seen.margins == -np.inf).all()

    def test_a_ray_outside_of_the_model_has_no_image(self):
        """This polynomial folds over at a tangent of 0.58: a corner beyond would come back in."""
        K_wide = np.array([[300, 0, 319.5], [0, 300, 239.5], [0, 0, 1]])
        wide = Camera(K_wide, np.eye(3), [0, 0, 0], (640, 480))
        seen = box_in_view(Box([3.2, 0.2, 0.1], [0, 0, 2]), wide, (-1.0, 0, 0, 0, 0))
        assert not seen.inside
        assert "no image" in seen.reason


class TestDepthAndResolution:
    def test_depth_range_is_along_the_axis(self, camera):
        assert depth_range(Box([1, 0.5, 1]), camera) == pytest.approx((1.75, 2.25))

    def test_resolution_is_that_of_neighbouring_pixels(self, rng):
        camera = camera_at(rng.uniform([-1, -3, -1], [1, -2, 1]), [0, 0, 0], K, (640, 480))
        normal, point = rng.normal(size=3), rng.uniform(-0.2, 0.2, 3)
        finest, coarsest = object_resolution(point, normal, camera)
        turns = np.linspace(0, np.pi, 721)
        around = camera.project(point) + 1e-3 * np.column_stack([np.cos(turns), np.sin(turns)])
        rays = camera.pixel_ray(around)
        share = normal @ (point - camera.centre) / (rays @ normal)
        moved = camera.centre + share[:, None] * rays - point
        sizes = np.linalg.norm(moved, axis=1) / 1e-3
        assert [sizes.min(), sizes.max()] == pytest.approx([finest, coarsest], rel=2e-3)

    def test_a_tilt_makes_pixels_longer_by_one_over_its_cosine(self, camera):
        tilted = [0, -np.cos(1.0), np.sin(1.0)]
        finest, coarsest = object_resolution([0, 0, 0], tilted, camera)
        assert finest == pytest.approx(0.002)
        assert coarsest == pytest.approx(0.002 / np.cos(1.0))

    def test_errors_say_what_is_wrong(self, camera):
        with pytest.raises(DegenerateConfigurationError, match="edge-on"):
            object_resolution([0, 0, 0], [1, 0, 0], camera)
        with pytest.raises(ValueError, match="in front of the camera"):
            object_resolution([0, -3, 0], [0, 1, 0], camera)
