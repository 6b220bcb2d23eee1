"""The figures of chapter 02: each draws, says what it shows, and shows the right thing."""

import matplotlib as mpl
import numpy as np
import pytest
from legible import Legible

mpl.use("Agg")  # as a test has no screen


from course_lib import homogeneous, transforms
from course_lib.camera import Camera
from course_lib.drawing import homogeneous as draw
from course_lib.drawing.homogeneous import moves, projective, site
from course_lib.drawing.space import onlooker
from course_lib.drawing.style import ROLES

PLAN = transforms.cv_from_graphics_camera(draw.FROM_BLENDER)
SECOND = Camera(draw.K, *PLAN, draw.SIZE)
PAIRS = np.array([[3, 2], [1.5, 1], [-1, 0.5], [1, 0.25], [2, 0], [-3, -0.5]])
ANGLES = np.radians([60, 120, 180])
TURNS = [transforms.rotation_about_axis(draw.HINGES, angle) for angle in ANGLES]
CASES = [(pan, -0.25, np.array([4.2, 12, 5]), np.array([0, -0.2, 0.4])) for pan in (1.0, 0.5)]

FIGURES = {
    "clockwise": draw.clockwise,
    "columns_of": lambda: draw.columns_of(draw.corner_camera().P, draw.corner_camera()),
    "gimbal": draw.gimbal,
    "gimbal_lock": draw.gimbal_lock,
    "imports": lambda: draw.imports([PLAN, None, (np.eye(3), [1, 2])], ["a", "b", "c"]),
    "looking_at": draw.looking_at,
    "one_ray": lambda: draw.one_ray((622, 94), draw.first_camera(), SECOND),
    "opening_door": lambda: draw.opening_door(ANGLES, yours=TURNS),
    "order_matters": draw.order_matters,
    "pixel_shapes": draw.pixel_shapes,
    "points_on_rays": lambda: draw.points_on_rays(PAIRS),
    "split_by_axis": draw.split_by_axis,
    "street_map": lambda: draw.street_map(draw.cameras(), point=draw.CORNER),
    "sweep": lambda: draw.sweep([PLAN, None], CASES),
    "taken_from": lambda: draw.taken_from(PLAN, "plan"),
    "two_conventions": draw.two_conventions,
    "what_survives": draw.what_survives,
    "where_is_it": draw.where_is_it,
    "wire": lambda: draw.wire(SECOND),
}
NO_FIGURES = {"CORNER", "FROM_BLENDER", "HINGES", "HOUSE", "K", "SIZE"}
NO_FIGURES |= {"cameras", "corner_camera", "first_camera"}


@pytest.fixture(scope="module", params=FIGURES)
def figure(request):
    drawn = FIGURES[request.param]()
    drawn.draw_without_rendering()
    return drawn


def lines(figure, role):
    """Return the data of the lines that have the colour of a role."""
    found = [line for ax in figure.axes for line in ax.lines if line.get_color() == ROLES[role]]
    return [np.asarray(line.get_xydata()) for line in found]


class TestEachFigure(Legible):
    UNITS = ("px", "mm", "m", "no unit")


def test_every_function_is_tried_here():
    assert set(FIGURES) | NO_FIGURES == set(draw.__all__)


@pytest.mark.parametrize("yours", [None, "left", [1, 2], np.full((3, 3), np.nan), {}])
def test_what_a_student_cannot_have_meant_is_not_drawn_or_does_no_harm(yours):
    draw.points_on_rays(PAIRS, yours=yours).draw_without_rendering()
    draw.opening_door(ANGLES, yours=[yours] * 3).draw_without_rendering()
    draw.taken_from(yours).draw_without_rendering()
    draw.taken_from((yours, yours)).draw_without_rendering()
    draw.wire(SECOND, yours=yours).draw_without_rendering()
    draw.columns_of(yours, draw.corner_camera()).draw_without_rendering()
    draw.one_ray((622, 94), draw.first_camera(), SECOND, yours=yours).draw_without_rendering()
    draw.street_map(draw.cameras(), centres=[yours] * 3, point=yours).draw_without_rendering()


