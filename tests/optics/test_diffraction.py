import numpy as np
import pytest

from course_lib.optics import airy_diameter, is_diffraction_limited


@pytest.mark.parametrize("bad", [0, -1, np.nan, np.inf])
def test_errors(bad):
    for i in range(3):
        arguments = [8, 0.00055, 0.005]
        arguments[i] = bad
        with pytest.raises(ValueError, match=r"positive|finite"):
            is_diffraction_limited(*arguments)


def test_errors_of_type():
    with pytest.raises(TypeError, match="pitch must be real numbers, got '5 µm'"):
        is_diffraction_limited(8, 0.55, "5 µm")


def test_shapes():
    assert type(is_diffraction_limited(8, 0.55, 5)) is np.bool
    limited = is_diffraction_limited([[4], [8]], 0.55, [2, 5, 20])
    assert (limited.shape, limited.dtype) == ((2, 3), bool)


def test_accuracy():
    # The disk of the stop whose Airy disk is one pixel wide just fits.
    pitch, wavelength = 0.00345, 0.00055
    N = pitch / (2.44 * wavelength)
    assert airy_diameter(wavelength, N) == pytest.approx(pitch)
    np.testing.assert_array_equal(
        is_diffraction_limited([0.999 * N, 1.001 * N], wavelength, pitch), [False, True]
    )


def test_unit_does_not_matter():
    N = [1.4, 2.8, 5.6]
    in_mm, in_um = is_diffraction_limited(N, 0.00055, 0.004), is_diffraction_limited(N, 0.55, 4)
    np.testing.assert_array_equal(in_mm, in_um)


def test_red_light_is_limited_first():
    assert is_diffraction_limited(3.5, 0.00065, 0.005)
    assert not is_diffraction_limited(3.5, 0.00045, 0.005)
