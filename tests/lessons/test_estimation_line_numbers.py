"""Chapter 06's numbers of its first section: one unknown, and a line through readings."""

import numpy as np
import pytest
from lesson_text import about, lesson_text, read

from course_lib import least_squares
from course_lib.drawing import estimation as draw
from course_lib.drawing.explorers.least_squares import least_squares_frame, squares

says = lesson_text("06_estimation").says


def test_published_solution_in_one_unknown():
    b = draw.PIXELS
    assert draw.BLOCKS.tolist() == [2, 3, 4]
    x = least_squares.solve_one_unknown(draw.BLOCKS, b)
    assert x == pytest.approx((2 * b[0] + 3 * b[1] + 4 * b[2]) / 29)
    assert x == about(10.286, 3)
    assert (b / draw.BLOCKS).mean() == about(10.358, 3)
    assert (b / draw.BLOCKS).tolist() == pytest.approx([10.8, 9.9, 10.375])
    assert (draw.BLOCKS * b).tolist() == pytest.approx([43.2, 89.1, 166.0])
    says("{29}", "(43.2 + 89.1 + 166.0)/29 = 10.286", "(10.358)", "10.8, the second 9.9")
    says("21.6 px, 29.7 px and 41.5 px")


def test_the_line_of_the_bar():
    m, c = least_squares.fit_line(draw.LOADS, draw.readings())
    assert (m, c) == (about(45.63, 2), about(21.04, 2))
    A = np.column_stack([draw.LOADS, np.ones(8)])
    assert (A.T @ A).tolist() == [[204, 36], [36, 8]]
    assert (A.T @ draw.readings()).tolist() == [10066, 1811]
    says("204 & 36\\\\ 36 & 8", "10066\\\\ 1811", "m = 45.63,\\; c = 21.04")
    stress = 1000 / 105
    assert stress == about(9.52, 2)
    assert round(stress / (m * 1e-6), -3) == 209_000
    says("a section of 105 mm²", "209\\,000$ N/mm²", "74\\\\ 95\\\\ \\vdots\\\\ 381")
    assert draw.readings()[[0, 1, -1]].tolist() == [74, 95, 381]


def test_the_line_by_hand():
    slopes = np.arange(10, 80.5, 0.5)
    sums = [squares(slope, 100, draw.readings()) for slope in slopes]
    assert slopes[np.argmin(sums)] == 31.5
    assert min(sums) == 11_578
    frame = least_squares_frame(30, 100, best=True)
    assert read(frame, "Smallest possible") == 1300
    assert (read(frame, "Best slope"), read(frame, "Best height")) == (45.6, 21.0)
    assert read(least_squares_frame(30, 100, True, True), "Best slope") == 56.9
    says("$m = 31.5$, with $E^2 = 11\\,578$; but 1300", "$m = 45.6$ and $c = 21.0$")
    says("From 45.6 to 56.9")


def test_the_robust_line():
    A = np.column_stack([draw.LOADS, np.ones(8)])
    fit = least_squares.solve_robust(A, draw.readings(slipped=True))
    assert fit.x[0] == about(46.2, 1)
    assert 1 / fit.weights[6] == about(9, 0)
    plain, _ = least_squares.fit_line(draw.LOADS, draw.readings(slipped=True))
    assert round(1000 / 105 / (plain * 1e-6), -3) == 167_000
    assert fit.threshold == about(22, 0)
    says("For $k$ one takes 1.345 times the usual error")
    assert A[6] @ fit.x - draw.readings(slipped=True)[6] == about(-202, 0)
    says("$k = 22$ millionths", "$r = 202$: it counts $22/202 = 0.11$")
    says("56.9, so only 167 000 N/mm²")
    says("The robust line says 46.2, and the slipped reading counts a ninth")


def test_a_reading_that_is_less_certain():
    A = np.column_stack([draw.LOADS, np.ones(8)])
    sigma = np.where(np.arange(8) == 6, 2.0, 1)
    x, *_ = np.linalg.lstsq(A / sigma[:, None], draw.readings() / sigma)
    assert x[0] == about(44.8, 1)
    says("the slope goes from 45.63 to 44.8")


def test_time_in_milliseconds():
    t = 5e7 + 100 * np.arange(10)
    A, b = np.column_stack([t, np.ones(10)]), 0.0005 * t - 24_980
    normal, qr = np.linalg.solve(A.T @ A, A.T @ b)[1], least_squares.solve_qr(A, b)[1]
    assert abs(qr + 24_980) < 1e-3
    assert 1e-7 < abs(normal / -24_980 - 1) < 1e-4
    assert np.log10(np.linalg.cond(A)) == about(13, 0)
    scaled = np.linalg.cond(A / np.linalg.norm(A, axis=0))
    assert scaled == about(3.5e5, -4)
    assert scaled**2 == about(1.2e11, -10)
    says(
        "$-24\\,980$",
        "sixth digit",
        "That of $A$ is $10^{13}$",
        "3.5\\cdot10^5",
        "1.2\\cdot10^{11}",
    )
