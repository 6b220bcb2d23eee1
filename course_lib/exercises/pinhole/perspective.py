"""Exercises of chapter 01 on what a pinhole does to the world: points, directions, distances."""

from __future__ import annotations

from course_lib import camera
from course_lib.exercises.pinhole import inputs
from course_lib.exercises.pinhole import misconceptions_perspective as wrong
from course_lib.judging import Exercise, Explain, Misconception, Part

PROJECT_PINHOLE = Exercise(
    "pinhole",
    camera.project_pinhole,
    points=6,
    parts={
        "points in front of the camera": Part(inputs.points_in_front, weight=2),
        "a single point": Part(inputs.one_point, weight=1),
        "two focal lengths (fx, fy)": Part(inputs.two_focal_lengths, weight=1),
        "points that are not in front": Part(inputs.points_behind, weight=2),
    },
    misconceptions=[
        Misconception(
            wrong.divides_by_focal_length,
            "What makes a distant object small in the picture: the lens or the distance?",
        ),
        Misconception(
            wrong.exchanges_f_and_Z,
            "Let the point move away: Z grows. Does its image grow or shrink in your formula?",
        ),
        Misconception(
            wrong.principal_point_forgotten,
            "A point on the optical axis: which pixel should it get, and which do you give it?",
        ),
        Misconception(
            wrong.row_then_column,
            "Which of u and v runs along a row of pixels, and which of X and Y does?",
        ),
        Misconception(
            wrong.image_plane_behind,
            "Your picture stands on its head, as on the wall of a real camera obscura. "
            "On which side of the hole does the course put the image plane?",
        ),
        Misconception(
            wrong.distance_for_depth,
            "Is it the distance along the ray that counts, or the depth along the optical axis?",
        ),
        Misconception(
            wrong.mirrors_what_is_behind,
            "Can light from behind the camera reach the picture? What should such a row say?",
        ),
        Misconception(
            wrong.centre_added_first,
            "Is c a length in the scene or a place in the picture? When should it be added?",
        ),
        Misconception(
            wrong.depth_without_sign,
            "A point behind the camera: does it appear where one in front of it would?",
        ),
        Misconception(
            wrong.zero_depth_is_in_front,
            "A point at depth zero lies beside the hole. Is it in front of the camera?",
        ),
        Misconception(
            wrong.both_focal_lengths_for_each,
            "f may be two numbers: which of them belongs to u, which to v?",
        ),
        Misconception(
            wrong.first_focal_length_for_both,
            "f may be two numbers. Which of them did you use for v?",
        ),
        Misconception(
            wrong.loop_over_one_point,
            "One point is an array of shape (3,). What does your loop get from it?",
        ),
    ],
    forbidden=("cv2.projectPoints",),
)

VANISHING_POINT = Exercise(
    "pinhole",
    camera.vanishing_point,
    parts={
        "lines that lead away": inputs.line_ahead,
        "the same lines, from the other end": inputs.line_towards_us,
        "two focal lengths (fx, fy)": inputs.line_with_two_focal_lengths,
        "lines parallel to the image plane": inputs.lines_across,
    },
    points=6,
    misconceptions=[
        Misconception(
            wrong.forward_only,
            "A rail has two ends. Does its direction, seen from the far end, give another line?",
        ),
        Misconception(
            wrong.centre_forgotten,
            "Lines straight ahead meet at the principal point. Where do they meet in your picture?",
        ),
        Misconception(
            wrong.unit_direction,
            "Walk along the line for a very long time. Which coordinate do you divide by?",
        ),
        Misconception(
            wrong.tangent_without_focal_length,
            "Zoom in: the vanishing point moves outwards. Does yours move at all?",
        ),
        Misconception(
            wrong.at_infinity,
            "Lines parallel to the image plane meet nowhere. What does your function say there?",
        ),
        Misconception(
            wrong.without_sign,
            "d and -d belong to the same lines. Do both give the same pixel in your function?",
        ),
        Misconception(
            wrong.one_direction_only,
            "With several rows, is `direction[2]` a number? `[..., 2]` is the last column.",
        ),
        Misconception(
            wrong.both_lengths_for_each_pixel,
            "f may be two numbers: which of them belongs to u, which to v?",
        ),
    ],
)

DOLLY_ZOOM = Exercise(
    "pinhole",
    camera.dolly_zoom,
    parts={
        "moving away": Part(inputs.moving_away, weight=1.5),
        "moving closer": Part(inputs.moving_closer, weight=1.5),
        "several new distances at once": Part(inputs.several_distances, weight=1),
    },
    misconceptions=[
        Misconception(
            wrong.inverse_ratio,
            "From farther away the object looks smaller. Must the lens then get longer or shorter?",
        ),
        Misconception(
            wrong.adds_the_way,
            "Take twice the distance. By which factor does the object shrink, and what undoes it?",
        ),
        Misconception(
            wrong.ratio_squared,
            "You may be thinking of an area. How does a length in the picture go with distance?",
        ),
        Misconception(
            wrong.only_the_factor,
            "That is how many times longer the lens must get. How long is it then?",
        ),
        Misconception(
            wrong.times_the_distance,
            "In which unit is your focal length? Which number without a unit should multiply f?",
        ),
        Misconception(
            wrong.only_the_change,
            "If the camera does not move, f should stay as it is. What does your formula give?",
        ),
    ],
)

EXPLAIN_FLAT_FACES = Explain(
    "pinhole",
    "explain_flat_faces",
    rubric=[
        (1, "Says that perspective (ratios of sizes) depends on distances alone, not on f."),
        (1, "Says that f scales the whole picture by one factor, the same near and far."),
        (1, "Says why the two come together: with a long lens one stands farther away."),
        (
            1,
            "Gives a check: a wide picture cropped, or numbers for two depths.",
        ),
    ],
    model_answer=(
        "Sizes in the picture are f X / Z. A change of f multiplies all of them by one factor, so "
        " the ratio of nose to ear stays as it is: that ratio is set by their distances Z alone. "
        "A long lens makes us step back to fit the face in; then nose and ear are at almost the "
        "same distance (2.00 m and 2.10 m: 5 %; at 0.30 m and 0.40 m: 33 %), and the face looks "
        "flat. A wide picture taken from the same place and cropped shows the same flat face."
    ),
)
