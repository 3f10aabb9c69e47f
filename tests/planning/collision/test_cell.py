"""The paper rig as bodies: its plans are free, and what is not is told; every planned move is checked again by another library."""

from __future__ import annotations

from collections import defaultdict
from dataclasses import replace
from itertools import pairwise

import fcl
import numpy as np
import pytest
import trimesh

from measureapp.data.cell import CellDescription, Fixture, NamedBox
from measureapp.data.plan import FlangePose, Viewpoint
from measureapp.data.rig import KeepOutBox, MotionRules, ParkPose, RigDescription
from measureapp.errors import InputError, PlanError
from measureapp.geometry.kinematics.arm import LinkBody
from measureapp.planning.calibration_views import calibration_viewpoints
from measureapp.planning.collision.bodies import Body, Pair
from measureapp.planning.collision.build import PartSolid
from measureapp.planning.collision.cell import Cell
from measureapp.planning.collision.check import NO_ARM, NO_PART, NO_SHAPE, CollisionReport, check_collisions
from measureapp.planning.collision.routes import NoRoute, find_route
from measureapp.planning.viewpoints import LookAt, plan_around_part, viewpoint_looking_at
from measureapp.project.geometry.robot_file import arm_of
from measureapp.project.rig_file import read_rig
from measureapp.resources import resource

RIG = read_rig("paper")
ARM = arm_of(RIG)
CENTRE = np.array(RIG.table.centre_in_guide_mm)
IMPELLER_POINTS = np.asarray(trimesh.load(resource("parts/impeller/nominal.stl")).vertices)
IMPELLER = PartSolid.of_points(IMPELLER_POINTS)
PLAN = plan_around_part(RIG, "impeller", radius_mm=140.0, height_mm=60.0, count=26, arm=ARM)
STEP_MM = 5.0


def rig_with(**changes: object) -> RigDescription:
    return RIG.model_copy(update=changes)


def looking_at(name: str, azimuth_deg: float, elevation_deg: float, distance_mm: float = 550.0, **axes: float) -> Viewpoint:
    return viewpoint_looking_at(RIG, name, CENTRE + np.array([0.0, 0.0, 55.0]), LookAt(azimuth_deg, elevation_deg, distance_mm), **axes)


@pytest.fixture(scope="module")
def report() -> CollisionReport:
    """Of the plan around the impeller."""
    return check_collisions(PLAN, RIG, ARM, IMPELLER)


def test_the_plan_of_26_viewpoints_around_the_impeller_is_free(report: CollisionReport) -> None:
    assert report.problems == ()
    assert report.notes == ()
    assert len(report.moves) == 26


@pytest.mark.parametrize(("radius_mm", "height_mm"), [(60.0, 80.0), (120.0, 200.0), (30.0, 20.0)])
def test_plans_around_other_parts_are_free_too(radius_mm: float, height_mm: float) -> None:
    plan = plan_around_part(RIG, "part", radius_mm=radius_mm, height_mm=height_mm, count=12, arm=ARM)
    assert check_collisions(plan, RIG, ARM, PartSolid.enclosing(radius_mm, height_mm)).problems == ()


def test_the_calibration_is_free_of_collisions_and_was_not_by_reach_alone() -> None:
    cell = Cell.of(RIG, ARM, PartSolid.board_on_stand())
    by_reach = [viewpoint for viewpoint in calibration_viewpoints(RIG, motions=("robot",)) if cell.problem_at(viewpoint)]
    assert {viewpoint.id for viewpoint in by_reach} >= {"pose02", "pose08", "pose12"}
    views = calibration_viewpoints(RIG, motions=("robot",), arm=ARM)
    report = check_collisions(views, RIG, ARM, PartSolid.board_on_stand())
    assert report.problems == ()
    assert len(report.moves) == len(views)


def test_bodies_that_always_touch_are_an_error_of_the_model() -> None:
    assert Cell.of(RIG, ARM, IMPELLER).always_touching() == ""
    fat = replace(ARM, bodies=(*ARM.bodies, LinkBody(4, ((0.0, 0.0, 791.1), (560.0, 0.0, 791.1)), 90.0)))
    with pytest.raises(InputError, match=r"head .* touch whatever the joint angles"):
        check_collisions([PLAN[0]], RIG, fat, IMPELLER)


