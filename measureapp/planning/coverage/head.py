"""The measuring head as pinhole devices of a nominal rig, and where viewpoints put it relative to the part."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, read_only
from measureapp.data.plan import FlangePose, Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.geometry.transform import RigidTransform, rotation_about

NEAREST_FOCUS, FARTHEST_FOCUS = 0.8, 1.2  # depth of field, relative to the standoff


@dataclass(frozen=True, slots=True, eq=False)
class Eye:
    """One camera or the projector, as a pinhole without distortion, in the frame `head`."""

    name: str
    position_mm: FloatArray  # (3,)
    head_from_eye: FloatArray  # (3, 3), rotation; x right, y down, z forward
    focal_px: float
    width_px: int
    height_px: int


@dataclass(frozen=True, slots=True, eq=False)
class Head:
    """Projector and cameras of a rig, and the depth of field they have in common."""

    projector: Eye
    cameras: tuple[Eye, ...]
    standoff_mm: float
    depth_mm: tuple[float, float]  # along z of the head

    @classmethod
    def of(cls, rig: RigDescription) -> Head:
        """Build from the nominal description of a rig."""
        seats = [(one.name, one.head_from_camera, one) for one in rig.cameras]
        cameras = tuple(_eye(name, seat.transform("head", name), one.focal_px, one.width_px, one.height_px) for name, seat, one in seats)
        light = rig.projector
        mount = light.head_from_projector.transform("head", "projector")
        projector = _eye("projector", mount, light.focal_px, light.width_px, light.height_px)
        depth = (NEAREST_FOCUS * rig.standoff_mm, FARTHEST_FOCUS * rig.standoff_mm)
        return cls(projector, cameras, rig.standoff_mm, depth)

    @property
    def least_cameras(self) -> int:
        """Number of cameras that have to see a point: two, or one with the projector as its partner."""
        return min(2, len(self.cameras))

    @property
    def field_radius_mm(self) -> float:
        """Half of the smallest side of all fields of view at the standoff."""
        eyes = (self.projector, *self.cameras)
        return min(min(eye.width_px, eye.height_px) / 2.0 / eye.focal_px * self.standoff_mm for eye in eyes)


def part_from_head(viewpoint: Viewpoint, rig: RigDescription) -> RigidTransform:
    """Return the pose of the head relative to the part at a viewpoint, by the nominal rig.

    Frame `part`: origin in the middle of the table's top, z up, x and y as those of the guide frame at table angle 0; turns with the table.
    """
    guide_from_base = RigidTransform.from_parts(np.eye(3), [0.0, viewpoint.guide_mm, 0.0], "guide", "base")
    flange_from_head = rig.flange_from_head.transform("flange", "head")
    return part_from_guide(viewpoint.table_deg, rig) @ guide_from_base @ viewpoint.flange.transform() @ flange_from_head


def heads_at(viewpoints: Iterable[Viewpoint], rig: RigDescription) -> FloatArray:
    """Return ``part_from_head`` of many viewpoints as matrices (V, 4, 4)."""
    flange_from_head = rig.flange_from_head.transform("flange", "head")
    of_flange: dict[FlangePose, FloatArray] = {}
    heads = []
    for one in viewpoints:
        if one.flange not in of_flange:
            of_flange[one.flange] = (one.flange.transform() @ flange_from_head).matrix
        guide_from_head = of_flange[one.flange].copy()
        guide_from_head[1, 3] += one.guide_mm
        heads.append(part_from_guide(one.table_deg, rig).matrix @ guide_from_head)
    return np.array(heads).reshape(-1, 4, 4)


def part_from_guide(table_deg: float, rig: RigDescription) -> RigidTransform:
    """Return the guide frame relative to the part at a table angle."""
    turn = rotation_about([0.0, 0.0, 1.0], -np.deg2rad(table_deg))
    return RigidTransform.from_parts(turn, -turn @ np.array(rig.table.centre_in_guide_mm), "part", "guide")


def _eye(name: str, head_from_eye: RigidTransform, focal_px: float, width_px: int, height_px: int) -> Eye:
    return Eye(name, read_only(head_from_eye.translation_mm), read_only(head_from_eye.rotation), focal_px, width_px, height_px)
