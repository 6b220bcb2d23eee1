"""Displacement fields, maps, and pictures made straight."""

import numpy as np
import pytest

from course_lib.distortion import (
    displacement_field,
    distort_pixels,
    opencv_from_bouguet,
    pixel_grid,
    straightness,
    undistortion_map,
    valid_radius,
)
from course_lib.remapping import packed_map, remap, undistort_picture

K = np.array([[300.0, 1, 155], [0, 290, 125], [0, 0, 1]])
LENS = np.array([-0.3, 0.12, 0.001, -0.0008, -0.02, 0.01, 0, 0, 0.001, -0.002, 0.001, 0])
SIZE = (320, 240)
#: The camera of the classic example, as its author printed it after the last step.
CLASSIC = opencv_from_bouguet(
    [657.30254, 657.74391], [302.71656, 242.33386], 0, [-0.25349, 0.11868, -0.00028, 0.00005, 0]
)


class TestGrid:
    def test_corner_to_corner(self):
        grid = pixel_grid((640, 480), 5, 4)
        assert grid.shape == (4, 5, 2)
        np.testing.assert_array_equal(grid[0, 0], [0, 0])
        np.testing.assert_array_equal(grid[-1, -1], [639, 479])
        np.testing.assert_array_equal(grid[0, -1], [639, 0])

    def test_errors(self):
        with pytest.raises(ValueError, match="at least 2 columns and 2 rows, got 1 and 5"):
            pixel_grid((640, 480), 1, 5)


class TestDisplacement:
    def test_shapes(self):
        assert displacement_field([3, 4], K, LENS).shape == (2,)
        assert displacement_field(np.zeros((7, 2)), K, LENS).shape == (7, 2)

    def test_is_what_the_lens_does(self):
        pixels = pixel_grid(SIZE, 9, 7).reshape(-1, 2)
        expected = distort_pixels(pixels, K, LENS) - pixels
        np.testing.assert_allclose(displacement_field(pixels, K, LENS), expected, atol=1e-11)

    def test_complete_is_the_sum_of_its_parts(self):
        pixels = pixel_grid(SIZE, 9, 7).reshape(-1, 2)
        parts = [displacement_field(pixels, K, LENS, p) for p in ("radial", "tangential", "prism")]
        assert all(np.abs(part).max() > 0.01 for part in parts)
        np.testing.assert_allclose(sum(parts), displacement_field(pixels, K, LENS), atol=1e-11)

    def test_radial_points_to_the_centre(self):
        pixels = pixel_grid(SIZE, 9, 7).reshape(-1, 2)
        square = np.diag([300.0, 300, 1])
        square[:2, 2] = 155, 125
        moved = displacement_field(pixels, square, LENS, "radial")
        towards = pixels - (155, 125)
        (a, b), (c, d) = moved.T, towards.T
        np.testing.assert_allclose(a * d - b * c, 0, atol=1e-9)

    def test_published_example(self):
        # Bouguet read 25 px and 0.14 px off his plots: they are the outermost iso-lines, in steps
        # of 5 px and 0.02 px, on the grid of 32 x 24 px that the toolbox draws.
        u, v = np.meshgrid(np.arange(0, 640, 32), np.arange(0, 480, 24))
        grid = np.stack([u, v], axis=-1).reshape(-1, 2)
        for part, step, outermost in (("complete", 5, 25), ("tangential", 0.02, 0.14)):
            moved = np.hypot(*displacement_field(grid, *CLASSIC, part).T)
            assert step * np.floor(moved.max() / step) == pytest.approx(outermost)
        corners = displacement_field(pixel_grid((609, 457), 2, 2).reshape(-1, 2), *CLASSIC)
        assert (np.hypot(*corners.T) > 25).all()

    def test_errors(self):
        with pytest.raises(ValueError, match="complete, radial, tangential, prism, got 'both'"):
            displacement_field([1, 2], K, LENS, "both")


class TestMap:
    def test_shapes(self):
        for m in undistortion_map(K, LENS, SIZE):
            assert m.shape == (240, 320)
            assert m.dtype == np.float32
        assert undistortion_map(K, LENS, SIZE, dtype=np.float64)[0].dtype == np.float64

    def test_looks_where_the_lens_puts_the_pixel(self):
        new = np.array([[250.0, -2, 150], [0, 260, 130], [0, 0, 1]])
        pixels = np.stack(np.meshgrid(np.arange(320.0), np.arange(240.0)), axis=-1).reshape(-1, 2)
        homogeneous = np.column_stack([pixels, np.ones(len(pixels))]) @ np.linalg.inv(new).T @ K.T
        expected = distort_pixels(homogeneous[:, :2], K, LENS)
        found = undistortion_map(K, LENS, SIZE, new, dtype=np.float64)
        np.testing.assert_allclose(np.stack(found, axis=-1).reshape(-1, 2), expected, atol=1e-9)

    def test_beyond_the_fold_there_is_nothing(self):
        k, wide = [-0.3], np.array([[50.0, 0, 160], [0, 50, 120], [0, 0, 1]])
        map_u, map_v = undistortion_map(K, k, SIZE, wide)
        v, u = np.mgrid[:240, :320]
        beyond = np.hypot(u - 160, v - 120) / 50 > valid_radius(k)
        assert 0 < beyond.mean() < 1
        np.testing.assert_array_equal(map_u == -1e6, beyond)
        np.testing.assert_array_equal(map_v == -1e6, beyond)

    @pytest.mark.parametrize("size", [(0, 5), (5.5, 4), (3, 4, 5)])
    def test_errors_of_size(self, size):
        with pytest.raises(ValueError, match="image_size"):
            undistortion_map(K, LENS, size)

    def test_errors_of_new_intrinsics(self):
        with pytest.raises(ValueError, match="the corners must be tangents"):
            undistortion_map(K, LENS, SIZE, np.diag([1e-9, 1e-9, 1]))


