"""What a beginner reads when Python says something that only programmers understand."""

import math
import re

import numpy as np
import pytest

from course_lib.distortion import distort
from course_lib.judging.advice import advice
from course_lib.transforms import rigid_matrix, skew


def said(function, *inputs):
    """Return the advice for what a function raises."""
    with pytest.raises(Exception) as raised:  # noqa: PT011 - any exception has its advice
        function(*inputs)
    return advice(type(raised.value).__name__, str(raised.value))


@pytest.mark.parametrize("f", [24.0, np.float64(24), np.array([24.0])])
def test_caret_is_no_power(f):
    assert "`f**2`" in said(lambda f: f ^ 2, f)


@pytest.mark.parametrize("a", [np.eye(3), [1.0, 2.0]])
def test_bar_puts_nothing_side_by_side(a):
    assert "np.column_stack" in said(lambda a, b: a | b, a, np.ones(3))
    assert "np.column_stack" in said(lambda a, b: a | b, a, [1.0, 2.0, 3.0])


@pytest.mark.parametrize("f", [24.0, 24, np.float64(24), np.array([24.0])])
def test_bracket_after_a_number_lacks_a_star(f):
    assert "`*` missing" in said(lambda f: f(1 + 1 / 2), f)


def test_search_that_found_nothing():
    for use in (lambda: re.search("mm", "a")[1], lambda: re.search("mm", "a").groups()):
        assert "Has a search found nothing" in said(use)


def test_size_times_a_number_wants_an_array():
    assert "np.array" in said(lambda f, size: f * size, 24.0, (36, 24))
    assert "np.array" in said(lambda f, size: size * f, 24.0, [36, 24])


def test_loop_over_a_single_point():
    assert "(3,)" in said(lambda points: [X / Z for X, _, Z in points], np.array([1.0, 2, 3]))


def test_columns_of_a_single_point():
    assert "[..., 0]" in said(lambda points: points[:, 0], np.array([1.0, 2]))
    assert "first has index 0" in said(lambda points: points[2], np.array([1.0, 2]))


def test_a_mask_of_pixels_leaves_no_pictures():
    pictures = np.arange(24.0).reshape(2, 3, 4)
    words = said(lambda: pictures[pictures < 20].mean(axis=(1, 2)))
    assert "one True or False for each" in words


def test_hypot_takes_two_numbers():
    assert "np.hypot(a, b)" in said(np.hypot, (36, 24))


def test_arctan2_takes_two_numbers():
    assert "np.arctan2(a, b)" in said(np.arctan2, 0.5)


def test_tables_are_no_rows_of_points():
    x, y = np.meshgrid(np.arange(4.0), np.arange(3.0))
    for tables in (np.stack([x, y], axis=1), np.stack([x, y], axis=-1), np.column_stack([x, y])):
        assert "x.ravel(), y.ravel()" in said(distort, tables, [-0.2])
    assert "`.T`" in said(distort, np.ones((2, 5)), [-0.2])


def test_columns_and_rows_of_a_picture_differ_in_number():
    assert "np.meshgrid" in said(np.stack, [np.arange(4), np.arange(3)])


def test_guesses_that_run_away():
    assert "run away" in said(distort, np.array([[1e9, 0]]), [0.2])


@pytest.mark.parametrize("product", [np.matmul, np.dot])
@pytest.mark.parametrize("shapes", [((4, 3), (4, 3)), ((3, 3), (4, 3)), ((4, 3), (4,))])
def test_matrix_before_rows_of_points(product, shapes):
    words = said(product, *map(np.ones, shapes))
    assert "`points @ A.T`" in words
    assert "Print both shapes" in words


def test_number_in_a_matrix_product():
    assert "`*`" in said(np.matmul, np.eye(3), 2.0)


def test_arrays_that_do_not_fit_side_by_side():
    rows = np.ones((4, 3))
    for other, axis in ((np.ones((1, 4)), 1), (np.ones(4), 1), (np.ones((4, 2)), 0)):
        assert "Print both shapes" in said(lambda a=other, b=axis: np.concatenate([rows, a], b))


def test_determinant_of_a_camera_matrix():
    assert "square part" in said(np.linalg.det, np.ones((3, 4)))
    assert "least squares" in said(np.linalg.inv, np.ones((8, 2)))


def test_a_single_point_as_a_column():
    point = np.array([3.0, 4])
    words = said(lambda: np.column_stack([point, np.ones(2)]) @ np.eye(3))
    assert "`column_stack`" in words


def test_a_column_that_became_a_row():
    table = np.ones((4, 3))
    assert "`a[:, 2:]`" in said(lambda: table[:, :2] / table[:, 2])


def test_a_length_for_each_row_is_no_column():
    table = np.ones((5, 3))
    assert "`a[:, None]`" in said(lambda: table / np.linalg.norm(table[:, :2], axis=1))
    assert "`a[:, None]`" not in said(lambda: table / np.ones(4))


