import numpy as np
import pytest

from course_lib.planning import (
    LensModel,
    base_for_overlap,
    ground_sample_distance,
    height_for_resolution,
    max_speed,
    overlap,
    photo_count,
    plan_flight,
    read_cameras,
    read_lenses,
    views_of_ground,
)
from course_lib.planning.strips import inside_polygon

FIELD = [[0, 0], [400, 20], [420, 260], [180, 330], [-20, 240]]
CONCAVE = [[0, 0], [400, 0], [400, 300], [260, 300], [200, 80], [140, 300], [0, 300]]


@pytest.fixture(scope="module")
def drone():
    return read_cameras()["DJI Phantom 4 RTK"], read_lenses()["Phantom 4 RTK lens"]


class TestArithmetic:
    def test_published_overlap_for_three_pictures(self):
        assert overlap(1, 3) == pytest.approx(2 / 3)
        assert base_for_overlap(2 / 3, 90) == pytest.approx(30)

    def test_height_undoes_the_resolution(self):
        gsd = ground_sample_distance([50, 120], 8.8, 2.41)
        np.testing.assert_allclose(height_for_resolution(gsd, 8.8, 2.41), [50, 120])

    def test_speed_is_limited_by_the_camera_or_by_the_smear(self):
        assert max_speed(20, 2, 0.02, 1 / 2000) == pytest.approx(10)
        assert max_speed(20, 2, 0.02, 1 / 400) == pytest.approx(4)

    def test_count_covers_the_rectangle(self):
        """Any smaller number leaves a part out, counted on a fine line."""
        rng = np.random.default_rng(1)
        for _ in range(50):
            length, width, base, distance = rng.uniform([100, 50, 5, 10], [900, 600, 40, 80])
            across = distance * rng.uniform(1, 4)
            pictures, strips = photo_count(length, width, base, distance, across)
            assert (pictures - 2) * base < length <= (pictures - 1) * base
            assert (strips - 1) * distance + across >= width
            assert strips == 1 or (strips - 2) * distance + across < width

    def test_whole_numbers_are_not_rounded_up(self):
        assert photo_count(300, 110, 0.1 * 3, 20, 70) == (1001, 3)

    @pytest.mark.parametrize(
        ("call", "message"),
        [
            (lambda: base_for_overlap(80, 90), "80 % is 0.8"),
            (lambda: base_for_overlap(1.0, 90), "the camera would not move"),
            (lambda: photo_count(100, 100, 10, 80, 60), "leave gaps"),
            (lambda: ground_sample_distance(-5, 8.8, 2.41), "H must be positive"),
            (lambda: overlap(-1, 80), "base must not be negative"),
        ],
    )
    def test_errors_say_what_to_do(self, call, message):
        with pytest.raises(ValueError, match=message):
            call()


