"""Exercises of chapter 08 on RANSAC, on the pose from E, and a question in words."""

from __future__ import annotations

from course_lib.exercises.epipolar import pair_inputs as inputs
from course_lib.exercises.epipolar import plain_estimation as plain
from course_lib.exercises.epipolar import search_misconceptions as wrong
from course_lib.exercises.epipolar.comparison import MatrixAndFits, TheOtherWayRound
from course_lib.judging import Exercise, Explain, Misconception, Part

RANSAC_FUNDAMENTAL = Exercise(
    "epipolar",
    plain.ransac_fundamental,
    points=8,
    compare=MatrixAndFits(),
    parts={
        "exact pairs, and a quarter wrong": Part(inputs.exact_but_a_quarter, cases=1, weight=4),
        "pairs with noise, and nearly half wrong": Part(
            inputs.noisy_but_nearly_half, cases=1, weight=4
        ),
    },
    forbidden=(
        "course_lib.epipolar.robust.ransac_fundamental",
        "cv2.findFundamentalMat",
    ),
    misconceptions=[
        Misconception(
            wrong.last_sample,
            "Few pairs fit your F. What decides which sample you keep: its place, its errors, "
            "whether its own eight pairs fit, or how many of all pairs fit?",
            also=[
                wrong.agreement_of_the_sample,
                wrong.agreement_of_the_sample_last,
                wrong.last_sample_not_refined,
                wrong.first_sample,
                wrong.smallest_sum_of_errors,
                wrong.fewest_fits,
                wrong.samples_not_used,
                wrong.samples_not_used_but_refined,
                wrong.first_eight_pairs,
            ],
        ),
        Misconception(
            wrong.not_refined,
            "Without noise it is right. Your F knows eight pairs. How many agree with it, and "
            "could help?",
            also=[wrong.last_of_the_best_not_refined],
        ),
        Misconception(
            wrong.threshold_squared,
            "Some wrong pairs pass that are just beyond the threshold. Is the error you compare "
            "with it already a distance?",
        ),
        Misconception(
            wrong.refined_with_all,
            "The right pairs are marked. Which pairs make your final F?",
        ),
        Misconception(
            wrong.wrong_ones_marked,
            "Which pairs do you mark with True: those that fit, or the others?",
        ),
        Misconception(
            wrong.wrong_ones_counted,
            "Is a right pair one with a small error, or with a large one?",
        ),
        Misconception(
            wrong.numbers_of_the_pairs,
            "F is right. What does a comparison give for each pair, before you pick with it?",
            also=[wrong.fits_as_numbers, wrong.fits_counted, wrong.errors_for_fits],
        ),
        Misconception(
            wrong.only_F,
            "Two things are asked for. Which one is missing?",
            also=[wrong.only_fits],
        ),
        Misconception(
            wrong.fits_before_F,
            "Both are right. In which order are they asked for?",
            compare=TheOtherWayRound(MatrixAndFits()),
        ),
        Misconception(
            wrong.sample_marked,
            "You mark the eight pairs of the sample. Which others agree with its F?",
        ),
    ],
)

POSE_FROM_ESSENTIAL = Exercise(
    "epipolar",
    plain.pose_from_essential,
    points=8,
    parts={
        "several points": Part(inputs.several_points, cases=1, weight=4),
        "one point": Part(inputs.one_point, cases=1, weight=4),
    },
    forbidden=(
        "course_lib.epipolar.essential.pose_from_essential",
        "course_lib.epipolar.essential.poses_from_essential",
        "cv2.recoverPose",
        "cv2.decomposeEssentialMat",
    ),
    misconceptions=[
        Misconception(
            wrong.points_not_asked,
            "You return the same one of the four poses each time. Who tells which is right?",
        ),
        Misconception(
            wrong.mirrored,
            "Here the determinant of your R is −1. What makes a rotation of a mirror image?",
        ),
        Misconception(
            wrong.one_turn_only,
            "You try one rotation. Which is the other one that E allows?",
        ),
        Misconception(
            wrong.one_sign_only,
            "E does not know its sign. Which poses does that allow beside yours?",
            also=[wrong.one_sign_and_the_other_turn_else],
        ),
        Misconception(
            wrong.behind_the_cameras,
            "Which sign has the depth of a point that a camera sees?",
        ),
        Misconception(
            wrong.before_camera_1_only,
            "You ask one camera. Can a point be before it and still behind the other one?",
            also=[wrong.before_camera_2_only, wrong.before_one_of_both],
        ),
        Misconception(
            wrong.camera_2_to_camera_1,
            "Yours leads from camera 2 to camera 1. Which way is asked for?",
        ),
        Misconception(
            wrong.centre_for_t,
            "This is where camera 2 stands, or its opposite. Is that the t that E was made of?",
        ),
        Misconception(
            wrong.rotation_transposed,
            "Your t is right. Does your R lead from camera 1 to camera 2?",
        ),
        Misconception(
            wrong.t_of_the_other_null_space,
            "None of your poses is right. Which factor comes transposed, is W between both, and on "
            "which side of E is t?",
            also=[wrong.t_from_a_row, wrong.last_factor_transposed_again, wrong.without_W],
        ),
        Misconception(
            wrong.t_of_the_length_of_E,
            "Does E know how far apart the cameras are? Which length is asked for?",
        ),
        Misconception(
            wrong.t_before_R,
            "Both are right. In which order are they asked for?",
        ),
        Misconception(
            wrong.only_R,
            "Two things are asked for. Which one is missing?",
        ),
    ],
)

EXPLAIN_SCALE = Explain(
    "epipolar",
    "explain_scale",
    rubric=[
        (1, "Says that a scene and a baseline k times as large give the same two pictures."),
        (1, "Says that a multiple of E fits as well, so the length of t is open."),
        (1, "Names one measurement that would tell: a length in the scene, or the baseline."),
        (1, "Says that angles and ratios of distances are known without it."),
    ],
    model_answer=(
        "Make everything ten times as large: the scene, and the distance between the cameras. "
        "Every ray keeps its direction, so both pictures stay the same to the last pixel, and "
        "pictures that are the same cannot tell a model from a house. In the formulas: if x2ᵀ E x1 "
        "is zero it is zero for 10 E too, and the length of t is in E as a factor only. R, the "
        "direction of t, and the form of the scene with all its angles and ratios are known. One "
        "length is enough for the rest: between two points of the scene, or between the cameras."
    ),
)
