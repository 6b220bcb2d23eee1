"""Mosaics and colours against OpenCV and scikit-image."""

import cv2
import numpy as np
import pytest
from skimage import color
from skimage.data import astronaut

from course_lib.sensor.mosaic import bayer_mosaic, demosaic_bilinear
from course_lib.sensor.tone import hsv_from_rgb, rgb_from_hsv, srgb_decode, srgb_encode


@pytest.fixture(scope="module")
def portrait():
    return astronaut()[:240, 120:440]


def test_demosaic_agrees_with_opencv(portrait):
    mosaic = bayer_mosaic(portrait.astype(np.uint16) * 256)
    theirs = cv2.cvtColor(mosaic, cv2.COLOR_BayerRGGB2RGB)
    ours = demosaic_bilinear(mosaic)
    # OpenCV rounds to whole numbers and copies the frame from its neighbours.
    np.testing.assert_allclose(ours[1:-1, 1:-1], theirs[1:-1, 1:-1], atol=0.51)


def test_srgb_agrees_with_scikit_image(portrait):
    linear = srgb_decode(portrait / 255)
    xyz = color.rgb2xyz(portrait / 255)  # decodes, then multiplies with a matrix
    np.testing.assert_allclose(linear @ color.colorconv.xyz_from_rgb.T, xyz, atol=1e-9)
    np.testing.assert_allclose(srgb_encode(linear), color.xyz2rgb(xyz), atol=1e-6)


def test_hsv_agrees_with_scikit_image(portrait):
    np.testing.assert_allclose(hsv_from_rgb(portrait / 255), color.rgb2hsv(portrait), atol=1e-12)
    hsv = np.random.default_rng(2).uniform(0, 1, (50, 60, 3))
    np.testing.assert_allclose(rgb_from_hsv(hsv), color.hsv2rgb(hsv), atol=1e-12)
