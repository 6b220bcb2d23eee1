"""Chapter 01: the exercises on the pinhole camera."""

from __future__ import annotations

from course_lib import camera, optics
from course_lib.exercises.pinhole import inputs
from course_lib.exercises.pinhole import misconceptions as wrong
from course_lib.judging import Close, Exercise, Explain, Misconception, Part, ValuesExercise

PIXEL_FOCAL_LENGTH = Exercise(
    "pinhole",
    camera.pixel_focal_length,
    parts={
        "square pixels": inputs.square_pixels,
        "pixels that are not square": inputs.oblong_pixels,
    },
    misconceptions=[
        Misconception(
            wrong.pixel_upside_down,
            "Is your answer in pixels? Write the units behind each quantity and see what cancels.",
        ),
        Misconception(
            wrong.width_for_both_axes,
            "Suppose a pixel is taller than it is wide. Which of its sides matters for fy?",
        ),
        Misconception(
            wrong.height_first,
            "A size is (width, height). Which of the two belongs to the first result, fx?",
        ),
        Misconception(
            wrong.pixels_per_millimetre,
            "This is how many pixels fit into one millimetre. How long is the lens in millimetres?",
        ),
    ],
)

FIELD_OF_VIEW = Exercise(
    "pinhole",
    optics.field_of_view,
    parts={"wide lenses": inputs.wide_lens, "long lenses": inputs.long_lens},
    misconceptions=[
        Misconception(
            wrong.half_angle,
            "Your angle reaches from the optical axis to one edge. Does the picture end there?",
        ),
        Misconception(
            wrong.in_degrees,
            "These are angles in degrees. Which unit does the task ask for?",
        ),
        Misconception(
            wrong.whole_width,
            "Draw the right triangle at the hole: how much of the sensor is its short side?",
        ),
        Misconception(
            wrong.small_angle,
            "For a long lens you are nearly right. What did you take an angle and its tangent for?",
        ),
        Misconception(
            wrong.width_for_height,
            "Which side of the sensor limits how far the camera sees up and down?",
        ),
        Misconception(
            wrong.triangle_upside_down,
            "A longer lens sees less. Does your angle get smaller when f grows?",
        ),
    ],
)

EQUIVALENT_FOCAL_LENGTH = Exercise(
    "pinhole",
    optics.equivalent_focal_length,
    parts={
        "sensors of the same shape": Part(inputs.same_shape_sensor, weight=1),
        "sensors of another shape": Part(inputs.wide_lens, weight=3),
    },
    misconceptions=[
        Misconception(
            wrong.crop_by_width,
            "Sensors differ in shape. Which length did the makers agree to compare?",
        ),
        Misconception(
            wrong.crop_by_height,
            "You compare the short sides. Which length takes both sides into account?",
        ),
        Misconception(
            wrong.crop_upside_down,
            "A small sensor sees less through the same lens. "
            "Which lens sees less on full frame: a longer or a shorter one?",
        ),
        Misconception(
            wrong.crop_by_area,
            "Focal length and angle go with lengths. What kind of quantity did you compare?",
        ),
    ],
)

FIRST_GUESS_INTRINSICS = Exercise(
    "pinhole",
    camera.first_guess_intrinsics,
    parts={
        "square pixels": inputs.square_pixels,
        "pixels that are not square": inputs.oblong_pixels,
    },
    misconceptions=[
        Misconception(
            wrong.half_the_size,
            "Where is pixel 0: at the left edge of the picture, or half a pixel inside?",
        ),
        Misconception(
            wrong.millimetres_in_K,
            "K turns directions into pixels. In which unit is the focal length that you put in?",
        ),
        Misconception(
            wrong.no_principal_point,
            "Which pixel does a point straight ahead fall on? Try it with your matrix.",
        ),
        Misconception(
            wrong.centre_rows_first,
            "In K, the first row makes u. Does u count columns or rows?",
        ),
        Misconception(
            wrong.transposed,
            "Multiply your matrix with (X, Y, Z). Is the last of the three results still Z?",
        ),
    ],
)