def test_a_mirrored_camera_takes_no_picture():
    words = [
        t.get_text() for t in draw.taken_from((np.diag([1, 1, -1]), np.zeros(3))).axes[0].texts
    ]
    assert words == ["not a pose\n(R must be a rotation)"]


# What they show


def test_rays_cut_the_line_where_the_points_are():
    found = lines(draw.points_on_rays(PAIRS, yours=homogeneous.from_homogeneous(PAIRS)), "second")
    np.testing.assert_allclose(found[-1], [[1.5, 1], [1.5, 1], [-2, 1], [4, 1], [6, 1]])
    for (x, w), ray in zip(PAIRS, lines(draw.points_on_rays(PAIRS), "ray"), strict=True):
        assert ray[1, 0] * w == pytest.approx(ray[1, 1] * x)


def test_each_kind_of_transformation_is_what_it_is_called():
    euclidean, similar, affine, projected = projective.KINDS.values()
    np.testing.assert_allclose(euclidean[:2, :2] @ euclidean[:2, :2].T, np.eye(2), atol=1e-3)
    product = similar[:2, :2] @ similar[:2, :2].T
    np.testing.assert_allclose(product, product[0, 0] * np.eye(2), atol=1e-12)
    assert product[0, 0] < 0.6
    assert affine[2].tolist() == [0, 0, 1]
    assert abs(affine[0, 0] - affine[1, 1]) > 0.1
    assert (projected[2, :2] > 0).all()


def test_both_orders_end_where_the_text_says():
    left, right = draw.order_matters(60, 2).axes
    ends = [[tuple(np.round(line.get_xydata()[0], 2)) for line in ax.lines] for ax in (left, right)]
    assert ends[0][-1] == (2.0, 0.0)
    assert ends[1][-1] == (1.0, 1.73)
    for ax, foot in ((left, "(2, 0)"), (right, "(1, 1.73)")):
        assert foot in [text.get_text() for text in ax.texts]


def test_one_matrix_turns_up_on_one_page_and_down_on_the_other():
    tips = [
        line.get_xydata()[1]
        for ax in draw.clockwise(30).axes
        for line in ax.lines
        if line.get_color() == ROLES["object"]
    ]
    np.testing.assert_allclose(tips, [[np.cos(np.pi / 6), 0.5], [np.cos(np.pi / 6), -0.5]])


def test_in_gimbal_lock_two_rings_lie_in_one_plane():
    turn = np.linspace(0, 2 * np.pi, 400)
    level = 0.72 * np.stack([np.cos(turn), np.sin(turn), 0 * turn], axis=1)
    flat = onlooker((3.4, -4.6, 2.6), (0, 0, 0), 1080).project(level)
    rings = [ax.lines[2].get_xydata() for ax in draw.gimbal_lock((20, 89, 90)).axes]
    off = [
        np.linalg.norm(ring[:, None] - flat, axis=2).min(axis=1).max() for ring in rings
    ]  # px: how far the roll's ring leaves the level plane
    assert off[0] > 50
    assert off[1] > 1.5
    assert off[2] < 1.5


def test_the_door_hangs_on_its_hinges_and_is_turned_by_the_students_matrices():
    np.testing.assert_allclose(np.cross(moves.DOOR[1], draw.HINGES), 0, atol=1e-12)
    drawn = lines(draw.opening_door(ANGLES, yours=TURNS), "second")
    view = onlooker((3.4, -4.6, 2.4), (0.0, 0.0, 0.45), 1250)
    for door, turn in zip(drawn, TURNS, strict=True):
        np.testing.assert_allclose(door[:5], view.project(moves.DOOR @ turn.T))


def test_the_plan_is_one_rigid_placement_and_sees_the_house():
    axes = site.FROM_BLENDER[:3, :3]
    np.testing.assert_allclose(axes.T @ axes, np.eye(3), atol=1e-15)
    inside = SECOND.project(draw.HOUSE[:4])
    assert ((inside > 0) & (inside < draw.SIZE)).all()