class TestRemap:
    @pytest.mark.parametrize("dtype", [np.uint8, np.uint16, np.float32, np.float64])
    @pytest.mark.parametrize("shape", [(40, 50), (40, 50, 3)])
    def test_whole_steps_copy(self, dtype, shape):
        image = np.random.default_rng(2).uniform(0, 200, shape).astype(dtype)
        v, u = np.mgrid[:40, :50]
        moved = remap(image, packed_map(u + 3, v - 5))
        assert moved.dtype == dtype
        np.testing.assert_array_equal(moved[5:, :-3], image[:-5, 3:])
        assert not moved[:5].any()
        assert not moved[:, -3:].any()

    def test_parts_of_pixels(self):
        v, u = np.mgrid[:40, :50].astype(float)
        ramp = 2 * u + 3 * v
        got = remap(ramp, packed_map(u[5:-5, 5:-5] + 0.3, v[5:-5, 5:-5] - 0.6))
        # Rounded to a 32nd of a pixel.
        np.testing.assert_allclose(got, ramp[5:-5, 5:-5] + 0.6 - 1.8, atol=5 / 64 + 1e-9)

    def test_packing_is_exact_on_the_grid(self):
        u = np.array([[0, 1 / 32, -1 / 32, 31 / 32, 1e6, -1e6]])
        whole, fraction = packed_map(u, np.zeros_like(u))
        np.testing.assert_array_equal(whole[0, :, 0], [0, 0, -1, 0, 32767, -32768])
        np.testing.assert_array_equal(fraction[0, :4], [0, 1, 31, 31])

    @pytest.mark.parametrize(
        ("image", "error", "message"),
        [
            (np.zeros((4, 4), dtype=bool), TypeError, "got bool: convert"),
            (np.zeros((4, 4), dtype=int), TypeError, "got int64"),
            (np.zeros(4), ValueError, r"got \(4,\)"),
            (np.zeros((4, 4, 2)), ValueError, r"got \(4, 4, 2\)"),
            (np.zeros((0, 4)), ValueError, r"got \(0, 4\)"),
            (np.zeros((1, 40_000)), ValueError, "at most 32766"),
        ],
    )
    def test_errors(self, image, error, message):
        with pytest.raises(error, match=message):
            remap(image, packed_map([[0]], [[0]]))
        with pytest.raises(error, match=message):
            undistort_picture(image, K, LENS)

    def test_errors_of_maps(self):
        with pytest.raises(ValueError, match=r"both have shape .* got \(1, 1\) and \(1, 2\)"):
            packed_map([[0]], [[0, 1]])


class TestUndistortPicture:
    def test_straightens_a_drawn_line(self):
        # A bright line that the lens has bent, drawn from its formula.
        ideal = np.stack([np.linspace(-40, 360, 2000), np.full(2000, 30.0)], axis=1)
        bent = distort_pixels(ideal, K, LENS)
        v, u = np.mgrid[:240, :320].astype(float)
        heights = np.interp(u[0], *bent[np.argsort(bent[:, 0])].T)
        image = (250 * np.exp(-((v - heights) ** 2) / 4)).astype(np.uint8)
        straight = undistort_picture(image, K, LENS)

        def ridge(picture):
            light = picture[:, 20:300].astype(float)
            light[light < 30] = 0
            return np.stack([np.arange(20, 300), (light * v[:, 20:300]).sum(0) / light.sum(0)], 1)

        assert straightness(ridge(image)) > 1.5
        assert straightness(ridge(straight)) < 0.05
        np.testing.assert_allclose(ridge(straight)[:, 1], 30, atol=0.15)

    def test_another_camera_has_another_map(self):
        image = np.random.default_rng(3).integers(0, 255, (24, 32), dtype=np.uint8)
        small = np.array([[30.0, 0, 16], [0, 30, 12], [0, 0, 1]])
        first = undistort_picture(image, small, [-0.3])
        assert (undistort_picture(image, small, [0.3]) != first).any()
        assert (
            undistort_picture(image, small * [[1.1, 1, 1], [1, 1, 1], [1, 1, 1]], [-0.3]) != first
        ).any()
        np.testing.assert_array_equal(undistort_picture(image, small, [-0.3, 0]), first)
        np.testing.assert_array_equal(undistort_picture(image, small, [0]), image)