# what is found


def test_a_head_too_close_to_the_part_is_told_with_both_bodies() -> None:
    cell = Cell.of(RIG, ARM, PartSolid.enclosing(240.0, 420.0))
    assert cell.problem_at(looking_at("far", 0.0, 32.0)) == ""
    problem = cell.problem_at(looking_at("near", 0.0, 32.0, 350.0))
    assert problem.startswith("the measuring head (")
    assert problem.removesuffix(" (at least 15 mm)").endswith("the part")


def test_a_fixture_between_two_free_viewpoints_is_found_on_the_move() -> None:
    first, second = looking_at("left", 50.0, 35.0, guide_mm=-400.0), looking_at("right", -50.0, 35.0, guide_mm=400.0)
    free = Cell.of(RIG, ARM)
    assert (free.problem_at(first), free.problem_at(second), free.problem_between(first, second)) == ("", "", "")
    post = Fixture(name="post", shape="cylinder", low_mm=(330.0, -20.0, 0.0), high_mm=(370.0, 20.0, 1500.0))
    cell = Cell.of(rig_with(cell=CellDescription(fixtures=(post,))), ARM)
    assert (cell.problem_at(first), cell.problem_at(second)) == ("", "")
    assert "post" in cell.problem_between(first, second)


def test_a_keep_out_box_must_not_be_entered_but_needs_no_further_clearance() -> None:
    def problem(y_mm: float) -> str:
        box = KeepOutBox(name="cabinet", low_mm=(300.0, y_mm, 400.0), high_mm=(460.0, y_mm + 40.0, 500.0))
        return Cell.of(rig_with(motion=MotionRules(keep_out=(box,))), ARM).problem_at(looking_at("here", 0.0, 32.0))

    assert "would enter the keep-out box cabinet" in problem(200.0)
    assert problem(260.0) == ""  # the head reaches 255 mm to the side, margin included


def test_a_part_that_is_larger_than_the_table_is_refused_with_both_diameters() -> None:
    with pytest.raises(PlanError, match=r"needs 900 mm, and parts may have up to 500 mm"):
        check_collisions(PLAN, RIG, ARM, PartSolid.enclosing(450.0, 100.0))
    small = rig_with(table=RIG.table.model_copy(update={"diameter_mm": 200.0}))
    assert Cell.of(small, ARM, PartSolid.board_on_stand()).problem_at(PLAN[20]) == ""  # a board may overhang
    wide = rig_with(cell=CellDescription(largest_part_mm=1000.0))
    assert check_collisions([PLAN[0]], wide, ARM, PartSolid.enclosing(450.0, 100.0)) is not None


def test_a_fixture_on_the_table_turns_with_it() -> None:
    arm = Fixture(name="clamp", low_mm=(-240.0, -20.0, 0.0), high_mm=(-200.0, 20.0, 420.0), on_table=True)
    cell = Cell.of(rig_with(cell=CellDescription(fixtures=(arm,))), ARM)
    away, near = looking_at("away", 0.0, 32.0, 360.0, table_deg=180.0), looking_at("near", 0.0, 32.0, 360.0, table_deg=0.0)
    assert cell.problem_at(away) == ""
    assert "clamp" in cell.problem_at(near)
    assert "clamp" in cell.problem_between(
        looking_at("before", 0.0, 32.0, 360.0, table_deg=90.0), looking_at("after", 0.0, 32.0, 360.0, table_deg=-90.0)
    )


def test_what_cannot_be_checked_is_told() -> None:
    plan = (PLAN[0], PLAN[1])
    assert check_collisions(plan, RIG, None, None).notes == (NO_ARM, NO_PART)
    unknown = check_collisions(plan, RIG, replace(ARM, bodies=()), None)
    assert (unknown.notes, unknown.problems) == ((NO_SHAPE, NO_PART), ())


