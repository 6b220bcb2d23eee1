"""What a block tells of the lens: against the truth, and against SciPy on all unknowns at once."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import least_squares

from course_lib.bundle import Block, Control, Observations, bundle_adjust, self_calibrate
from course_lib.calibration.model import rotations_from_vectors
from course_lib.checks import DegenerateConfigurationError
from course_lib.similarity import similarity_transform
from data_generators.blocks import flight, turntable

SIGMA = 0.5
WRONG = {"f": 0.003, "cx": 2.0, "cy": -3.0, "k1": 0.004}


def spoilt(block, seen, f=0.0, cx=0.0, cy=0.0, k1=0.0):
    """Return pixels that the given corrections would mend (nearly: they begin where they are)."""
    K = block.K[0]
    c, pixels = K[:2, 2], seen.pixels
    for _ in range(20):
        away = pixels - c
        r2 = ((away / [K[0, 0], K[1, 1]]) ** 2).sum(axis=1, keepdims=True)
        pixels = seen.pixels - f * away - [cx, cy] - k1 * r2 * away
    return replace(seen, pixels=pixels)


@pytest.fixture(scope="module")
def small():
    known = flight(np.random.default_rng(3), strips=2, pictures=3, points=60, oblique=4)
    return known, spoilt(known.truth, known.observations, **WRONG)


def test_without_noise_the_lens_comes_back():
    known = turntable(np.random.default_rng(1), pictures=8, points=60, noise=0, rings=2)
    seen = spoilt(known.truth, known.observations, **WRONG)
    found = self_calibrate(known.truth, seen, free=("f", "c", "k1"))
    assert found.corrections == pytest.approx(WRONG, rel=1e-4)
    assert found.adjustment.rms < 1e-4
    np.testing.assert_allclose(found.observations.pixels, known.observations.pixels, atol=1e-3)


def test_the_found_intrinsics_see_the_uncorrected_pixels():
    known = turntable(np.random.default_rng(1), pictures=9, points=80, noise=0, rings=2)
    seen = spoilt(known.truth, known.observations, f=0.003, cx=2, cy=-3)
    found = self_calibrate(known.truth, seen, free=("f", "c"))
    block = replace(found.adjustment.block, K=found.K)
    np.testing.assert_allclose(block.project(seen.cameras, seen.points), seen.pixels, atol=1e-3)


def test_as_scipy_with_all_unknowns_at_once(small):
    known, seen = small
    start, v, n = known.truth, len(known.truth.R), len(known.truth.points)
    x0 = np.zeros(6 * v + 3 * n + 2)

    def residuals(x):
        cameras, moves, (f, k1) = x[: 6 * v].reshape(v, 6), x[6 * v : -2].reshape(n, 3), x[-2:]
        R = rotations_from_vectors(cameras[:, :3]) @ start.R
        C = start.centres + cameras[:, 3:]
        block = Block(start.K, R, -np.einsum("vij,vj->vi", R, C), start.points + moves)
        away = seen.pixels - start.K[0, :2, 2]
        r2 = ((away / start.K[0, 0, 0]) ** 2).sum(axis=1, keepdims=True)
        corrected = seen.pixels + f * away + k1 * r2 * away
        return ((block.project(seen.cameras, seen.points) - corrected) / SIGMA).ravel()

    other = least_squares(residuals, x0, method="lm", x_scale="jac", xtol=1e-12, ftol=1e-14)
    found = self_calibrate(start, seen, free=("f", "k1"))
    assert found.adjustment.cost == pytest.approx(2 * other.cost, rel=1e-6)
    assert [*found.corrections.values()] == pytest.approx(other.x[-2:], rel=1e-3, abs=1e-6)
    # All singular values but those of the gauge tell how well the lens is known.
    J = other.jac
    size = np.linalg.norm(J, axis=0)
    inverse = np.linalg.pinv(J / size, rcond=1e-4)
    variance = 2 * other.cost / (J.shape[0] - J.shape[1] + 7) * (inverse**2).sum(axis=1) / size**2
    assert [*found.sigma.values()] == pytest.approx(np.sqrt(variance[-2:]), rel=2e-3)


def test_reported_sigma_is_how_200_flights_scatter():
    known = flight(np.random.default_rng(7), strips=2, pictures=3, points=40, oblique=4, noise=0)
    rng, seen, off = np.random.default_rng(7), known.observations, []
    for _ in range(200):
        pixels = seen.pixels + 0.5 * rng.standard_normal(seen.pixels.shape)
        found = self_calibrate(known.truth, replace(seen, pixels=pixels))
        off.append((found.corrections["k1"], found.sigma["k1"]))
    scatter, sigma = np.sqrt(np.mean(np.square(off), axis=0))
    assert sigma == pytest.approx(scatter, rel=0.1)


def test_a_dome_goes_when_the_lens_is_free():
    known = flight(np.random.default_rng(4), 3, 6, 200, oblique=6)
    seen = spoilt(known.truth, known.observations, k1=0.01)

    def heights(block):
        errors = similarity_transform(block.points, known.truth.points).apply(block.points)
        return np.sqrt(((errors - known.truth.points)[:, 2] ** 2).mean())

    held = heights(bundle_adjust(known.truth, seen).block)
    found = self_calibrate(known.truth, seen)
    right = heights(bundle_adjust(known.truth, known.observations).block)
    assert held > 2 * right
    assert heights(found.adjustment.block) < 1.15 * right
    assert found.corrections["k1"] == pytest.approx(0.01, abs=4 * found.sigma["k1"])


def test_control_points_may_be_held_or_weighted(small):
    known, seen = small
    for sigma in (0.0, 0.02):
        control = Control(known.control, known.truth.points[known.control], sigma)
        found = self_calibrate(known.truth, seen, control, free=("f", "k1"))
        for name, value in found.corrections.items():
            assert value == pytest.approx(WRONG[name], abs=5 * found.sigma[name])


def test_what_the_pictures_cannot_tell_is_named():
    """Straight down, flat ground: a longer focal length is a larger height."""
    known = flight(np.random.default_rng(3), strips=2, pictures=3, points=60, noise=0)
    true = known.truth
    R = np.array([np.diag([1.0, -1, -1])] * len(true.R))
    centres = np.column_stack([true.centres[:, :2], np.full(len(R), 100.0)])
    flat = np.column_stack([true.points[:, :2], np.zeros(len(true.points))])
    block = Block(true.K, R, -np.einsum("vij,vj->vi", R, centres), flat)
    i, j = known.observations.cameras, known.observations.points
    seen = Observations(i, j, block.project(i, j))
    with pytest.raises(DegenerateConfigurationError, match="cannot tell f:"):
        self_calibrate(block, seen, free=("f",))


@pytest.mark.parametrize("free", [(), "k1", ("k3",), ("f", "skew")])
def test_bad_names_are_named(small, free):
    with pytest.raises(ValueError, match="free must list some of f, c, k1, k2"):
        self_calibrate(small[0].truth, small[1], free=free)