def test_the_house_stands_where_its_corners_are():
    patches = np.concatenate([p.corners for p in site.renderer().scene.patches])
    for corner in draw.HOUSE:
        assert np.linalg.norm(patches - corner, axis=1).min() < 0.05, corner


@pytest.mark.parametrize(
    ("way", "words"), [(0.0, None), (2000.0, "outside of the "), (np.nan, "all nan")]
)
def test_answers_that_would_vanish_are_announced(way, words):
    first, R = draw.first_camera(), SECOND.R
    ray = np.array([first.centre, first.pixel_ray((622, 94))]) + way * np.array([R[0], 0 * R[0]])
    drawn = [
        draw.wire(SECOND, yours=SECOND.project(draw.HOUSE) + way).axes[0],
        draw.street_map([SECOND], centres=[SECOND.centre + way]).axes[0],
    ]
    if np.isfinite(way):
        drawn.append(draw.one_ray((622, 94), first, SECOND, yours=ray).axes[1])
    for ax in drawn:
        said = [text.get_text() for text in ax.texts if "your points" in text.get_text()]
        assert len(said) == (words is not None)
        assert not words or words in said[0]


def test_stars_beside_the_map_are_counted():
    centres = [(1, 20, 3), (1, 200, 3), (np.nan, 20, 3)]
    texts = [t.get_text() for t in draw.street_map(draw.cameras(), centres=centres).axes[0].texts]
    assert "outside of the map: 2 of your 3 points" in texts


@pytest.mark.parametrize(
    ("pose", "words"),
    [
        (None, "no pose yet"),
        (PLAN, None),
        ((SECOND.R.T, SECOND.t), "hardly a house in sight from"),
        ((SECOND.R, np.full(3, np.nan)), "not a pose\n(nan)"),
        ((SECOND.R, 1e200 * SECOND.t), "not a pose\n(t is far too long)"),
        ((2 * SECOND.R, SECOND.t), "not a pose\n(R must be a rotation)"),
        ((0 * SECOND.R, SECOND.t), "not a pose\n(R must be a rotation)"),
        ((SECOND.R + 0j, SECOND.t), "not a pose\n(R is 3 × 3, t has 3 numbers)"),
        (np.eye(4), "not a pose\n(R and t)"),
    ],
)
def test_a_pose_without_a_picture_of_houses_says_why(pose, words):
    for drawn in (draw.taken_from(pose), draw.imports([pose], [""]), draw.sweep([pose], CASES[:1])):
        said = [text.get_text() for text in drawn.axes[0].texts]
        assert len(said) == (words is not None)
        assert not words or said[0].startswith(words)


def test_words_for_no_pose_stay_in_their_frame():
    mirrored = np.diag([1, 1, -1]), np.zeros(3)
    drawn = draw.imports([mirrored, (np.eye(3), [1, 2]), (np.eye(3), [1e300] * 3)], "abc")
    drawn.draw_without_rendering()
    for ax in drawn.axes:
        frame, words = ax.get_window_extent(), ax.texts[0].get_window_extent()
        assert frame.x0 < words.x0 < words.x1 < frame.x1, ax.texts[0].get_text()


def test_names_of_points_on_rays_stay_beside_the_axis():
    drawn = draw.points_on_rays(PAIRS)
    drawn.draw_without_rendering()
    (ax,) = drawn.axes
    for text in ax.texts:
        assert text.get_window_extent().x0 > ax.get_window_extent().x0, text.get_text()


def test_stars_of_a_sweep_lie_in_the_circles_only_if_the_pose_is_right():
    def apart(pose):
        (ax,) = draw.sweep([pose], CASES[:1]).axes
        circles, stars = (line.get_xydata() for line in ax.lines)
        seen = np.isfinite(circles + stars).all(axis=1)
        assert seen.sum() >= 3
        return np.linalg.norm(circles - stars, axis=1)[seen].max()

    R, t = transforms.gimbal_pose(*CASES[0])
    assert apart((R, t)) < 1e-9
    assert apart((R, t + np.array([0.5, 0, 0]))) > 15  # px


