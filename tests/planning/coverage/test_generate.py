"""Generated plans: coverage, number of viewpoints, reasons for what is not seen, and what is refused."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.data.mesh import Mesh
from measureapp.errors import PlanError
from measureapp.geometry.transform import RigidTransform, rotation_about
from measureapp.planning.coverage.candidates import checked_grid
from measureapp.planning.coverage.extent import extent_on_table, standing
from measureapp.planning.coverage.limits import VisibilityLimits
from measureapp.planning.coverage.result import GeneratedPlan
from measureapp.planning.coverage.samples import sample_surface
from measureapp.planning.coverage.scene import PartScene
from measureapp.planning.coverage.unreachable import Cause
from measureapp.planning.coverage.visibility import seen_by
from measureapp.planning.feasibility import Feasibility
from measureapp.planning.generate import GeneratorSettings, generate_plan
from measureapp.planning.reach import limit_violations
from measureapp.progress import Cancelled, NoProgress
from measureapp.project.geometry.robot_file import arm_of
from measureapp.project.rig_file import read_rig
from tests.planning.coverage.parts import casting
from tests.planning.coverage.reference import greedy_cover

RIG = read_rig("paper")
ARM = arm_of(RIG)
QUICK = GeneratorSettings(samples=500, candidates=400)
SMALL = GeneratorSettings(samples=250, candidates=200)
TINY = GeneratorSettings(samples=120, candidates=100)  # where a reason is asked for, which whole faces have


def placed(mesh: Mesh) -> Mesh:
    return mesh.seen_from(standing(mesh))


def checked(mesh: Mesh) -> Feasibility:
    return Feasibility.checked(RIG, ARM, placed(mesh))


@pytest.fixture(scope="module")
def cell() -> Feasibility:
    """What is free about the casting, which is checked once for all tests."""
    return checked(casting())


@pytest.fixture(scope="module")
def made(cell: Feasibility) -> GeneratedPlan:
    return generate_plan(casting(), cell, QUICK)


@pytest.fixture(scope="module")
def once(cell: Feasibility) -> GeneratedPlan:
    """Every place seen once at least."""
    return generate_plan(casting(), cell, QUICK.model_copy(update={"views": 1}))


def test_a_plan_sees_what_it_states_and_98_percent_of_what_is_measurable(made: GeneratedPlan) -> None:
    again = seen_by(tuple(made.plan), made.samples, RIG, PartScene.of(placed(casting()), RIG))
    assert np.array_equal(again.seen, made.seen)
    assert made.planned_of_allowed >= 0.98
    assert np.array_equal(np.isfinite(made.sigma_mm), made.planned)
    assert made.problems == ()


def test_a_plan_sees_places_twice_so_that_clouds_overlap(made: GeneratedPlan, once: GeneratedPlan) -> None:
    areas = made.samples.areas_mm2
    twice = areas[made.seen.sum(axis=0) >= 2].sum() / areas[made.allowed].sum()
    assert twice >= 0.9 > 1.5 * areas[once.seen.sum(axis=0) >= 2].sum() / areas[once.allowed].sum()
    assert len(once.plan) < len(made.plan) <= 2 * len(once.plan)


def test_a_plan_needs_no_more_viewpoints_than_a_greedy_cover_of_the_same_candidates(cell: Feasibility, once: GeneratedPlan) -> None:
    scene = PartScene.of(placed(casting()), RIG)
    grid, free = checked_grid(extent_on_table(scene.part, RIG), RIG, ARM, cell.is_free, NoProgress(), QUICK.candidates)
    seen = seen_by(grid.subset(free).viewpoints, once.samples, RIG, scene).seen
    assert len(once.plan) <= 1.1 * greedy_cover(seen, once.samples.areas_mm2, 0.98)


def test_every_viewpoint_is_within_reach_and_touches_nothing_and_so_are_the_moves(made: GeneratedPlan) -> None:
    from itertools import pairwise

    from measureapp.planning.collision.build import PartSolid
    from measureapp.planning.collision.cell import Cell

    cell = Cell.of(RIG, ARM, PartSolid.of_points(placed(casting()).vertices_mm))
    assert [limit_violations(one, RIG, ARM) for one in made.plan] == [()] * len(made.plan)
    assert [cell.problem_at(one) for one in made.plan] == [""] * len(made.plan)
    assert [cell.problem_between(one, other) for one, other in pairwise(made.plan)] == [""] * (len(made.plan) - 1)


def test_few_robot_poses_serve_many_viewpoints_each_visited_once(made: GeneratedPlan) -> None:
    flanges = [one.flange for one in made.plan]
    visits = [flange for place, flange in enumerate(flanges) if place == 0 or flanges[place - 1] != flange]
    assert len(visits) == len(set(flanges)) == made.stations
    assert made.stations <= len(made.plan) / 2


def test_the_bottom_touches_the_support_and_the_reasons_cover_all_that_is_never_seen(made: GeneratedPlan) -> None:
    by_cause: dict[Cause, float] = {}
    for area in made.unreachable:
        by_cause[area.cause] = by_cause.get(area.cause, 0.0) + area.area_mm2
    assert by_cause[Cause.SUPPORT] == pytest.approx(180 * 120, rel=0.1)
    unseen = sorted(place for area in made.unreachable for place in area.samples)
    assert np.array_equal(unseen, np.flatnonzero(~made.allowed))
    largest = made.unreachable[0]
    assert largest.cause is Cause.SUPPORT
    assert largest.place_mm[2] == pytest.approx(0.0, abs=1e-3)


def test_time_and_disk_are_those_of_the_plan(made: GeneratedPlan) -> None:
    images = made.plan.patterns.count * 5 * len(made.plan)
    assert made.bytes == images * 3 * 2592 * 1944
    assert made.images_s == pytest.approx(images * (0.3 / 5 + 0.069))
    assert made.time_s > made.images_s > 0.0


def test_the_same_arguments_give_the_same_plan(made: GeneratedPlan) -> None:
    assert generate_plan(casting(), checked(casting()), QUICK).plan == made.plan


def test_a_given_number_of_viewpoints_covers_less_the_fewer_they_are(cell: Feasibility, made: GeneratedPlan) -> None:
    few, more = (generate_plan(casting(), cell, QUICK.model_copy(update={"viewpoints": count})) for count in (2, 4))
    assert (len(few.plan), len(more.plan)) == (2, 4)
    assert few.planned_share < more.planned_share <= made.allowed_share


def test_a_required_standard_deviation_needs_more_viewpoints_and_is_reached_where_it_can_be(cell: Feasibility, made: GeneratedPlan) -> None:
    required = float(np.nanmedian(made.sigma_mm)) * 0.8
    finer = generate_plan(casting(), cell, QUICK.model_copy(update={"sigma_mm": required}))
    assert len(finer.plan) > len(made.plan)
    areas = made.samples.areas_mm2

    def reached(found: GeneratedPlan) -> float:
        return float(areas[found.sigma_mm <= required * 1.001].sum() / areas[found.allowed].sum())

    assert reached(finer) > 0.8 > 0.6 > reached(made)


def test_a_deep_bore_has_no_free_line_of_sight_at_its_bottom() -> None:
    deep = casting(pocket_mm=69.0)
    narrow = Mesh(deep.vertices_mm * [0.25, 0.25, 1.0], deep.triangles, "nominal")
    found = generate_plan(narrow, checked(narrow), SMALL)
    causes = {area.cause for area in found.unreachable}
    assert Cause.NO_PAIR in causes
    blocked = [area for area in found.unreachable if area.cause is Cause.NO_PAIR]
    assert max(area.place_mm[2] for area in blocked) < 60.0


def test_where_only_colliding_viewpoints_see_a_surface_the_reason_is_the_collision() -> None:
    cell = Feasibility(RIG, ARM, is_free=lambda viewpoint: -90.0 < viewpoint.table_deg < 90.0)
    found = generate_plan(casting(), cell, TINY)
    assert Cause.COLLISION in {area.cause for area in found.unreachable}
    assert all(-90.0 < one.table_deg < 90.0 for one in found.plan)


def test_where_only_mirror_directions_see_a_surface_the_reason_is_the_light() -> None:
    limits = VisibilityLimits(mirror_deg=60.0, camera_incidence_deg=45.0, projector_incidence_deg=45.0)
    glossy = TINY.model_copy(update={"limits": limits})
    found = generate_plan(casting(60.0), Feasibility(RIG, ARM), glossy)
    assert Cause.LIGHT in {area.cause for area in found.unreachable}


def test_collisions_checked_for_all_angles_of_the_table_at_once_are_those_of_every_viewpoint(cell: Feasibility) -> None:
    from measureapp.planning.collision.build import PartSolid
    from measureapp.planning.collision.cell import Cell

    part = placed(casting())
    exact = Cell.of(RIG, ARM, PartSolid.of_points(part.vertices_mm))
    grid, _ = checked_grid(extent_on_table(part, RIG), RIG, ARM, None, NoProgress(), 1500)
    some = [grid.viewpoints[place] for place in np.random.default_rng(4).choice(len(grid), 60, replace=False)]
    found = [cell.is_free(one) for one in some] if cell.is_free else []
    assert found == [not exact.problem_at(one) for one in some]
    assert 0.1 < np.mean(found) < 0.9


def test_a_robot_that_reaches_only_low_views_leaves_the_rest_out_of_reach() -> None:
    robot = RIG.robot.model_copy(update={"max_reach_mm": 480.0})
    low = RIG.model_copy(update={"robot": robot})
    found = generate_plan(casting(), Feasibility(low), TINY)
    assert Cause.REACH in {area.cause for area in found.unreachable}


def test_moves_that_are_not_free_are_avoided_by_another_order_or_stated() -> None:
    def never(first: object, second: object) -> str:
        return "the head would touch the table"

    found = generate_plan(casting(), Feasibility(RIG, ARM, None, never), SMALL)
    assert len(found.problems) == len(found.plan) - 1
    assert "is not free: the head would touch the table" in found.problems[0]


@pytest.mark.parametrize(
    ("scale", "words"),
    [(0.001, "too small to be measured"), (4.0, "too large for"), (np.nan, "not finite")],
)
def test_a_part_of_impossible_size_is_refused_in_words(scale: float, words: str) -> None:
    part = casting()
    with pytest.raises(PlanError, match=words):
        generate_plan(Mesh(part.vertices_mm * scale, part.triangles, "nominal"), Feasibility(RIG, ARM), QUICK)


def test_a_tall_part_and_one_below_the_table_are_refused() -> None:
    part = casting()
    tall = Mesh(part.vertices_mm * [0.1, 0.1, 30.0], part.triangles, "nominal")
    with pytest.raises(PlanError, match="high; the robot"):
        generate_plan(tall, Feasibility(RIG, ARM), QUICK)
    sunk = RigidTransform.from_parts(np.eye(3), [0.0, 0.0, -20.0], "part", "nominal")
    with pytest.raises(PlanError, match="below the top of the table"):
        generate_plan(part, Feasibility(RIG, ARM), QUICK, part_from_nominal=sunk)


def test_a_part_can_lie_on_its_side() -> None:
    turned = RigidTransform.from_parts(rotation_about([1, 0, 0], np.pi / 2), [0.0, 35.0, 60.0], "part", "nominal")
    found = generate_plan(casting(), Feasibility(RIG, ARM), QUICK, part_from_nominal=turned)
    assert found.samples.points_mm[:, 2].max() == pytest.approx(120.0, abs=1.0)
    assert found.planned_of_allowed >= 0.98


def test_the_generator_can_be_cancelled_at_any_report() -> None:
    class StopAfter:
        def __init__(self, share: float) -> None:
            self.share = share

        def report(self, done: float, total: float, note: str = "") -> None:
            if done / total > self.share:
                raise Cancelled

        def check(self) -> None: ...

    for share in (0.0, 0.3, 0.7):
        with pytest.raises(Cancelled):
            generate_plan(casting(), Feasibility(RIG, ARM), SMALL, progress=StopAfter(share))


def test_progress_never_goes_back() -> None:
    told: list[float] = []

    class Listener(NoProgress):
        def report(self, done: float, total: float, note: str = "") -> None:
            told.append(done / total)

    generate_plan(casting(), Feasibility(RIG, ARM), SMALL, progress=Listener())
    assert told == sorted(told)
    assert told[-1] == 1.0


def test_a_flat_sheet_is_planned_with_collisions_checked() -> None:
    corners = np.array([[-80.0, -60, 0], [80, -60, 0], [80, 60, 30], [-80, 60, 30]])
    sheet = Mesh(corners, np.array([[0, 1, 2], [0, 2, 3]]), "nominal")
    found = generate_plan(sheet, checked(sheet), QUICK)
    assert found.planned_share > 0.95
    assert (found.samples.normals[:, 2] > 0.0).all()


def test_a_search_that_needs_too_much_memory_is_refused() -> None:
    with pytest.raises(PlanError, match="too much memory"):
        generate_plan(casting(), Feasibility(RIG, ARM), GeneratorSettings(samples=50_000, candidates=20_000))


def test_an_unknown_pattern_set_is_refused() -> None:
    with pytest.raises(PlanError, match="no pattern set 'stripes'"):
        generate_plan(casting(), Feasibility(RIG, ARM), QUICK.model_copy(update={"patterns": "stripes"}))


def test_a_non_watertight_and_inverted_nominal_gives_the_same_coverage(made: GeneratedPlan) -> None:
    part, keep = casting(), np.ones(len(casting().triangles), bool)
    keep[3] = False  # half of a wall
    damaged = Mesh(part.vertices_mm, part.triangles[keep][:, [0, 2, 1]], "nominal")
    found = generate_plan(damaged, Feasibility(RIG, ARM), QUICK)
    assert found.planned_of_allowed >= 0.98
    assert found.allowed_share > made.allowed_share - 0.1


def test_samples_of_the_generator_are_those_of_the_public_function(made: GeneratedPlan) -> None:
    samples = sample_surface(PartScene.of(placed(casting()), RIG), QUICK.samples, QUICK.seed)
    assert np.array_equal(samples.points_mm, made.samples.points_mm)