@pytest.mark.parametrize("rows", [([1, 2], [3, 4]), ([1, 2], [3, 4], [5, 6])])
def test_rows_without_outer_brackets(rows):
    assert "brackets of its own" in said(np.array, *rows)


def test_fits_of_a_sample_do_not_pick_from_all_pairs():
    assert "those of a sample" in said(lambda: np.ones((40, 2))[np.ones(8, bool)])


def test_a_system_whose_right_side_is_zero():
    F = np.array([[0, 0, 0], [0, 0, -1], [0, 1, 0]])
    for right in (0, np.zeros(3)):
        assert "SVD" in said(np.linalg.solve, F, right)


def test_logarithm_of_a_negative_number():
    assert "above 0" in said(math.log, 1 - 0.5 * 8)


def test_a_column_is_no_vector():
    assert "`a[:, 3]`" in said(skew, np.ones((3, 1)))


def test_a_name_without_its_module():
    assert "`np` in `np.sqrt`" in said(eval, "to_homogeneous(3)")


def test_more_values_than_names():
    assert "`x, *_ =`" in said(exec, "m, c = (1, 2, 3, 4)")


def test_other_advice_is_not_hidden():
    assert "np.array" in said(lambda points: points / 2, [1, 2])
    assert "divisor is zero" in said(lambda: 1.0 / 0)
    assert advice("AssertionError", "a") == ""


def test_matrices_without_an_inverse():
    assert "depend on each other" in said(np.linalg.inv, np.ones((2, 2)))
    assert "`a[:, None]`" in said(np.linalg.solve, np.ones(2), np.ones(2))
    assert "`a[:, None]`" in said(np.linalg.lstsq, np.ones(2), np.ones(2))


def test_reshape_keeps_the_number_of_entries():
    assert "as many entries" in said(np.ones(12).reshape, 3, 3)


@pytest.mark.parametrize("together", [np.column_stack, np.hstack, np.concatenate, np.stack])
def test_arrays_to_put_together_need_brackets_of_their_own(together):
    assert "brackets of its own" in said(np.column_stack, np.eye(3), np.ones(3))
    assert "brackets of" in said(together, np.eye(3), np.ones((3, 1)))
    words = said(lambda: np.concatenate(np.eye(3), np.ones((3, 1)), axis=-1))
    assert "`np.concatenate([a, b], axis=-1)`" in words


def test_ones_without_their_axis():
    assert "`axis=-1`" in said(np.concatenate, [np.ones((4, 2)), np.ones((4, 1))])


def test_star_between_matrices():
    assert "`@`" in said(lambda K, pose: K * pose, np.eye(3), np.ones((3, 4)))


def test_shift_without_its_name():
    assert "`rigid_matrix(t=…)`" in said(rigid_matrix, np.ones(3))


def test_rows_that_come_apart_as_rows():
    def coordinates(point):
        x, y, w = point
        return np.array([x / w, -1, y])

    assert "`p[..., 0]`" in said(coordinates, np.ones((4, 3)))
    assert "`p[..., 0]`" in said(coordinates, np.ones((3, 4)))


@pytest.mark.parametrize("numbers", [2, 3])
def test_a_shift_of_points_in_columns(numbers):
    words = said(lambda points, t: points.T + t, np.zeros((20, numbers)), np.zeros(numbers))
    assert "`+ t[:, None]`" in words
    assert "not with `*`" not in words


def test_two_unknowns_want_two_columns():
    words = said(lambda a, b: np.linalg.lstsq(a, b, rcond=None), np.arange(4.0), np.arange(4.0))
    assert "`np.column_stack([a, b])`" in words


def test_a_system_lying_on_its_side():
    A, b = np.ones((2, 24)), np.ones(24)
    words = said(lambda: np.linalg.lstsq(A, b, rcond=None))
    assert "one row for each equation" in words


def test_an_array_for_a_yes_or_no_can_have_an_axis_too_many():
    assert "an axis too many" in said(lambda b: 1 if b < 0 else 2, np.arange(6.0))


def test_slips_in_a_table_of_cells():
    row, column = np.array([0, 1]), np.array([1, 1])
    for joined in (lambda: (row == 0) and (column == 1), lambda: row == 0 & column == 1):
        assert "joined by `&`" in said(joined)
    assert "`np.zeros((3, 4, 2))`" in said(lambda: np.zeros(6, 8, 2))

    def filled():
        table = np.zeros((6, 8))
        table[0, 0] = np.ones(2)

    assert "is an axis missing?" in said(filled)


def test_one_number_for_a_column():
    for points in (np.ones((4, 2)), np.ones(2)):
        assert "`np.ones(len(points))`" in said(lambda p=points: np.column_stack([p, 1]))


def test_several_values_under_one_name():
    assert "Name each" in said(lambda: (np.ones((4, 2)), np.eye(3)).T)


