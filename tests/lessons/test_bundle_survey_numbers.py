"""The numbers that the text of chapter 10 states in its second sitting, and in what is extra."""

import sys

import numpy as np
import pytest
from lesson_text import about, lesson_text
from real_data import fetched

from course_lib import orientation, tie_points
from course_lib.drawing import bundle as draw
from course_lib.drawing.bundle import flights, placement
from course_lib.drawing.explorers import control_points as game
from course_lib.drawing.explorers.control_points import control_frame
from course_lib.exercises.bundle import similarity_plain
from course_lib.reconstruction import reconstruct
from data_generators import vase

says = lesson_text("10_bundle").says
# A figure of the package has the same name.
acquisition = sys.modules["course_lib.drawing.bundle.acquisition"]


def test_the_timeline_is_in_order():
    years = [year for year, *_ in acquisition.HISTORY]
    assert years == sorted(years)
    assert {1816, 1867, 1903, 1921, 2004, 2006, 2010} <= set(years)


def test_pictures_for_a_circle():
    circle = similarity_plain.pictures_for_circle
    assert (circle(np.radians(10)), circle(np.radians(7))) == (36, 52)
    assert about(51.4, 1) == 360 / 7
    says("$360/10 = 36$", "$360/7 = 51.4$, so 52")


@pytest.fixture(scope="module")
def known():
    return draw.photographs()


@pytest.fixture(scope="module")
def model(known):
    rng = np.random.default_rng(2)
    seen = tie_points.tracks(known.pictures, known.K, rng, pairs=draw.neighbours())
    return reconstruct(seen, known.K, np.random.default_rng(0))


def test_the_reconstruction(known, model):
    assert len(model.cameras) == 24
    assert not model.left_out
    numbers, X = model.triangulated(known.observed_marks(np.random.default_rng(3)))
    assert len(numbers) == len(known.marks) == 12
    assert len(known.control) == 6
    control = np.isin(numbers, known.control)
    lay = orientation.similarity_transform(X[control], known.marks[numbers[control]])
    totals = [
        1000 * orientation.check_point_rmse(lay.apply(X[some]), known.marks[numbers[some]]).total
        for some in (control, ~control)
    ]
    # Other versions of OpenCV may find slightly other details.
    assert totals == [pytest.approx(0.14, abs=0.02), pytest.approx(0.20, abs=0.03)]
    says("Twelve marks", "Six of them are control", "to 0.3 px", "0.14 mm! Is the model")
    assert 24 / 36 * 6000 == 4000
    says("$24/36\\cdot 6000 = 4000$ px", "24 mm, on a sensor 36 mm wide with 6000 px")
    says("0.14 mm at the control points, 0.20 mm at the check points", "| 0.20 mm |")


def test_the_vase_is_measured_to_tenths_of_a_millimetre(known, model):
    numbers, X = model.triangulated(known.observed_marks(np.random.default_rng(3)))
    control = np.isin(numbers, known.control)
    lay = orientation.similarity_transform(X[control], known.marks[numbers[control]])
    seen, off = model.observations, []
    for camera, picture in enumerate(model.cameras[:6]):
        mine = seen.only(seen.cameras == camera)
        true = known.surface(picture, mine.pixels)
        off += np.linalg.norm(lay.apply(model.block.points[mine.points]) - true, axis=1).tolist()
    assert 0.25 < 1000 * np.nanmedian(off) < 0.4
    says("Half of all tie points, too, are within 0.4 mm")
    x, y, z = 1000 * lay.apply(model.block.points).T
    radius = np.hypot(x, y)
    widest = 2 * radius[(abs(z - 80) < 5) & (radius < 150)]
    assert np.percentile(z[radius < 130], 99.5) == pytest.approx(299, abs=0.7)
    assert np.median(widest) == pytest.approx(238, abs=0.7)
    assert 0.5 < widest.std() < 2
    says("299 mm high and 238 mm wide", "each to about a millimetre")


def test_how_large_the_vase_was_made():
    rings = np.linspace(0, vase.HEIGHT, vase.RINGS + 1)
    between = np.interp(np.linspace(0.075, 0.085, 201), rings, vase.radius(rings))
    half = np.pi / vase.SIDES
    flat = np.cos(half) / np.cos(np.linspace(-half, half, 201))  # a side is nearer than a corner
    assert (1000 * vase.HEIGHT, vase.SIDES) == (300, 36)
    assert 2000 * between.mean() * flat.mean() == about(238.4, 1)
    says("made 300 mm high, and 238.4 mm wide there, on the average over its 36 flat sides")


def test_the_worked_similarity():
    x = np.array([[-1.0, 0, 0], [1, 0, 0], [0, -2, 0], [0, 2, 0]])
    y = np.array([[10.0, 17, 5], [10, 23, 5], [16, 20, 5], [4, 20, 5]])
    M = (y - y.mean(axis=0)).T @ x
    assert M.tolist() == [[0, -24, 0], [6, 0, 0], [0, 0, 0]]
    np.testing.assert_allclose(np.linalg.svd(M)[1], [24, 6, 0], atol=1e-9)
    scale, R, t = similarity_plain.similarity_transform(x, y)
    assert scale == pytest.approx(3)
    np.testing.assert_allclose(R, [[0, -1, 0], [1, 0, 0], [0, 0, 1]], atol=1e-9)
    np.testing.assert_allclose(t, [10, 20, 5])
    says(
        "0 & -24 & 0\\\\ 6 & 0 & 0", "(24 + 6 + 0)/(1 + 1 + 4 + 4) = 3", "\\mathbf t = (10, 20, 5)"
    )
    says("(10, 17, 5), (10, 23, 5), (16, 20, 5), (4, 20, 5)")