class TestPlan:
    @pytest.mark.parametrize("heading", [0.0, 0.4, 2.0, -1.1])
    @pytest.mark.parametrize("polygon", [FIELD, CONCAVE])
    def test_every_place_is_seen_as_often_as_the_overlap_promises(self, drone, polygon, heading):
        plan = plan_flight(polygon, *drone, gsd=0.03, forward=0.8, side=0.6, heading=heading)
        corners = np.array(polygon, float)
        grid = np.stack(
            np.meshgrid(
                *(
                    np.linspace(*span, 60)
                    for span in zip(corners.min(axis=0), corners.max(axis=0), strict=True)
                )
            ),
            axis=-1,
        ).reshape(-1, 2)
        counts = views_of_ground(plan, grid[inside_polygon(grid, corners)])
        # at least three of five along the strip even at its ends, in one strip or more
        assert counts.min() >= 3

    def test_counts_are_those_of_the_footprints(self, drone):
        """On flat ground a place is seen by the pictures whose footprint it is in."""
        plan = plan_flight(FIELD, *drone, gsd=0.05, heading=0.7)
        rng = np.random.default_rng(4)
        points = rng.uniform([-40, -40], [440, 340], (3000, 2))
        counted = sum(inside_polygon(points, f) for f in plan.footprints()).astype(int)
        assert (views_of_ground(plan, points) == counted).mean() > 0.998  # but for borders

    def test_neighbours_overlap_as_asked(self, drone):
        plan = plan_flight(FIELD, *drone, gsd=0.03, forward=0.75, side=0.5)
        first = plan.centres[plan.strips == 0]
        step = np.linalg.norm(np.diff(first, axis=0), axis=1)
        depth, width = plan.gsd * plan.image_size[1], plan.gsd * plan.image_size[0]
        np.testing.assert_allclose(overlap(step, depth), 0.75)
        assert overlap(plan.distance, width) == pytest.approx(0.5)

    def test_pixels_are_as_large_as_asked(self, drone):
        plan = plan_flight(FIELD, *drone, gsd=0.03)
        camera = plan.cameras[5]
        x, y, _ = camera.centre
        middle, right, below = camera.project([[x, y, 0], [x + 0.03, y, 0], [x, y - 0.03, 0]])
        np.testing.assert_allclose([right - middle, below - middle], np.eye(2), atol=1e-9)

    def test_a_corner_given_twice_changes_nothing(self, drone):
        corners = [[300, 0], [210, 0], [300, 240]]
        once = plan_flight(corners, *drone, 0.02, heading=np.pi / 2)
        twice = plan_flight([*corners, corners[-1]], *drone, 0.02, heading=np.pi / 2)
        np.testing.assert_allclose(twice.centres, once.centres)

    def test_time_is_way_by_speed_and_turns(self, drone):
        plan = plan_flight([[0, 0], [300, 0], [300, 500], [0, 500]], *drone, gsd=0.03, side=0.7)
        strips = len(np.unique(plan.strips))
        pictures = (plan.strips == 0).sum()
        way = strips * (pictures - 1) * plan.base + (strips - 1) * plan.distance
        assert plan.length == pytest.approx(way)
        assert plan.duration(5, turn=8) == pytest.approx(way / 5 + 8 * (strips - 1))

    def test_a_wall_hides_the_ground_behind_it(self, drone):
        """Shadow of a wall of height h at d from the nadir: h d / (H - h) deep, one picture."""

        def wall(x, y):
            return np.where((x > 30) & (x < 34), 12.0, 0.0) + 0 * y

        plan = plan_flight([[0, 0], [1, 0], [1, 1], [0, 1]], *drone, gsd=0.03, side=0.0)
        plan_one = plan_flight([[0, 0], [1, 0], [1, 1], [0, 1]], *drone, gsd=0.03)
        assert len(plan_one.centres) == 2
        x = np.linspace(34.01, 45, 400)
        points = np.column_stack([x, np.full_like(x, 0.5)])
        seen = views_of_ground(plan, points, wall, numbers=[0])
        C = plan.cameras[0].centre
        edge = 34 + 12 * (34 - C[0]) / (C[2] - 12)
        shadow = x[seen == 0]
        assert shadow.max() == pytest.approx(edge, abs=0.4)
        assert (seen[x > edge + 0.4] == 1).all()

    def test_higher_ground_is_seen_less_often(self, drone):
        plan = plan_flight(FIELD, *drone, gsd=0.03)
        hill = views_of_ground(plan, [[200, 150]], lambda x, y: np.full(np.shape(x), 60.0))
        assert hill < views_of_ground(plan, [[200, 150]])

    @pytest.mark.parametrize(
        ("change", "message"),
        [
            ({"polygon": [[0, 0], [1, 1], [2, 2]]}, "corners lie on a line"),
            ({"polygon": [[0, 0], [1, 1]]}, "at least 3 corners"),
            ({"gsd": 0}, "gsd must be positive"),
            ({"forward": 80}, "80 % is 0.8"),
        ],
    )
    def test_errors_say_what_to_do(self, drone, change, message):
        arguments = {"polygon": FIELD, "camera": drone[0], "lens": drone[1], "gsd": 0.03} | change
        with pytest.raises(ValueError, match=message):
            plan_flight(**arguments)

    def test_ground_that_reaches_the_flight_is_named(self, drone):
        plan = plan_flight(FIELD, *drone, gsd=0.03)
        with pytest.raises(ValueError, match="fly higher"):
            views_of_ground(plan, [[0, 0]], lambda x, y: np.full(np.shape(x), 500.0))
        with pytest.raises(ValueError, match="above the flight"):
            plan.footprints(height=500)


