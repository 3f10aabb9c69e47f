"""Conversions between robot poses and what a person enters; targets that were entered are remembered."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from measureapp.errors import MeasureError, PlanError
from ui.session import Session

if TYPE_CHECKING:
    from measureapp.data.fringe import PatternSet
    from measureapp.data.plan import FlangePose, Viewpoint
    from measureapp.planning.aim import Aim

SHORTEST_QUATERNION = 1e-3
KEPT_AIMS = 500


class PlanAims:
    """Aims of viewpoints on the session's rig."""

    def __init__(self, session: Session) -> None:
        self._session = session
        self._targets: dict[str, tuple[float, float, float]] = {}  # entered last, by viewpoint
        self._known: dict[str, tuple[tuple[object, ...], Aim]] = {}  # by viewpoint, with what it was found for: rows are painted often

    def aim(self, viewpoint: Viewpoint) -> Aim | None:
        """Return where a viewpoint looks; None without a rig."""
        from measureapp.planning.aim import aim_of

        rig, target = self._session.rig, self._targets.get(viewpoint.id)
        if rig is None:
            return None
        found_for = (viewpoint, rig, target)
        known = self._known.get(viewpoint.id)
        if known is not None and all(one is other for one, other in zip(known[0], found_for, strict=True)):
            return known[1]
        if len(self._known) >= KEPT_AIMS:
            self._known.clear()
        found = aim_of(viewpoint.flange, viewpoint.guide_mm, rig, target)
        self._known[viewpoint.id] = found_for, found
        return found

    def angles(self, viewpoint: Viewpoint) -> tuple[float, float]:
        """Return azimuth and elevation in degrees."""
        aim = self.aim(viewpoint)
        return (0.0, 0.0) if aim is None else (aim.look_at.azimuth_deg, aim.look_at.elevation_deg)

    def flange(
        self, viewpoint: Viewpoint, target_mm: tuple[float, float, float], direction_deg: Sequence[float], distance_mm: float
    ) -> FlangePose | MeasureError:
        """Return the pose of the robot for azimuth, elevation and roll, or why there is none."""
        from measureapp.planning.aim import Aim, flange_aimed
        from measureapp.planning.viewpoints import LookAt

        rig = self._session.rig
        if rig is None:
            return PlanError("No rig is chosen.", "Choose a rig on the page Rig first.")
        azimuth, elevation, roll = direction_deg
        try:
            flange = flange_aimed(Aim(target_mm, LookAt(azimuth, elevation, distance_mm, roll)), viewpoint.guide_mm, rig)
        except MeasureError as error:
            return error
        self._targets[viewpoint.id] = target_mm
        return flange

    def pose(self, position_mm: Sequence[float], quaternion_wxyz: Sequence[float]) -> FlangePose | MeasureError:
        """Return a pose as entered; a quaternion of another length is scaled to 1."""
        from math import hypot

        from measureapp.data.plan import FlangePose

        length = hypot(*quaternion_wxyz)
        if length < SHORTEST_QUATERNION:
            return PlanError("The quaternion (w, x, y, z) is zero and names no direction.", "For no rotation enter 1, 0, 0, 0.")
        x, y, z = position_mm
        qw, qx, qy, qz = (value / length for value in quaternion_wxyz)
        return FlangePose(position_mm=(x, y, z), quaternion_wxyz=(qw, qx, qy, qz))

    def pattern_sets(self) -> Mapping[str, PatternSet]:
        """Return the predefined pattern sets for the rig's projector, by name."""
        from measureapp.data.pattern_sets import make_pattern_sets

        rig = self._session.rig
        return {} if rig is None else make_pattern_sets(rig.projector.width_px, rig.projector.height_px)

    def pattern_name(self, patterns: PatternSet) -> str | None:
        """Return the name of a predefined set; None for another one."""
        return next((name for name, known in self.pattern_sets().items() if known == patterns), None)
