"""The questions of the lab report; who grades them sees the report above the last question."""

from course_lib.judging import Explain

EXPLAIN_CAMERA = Explain(
    "lab",
    "explain_camera",
    rubric=[
        (1, "Gives the numbers: how many photographs, the RMS and the ± of a focal length."),
        (
            1,
            "Says that the RMS alone proves little, and uses another sign: held-out photographs, "
            "coverage or tilts.",
        ),
        (1, "Names where in the picture the camera is not to be trusted, and why."),
        (1, "Names a photograph that was set aside, with the reason, and what would mend it."),
    ],
    model_answer=(
        "Of 17 photographs 12 were used, three were kept for measuring. The RMS is 0.02 px and "
        "fx = 881.96 px ± 0.14 px. The RMS alone would be as small if the target had never been in "
        "a corner of the picture; but photographs that were held out fit as well, the target was "
        "tilted to all four sides by up to 40°, and 45 of 48 fields of the picture have corners. "
        "The fields without any are at the upper edge and in a lower corner, so I would not "
        "measure there. desk_13 was set aside because it is blurred: the phone moved. I would "
        "take it again, leaning on the desk."
    ),
)

EXPLAIN_PLANE = Explain(
    "lab",
    "explain_plane",
    rubric=[
        (1, "Gives the length with its ± and says what 95 % means."),
        (1, "Names the largest part of the uncertainty in the table, and what would lessen it."),
        (
            1,
            "Explains the lid: its height was forgotten, so the rays were followed too far, to the "
            "desk.",
        ),
        (1, "Computes or estimates the factor Z / (Z - h) and finds that it explains the error."),
    ],
    model_answer=(
        "The card is 85.6 mm ± 0.9 mm wide: if I measured again and again, each time with new "
        "photographs, 95 % of such intervals would hold the true width. By far the largest part is "
        "pointing, 0.39 mm of 0.44 mm; a photograph from nearer, so that a pixel covers less of "
        "the card, would help most. The edge of the lid came out as 138 mm instead of 120 mm, "
        "because its ends are 60 mm above the plane: the rays go on past them until they meet "
        "the desk. The camera was 457 mm above it, so the factor is 457 / (457 - 60) = 1.15, and "
        "120 mm · 1.15 = 138 mm."
    ),
)

EXPLAIN_SPACE = Explain(
    "lab",
    "explain_space",
    rubric=[
        (1, "Gives the length in space with its ±, and compares it with that on the plane."),
        (1, "Says why two pictures find the height that one cannot: two rays meet in one point."),
        (
            1,
            "Says what happens if the camera hardly moves between them: rays nearly parallel, and "
            "the error along them grows.",
        ),
        (1, "Names what must not move between the two pictures: object and target (or focus)."),
    ],
    model_answer=(
        "In space the edge is 119.9 mm ± 0.7 mm; on the plane it seemed to be 138 mm. One picture "
        "gives a ray only, and the point could be anywhere on it; the second picture's ray crosses "
        "it, and that is the point, at whatever height. My rays meet at 51°. From nearly the same "
        "place they would be nearly parallel, and a small error of pointing would move their "
        "meeting point far along them, so the ± would grow. Between the pictures only the camera "
        "may move: box and target stay where they are, and the focus stays as well."
    ),
)

EXPLAIN_RULER = Explain(
    "lab",
    "explain_ruler",
    rubric=[
        (1, "Gives both values with ±, their difference, and how the ± of the ruler was found."),
        (1, "Judges by the ratio of the difference to both ± together, and not by the difference."),
        (
            1,
            "Names an error that is in no part of the table (a bent target, a wrong length of its "
            "squares, a rounded edge, a moved focus).",
        ),
        (1, "Says in which direction that error would go, or how it could be tested."),
    ],
    model_answer=(
        "Camera: 85.6 mm ± 0.9 mm; ruler: 85.5 mm ± 0.7 mm, as I can read half a millimetre at "
        "each end. The difference is 0.1 mm, and both ± together are 1.1 mm, so E = 0.1: they "
        "agree. If squares that are said to be 25 mm were printed as 24.8 mm, all "
        "lengths would come out 0.8 % too long, both those on the plane and those in space, and "
        "nothing in the table would show it. I would see it at the bar beside the target, which "
        "must measure 100 mm."
    ),
)

EXPLAIN_REPORT = Explain(
    "lab",
    "explain_report",
    rubric=[
        (
            2,
            "The report is there, with a camera, a length on the plane and one in space.",
        ),
        (1, "States the results so that somebody else can use them: value, ±, 95 %, unit."),
        (1, "Says what must stay as it is for the camera to be used again tomorrow."),
        (1, "Proposes one change that is worth most, from the table of contributions."),
        (1, "Says for what a ± of this size is good enough, or not."),
    ],
    model_answer=(
        "With a phone's camera and a printed target, the width of a bank card on the plane of the "
        "target is 85.6 mm ± 0.9 mm, and the front edge of a box's lid, 60 mm above it, "
        "119.9 mm ± 0.7 mm (95 %). The camera may be used again as long as zoom, focus and size "
        "of the pictures stay as they are; one photograph of the target tells whether it still "
        "fits. Most of the ± is pointing. So I would first go nearer, or photograph at full "
        "size, and only then think of a better target. For finding out whether the box fits on a "
        "shelf this is more than enough; for a part that must fit into a hole to a tenth of a "
        "millimetre it is not."
    ),
)
