"""The cell as a planner asks it: which configuration is free at a viewpoint, and whether a move is."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.leg import Axis
from measureapp.data.plan import Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.errors import LimitError
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.geometry.kinematics.choice import away_from_singularities, driven
from measureapp.geometry.kinematics.refine import seeds
from measureapp.geometry.kinematics.singularity import GOAL_MARGINS
from measureapp.geometry.transform import RigidTransform
from measureapp.planning.collision.build import PartSolid, cell_bodies, check_part_fits
from measureapp.planning.collision.clearance import Encounter, Scene, Sweep
from measureapp.planning.collision.motion import Mechanism, Placement
from measureapp.planning.reach import LIMIT_MARGIN_RAD, limit_violations

ORDER: tuple[Axis, ...] = ("table", "guide", "robot")  # in which a session moves the axes, one after the other
SAMPLED = 200  # joint angles at which bodies are looked at that touch in all of them
REST_RAD = np.array(
    [0.0, 0.0, 0.0, 0.0, np.pi / 6.0, 0.0]
)  # where an arm is assumed to come from, if nothing is known; away from singularities


@dataclass(frozen=True, slots=True, eq=False)
class Cell:
    """All bodies of a cell, and the rig's limits; built by `Cell.of`, and not changed by any call."""

    rig: RigDescription
    arm: ArmModel | None
    kept: ArmModel | None  # the arm with the margins that drivers keep from the limits of joints
    scene: Scene
    has_part: bool

    @classmethod
    def of(cls, rig: RigDescription, arm: ArmModel | None, part: PartSolid | None = None) -> Cell:
        """Build the bodies of a cell.

        Parameters
        ----------
        arm : of the rig's robot; None: only the head is checked, on straight ways
        part : on the table; None: the table is empty

        Raises
        ------
        PlanError
            The part is larger than the table.
        """
        if part is not None:
            check_part_fits(part, rig)
        kept = None if arm is None else arm.with_margin(LIMIT_MARGIN_RAD)
        return cls(rig, arm, kept, Scene.of(cell_bodies(rig, arm, part), rig.motion.clearance_mm, Mechanism(rig, arm)), part is not None)

    # viewpoints

    def problem_at(self, viewpoint: Viewpoint) -> str:
        """Describe why the axes cannot stand at a viewpoint: limits, reach, or what would touch; empty if some configuration is free."""
        if reasons := limit_violations(viewpoint, self.rig, None):
            return "; ".join(reasons)
        try:
            placements = self.placements(viewpoint)
        except LimitError as error:
            return error.message.removesuffix(".")
        found = []
        for placement in placements:
            if (encounter := self.encounter_at(placement)) is None:
                return ""
            found.append(encounter)
        return max(found, key=lambda one: one.distance_mm).words()

    def free_at(self, viewpoint: Viewpoint, present_rad: FloatArray | None = None) -> tuple[Placement, ...]:
        """Return the placements at a viewpoint where nothing touches, the preferred one first; empty if there is none.

        Parameters
        ----------
        present_rad : (6,) joint angles to come from
        """
        if limit_violations(viewpoint, self.rig, None):
            return ()
        try:
            return tuple(one for one in self.placements(viewpoint, present_rad) if self.encounter_at(one) is None)
        except LimitError:
            return ()

    def placements(self, viewpoint: Viewpoint, present_rad: FloatArray | None = None) -> tuple[Placement, ...]:
        """Return where the axes can be at a viewpoint, the configuration that is driven first; raises LimitError as `away_from_singularities`."""
        if self.kept is None:
            return (Placement.at(viewpoint, None),)
        present = REST_RAD if present_rad is None else present_rad
        solutions = away_from_singularities(self.kept, viewpoint.flange.transform(), present, GOAL_MARGINS)
        return tuple(Placement.at(viewpoint, solution.joints_rad) for solution in solutions)

    def nearest(self, base_from_flange: RigidTransform, present: Placement) -> Placement:
        """Return the placement with the flange at a pose, in the configuration that a driver chooses; raises LimitError as `driven`."""
        joints_rad = None
        if self.kept is not None:
            joints_rad = driven(self.kept, base_from_flange, present.joints_from(REST_RAD)).joints_rad
        return replace(present, base_from_flange=base_from_flange.matrix, joints_rad=joints_rad)

    def encounter_at(self, placement: Placement) -> Encounter | None:
        """Return two bodies that are too close to each other at a placement; None if all keep their distance."""
        return self._sweep(placement, placement).first_encounter()

    def clearance_mm(self, placement: Placement) -> float:
        """Return the least distance of any two bodies that may meet; 0 where they touch or overlap."""
        return max(0.0, float(self.distances_mm(placement).min(initial=np.inf)))

    def distances_mm(self, placement: Placement) -> FloatArray:
        """Return the distance of every pair of `scene`, (pairs,); not above 0 where they touch or overlap."""
        return self._sweep(placement, placement).distances_mm()

    def always_touching(self) -> str:
        """Return the names of two bodies that touch whatever the joint angles, an error of the model; empty if there are none."""
        if self.kept is None:
            return ""
        pairs = np.arange(len(self.scene.pairs))
        for joints_rad in seeds(self.kept.limits_rad, SAMPLED):
            place = Placement(self.kept.forward_matrices(joints_rad), joints_rad, 0.0, 0.0)
            pairs = pairs[self.distances_mm(place)[pairs] <= 0.0]
            if not len(pairs):
                return ""
        pair = self.scene.pairs[pairs[0]]
        return f"{self.scene.bodies[pair.first].name} and {self.scene.bodies[pair.second].name}"

    # moves

    def problem_between(self, first: Viewpoint, second: Viewpoint) -> str:
        """Describe what would touch on the direct move between two viewpoints, axes one after the other; empty if it is free.

        The robot leaves the first viewpoint in the preferred free configuration, for the free one of the second that it reaches soonest.
        """
        if not (starts := self.free_at(first)):
            return self.problem_at(first)
        if not (ends := self.free_at(second, starts[0].joints_rad)):
            return self.problem_at(second)
        return "" if (found := self.encounter_between(starts[0], ends[0])) is None else found.words()

    def encounter_between(self, start: Placement, end: Placement, *, leaving: bool = False) -> Encounter | None:
        """Return what comes too close first when the axes move one after the other from one placement to another; None: nothing."""
        here = start
        for axis in ORDER:
            there = here.moved(axis, end)
            if found := self.encounter_on(here, there, leaving=leaving):
                return replace(found, axis=axis)
            here = there
        return None

    def encounter_on(self, start: Placement, end: Placement, *, leaving: bool = False) -> Encounter | None:
        """Return what comes too close first when everything moves from one placement to another at once; None if nothing does."""
        return self._sweep(start, end).first_encounter(leaving=leaving)

    def _sweep(self, start: Placement, end: Placement) -> Sweep:
        return Sweep(self.scene, start, end)
