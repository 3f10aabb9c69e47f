"""The names in a scan plan and what they stand for."""

from __future__ import annotations

import re
from dataclasses import dataclass

from measureapp.data.plan import ScanPlan
from measureapp.errors import PlanError

NUMBER = re.compile(r"^(.*?)([-_.]?)(\d+)$")


@dataclass(frozen=True, slots=True)
class Place:
    """Where a name stands in a plan."""

    group: int | None  # None: a single viewpoint
    viewpoint: int | None  # among the single ones; None: a group as a whole, or one of its viewpoints
    pose: int = 0
    angle: int | None = None  # None: a group as a whole


class PlanIndex:
    """The names of one plan and their places."""

    def __init__(self, plan: ScanPlan) -> None:
        self._places: dict[str, Place] = {viewpoint.id: Place(None, number) for number, viewpoint in enumerate(plan.viewpoints)}
        for number, group in enumerate(plan.groups):
            self._places.setdefault(group.id, Place(number, None))
            for order, made in enumerate(group.viewpoints()):
                pose, angle = divmod(order, len(group.table_deg))
                self._places[made.id] = Place(number, None, pose, angle)

    def __contains__(self, name: str) -> bool:
        return name in self._places

    def find(self, name: str) -> Place:
        """Return the place of a name. Raises PlanError if the plan does not have it."""
        try:
            return self._places[name]
        except KeyError:
            raise PlanError(f"The plan has no viewpoint or group {name!r}.", "See `measureapp plan show` for its names.") from None

    def take_name(self, wanted: str) -> str:
        """Return a free name, and count it as taken from here on."""
        name = self.free_name(wanted)
        self._places[name] = Place(None, None)
        return name

    def free_name(self, wanted: str) -> str:
        """Return ``wanted``, or the next number after it that is not taken."""
        if wanted not in self._places:
            return wanted
        found = NUMBER.match(wanted)
        stem, joint, digits = (found[1], found[2], found[3]) if found and found[1] else (wanted, "-", "01")
        number = int(digits)
        while f"{stem}{joint}{number:0{len(digits)}d}" in self._places:
            number += 1
        return f"{stem}{joint}{number:0{len(digits)}d}"
