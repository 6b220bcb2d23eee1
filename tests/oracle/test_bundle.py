"""Bundle adjustment and resection against SciPy, OpenCV and what was published of real pictures."""

import re

import cv2
import numpy as np
import pytest
from real_data import fetched
from scipy.optimize import least_squares

from course_lib.bundle import Block, Control, Observations, bundle_adjust
from course_lib.bundle.derivatives import Position
from course_lib.orientation import resect_camera
from course_lib.transforms import euler_from_rotation, omega_phi_kappa_from_rotation
from data_generators.blocks import flight, turntable

F, PIXEL = 123.9392, 0.006  # mm, as the reports of the aerial block say
K_AERIAL = np.array([[F / PIXEL, 0, 26.577 / PIXEL], [0, F / PIXEL, 38.811 / PIXEL], [0, 0, 1]])


def scipy_minimum(start, seen, robust=None):
    """Return the smallest cost that SciPy finds with numerical derivatives."""
    first, v = Position.of(start), len(start.R)

    def residuals(x):
        position = first.moved(x[: 6 * v].reshape(v, 6), x[6 * v :].reshape(-1, 3))
        r = position.image(seen).residuals
        if robust is None:
            return r.ravel()
        sizes = np.sqrt((r * r).sum(axis=0))
        # The square of it is Huber's cost of the length.
        far = np.sqrt(np.maximum(2 * robust * sizes - robust**2, 0))
        return np.where(sizes > robust, far, sizes)

    x = np.zeros(6 * v + 3 * len(start.points))
    fit = least_squares(
        residuals, x, x_scale="jac", ftol=1e-12, xtol=1e-12, gtol=1e-12, max_nfev=60
    )
    return 2 * fit.cost


@pytest.mark.parametrize(("make", "pictures"), [(flight, 3), (turntable, 9)])
def test_the_cost_is_scipys(make, pictures):
    known = make(np.random.default_rng(1), pictures=pictures, points=40)
    fit = bundle_adjust(known.truth, known.observations)
    cost = scipy_minimum(known.truth, known.observations)
    assert fit.cost == pytest.approx(cost, rel=1e-6)


def test_the_robust_cost_is_scipys():
    known = flight(np.random.default_rng(2), 2, 3, points=50, wrong=0.05)
    fit = bundle_adjust(known.truth, known.observations, robust=2.5)
    # SciPy begins near, where it does not lose its way; neither finds anything lower.
    cost = scipy_minimum(fit.block, known.observations, robust=2.5)
    assert known.wrong.any()
    assert fit.converged
    assert fit.cost == pytest.approx(cost, rel=1e-6)


def test_resection_finds_what_opencv_finds():
    rng, K = np.random.default_rng(3), np.array([[900.0, 0, 320], [0, 900, 240], [0, 0, 1]])
    for count in (6, 10, 40):
        X, turn = rng.uniform(-1, 1, (count, 3)), rng.standard_normal(3)
        pixels = cv2.projectPoints(X, turn, np.array([0, 0, 4.0]), K, None)[0][:, 0]
        pixels += 0.5 * rng.standard_normal(pixels.shape)
        ours = resect_camera(X, pixels, K)
        _, rvec, tvec = cv2.solvePnP(X, pixels, K, None)
        rvec, tvec = cv2.solvePnPRefineLM(X, pixels, K, None, rvec, tvec)
        theirs = cv2.projectPoints(X, rvec, tvec, K, None)[0][:, 0] - pixels
        assert (ours.residuals**2).sum() <= (theirs**2).sum() * (1 + 1e-9)
        np.testing.assert_allclose(ours.R, cv2.Rodrigues(rvec)[0], rtol=0, atol=1e-4)


