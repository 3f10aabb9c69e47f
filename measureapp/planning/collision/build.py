"""Bodies made from the descriptions of rig, robot and part."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.cell import Fixture, NamedBox
from measureapp.data.rig import RigDescription
from measureapp.errors import PlanError
from measureapp.geometry.kinematics.arm import JOINTS, ArmModel, LinkBody
from measureapp.planning.collision.bodies import BASE, FIXED, FLANGE, TABLE, TABLE_NAME, Body, Kind
from measureapp.planning.collision.solids import Solid, box, capsule, cylinder, hull

PART_MARGIN_MM = 5.0  # a part is not exactly its nominal, and not exactly in its place
HEAD_MARGIN_MM = 15.0  # cables, screws, and what the description rounds
CAMERA_HALF_MM = (65.0, 55.0)  # half the width and height of a camera with its bracket
PROJECTOR_HALF_MM = (90.0, 75.0)
BEHIND_MM, AHEAD_MM = 90.0, 30.0  # of the entrance pupil: end of the housing, front of the lens
CELL_HALF_MM, FLOOR_THICKNESS_MM = 4000.0, 500.0
LEAST_TABLE_MM = 20.0  # thickness of a table whose top lies on the floor
BOARD_RADIUS_MM, BOARD_HEIGHT_MM = 150.0, 190.0  # of the largest usual board, tilted by 45° with its centre 90 mm above the table
FOREARM, WRIST = 4, 5  # the link before the wrist, and the joint at its centre
WRIST_SHARE = 0.6  # radius over the distance of the flange from the wrist
CAPSULE_SHARES = (0.13, 0.13, 0.13, 0.13, 0.1)  # radius over the stretched arm, base to forearm; typical arms are slimmer


@dataclass(frozen=True, slots=True, eq=False)
class PartSolid:
    """What stands on the table, in the frame of the table: origin in the centre of its top, z up."""

    name: str
    solid: Solid
    radius_mm: float  # about the table's axis
    may_overhang: bool = False

    @classmethod
    def of_points(cls, points_mm: FloatArray, name: str = "part", margin_mm: float = PART_MARGIN_MM) -> PartSolid:
        """Return the convex hull of points (N, 3), such as the vertices of the nominal in its place on the table."""
        return cls(name, hull(points_mm, margin_mm), float(np.linalg.norm(points_mm[:, :2], axis=1).max()))

    @classmethod
    def enclosing(cls, radius_mm: float, height_mm: float, name: str = "part") -> PartSolid:
        """Return the enclosing cylinder of a part of which no more is known."""
        return cls(name, cylinder((0.0, 0.0, 0.0), radius_mm, height_mm, PART_MARGIN_MM), radius_mm)

    @classmethod
    def board_on_stand(cls) -> PartSolid:
        """Return an upright cylinder around a calibration board on its stand, as `calibration_views` has it."""
        return cls("board", cylinder((0.0, 0.0, 0.0), BOARD_RADIUS_MM, BOARD_HEIGHT_MM, PART_MARGIN_MM), BOARD_RADIUS_MM, may_overhang=True)


def check_part_fits(part: PartSolid, rig: RigDescription) -> None:
    """Refuse a part that is larger than the table.

    Raises
    ------
    PlanError
        With both diameters.
    """
    largest_mm = rig.table.diameter_mm if rig.cell.largest_part_mm is None else rig.cell.largest_part_mm
    if not part.may_overhang and 2.0 * part.radius_mm > largest_mm + 1e-6:
        raise PlanError(
            f"The part is too large for {rig.name}: turning with the table it needs {2.0 * part.radius_mm:.0f} mm, "
            f"and parts may have up to {largest_mm:.0f} mm.",
            "Move it to the centre of the table; if it may overhang, state largest_part_mm in [cell] of the rig description.",
        )


def cell_bodies(rig: RigDescription, arm: ArmModel | None, part: PartSolid | None) -> tuple[Body, ...]:
    """Return everything in the cell; without an arm only the head moves."""
    bodies = [*_head_bodies(rig, np.eye(4) if arm is None else arm.forward_matrices(np.zeros(JOINTS))), *_standing_bodies(rig)]
    if arm is not None:
        bodies += _arm_bodies(arm)
    if part is not None:
        bodies.append(Body(part.name, Kind.OBSTACLE, TABLE, part.solid, np.eye(4)))
    return tuple(bodies)


def _arm_bodies(arm: ArmModel) -> Iterator[Body]:
    kind = Kind.ARM if arm.bodies else Kind.ROUGH
    for one in arm.bodies or _assumed_bodies(arm):
        solid = capsule(*one.ends_mm, one.radius_mm, one.margin_mm) if one.radius_mm > 0.0 else box(*one.ends_mm, one.margin_mm)
        yield Body(_link_name(one.link), kind, one.link, solid, np.eye(4))


def _assumed_bodies(arm: ArmModel) -> Iterator[LinkBody]:
    """Yield a thick capsule along every link of an arm of which only the kinematics are known.

    At the wrist the forearm must be thinner than the flange is away from it, or nothing could be mounted there; its thick part ends halfway.
    What is between wrist and flange belongs to link 5.
    """
    origins = np.vstack([np.zeros(3), arm.link_frames(np.zeros(JOINTS))[:, :3, 3], arm.forward_matrices(np.zeros(JOINTS))[:3, 3]])
    length_mm = float(np.linalg.norm(np.diff(origins, axis=0), axis=1).sum())
    wrist_mm = max(1.0, WRIST_SHARE * float(np.linalg.norm(origins[JOINTS + 1] - origins[WRIST])))
    ends = origins[1:].copy()
    ends[FOREARM] = (origins[FOREARM] + origins[WRIST]) / 2.0
    for link, share in enumerate(CAPSULE_SHARES):
        yield LinkBody(link, (_point(origins[link]), _point(ends[link])), share * length_mm, 0.0)
    yield LinkBody(FOREARM, (_point(origins[FOREARM]), _point(origins[WRIST])), wrist_mm, 0.0)
    yield LinkBody(WRIST, (_point(origins[WRIST]), _point(origins[JOINTS + 1])), wrist_mm, 0.0)


def _point(position_mm: FloatArray) -> tuple[float, float, float]:
    x, y, z = (float(value) for value in position_mm)
    return x, y, z


def _head_bodies(rig: RigDescription, base_from_flange: FloatArray) -> Iterator[Body]:
    placed = base_from_flange @ rig.flange_from_head.transform("flange", "head").matrix
    for one in rig.cell.head_bodies or derived_head(rig):
        yield Body(f"measuring head ({one.name})", Kind.HEAD, FLANGE, box(one.low_mm, one.high_mm, HEAD_MARGIN_MM), placed)


def derived_head(rig: RigDescription) -> tuple[NamedBox, ...]:
    """Return a box for every camera and the projector, each with its arm to the flange's axis, in the head frame.

    Nothing of it is behind the flange, where the robot is.
    """
    flange_mm = rig.flange_from_head.transform("flange", "head").inverse().translation_mm
    mounted = [(f"camera {one.name}", one.head_from_camera.position_mm, CAMERA_HALF_MM) for one in rig.cameras]
    mounted.append((rig.projector.name, rig.projector.head_from_projector.position_mm, PROJECTOR_HALF_MM))
    boxes = []
    for name, position_mm, half_mm in mounted:
        at, half = np.array(position_mm), np.array([*half_mm, 0.0])
        behind = max(at[2] - BEHIND_MM, min(float(flange_mm[2]) + HEAD_MARGIN_MM, at[2] - 1.0))
        low = np.minimum(at, [*flange_mm[:2], at[2]]) - half
        high = np.maximum(at, [*flange_mm[:2], at[2]]) + half
        boxes.append(NamedBox(name=name, low_mm=(low[0], low[1], behind), high_mm=(high[0], high[1], at[2] + AHEAD_MM)))
    return tuple(boxes)


def _standing_bodies(rig: RigDescription) -> Iterator[Body]:
    cell, table = rig.cell, rig.table
    floor = box((-CELL_HALF_MM, -CELL_HALF_MM, cell.floor_mm - FLOOR_THICKNESS_MM), (CELL_HALF_MM, CELL_HALF_MM, cell.floor_mm))
    yield Body("floor", Kind.GROUND, FIXED, floor, np.eye(4))
    if cell.guide_beam is not None:
        yield Body("linear guide", Kind.GROUND, FIXED, box(cell.guide_beam.low_mm, cell.guide_beam.high_mm), np.eye(4))
    if table.is_described:
        height_mm = max(table.centre_in_guide_mm[2] - cell.floor_mm, LEAST_TABLE_MM)
        yield Body(TABLE_NAME, Kind.OBSTACLE, TABLE, cylinder((0.0, 0.0, -height_mm), table.diameter_mm / 2.0, height_mm), np.eye(4))
    for fixture in cell.fixtures:
        yield Body(fixture.name, Kind.OBSTACLE, TABLE if fixture.on_table else FIXED, _fixture_solid(fixture), np.eye(4))
    for keep_out in rig.motion.keep_out:
        yield Body(f"keep-out box {keep_out.name}", Kind.KEEP_OUT, FIXED, box(keep_out.low_mm, keep_out.high_mm), np.eye(4))


def _fixture_solid(fixture: Fixture) -> Solid:
    low, high = np.array(fixture.low_mm), np.array(fixture.high_mm)
    if fixture.shape == "box":
        return box(low, high)
    middle = (low + high) / 2.0
    return cylinder((middle[0], middle[1], low[2]), float(min(high[:2] - low[:2])) / 2.0, float(high[2] - low[2]))


def _link_name(link: int) -> str:
    return "robot's base" if link == BASE else f"robot's link {link}"
