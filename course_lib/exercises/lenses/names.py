"""Exercise of chapter 03 on what a lens is called."""

from __future__ import annotations

from course_lib import optics
from course_lib.exercises.lenses import inputs_names as inputs
from course_lib.exercises.lenses import misconceptions_names as wrong
from course_lib.judging import Exercise, Misconception, Part

PARSE_LENS_NAME = Exercise(
    "lenses",
    optics.parse_lens_name,
    points=5,
    parts={
        "a prime lens": Part(inputs.prime, cases=2),
        "a zoom": Part(inputs.zoom, cases=2),
        "a zoom with one f-number": Part(inputs.zoom_of_one_aperture, cases=2, weight=0.5),
        "an f-number written as a ratio": Part(inputs.ratio_notation, cases=2),
        "an f-number after a capital letter": Part(inputs.capital_letter, cases=2, weight=0.5),
        "an f-number after a small letter": Part(inputs.small_letter, cases=2, weight=0.5),
        "a focal length with a point": Part(inputs.with_a_point, cases=2, weight=0.5),
        "a space before mm": Part(inputs.space_before_mm, cases=2, weight=0.5),
        "a name without a focal length": Part(inputs.no_focal_length, cases=2, weight=0.4),
        "a name without an f-number": Part(inputs.no_f_number, cases=2, weight=0.4),
        "a name that lacks both": Part(inputs.neither, cases=1, weight=0.2),
    },
    misconceptions=[
        Misconception(
            wrong.first_numbers,
            "Some names hold other numbers too. What stands right behind a focal length, and what "
            "before an f-number?",
            also=[wrong.any_number],
        ),
        Misconception(
            wrong.whole_numbers,
            "Print what your pattern finds in a name with 2.8 in it. Does it read past the point?",
        ),
        Misconception(
            wrong.one_way_of_writing,
            "Makers write the f-number in several ways. Which does your pattern not know?",
            also=[
                wrong.one_way_of_writing_and_a_check,
                wrong.no_capital_letter,
                wrong.no_capital_letter_and_no_check,
                wrong.no_capital_letter_and_half_a_check,
                wrong.no_small_letter,
            ],
        ),
        Misconception(
            wrong.first_of_a_range,
            "Twist the zoom ring: the lens has two ends. Which of them have you read?",
            also=[wrong.first_of_two_numbers],
        ),
        Misconception(
            wrong.second_number_with_its_minus,
            "A second number is negative. Which part of the match holds the minus, too, and which "
            "the number alone?",
            also=[wrong.focal_length_with_its_minus],
        ),
        Misconception(
            wrong.sign_for_a_number,
            "No f-number is read. Which part of its match is the sign, such as f/, and which the "
            "number? And does mm still end its pattern?",
            also=[
                wrong.sign_for_a_number_and_no_check,
                wrong.millimetres_behind_the_f_number,
                wrong.millimetres_behind_the_f_number_and_a_check,
            ],
        ),
        Misconception(
            wrong.texts_for_numbers,
            "Can one compute with your answer? What makes a number of the text '50'?",
        ),
        Misconception(
            wrong.answers_anything,
            "None goes on, and fails somewhere else. What should a name that tells nothing give?",
        ),
        Misconception(
            wrong.every_lens_a_zoom,
            "A prime lens has one focal length only. What is the pair then, and does your pattern "
            "find it?",
            also=[
                wrong.second_number_taken_for_granted,
                wrong.second_number_taken_for_granted_and_no_check,
                wrong.none_for_the_second_number,
            ],
        ),
        Misconception(
            wrong.signs_without_their_bracket,
            "A bar `|` parts the whole pattern, if no bracket ends what it parts. Is there one "
            "around the four signs?",
        ),
        Misconception(
            wrong.number_without_its_bracket,
            "Print the parts of the match, `[1]`, `[2]` and so on. Has the first number a bracket "
            "of its own that remembers it?",
        ),
        Misconception(
            wrong.returns_the_error,
            "You hand the refusal back like an answer, and the program would go on with it. Which "
            "word stops it?",
            also=[wrong.returns_a_text],
            compare=wrong.BothTexts(),
        ),
        Misconception(
            wrong.digits_after_the_point,
            "Print what your pattern finds for the focal length 10.5. Does `\\d` alone know the "
            "point?",
        ),
        Misconception(
            wrong.no_space_allowed,
            "Some makers write a space between the number and mm. Which sign in a pattern allows "
            "for it?",
        ),
        Misconception(
            wrong.no_space_and_no_check,
            "A space before mm hides the number from your pattern, and your search comes back "
            "with None. Which sign allows for a space?",
        ),
        Misconception(
            wrong.search_may_find_nothing,
            "What does `re.search` give when it finds nothing, and what should the function do "
            "then? You search twice: either can find nothing.",
            also=[
                wrong.f_number_taken_for_granted,
                wrong.focal_length_taken_for_granted,
                wrong.refuses_what_lacks_both,
            ],
        ),
    ],
)