@pytest.mark.parametrize("number", [3, 3.0, np.float64(3)])
def test_a_number_is_no_list(number):
    assert "`range(n)`" in said(lambda: [2 * one for one in number])
    assert "`range(n)`" in said(lambda: max(number))


def test_whole_numbers_where_they_belong():
    assert "`int(…)`" in said(range, 2.5)
    assert "`np.minimum(a, b)`" in said(np.min, 2.5, 3.5)


def test_a_key_that_is_not_there():
    assert "print(list(…))" in said(lambda task: task["blur"], {"blur_px": 2})


def test_the_smallest_of_none():
    assert "No entries are left" in said(lambda a: a[a > 9].min(), np.arange(3.0))


@pytest.mark.parametrize(
    "use", ["a, b = nothing()", "nothing()[0]", "2 * nothing()", "nothing()()"]
)
def test_a_function_that_lacks_its_return(use):
    assert "`return`" in said(exec, use, {"nothing": lambda: None})


@pytest.mark.parametrize(
    "use",
    ["np.linalg.norm - 1", "a.sum / 2", "np.sqrt * 2", "np.array[1, 2]", "len > 2", "2 > len"],
)
def test_a_function_without_its_brackets(use):
    assert "round brackets call it" in said(exec, use, {"np": np, "a": np.ones(3)})


def test_an_index_is_a_whole_number():
    a, rows = np.ones((4, 2)), [[1.0, 2.0], [3.0, 4.0]]
    for use in (lambda: a[1.0], lambda: a[np.array([0.0, 1.0])], lambda: rows[len(rows) / 2]):
        assert "`//`" in said(use)
    assert "has no columns" in said(lambda: rows[:, 0])


def test_what_has_no_parts():
    for use in (lambda: np.float64(2)[0], lambda number=2.0: number[0]):
        assert "no parts" in said(use)
    for many in (zip("a"), map(abs, [1]), {1: 2}.values(), (x for x in "a")):
        assert "`list(…)`" in said(lambda m=many: m[0])
    assert "no length" in said(len, 2.5)


def test_names_behind_a_dot():
    assert "`np.linalg.norm`" in said(lambda: np.norm)
    assert "`np.cross(a, b)`" in said(lambda: np.ones(3).cross(np.ones(3)))
    assert "`np.asarray(…)`" in said(lambda number=2.0: number.shape)


def test_texts_that_are_no_numbers():
    assert "`float(…)`" in said(lambda text="12": text - 1)
    assert "`float(…)`" in said(lambda text="12": text + 1)
    assert "letters or blanks" in said(float, "50 mm")
    assert "letters or blanks" in said(int, "f/8")


def test_numbers_that_are_no_finite_ones():
    for use in (lambda: int(math.nan), lambda: int(math.inf)):
        assert "NaN or infinite" in said(use)
    assert "NaN or infinite" in said(np.linalg.svd, np.full((3, 3), np.nan))


def test_whole_numbers_that_should_be_decimals():
    a = np.array([1, 2])
    assert "`1 / a`" in said(lambda: a**-1)
    assert "`a = a / 2`" in said(exec, "a /= 2", {"a": a})


def test_true_and_false_are_not_subtracted():
    yes = np.array([True, False])
    assert "`~a`" in said(lambda: yes - yes)
    assert "`~a`" in said(lambda: -yes)


def test_letters_of_einsum():
    assert "`einsum`" in said(np.einsum, "ij,jk", np.ones((4, 3)), np.ones((4, 3)))


def test_the_smallest_of_an_empty_list():
    assert "No entries are left" in said(min, [])


@pytest.mark.parametrize(
    ("use", "words"),
    [
        ("np.linalg(a)", "Which of its functions"),
        ("(1, 2) / 2", "Make it an array"),
        ("[1, 2].T", "Make it an array"),
        ("math.sqrt(a)", "NumPy has it for arrays"),
        ("np.zeros(2.5)", "`int(…)`"),
        ("np.sum(a, axes=0)", "no argument of this name"),
        ("np.eye()", "number of arguments"),
        ("(lambda: (own, own := 1))()", "before it is assigned"),
        ("np.linalg.cholesky(-np.eye(2))", "no factor"),
        ("np.linalg.eig(np.nan * np.eye(2))", "NaN or infinite"),
        ("np.einsum('ij->k', np.eye(2))", "each axis has its letter"),
        ("np.diag(np.ones((2, 2, 2)))", "`np.eye`"),
    ],
)
def test_common_slips(use, words):
    assert words in said(eval, use, {"np": np, "math": math, "a": np.ones(3)})


def test_a_function_that_calls_itself():
    def again():
        return again()

    assert "calls itself" in said(again)


@pytest.mark.parametrize(
    ("error", "message", "words"),
    [
        ("TypeError", "only length-1 arrays can be converted to Python scalars", "for arrays too"),
        ("ValueError", "expected a positive input, got -1.0", "above 0"),
    ],
)
def test_other_versions_say_it_in_other_words(error, message, words):
    assert words in advice(error, message)
