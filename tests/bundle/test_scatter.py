"""Reported covariances against the scatter of what is adjusted again and again with other noise."""

import numpy as np
import pytest

from course_lib.bundle import Observations, bundle_adjust
from course_lib.transforms import vector_from_rotation
from data_generators.blocks import turntable

RUNS = 200


def rms(errors, axis):
    return np.sqrt(np.mean(np.square(errors), axis=axis))


@pytest.mark.parametrize("gauge", ["fixed", "inner", "control"])
def test_what_is_reported_is_how_200_adjustments_scatter(gauge):
    """Turns and centres camera by camera, points axis by axis: each within 10 %."""
    known = turntable(np.random.default_rng(8), pictures=8, points=60, noise=0)
    rng, truth, seen = np.random.default_rng(9), known.truth, known.observations
    errors, sigmas = ([], [], []), ([], [], [])
    for run in range(RUNS):
        pixels = seen.pixels + 0.5 * rng.standard_normal(seen.pixels.shape)
        noisy = Observations(seen.cameras, seen.points, pixels, 0.5)
        control = known.surveyed(rng, 0.0002) if gauge == "control" else None
        fit = bundle_adjust(truth, noisy, control, "inner" if control else gauge)
        turned = fit.block.R @ truth.R.transpose(0, 2, 1)
        errors[0].append([vector_from_rotation(turn) for turn in turned])
        errors[1].append(fit.block.centres - truth.centres)
        errors[2].append(fit.block.points - truth.points)
        if run < 20:
            found = fit.precision
            for to, sigma in zip(
                sigmas, (found.turn_sigma, found.centre_sigma, found.point_sigma), strict=True
            ):
                to.append(sigma)
    for scatter, sigma, alike in zip(errors, sigmas, ((0, 2), (0, 2), (0, 1)), strict=True):
        np.testing.assert_allclose(rms(sigma, alike), rms(scatter, alike), rtol=0.1, atol=1e-9)