def test_without_a_model_of_the_arm_the_head_is_checked_on_straight_ways() -> None:
    free = Cell.of(RIG, None)

    def at(y_mm: float) -> Viewpoint:
        flange = FlangePose(position_mm=(400.0, y_mm, 700.0), quaternion_wxyz=(0, 1, 0, 0))
        return Viewpoint(id="here", flange=flange, guide_mm=0.0, table_deg=0.0)

    assert free.problem_between(at(-320.0), at(320.0)) == ""
    pillar = Fixture(name="pillar", low_mm=(390.0, -10.0, 1.0), high_mm=(410.0, 10.0, 620.0))
    blocked = Cell.of(rig_with(cell=CellDescription(fixtures=(pillar,))), None)
    assert "the measuring head" in blocked.problem_at(at(0.0))
    assert blocked.problem_at(at(-320.0)) == ""
    assert "the pillar" in blocked.problem_between(at(-320.0), at(320.0))


def test_a_head_that_the_rig_describes_replaces_the_derived_one() -> None:
    small = (NamedBox(name="all", low_mm=(-60, -60, -60), high_mm=(60, 60, 30)),)
    cell = Cell.of(rig_with(cell=CellDescription(head_bodies=small)), ARM)
    assert [body.name for body in cell.scene.bodies if body.name.startswith("measuring head")] == ["measuring head (all)"]


# detours


def test_where_the_direct_way_is_blocked_the_head_is_drawn_back_or_goes_by_the_park_pose() -> None:
    first, second = looking_at("left", 50.0, 35.0, guide_mm=-400.0), looking_at("right", -50.0, 35.0, guide_mm=400.0)
    post = Fixture(name="post", shape="cylinder", low_mm=(500.0, -20.0, 0.0), high_mm=(540.0, 20.0, 620.0))
    park = ParkPose(position_mm=(300.0, 0.0, 850.0), quaternion_wxyz=(0.5, 0.5, 0.5, 0.5))
    rig = rig_with(cell=CellDescription(fixtures=(post,)), motion=MotionRules(park=park))
    cell = Cell.of(rig, ARM)
    start = cell.free_at(first)[0]
    end = cell.free_at(second, start.joints_rad)[0]
    assert cell.encounter_between(start, end) is not None
    route = find_route(cell, start, second)
    assert route.detour
    here = start
    for leg in route.legs:
        assert cell.encounter_on(here, leg.goal) is None
        here = leg.goal
    assert np.allclose(here.base_from_flange, second.flange.transform().matrix)


def test_a_viewpoint_without_a_free_way_is_refused_with_what_is_in_the_way() -> None:
    wall = Fixture(name="wall", low_mm=(200.0, -310.0, 1.0), high_mm=(1500.0, -300.0, 1800.0))
    cell = Cell.of(rig_with(cell=CellDescription(fixtures=(wall,))), ARM)
    first, second = (PLAN[0].model_copy(update={"id": name, "guide_mm": guide_mm}) for name, guide_mm in (("left", -620.0), ("right", 0.0)))
    with pytest.raises(NoRoute, match=r"There is no free way to right: on the direct one, the .* the wall .* of the guide's move"):
        find_route(cell, cell.free_at(first)[0], second)


# another library