class TestCatalogue:
    def test_every_entry_has_a_source_and_a_partner(self):
        cameras, lenses = read_cameras(), read_lenses()
        assert len(cameras) >= 7
        assert len(lenses) >= 8
        assert all(entry.source for entry in [*cameras.values(), *lenses.values()])
        assert {c.mount for c in cameras.values()} == {lens.mount for lens in lenses.values()}

    def test_data_sheet_of_the_lecture(self):
        """85 mm on 2048 x 1920 px of 27.6 x 25.9 mm: f = 6307.2 px by its 74.2 px/mm."""
        camera = read_cameras()["Phantom v2640, 2048 x 1920"]
        np.testing.assert_allclose(camera.sensor_size, [27.6, 25.9], atol=0.06)
        K = camera.intrinsics(read_lenses()["Zeiss Milvus 1.4/85"])
        assert K[0, 0] == pytest.approx(6307.2, rel=0.002)

    def test_the_lenses_of_the_text_cover_their_sensors_and_some_do_not(self):
        """2/3 inch is 11 mm; the sensor of type 1/1.2 has a diagonal of 13.4 mm."""
        cameras, lenses = read_cameras(), read_lenses()
        sides = {name: np.hypot(*camera.sensor_size) for name, camera in cameras.items()}
        assert sides["Phantom v2640, 2048 x 1920"] == pytest.approx(37.9, abs=0.05)
        assert sides["mvBlueFOX3-2051"] == pytest.approx(11.07, abs=0.01)
        assert sides["mvBlueFOX3-2024a"] == pytest.approx(13.4, abs=0.05)
        assert lenses["Zeiss Milvus 1.4/85"].image_circle_mm == round(np.hypot(24, 36), 1)
        assert lenses["Computar M2514-MP2"].image_circle_mm == pytest.approx(np.hypot(8.8, 6.6))

    def test_a_reader_adds_a_line(self, tmp_path):
        table = tmp_path / "mine.tsv"
        head = "name\tf_mm\tN_least\tN_most\tclosest\timage_circle_mm\tmount\tsource\n"
        table.write_text(head + "Mine\t12\t2\t16\t0.2\t11\tC\tthe box\n", encoding="utf-8")
        mine = {"Mine": LensModel("Mine", 12, 2, 16, 0.2, 11, "C", "the box")}
        assert read_lenses(table) == mine
        table.write_bytes(b"\xef\xbb\xbf" + table.read_bytes())  # as Excel writes it
        assert read_lenses(table) == mine

    def test_says_where_it_looked_for_a_table(self, tmp_path, monkeypatch):
        monkeypatch.chdir(tmp_path)
        for read in (read_lenses, read_cameras):
            with pytest.raises(FileNotFoundError, match=f"{tmp_path.name}.*mine.tsv: write"):
                read("mine.tsv")

    @pytest.mark.parametrize(
        ("text", "message"),
        [
            ("name\tf_mm\nMine\t12\n", "mine.tsv has no column 'N_least': its first line"),
            (
                "name\tf_mm\tN_least\tN_most\tclosest\timage_circle_mm\tmount\tsource\nMine\ttwelve\t2\t16\t1\t11\tC\tbox\n",
                "mine.tsv, line 2: could not convert",
            ),
            (
                "name\tf_mm\tN_least\tN_most\tclosest\timage_circle_mm\tmount\tsource\nMine\t12\t16\t2\t1\t11\tC\tbox\n",
                "line 2: N_least must not be above N_most",
            ),
        ],
    )
    def test_names_the_line_that_is_wrong(self, tmp_path, text, message):
        (tmp_path / "mine.tsv").write_text(text, encoding="utf-8")
        with pytest.raises(ValueError, match=message):
            read_lenses(tmp_path / "mine.tsv")
