"""Lenses that bend strongly, as tests and measurements of the way back need them."""

import numpy as np

from course_lib.distortion import distort, distortion_jacobian


def disk(radius, rings=60, spokes=73):
    angle, r = np.meshgrid(np.linspace(0, 2 * np.pi, spokes), np.linspace(0, radius, rings))
    return np.stack([r * np.cos(angle), r * np.sin(angle)], axis=-1).reshape(-1, 2)


def random_coefficients(rng):
    """Return 4, 5, 8 or 12 coefficients, larger than those of good lenses."""
    radial, tangential = rng.uniform(-0.6, 0.6, 2), rng.uniform(-0.02, 0.02, 2)
    third, below = rng.uniform(-0.3, 0.3, 1), rng.uniform(-0.4, 0.8, 3)
    prism = rng.uniform(-0.02, 0.02, 4)
    return np.concatenate([radial, tangential, third, below, prism])[: rng.choice([4, 5, 8, 12])]


def strong_lenses(count, seed=5):
    """Yield lenses that displace the corner by more than 5 % of f, and do not fold over before."""
    rng = np.random.default_rng(seed)
    while count:
        k, corner = random_coefficients(rng), rng.uniform(0.5, 1.2)
        field = disk(corner)
        folds = np.linalg.det(distortion_jacobian(field, k)).min() < 0.05
        moved = np.abs(distort(field, k) - field).max()
        if not folds and moved > 0.05:
            count -= 1
            yield k, field