def test_the_wire_is_the_students():
    pixels = SECOND.project(draw.HOUSE)
    assert not lines(draw.wire(SECOND), "second")
    drawn = lines(draw.wire(SECOND, yours=pixels + 3), "second")
    np.testing.assert_allclose(drawn[0], pixels[[0, 1]] + 3)
    assert len(drawn) == 13  # twelve edges and the legend


def test_columns_are_drawn_at_the_vanishing_points():
    camera = draw.corner_camera()
    figure = draw.columns_of(camera.P, camera)
    found = {role: lines(figure, role)[0] for role in ("camera", "image", "object")}
    far = camera.project([[1e7, 0, 0], [0, 1e7, 0]])
    np.testing.assert_allclose([found["camera"][1], found["image"][1]], far, atol=0.01)
    for line in found.values():
        np.testing.assert_allclose(line[0], camera.project((0, 0, 0)))


@pytest.mark.parametrize(
    ("t", "words"),
    [
        (None, ["$p_3$: Z at infinity,\nat (360, 1067)"]),
        ((0, 0, 0), ["not on this page", "$p_4$: origin, nowhere (w is 0)"]),
        ((0, 9, 5), ["not on this page", "$p_4$: origin, at (360, 960)"]),
    ],
)
def test_columns_beside_the_page_are_named(t, words):
    camera = draw.corner_camera()
    P = camera.K @ np.column_stack([camera.R, camera.t if t is None else t])
    said = "\n".join(text.get_text() for text in draw.columns_of(P, camera).axes[0].texts)
    for word in words:
        assert word in said


def test_the_ray_is_seen_by_the_second_camera():
    first = draw.first_camera()
    pixel = first.project(draw.CORNER)
    ray = first.centre, first.pixel_ray(pixel)
    way = np.linalg.norm(draw.CORNER - first.centre)
    figure = draw.one_ray(pixel, first, SECOND, yours=ray, distances=(way / 2, way))
    (drawn,) = lines(figure, "second")
    np.testing.assert_allclose(drawn[1], SECOND.project(draw.CORNER), atol=1e-9)


def test_the_map_marks_what_the_student_gave():
    (stars,) = lines(draw.street_map(draw.cameras(), centres=[(1, 20, 3)] * 3), "second")
    assert stars.tolist() == [[1, 20]] * 3
    (star,) = lines(draw.street_map(draw.cameras(), point=(2, 30, 3)), "second")
    assert star.tolist() == [[2, 30]]


def test_the_fan_on_the_map_is_as_wide_as_the_lens_sees():
    camera = draw.first_camera()
    fan = next(x for x in lines(draw.street_map([camera]), "camera") if len(x) == 3)
    sides = (fan[[0, 2]] - fan[1]) / 12
    np.testing.assert_allclose(np.linalg.norm(sides, axis=1), 1)
    edges = camera.pixel_ray([[-0.5, 239.5], [719.5, 239.5]])[:, :2]
    np.testing.assert_allclose(sorted(sides.tolist()), sorted(edges.tolist()), atol=1e-9)


def test_slanted_pixels_slant_the_picture_the_other_way():
    figure = draw.pixel_shapes(aspect=0.7, skew=0.35)
    circles = [ax.lines[-1].get_xydata() for ax in figure.axes]
    for circle in circles[:3]:
        np.testing.assert_allclose(np.linalg.norm(circle, axis=1), 1.4)
    assert np.ptp(circles[4][:, 1]) == pytest.approx(0.7 * np.ptp(circles[3][:, 1]))
    np.testing.assert_allclose(circles[5], circles[3] @ [[1, 0], [0.35, 1]])


def test_the_other_convention_differs_by_half_a_turn_about_x():
    ours, theirs = (
        {t.get_text(): t.get_position() for t in ax.texts} for ax in draw.two_conventions().axes
    )
    assert ours["$x$"] == theirs["$x$"]
    for name in ("$y$", "$z$"):
        assert ours[name] != theirs[name]
    assert ours["$y$"][1] > theirs["$y$"][1]  # v counts downwards
