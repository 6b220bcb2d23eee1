import numpy as np
import pytest

from course_lib.sensor.mosaic import bayer_masks, bayer_mosaic, demosaic_bilinear

PATTERNS = ["RGGB", "BGGR", "GRBG", "GBRG"]
ODD = [(3, 4), (4, 3), (0, 4), (4, 0), (1, 1)]


def picture(shape=(6, 8)):
    return np.random.default_rng(3).uniform(0, 1, (*shape, 3))


class TestMasks:
    @pytest.mark.parametrize("pattern", PATTERNS)
    def test_each_pixel_sees_one_colour(self, pattern):
        masks = bayer_masks((6, 8), pattern)
        np.testing.assert_array_equal(masks.sum(axis=2), 1)
        np.testing.assert_array_equal(masks.sum(axis=(0, 1)), [12, 24, 12])
        read = "".join("RGB"[i] for i in masks.argmax(axis=2)[:2, :2].ravel())
        assert read == pattern

    @pytest.mark.parametrize("shape", ODD)
    def test_errors_of_shape(self, shape):
        with pytest.raises(ValueError, match=r"even number of rows and of columns, got shape"):
            bayer_masks(shape)

    @pytest.mark.parametrize("pattern", ["rggb", "RGB", "RRGB", "RGGBB", ""])
    def test_errors_of_pattern(self, pattern):
        with pytest.raises(ValueError, match=f"two G, one R and one B, got '{pattern}'"):
            bayer_masks((2, 2), pattern)


class TestMosaic:
    @pytest.mark.parametrize("pattern", PATTERNS)
    def test_accuracy(self, pattern):
        image = picture()
        seen = bayer_mosaic(image, pattern)
        np.testing.assert_array_equal(seen, image[bayer_masks((6, 8), pattern)].reshape(6, 8))

    @pytest.mark.parametrize("kind", [np.uint8, np.uint16, np.float64])
    def test_type_is_kept(self, kind):
        assert bayer_mosaic((picture() * 200).astype(kind)).dtype == kind

    def test_argument_stays_as_it_is(self):
        image = picture()
        bayer_mosaic(image)[:] = 7
        np.testing.assert_array_equal(image, picture())

    def test_errors(self):
        with pytest.raises(ValueError, match=r"image must have shape \(rows, columns, 3\)"):
            bayer_mosaic(np.ones((4, 4)))
        with pytest.raises(ValueError, match="cut off the last row or column"):
            bayer_mosaic(np.ones((5, 4, 3)))
        with pytest.raises(TypeError, match="image must be real numbers"):
            bayer_mosaic(np.full((2, 2, 3), "red"))


class TestDemosaic:
    def test_shapes(self):
        assert demosaic_bilinear(np.ones((2, 2))).shape == (2, 2, 3)
        assert demosaic_bilinear(np.ones((4, 10), np.uint8)).dtype == np.float64

    def test_what_was_seen_is_kept(self):
        image = picture()
        masks = bayer_masks((6, 8))
        found = demosaic_bilinear(bayer_mosaic(image))
        np.testing.assert_array_equal(found[masks], image[masks])

    def test_round_trip(self):
        seen = bayer_mosaic(picture())
        np.testing.assert_array_equal(bayer_mosaic(demosaic_bilinear(seen)), seen)

    def test_accuracy_of_ramps(self):
        # Linear interpolation is exact where each colour changes linearly, but for the edge.
        v, u = np.indices((8, 10))
        ramps = np.dstack([2 * u + v, 5 * v - u + 40, 90 - 3 * u - 2 * v]).astype(float)
        found = demosaic_bilinear(bayer_mosaic(ramps))
        np.testing.assert_allclose(found[1:-1, 1:-1], ramps[1:-1, 1:-1])

    def test_accuracy_at_the_edge(self):
        found = demosaic_bilinear([[10, 2, 30, 4], [6, 70, 8, 90]])
        np.testing.assert_allclose(found[0, 0], [10, (2 + 6) / 2, 70])
        np.testing.assert_allclose(found[0, 2], [30, (2 + 4 + 8) / 3, (70 + 90) / 2])
        np.testing.assert_allclose(found[1, 3], [30, (4 + 8) / 2, 90])

    def test_errors(self):
        for shape in ODD:
            with pytest.raises(ValueError, match="even number of rows"):
                demosaic_bilinear(np.ones(shape))
        with pytest.raises(ValueError, match=r"got shape \(2, 2, 3\)"):
            demosaic_bilinear(np.ones((2, 2, 3)))
