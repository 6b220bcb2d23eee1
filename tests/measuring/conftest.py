import pytest
from measuring_scene import calibrated, targeted


@pytest.fixture(scope="package")
def exact():
    """A camera and pictures without any error."""
    calibration = calibrated(noise=0)
    return calibration, targeted(calibration, noise=0)
