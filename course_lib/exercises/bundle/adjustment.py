"""Exercises of chapter 10 on many cameras: one step of the adjustment, and all of it."""

from __future__ import annotations

from course_lib.exercises.bundle import adjustment_misconceptions as wrong
from course_lib.exercises.bundle import inputs, plain
from course_lib.exercises.bundle import step_misconceptions as step
from course_lib.judging import Exercise, Misconception, Part

SOLVE_NORMAL_BLOCK = Exercise(
    "bundle",
    plain.solve_normal_block,
    points=10,
    parts={
        "one point": Part(inputs.one_point, cases=1, weight=4),
        "five points": Part(inputs.many_points, cases=1, weight=6),
    },
    forbidden=("course_lib.bundle.normals.solve_normal_block",),
    misconceptions=[
        Misconception(
            step.added_to_U,
            "A point that may move holds the cameras less firmly. Does your sum make U larger?",
        ),
        Misconception(
            step.points_ignored,
            "You solve for the cameras as if no point could move. Where does the first equation "
            "have the points?",
        ),
        Misconception(
            step.each_alone,
            "Cameras and points, each as if the others did not move. Where is W?",
        ),
        Misconception(
            step.gradient_of_points_left_out,
            "The left side for the cameras is right. What do the gradients of the points add on "
            "the right?",
        ),
        Misconception(
            step.gradient_of_points_subtracted,
            "The left side for the cameras is right. Bring the points' share to the right: which "
            "sign has it there?",
        ),
        Misconception(
            step.uphill,
            "Put your step into the first equation: which sign does the right side have?",
            also=[step.cameras_uphill],
        ),
        Misconception(
            step.points_uphill,
            "The step of the cameras is right. Which sign has the gradient of a point?",
        ),
        Misconception(
            step.cameras_put_in_with_plus,
            "The step of the cameras is right. On which side of a point's equation does it stand "
            "when you solve for the point?",
        ),
        Misconception(
            step.points_do_not_follow,
            "The step of the cameras is right. Do your points know that the cameras have moved?",
        ),
        Misconception(
            step.points_not_solved,
            "The step of the cameras is right. What stands before the step of a point in its "
            "equation, and what undoes it?",
            also=[step.points_multiplied_by_V],
        ),
        Misconception(
            step.cameras_not_solved,
            "You multiply with the matrix that stands before the step. What undoes it?",
        ),
        Misconception(
            step.V_not_inverted,
            "The better a point is held, the less it gives way. Is your V inverted, and as a "
            "matrix, not each number by itself?",
            also=[
                step.inverted_entry_by_entry,
                step.inverted_entry_by_entry_everywhere,
            ],
        ),
        Misconception(
            step.the_last_point_only,
            "With one point it is right. Does each round of your loop add to what was there "
            "before, or replace it?",
            also=[step.S_of_the_last_point_only, step.right_side_of_the_last_point_only],
        ),
        Misconception(
            step.U_once_for_each_point,
            "With one point it is right. How often does U itself stand in the sum?",
        ),
        Misconception(
            step.U_left_out,
            "With what do your sums begin, before the first point comes? Look at what stands in "
            "front of each Σ.",
            also=[
                step.both_begin_at_zero,
                step.both_begin_at_zero_and_grow,
                step.sum_of_the_points_only,
                step.gradient_of_cameras_left_out,
            ],
        ),
        Misconception(
            step.whole_stacks,
            "W and V are stacks, a block for each point, and the equation has a Σ. Have you a loop "
            "over the points, with `W[j]` and `V[j]`?",
            also=[step.whole_stacks_turned_rightly],
        ),
        Misconception(
            step.summed_over_everything,
            "`np.sum` without an axis makes a single number. Along which axis do the points lie?",
            also=[step.S_summed_over_everything],
        ),
        Misconception(
            step.back_after_the_first_point,
            "With one point it is right. Where does your `return` stand: inside of the loop, or "
            "after it?",
            also=[step.back_after_the_first_round, step.first_point_only_returned],
        ),
        Misconception(
            step.inverse_times_entries,
            "Your inverse is multiplied number by number. How is a matrix applied to a vector?",
        ),
        Misconception(
            step.not_transposed,
            "Compare your products with the equations, letter by letter. Is W transposed there?",
            also=[step.not_transposed_for_cameras, step.not_transposed_for_points],
        ),
        Misconception(
            step.points_first,
            "Both steps are there. Which is to come first?",
        ),
        Misconception(
            step.all_in_one_row,
            "How many things does the function return, and how many rows has the table of points?",
            also=[step.points_in_a_row, step.last_point_only_returned, step.cameras_only],
        ),
    ],
)

