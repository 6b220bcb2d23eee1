"""Exercises of chapter 11 on overlap: from the base, and the other way round."""

from __future__ import annotations

from course_lib.exercises.planning import inputs, plain
from course_lib.exercises.planning import overlap_misconceptions as wrong
from course_lib.judging import Exercise, Misconception, Part

OVERLAP = Exercise(
    "planning",
    plain.overlap,
    points=4,
    parts={
        "two pictures": Part(inputs.with_overlap, cases=1, weight=2),
        "a gap between them": Part(inputs.with_a_gap, cases=1, weight=1),
        "several pairs at once": Part(inputs.several_pairs, cases=1, weight=1),
    },
    forbidden=("course_lib.planning.flight.overlap",),
    misconceptions=[
        Misconception(
            wrong.per_cent,
            "How is 80 % written here: as 80 or as 0.8?",
        ),
        Misconception(
            wrong.new_ground,
            "Without any base both pictures are the same. What is their overlap, and yours?",
        ),
        Misconception(
            wrong.upside_down,
            "Of what should the base be a share?",
            also=[wrong.quotient_upside_down],
        ),
        Misconception(
            wrong.sign_turned,
            "Two pictures that overlap: should your number be negative?",
        ),
        Misconception(
            wrong.length_in_common,
            "That is a length on the ground. Which share of a footprint is it?",
        ),
        Misconception(
            wrong.brackets_forgotten,
            "You take a share off a length. What belongs in brackets?",
        ),
        Misconception(
            wrong.brackets_misplaced,
            "You take metres off the number 1. What must the base be divided by before?",
        ),
        Misconception(
            wrong.gap_is_zero,
            "Right where pictures overlap. How does your answer tell a gap from none?",
        ),
        Misconception(
            wrong.gap_is_positive,
            "Right where pictures overlap. Which sign has a gap?",
        ),
        Misconception(
            wrong.whole_numbers,
            "What does `//` make of a quotient, and what does `/`?",
        ),
        Misconception(
            wrong.share_of_both,
            "You divide by the ground of both pictures. Is the overlap a share of both, or of one?",
        ),
        Misconception(
            wrong.half_a_footprint,
            "The next picture begins one base farther on. Do you count the base twice, or half?",
            also=[wrong.base_shared],
        ),
        Misconception(
            wrong.largest_base,
            "You are given several bases. How many answers belong to them?",
        ),
    ],
)

BASE_FOR_OVERLAP = Exercise(
    "planning",
    plain.base_for_overlap,
    points=4,
    parts={
        "two thirds, for three pictures": Part(inputs.three_pictures, cases=1, weight=1),
        "any overlap": Part(inputs.any_share, cases=1, weight=2),
        "several overlaps at once": Part(inputs.several_shares, cases=1, weight=1),
    },
    forbidden=("course_lib.planning.flight.base_for_overlap",),
    misconceptions=[
        Misconception(
            wrong.overlap_itself,
            "More overlap: are the pictures farther apart then, or closer together?",
        ),
        Misconception(
            wrong.share_in_per_cent,
            "Is a share of 0.8 meant as 80 %, or as 0.8 %?",
            also=[wrong.hundred_less, wrong.hundred_less_per_cent],
        ),
        Misconception(
            wrong.footprint_below,
            "Your base gets shorter for a larger footprint. Should it?",
            also=[wrong.share_of_a_footprint],
        ),
        Misconception(
            wrong.share_below,
            "Your base is longer than a footprint. Do the pictures overlap at all?",
            also=[wrong.rest_of_the_share],
        ),
        Misconception(
            wrong.brackets_left_out,
            "Python multiplies before it subtracts. What belongs in brackets?",
        ),
        Misconception(
            wrong.whole_metres,
            "Your base is a whole number of metres. Must it be one?",
            also=[wrong.nearest_metres],
        ),
        Misconception(
            wrong.share_taken_off,
            "You take a share off a length. How long is that share?",
        ),
        Misconception(
            wrong.sides_exchanged,
            "Your base is negative. Which of the two should be the larger one?",
        ),
        Misconception(
            wrong.half_the_rest,
            "The camera moves by all that is new in the next picture. Do you take half of it?",
        ),
        Misconception(
            wrong.always_two_thirds,
            "Your base is right for one overlap only. Where does the argument come in?",
            also=[wrong.always_eighty_per_cent],
        ),
        Misconception(
            wrong.footprint_left_out,
            "That is the share of new ground. How many metres is it?",
        ),
    ],
)