class Surface:
    """A body's surface, made by trimesh, and distances to it by Open3D."""

    def __init__(self, body: Body) -> None:
        import open3d as o3d

        self.body = body
        mesh = as_mesh(body)
        self.points = np.vstack([trimesh.sample.sample_surface(mesh, 60, seed=1)[0], mesh.vertices[:: max(1, len(mesh.vertices) // 60)]])
        self.middle, self.radius_mm = mesh.bounds.mean(axis=0), np.linalg.norm(np.ptp(mesh.bounds, axis=0)) / 2.0
        self.scene = o3d.t.geometry.RaycastingScene()
        self.scene.add_triangles(np.asarray(mesh.vertices, np.float32), np.asarray(mesh.faces, np.uint32))

    def distances_mm(self, frames: list[np.ndarray], other: Surface) -> np.ndarray:
        """Distances (F,) of another body's samples from this solid, less the margins of both: one query for all frames."""
        import open3d as o3d

        moved = np.linalg.inv([frame[self.body.carrier] for frame in frames]) @ np.array([frame[other.body.carrier] for frame in frames])
        seen = (other.points @ moved[:, :3, :3].transpose(0, 2, 1) + moved[:, None, :3, 3]).reshape(-1, 3)
        apart_mm = self.scene.compute_signed_distance(o3d.core.Tensor(seen.astype(np.float32))).numpy().reshape(len(frames), -1)
        return apart_mm.min(axis=1) - self.body.solid.margin_mm - other.body.solid.margin_mm


def near_pairs(cell: Cell, surfaces: list[Surface], frame: np.ndarray) -> list[Pair]:
    """Pairs whose enclosing spheres are within 60 mm."""
    middles = np.array([frame[one.body.carrier][:3, :3] @ one.middle + frame[one.body.carrier][:3, 3] for one in surfaces])
    radii_mm = np.array([one.radius_mm for one in surfaces])
    pairs = np.array([(pair.first, pair.second) for pair in cell.scene.pairs])
    apart_mm = np.linalg.norm(middles[pairs[:, 0]] - middles[pairs[:, 1]], axis=1) - radii_mm[pairs].sum(axis=1)
    return [cell.scene.pairs[number] for number in np.flatnonzero(apart_mm < 60.0)]


def as_mesh(body: Body) -> trimesh.Trimesh:
    """The body's shape in its carrier."""
    geometry, size = body.solid.geometry, body.solid.high_mm - body.solid.low_mm
    if isinstance(geometry, fcl.Box):
        made = trimesh.creation.box(size)
    elif isinstance(geometry, fcl.Cylinder):
        made = trimesh.creation.cylinder(radius=geometry.radius, height=geometry.lz, sections=128)
    elif isinstance(geometry, fcl.Capsule):
        made = trimesh.creation.capsule(height=geometry.lz, radius=geometry.radius, count=(24, 24))
        made.apply_translation(-made.bounds.mean(axis=0))
    else:
        made = trimesh.convex.convex_hull(IMPELLER_POINTS)
    return made.apply_transform(body.placed)


@pytest.mark.parametrize("moves", [slice(11, 12), pytest.param(slice(None), marks=pytest.mark.slow)], ids=["one", "all"])
def test_every_5_mm_of_every_planned_move_keeps_its_clearance_by_another_library(moves: slice, report: CollisionReport) -> None:
    """Open3D's distances of densely sampled surfaces, margins included; a clearance may be 2 mm less between two samples of the check."""
    cell = Cell.of(RIG, ARM, IMPELLER)
    surfaces = [Surface(body) for body in cell.scene.bodies]
    ends = [move.route.end for move in report.moves]
    checked, least_mm = 0, np.inf
    for move, before in list(zip(report.moves, [ends[0], *ends], strict=False))[moves]:
        start = before
        near: dict[Pair, list[np.ndarray]] = defaultdict(list)
        for leg in move.route.legs:
            travel_mm = float((cell.scene.travels @ cell.scene.mechanism.changes(start, leg.goal)).max())
            shares = np.linspace(0.0, 1.0, int(np.ceil(travel_mm / STEP_MM)) + 1)
            for frame in cell.scene.mechanism.frames(start, leg.goal, shares):
                checked += 1
                for pair in near_pairs(cell, surfaces, frame):
                    near[pair].append(frame)
            start = leg.goal
        for pair, frames in near.items():
            nearest_mm = float(surfaces[pair.first].distances_mm(frames, surfaces[pair.second]).min())
            assert nearest_mm > pair.apart_mm - 2.0 - 0.1, (move.end_id, pair)
            least_mm = min(least_mm, nearest_mm)
    assert checked > 100
    assert least_mm < 30.0  # something was near enough to matter


def test_all_moves_of_a_report_hang_together(report: CollisionReport) -> None:
    assert [move.end_id for move in report.moves] == [viewpoint.id for viewpoint in PLAN]
    assert all(second.start_id == first.end_id for first, second in pairwise(report.moves))