PROJECT_PINHOLE = Exercise(
    "pinhole",
    camera.project_pinhole,
    points=6,
    parts={
        "points in front of the camera": Part(inputs.points_in_front, weight=3),
        "a single point": Part(inputs.one_point, weight=1),
        "points behind the camera": Part(inputs.points_behind, weight=2),
    },
    misconceptions=[
        Misconception(
            wrong.divides_by_focal_length,
            "What makes a distant object small in the picture: the lens or the distance?",
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
    ],
    forbidden=("cv2.projectPoints",),
)

VANISHING_POINT = Exercise(
    "pinhole",
    camera.vanishing_point,
    parts={
        "lines that lead away": inputs.line_ahead,
        "the same lines, from the other end": inputs.line_towards_us,
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
    ],
)

DOLLY_ZOOM = Exercise(
    "pinhole",
    camera.dolly_zoom,
    parts={"moving away": inputs.moving_away, "moving closer": inputs.moving_closer},
    misconceptions=[
        Misconception(
            wrong.inverse_ratio,
            "When you walk backwards, the object shrinks. Should you zoom in or out?",
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
    ],
)

BEST_PINHOLE_DIAMETER = Exercise(
    "pinhole",
    optics.best_pinhole_diameter,
    parts={"boxes of all sizes and light of all colours": Part(inputs.box_camera, cases=4)},
    misconceptions=[
        Misconception(
            wrong.radius_of_airy_disk,
            "Is your diffraction spot a diameter or a radius? Compare like with like.",
        ),
        Misconception(
            wrong.not_square_rooted,
            "Which unit does your answer have: a length, or a length squared?",
        ),
        Misconception(
            wrong.size_of_the_spot,
            "You found how large the smallest spot is. How large is the hole that makes it?",
        ),
        Misconception(
            wrong.radius_of_the_hole,
            "A drill is sold by its diameter. Is your number the diameter of the hole?",
        ),
    ],
)


def data_sheet(f, sensor_size, image_size, f_calibrated):
    """Work out a camera's first guess from its data sheet, and read a calibration back."""
    pixels_per_mm = image_size[0] / sensor_size[0]
    c_u, c_v = camera.image_centre(image_size)
    return {
        "pixels_per_mm": pixels_per_mm,
        "f_px": f * pixels_per_mm,
        "c_u": c_u,
        "c_v": c_v,
        "f_calibrated_mm": f_calibrated / pixels_per_mm,
    }


DATA_SHEET = ValuesExercise(
    "pinhole",
    data_sheet,
    given={
        "f": 85.0,
        "sensor_size": (27.6, 25.9),
        "image_size": (2048, 1920),
        "f_calibrated": 6890.5,
    },
    units={
        "pixels_per_mm": "px/mm, along the width",
        "f_px": "focal length in px, along the width",
        "c_u": "principal point, column in px",
        "c_v": "principal point, row in px",
        "f_calibrated_mm": "the calibrated focal length in mm",
    },
    points=5,
    compare=Close(rtol=1e-3),
    misconceptions=[
        Misconception(
            wrong.data_sheet_pixel_size,
            "Is that the number of pixels in a millimetre, or of millimetres in a pixel?",
        ),
        Misconception(
            wrong.data_sheet_rows_first,
            "A picture of 2048 × 1920 has 2048 columns. Which coordinate counts columns?",
        ),
        Misconception(
            wrong.data_sheet_inverse_ratio,
            "The calibrated focal length is longer in pixels. Should it be shorter in millimetres?",
        ),
        Misconception(
            wrong.data_sheet_whole_size,
            "The principal point is near the middle of the picture. Is yours?",
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

EXERCISES = (
    BEST_PINHOLE_DIAMETER,
    PIXEL_FOCAL_LENGTH,
    FIELD_OF_VIEW,
    EQUIVALENT_FOCAL_LENGTH,
    FIRST_GUESS_INTRINSICS,
    DATA_SHEET,
    PROJECT_PINHOLE,
    VANISHING_POINT,
    DOLLY_ZOOM,
    EXPLAIN_FLAT_FACES,
)
