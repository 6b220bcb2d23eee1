"""Exercises of chapter 05 on the way back: the inverse, and where a model folds over."""

from __future__ import annotations

from course_lib.exercises.distortion import inputs, plain
from course_lib.exercises.distortion import inverse_misconceptions as wrong
from course_lib.judging import Close, Exercise, Explain, Misconception, Part

UNDISTORT_POINTS = Exercise(
    "distortion",
    plain.undistort_points,
    points=7,
    compare=Close(rtol=0, atol=1e-7),
    parts={
        "barrel": Part(inputs.barrel, cases=2, weight=2),
        "pincushion": Part(inputs.pincushion, cases=2, weight=2),
        "all five coefficients": Part(inputs.five_at_once, cases=2, weight=3),
    },
    forbidden=(
        "course_lib.distortion.inverse.undistort_points",
        "cv2.undistortPoints",
        "cv2.undistortPointsIter",
    ),
    misconceptions=[
        Misconception(
            wrong.forward_again,
            "The lens draws a point in; you draw it in once more. Distort your answer: do you get "
            "the points back?",
        ),
        Misconception(
            wrong.one_round,
            "Near, but not there. One correction is not enough, nor are the coefficients with "
            "opposite signs. Distort your answer: by how much does it still miss?",
        ),
        Misconception(
            wrong.factor_of_the_distorted,
            "At which distance does the model want its factor: that of the ideal point, or of the "
            "distorted one?",
        ),
        Misconception(
            wrong.correction_only,
            "Is this the ideal point, or how far it is from the distorted one?",
        ),
        Misconception(
            wrong.what_it_misses,
            "This is by how much a guess misses. What do you do with that?",
        ),
        Misconception(
            wrong.radial_terms_only,
            "Right for a radial lens. Which of the five coefficients have you not used?",
        ),
        Misconception(
            wrong.wrong_way,
            "The guess runs away. If it lands too far left, to which side should it move?",
        ),
        Misconception(
            wrong.started_anew,
            "Each round moves the last guess. What does yours move: the last guess, or the "
            "measured point again and again?",
            also=[
                wrong.started_anew_ten_times,
                wrong.started_anew_thirty_times,
                wrong.started_anew_hundred_times,
            ],
        ),
        Misconception(
            wrong.same_miss_each_time,
            "Does the miss get smaller from round to round? Which point do you distort in each?",
            also=[wrong.same_miss_ten_times, wrong.same_miss_thirty_times],
        ),
        Misconception(
            wrong.target_lost,
            "With what do you compare the distorted guess: with the point that was measured?",
        ),
        Misconception(
            wrong.guess_forgotten,
            "Does each round move the last guess, or put what it misses in its place?",
            also=[wrong.guess_forgotten_from_zero],
        ),
        Misconception(
            wrong.last_guess_divided,
            "Which point should be divided by the factor in each round: your last guess, or the "
            "measured point?",
        ),
        Misconception(
            wrong.nothing_moved,
            "Your answer is the distorted points themselves. Which line moves them?",
        ),
        # Last, as it fits whatever comes near.
        Misconception(
            wrong.too_few_rounds,
            "Right way, but not there yet. How does the miss change from round to round, and "
            "when is it small enough?",
            compare=Close(rtol=0, atol=2e-3),
        ),
    ],
)

VALID_RADIUS = Exercise(
    "distortion",
    plain.valid_radius,
    points=5,
    parts={
        "k1 alone": Part(inputs.first_coefficient_alone, cases=2, weight=1),
        "one place": Part(inputs.one_fold, cases=2, weight=1),
        "two places": Part(inputs.two_folds, cases=2, weight=2),
        "none": Part(inputs.no_fold, cases=2, weight=1),
    },
    forbidden=("course_lib.distortion.inverse.valid_radius",),
    misconceptions=[
        Misconception(
            wrong.square_of_the_radius,
            "Is the root that you found a distance, or the square of one?",
        ),
        Misconception(
            wrong.where_the_factor_is_zero,
            "There the image is back at the centre. Where did it turn round?",
        ),
        Misconception(
            wrong.derivative_of_the_factor,
            "What turns round: the factor, or the distance that it multiplies?",
        ),
        Misconception(
            wrong.numbers_not_brought_down,
            "Which power of r does k1 have, once the r before the bracket is multiplied in?",
        ),
        Misconception(
            wrong.farther_fold,
            "On the way out from the centre, which of the two places do you meet first?",
        ),
        Misconception(
            wrong.second_coefficient_left_out,
            "Right with k1 alone. Where is the other coefficient?",
        ),
        Misconception(
            wrong.distorted_radius,
            "This is where the fold lies in the real picture. Which distance is asked for?",
        ),
        Misconception(
            wrong.as_degrees,
            "Your answer is an angle. Is that asked for, or its tangent r?",
            also=[wrong.as_an_angle, wrong.as_degrees_but_for_no_fold],
        ),
        Misconception(
            wrong.nan_without_fold,
            "If the image never turns round, how far out can you use the model?",
            also=[wrong.zero_without_fold, wrong.none_without_fold],
        ),
        Misconception(
            wrong.fails_without_fold,
            "`min` of an empty list has no answer. What does it mean that there is no root?",
            also=[wrong.fails_in_numpy_without_fold, wrong.first_of_none],
        ),
        Misconception(
            wrong.complex_roots_kept,
            "Print the roots where nothing folds. Are those distances?",
            also=[wrong.complex_roots_compared, wrong.sizes_of_complex_roots],
        ),
        Misconception(
            wrong.roots_not_chosen,
            "Some roots are negative. Can the square of a distance be?",
        ),
        Misconception(
            wrong.divides_by_second,
            "What is left of the equation when k2 is zero, and by what do you divide then?",
        ),
        Misconception(
            wrong.lowest_power_first,
            "`np.roots` wants the highest power first. With which does your list begin?",
        ),
        Misconception(
            wrong.powers_of_the_radius,
            "Which powers of r stand behind k1 and k2?",
        ),
    ],
)

EXPLAIN_FOLDED_CORNERS = Explain(
    "distortion",
    "explain_folded_corners",
    rubric=[
        (1, "Says that the coefficients were fitted in the middle only: beyond is extrapolation."),
        (1, "Says that r to r_d turns round beyond the valid radius: two rays share an image."),
        (
            1,
            "Says why the scene appears again: going backwards, each new pixel looks somewhere, "
            "and beyond the fold it looks further inside again.",
        ),
        (
            1,
            "Proposes a remedy: calibrate again with the target in the corners; fewer "
            "coefficients or a model that suits the lens (rational, fisheye); else leave black "
            "what lies beyond the valid radius.",
        ),
    ],
    model_answer=(
        "The board filled only the middle of the pictures, so nothing told the polynomial what the "
        "lens does in the corners: there it is extrapolated. A polynomial that fits well inside "
        "may turn round outside. Beyond the valid radius a ray farther from the axis is sent "
        "nearer to the centre again, so two rays share one place in the real picture. The map "
        "goes backwards: each pixel of the new picture asks the model where to look, and beyond "
        "the fold it is sent back inside, so the same part of the scene appears a second time, "
        "mirrored. Calibrate again with the board in the corners, with as few coefficients as the "
        "lens needs or with a rational or fisheye model. Until then, leave black what lies beyond "
        "the valid radius."
    ),
)
