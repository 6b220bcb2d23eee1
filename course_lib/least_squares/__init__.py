"""Least squares: many measurements, few unknowns, and the answer that leaves the smallest squares.

Measurements contradict each other a little. Of all answers, take the one for which the sum of the
squared residuals, measured minus computed, is smallest.
"""

from __future__ import annotations

from course_lib.least_squares.fits import fit_affine, fit_line, solve_one_unknown
from course_lib.least_squares.linear import (
    parameter_covariance,
    solve_homogeneous,
    solve_normal_equations,
    solve_qr,
    solve_svd,
    solve_weighted,
)
from course_lib.least_squares.marquardt import Fit, levenberg_marquardt
from course_lib.least_squares.robust import RobustFit, huber_weights, solve_robust

__all__ = [
    "Fit",
    "RobustFit",
    "fit_affine",
    "fit_line",
    "huber_weights",
    "levenberg_marquardt",
    "parameter_covariance",
    "solve_homogeneous",
    "solve_normal_equations",
    "solve_one_unknown",
    "solve_qr",
    "solve_robust",
    "solve_svd",
    "solve_weighted",
]
