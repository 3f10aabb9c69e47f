"""Candidates aimed at what the grid of candidates misses: pockets, undercuts and walls that only few directions reach."""

from __future__ import annotations

from itertools import islice

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.plan import FlangePose, Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.geometry.transform import RigidTransform, rotation_about
from measureapp.planning.coverage.candidates import Candidates
from measureapp.planning.coverage.head import Head, heads_at
from measureapp.planning.coverage.limits import VisibilityLimits
from measureapp.planning.coverage.samples import SurfaceSamples
from measureapp.planning.coverage.scene import PartScene
from measureapp.planning.coverage.stations import rounded
from measureapp.planning.coverage.unreachable import clusters, heads_around
from measureapp.planning.coverage.visibility import seen_from
from measureapp.planning.reach import limit_violations
from measureapp.progress import Progress

CLUSTERS = 60
LEAST_MEMBERS = 3  # samples of a cluster, on average
TRIES = 12  # poses checked for reach, of each cluster
KEPT = 3  # of each cluster
AZIMUTHS_DEG = (0.0, 30.0, -30.0, 60.0, -60.0)


def aimed_candidates(
    missed: SurfaceSamples,
    rig: RigDescription,
    arm: ArmModel | None,
    scene: PartScene,
    limits: VisibilityLimits,
    progress: Progress,
) -> Candidates:
    """Return reachable viewpoints aimed at samples that no other candidate sees, each from a robot pose of its own.

    Samples are clustered by place and normal; of the directions around each cluster's normal, those that see most of it and are within reach
    are kept.
    """
    head = Head.of(rig)
    viewpoints: list[Viewpoint] = []
    groups = clusters(missed, min(CLUSTERS, 1 + len(missed) // LEAST_MEMBERS)) if len(missed) else []
    for number, members in enumerate(groups):
        progress.report(number, len(groups), "viewpoints for pockets")
        some = missed.subset(members)
        middle = int(np.linalg.norm(some.points_mm - some.points_mm.mean(axis=0), axis=1).argmin())
        poses = heads_around(some.points_mm[middle], some.normals[middle], head.standoff_mm)
        seen = seen_from(poses, some, head, scene, limits).seen @ some.areas_mm2
        best = [pose for pose in np.argsort(-seen, kind="stable")[:TRIES] if seen[pose] > 0.0]
        found = (realise(poses[pose], rig, arm, f"p{number:02d}-{pose:03d}") for pose in best)
        viewpoints += islice((one for one in found if one is not None), KEPT)
    return Candidates(tuple(viewpoints), np.arange(len(viewpoints)), heads_at(viewpoints, rig))


def realise(part_from_head: FloatArray, rig: RigDescription, arm: ArmModel | None, name: str) -> Viewpoint | None:
    """Return a viewpoint within reach that puts the head there, by turning the table and sliding the guide; None if there is none."""
    forward = part_from_head[:2, 2]
    level = np.degrees(np.arctan2(forward[1], forward[0])) if np.hypot(*forward) > 1e-6 else 0.0
    low, high = rig.table.limits_deg
    for azimuth in AZIMUTHS_DEG:
        turn = azimuth - float(level)
        table_deg = next((round(one, 2) for one in (turn, turn - 360.0, turn + 360.0) if low <= one <= high), None)
        if table_deg is None:
            continue
        viewpoint = _placed(part_from_head, rig, name, table_deg)
        if not limit_violations(viewpoint, rig, arm):
            return viewpoint
    return None


def _placed(part_from_head: FloatArray, rig: RigDescription, name: str, table_deg: float) -> Viewpoint:
    turn = rotation_about([0.0, 0.0, 1.0], np.deg2rad(table_deg))
    guide_from_part = RigidTransform.from_parts(turn, rig.table.centre_in_guide_mm, "guide", "part")
    head_from_flange = rig.flange_from_head.transform("flange", "head").inverse()
    guide_from_flange = guide_from_part @ RigidTransform(part_from_head, "part", "head") @ head_from_flange
    low, high = rig.guide.limits_mm
    guide_mm = round(float(np.clip(guide_from_flange.translation_mm[1], low, high)), 1)
    base_from_guide = RigidTransform.from_parts(np.eye(3), [0.0, -guide_mm, 0.0], "base", "guide")
    return Viewpoint(id=name, flange=rounded(FlangePose.of(base_from_guide @ guide_from_flange)), guide_mm=guide_mm, table_deg=table_deg)