def test_the_textbook_resection():
    table = np.loadtxt(fetched("resection_tables/wuhan_resection.txt"))
    # Image coordinates in mm have y upwards; the focal length is in mm, too.
    found = resect_camera(table[:, 2:], table[:, :2] * [1, -1], np.diag([153.24, 153.24, 1]))
    np.testing.assert_allclose(found.centre, [39795.45, 27476.46, 7572.69], rtol=0, atol=0.006)
    world_from_image = found.R.T @ np.diag([1, -1, -1])
    # The textbook turns about y first, and counts that angle the other way.
    phi, omega, kappa = euler_from_rotation(world_from_image, "yxz")
    np.testing.assert_allclose([-phi, omega, kappa], [-0.00399, 0.00211, -0.06758], atol=5.1e-6)


def lines(name):
    return fetched(f"aerial_block/{name}").read_text("utf-8", errors="replace").splitlines()


def numbered(name):
    """Return the rows of a table that begin with a number."""
    return [line.split(",") for line in lines(name) if re.match(r"\d+,", line)]


def published(name):
    """Return σ₀, orientations and their σ, (5, 6) each, and the prior control points."""
    text = "\n".join(lines(f"dbatexports/{name}-dbatreport.txt"))
    rows = re.findall(r"(?:Omega|Phi|Kappa|[XYZ]c):\s+Value:\s+(\S+) \S+\s+Deviation: (\S+)", text)
    values, sigmas = np.array(rows, dtype=float).T.reshape(2, 5, 6)
    prior = text.split("Prior")[1].split("Posterior")[0]
    rows = re.findall(r"(\d+),(.+?),(.+?),(.+?),", prior)
    control = {int(row[0]): np.array(row[1:], float) for row in rows}
    return float(re.search(r"Sigma0: +(\S+)", text)[1]), values, sigmas, control


@pytest.mark.parametrize(
    ("marks", "table", "report"),
    [
        ("f-op0-with-orient", "ctrlpts-fixed.txt", "f-op0-with-orient"),
        ("w-op1-with-orient", "ctrlpts-weighted.txt", "w-op1-with-orient"),
    ],
)
def test_the_strasbourg_block_is_as_published(marks, table, report):
    sigma0, values, sigmas, local = published(report)
    survey = {int(row[0]): np.array(row[2:5], float) for row in numbered(f"ref/{table}")}
    # The reports count from near the middle of the control points, to the millimetre.
    origin = np.mean([survey[name] - local[name] for name in local], axis=0)
    survey = {name: place - origin for name, place in survey.items()}
    seen = np.array([row[:4] for row in numbered(f"pmexports/{marks}-2dpts.txt")], float)
    names, points = np.unique(seen[:, 0].astype(int), return_inverse=True)
    cameras, pixels = seen[:, 1].astype(int) - 1, seen[:, 2:]
    surveyed = np.array([name in survey for name in names])
    X = np.array([survey.get(name, np.zeros(3)) for name in names])
    starts = []
    for camera in range(5):
        mine = (cameras == camera) & surveyed[points]
        starts.append(resect_camera(X[points[mine]], pixels[mine], K_AERIAL))
    start = Block(K_AERIAL, np.array([s.R for s in starts]), np.array([s.t for s in starts]), X)
    weights = 0.0 if "fixed" in table else [0.02, 0.02, 0.04]
    control = Control(np.flatnonzero(surveyed), X[surveyed], np.array(weights))
    fit = bundle_adjust(start, Observations(cameras, points, pixels), control)

    assert fit.sigma0 == pytest.approx(sigma0, abs=5.1e-5)
    if "fixed" in table:  # the root mean square of the 94 coordinates
        assert np.sqrt(fit.cost / 94) == pytest.approx(0.8597, abs=5e-5)
    angles = [np.rad2deg(omega_phi_kappa_from_rotation(R)) for R in fit.block.R]
    np.testing.assert_allclose(angles, values[:, :3], rtol=0, atol=2e-5)
    np.testing.assert_allclose(fit.block.centres, values[:, 3:], rtol=0, atol=2e-3)
    np.testing.assert_allclose(fit.precision.centre_sigma, sigmas[:, 3:], rtol=0.005)
    # The turn about the camera's axis is kappa; its own axes are not those of omega and phi.
    kappa = np.rad2deg(fit.precision.turn_sigma[:, 2])
    np.testing.assert_allclose(kappa, sigmas[:, 2], rtol=0.02)