BUNDLE_ADJUST = Exercise(
    "bundle",
    plain.bundle_adjust,
    points=10,
    parts={
        "a step that helps": Part(inputs.a_step_that_helps, cases=1, weight=6),
        "a step that does not": Part(inputs.a_step_that_does_not, cases=1, weight=4),
    },
    forbidden=("course_lib.bundle.adjustment.bundle_adjust",),
    misconceptions=[
        Misconception(
            wrong.not_damped,
            "Pictures alone leave open where the whole block is. What makes the equations "
            "solvable all the same?",
        ),
        Misconception(
            wrong.only_cameras_damped,
            "Cameras and points take part in a step. Are the diagonals of both damped?",
            also=[wrong.only_points_damped],
        ),
        Misconception(
            wrong.the_whole_blocks_damped,
            "Which entries of a block does the damping change: all of them?",
            also=[
                wrong.W_damped_too,
            ],
        ),
        Misconception(
            wrong.ones_on_the_diagonal,
            "A turn in rad and a move in metres differ by thousands in U. Does your damping add "
            "the same to all, or a share of each? Mind the brackets, for U and for V.",
            also=[wrong.ones_on_U, wrong.ones_on_U_only, wrong.ones_on_V],
        ),
        Misconception(
            wrong.six_rows_for_U,
            "`np.eye(n)` must be as large as what it damps. How many rows has U, with all its "
            "cameras, and how many has one block of V?",
            also=[wrong.as_many_rows_as_points],
        ),
        Misconception(
            wrong.step_subtracted,
            "Your steps never help. Is their sign turned round? Or does U lose what stands on its "
            "diagonal, or beside it, when you damp it?",
            also=[wrong.one_left_out, wrong.only_the_diagonal_left],
        ),
        Misconception(
            wrong.only_cameras_moved,
            "A step has two parts. Do cameras and points both go to their new places?",
            also=[wrong.only_points_moved],
        ),
        Misconception(
            wrong.every_step_kept,
            "A step that helps is right. Where do you stay after one that makes the error larger? "
            "Is the old error that of the old R, t and points?",
            also=[wrong.overwritten, wrong.compared_with_a_mixture],
        ),
        Misconception(
            wrong.compared_with_itself,
            "Which two errors do you compare? Do R, t and points still stand for where we were?",
        ),
        Misconception(
            wrong.damping_by_a_hundred,
            "Where the step leads is right. By which number is the damping divided or multiplied?",
            also=[wrong.damping_lowered_by_a_hundred, wrong.damping_halved],
        ),
        Misconception(
            wrong.nothing_after_a_refusal,
            "A step that helps is right. What does your function return after one that does not?",
        ),
        Misconception(
            wrong.larger_errors_kept,
            "Which steps do you keep: those after which the error is larger?",
        ),
        Misconception(
            wrong.damping_never_raised,
            "A refused step, tried again with the same damping, is the same step. What must "
            "change?",
        ),
        Misconception(
            wrong.damping_never_lowered,
            "A step has helped. Should the next one be damped as much as this one?",
            also=[wrong.damping_stays],
        ),
        Misconception(
            wrong.damping_the_wrong_way,
            "A step was too long and was refused. Should the next one have more damping, or less?",
        ),
        Misconception(
            wrong.damping_left_out_of_the_answer,
            "Cameras and points are right. What else does the next step need to know?",
        ),
        Misconception(
            wrong.the_step_returned,
            "These are steps. Where do they lead to, and do they help?",
        ),
    ],
)