def test_the_worked_rmse():
    off = similarity_plain.check_point_rmse(np.array([[3.0, 4, 0], [0, 0, 0]]), np.zeros((2, 3)))
    assert off.tolist() == [about(2.12, 2), about(2.83, 2), 0, about(3.54, 2)]
    says("= 2.12$", "= 2.83$", "= 3.54$ mm")


def test_residuals_flatter():
    (count, control, check), *_ = flights.flattering()
    assert (count, 1000 * control, 1000 * check) == (3, about(17, 0), about(128, 0))
    assert 20 * np.sqrt(3) == about(35, 0)
    assert 35 * np.sqrt(2 / 9) == about(16, 0)
    says("their residuals are 17 mm, and the other points are off by 128 mm", "so 35 mm in space")
    says("35\\cdot\\sqrt{2/9} = 16$ mm", "Here 500 models")


def error(places, dome):
    """Return the height error of a choice of control points, mm."""
    numbers = tuple(game.numbered(*place) for place in places)
    return 1000 * placement.check_error(numbers, dome)


def test_the_game():
    outer = [(0, 0), (168, 0), (168, 120), (0, 120)]
    inner = [(24, 24), (144, 24), (144, 96), (24, 96)]
    four = game.START[:4]
    assert [error(c, False) for c in (four, outer, inner)] == [about(n, 0) for n in (63, 61, 42)]
    says("it falls from 63 to 61 mm only; 24 m further in to 42 mm", "only two pictures see them")
    best = [
        1000 * placement.check_error(placement.best_control(n, False), False) for n in (3, 4, 5)
    ]
    assert best == [about(44, 0), about(41, 0), about(41, 0)]
    says("44 mm with three, 41 mm with four and with five")
    middle = [*outer, (84, 60)]
    assert [error(c, True) for c in (outer, four, middle)] == [about(n, 0) for n in (159, 147, 79)]
    five = placement.best_control(5, True)
    assert 1000 * placement.check_error(five, True) == about(59, 0)
    says("159 mm, worse than at the start (147 mm)", "it is 79 mm; the best five reach 59 mm")
    seen = placement._all_seen(placement.free_block().block)
    assert np.bincount(seen.points)[game.numbered(0, 0)] == 2
    assert len(placement.free_block().block.R) == 18
    names = {
        f"{c}{i}": v for i, p in enumerate(game.START, 1) for c, v in zip("xy", p, strict=True)
    }
    far = control_frame(4, False, **names).pictures[0].alt
    assert "is at (168, 0) m" in far  # at the side away from the points


def test_domes():
    right, bent, held, better, oblique = (flights.flown(*k) for k in flights.FLIGHTS.values())
    heights = [1000 * found.check_rms for found in (right, bent, held, better, oblique)]
    assert heights == [about(n, 0) for n in (29, 116, 89, 67, 21)]
    assert (right.rms, bent.rms) == (about(0.620, 3), about(0.620, 3))
    assert (len(held.control), len(better.control)) == (8, 25)
    assert 1000 * held.control_rms == about(21, 0)
    corner = 3600 * 0.002 * np.hypot(2000 / 3600, 1500 / 3600) ** 3
    assert corner == about(2.4, 1)
    says("flat to ± 29 mm", "**dome**, ± 116 mm", "0.620 px, with either", "is 2.4 px in the")
    says("bring it to ± 89 mm only", "The residuals at the eight: 21 mm", "Result: ± 21 mm")
    says("and 25 to ± 67 mm", "25 control points cost a day of surveying and leave ± 67 mm")
    assert len(bent.known.truth.R) == 40
    (_, without), (k1, sigma) = flights.k1_told_by(0), flights.k1_told_by(8)
    assert (-k1, sigma, without) == (about(-0.00196, 5), about(0.00008, 5), about(0.00078, 5))
    assert without / sigma == about(9, 0)
    says("$-0.00196 \\pm 0.00008$", "\\pm\\,0.00078$, nine times as uncertain")


# Extra


def test_strasbourg():
    fetched("aerial_block/ref/ctrlpts-fixed.txt")
    city = draw.strasbourg()
    assert 2 * len(city.fit.residuals) == 94
    assert city.fit.redundancy == 64
    assert np.sqrt(city.fit.cost / 94) == about(0.8597, 4)
    assert len(city.fit.block.R) == 5
    assert len(city.control) == len(city.fit.block.points) == 16
    says("the 16 control points", "five with six numbers each")
    says("94 measured numbers minus 30 unknowns", "0.8597", "Five pictures", "$f = 123.94$ mm")


def test_the_textbook_resection():
    fetched("resection_tables/wuhan_resection.txt")
    centre = draw.textbook_resection().centre
    np.testing.assert_allclose(centre, [39795.45, 27476.46, 7572.69], atol=0.006)
    says("$(39\\,795.45,\\; 27\\,476.46,\\; 7572.69)$", "$f = 153.24$ mm", "four known points")
