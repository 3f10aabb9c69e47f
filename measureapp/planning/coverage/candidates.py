"""Candidate viewpoints: stations of the robot, each at several places of the guide and many angles of the table."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.plan import Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.planning.coverage.extent import Extent
from measureapp.planning.coverage.head import Head, heads_at
from measureapp.planning.coverage.stations import Station, aims, reachable_station, slides_mm
from measureapp.progress import Progress

TABLE_STEPS = 24  # angles of the table at each station
MOST_CANDIDATES = 2600


@dataclass(frozen=True, slots=True, eq=False)
class Candidates:
    """V viewpoints within reach, and whether each of them touches anything."""

    viewpoints: tuple[Viewpoint, ...]
    station: IntArray  # (V,), which viewpoints have the same robot pose
    heads: FloatArray  # (V, 4, 4), part_from_head

    def __len__(self) -> int:
        return len(self.viewpoints)

    def subset(self, chosen: IntArray) -> Candidates:
        """Return some of them, by indices."""
        return Candidates(tuple(self.viewpoints[int(one)] for one in chosen), self.station[chosen], self.heads[chosen])

    def joined(self, other: Candidates) -> Candidates:
        """Return both in one; stations of ``other`` stay apart from these."""
        first = int(self.station.max(initial=-1)) + 1
        station = np.concatenate([self.station, other.station + first])
        return Candidates(self.viewpoints + other.viewpoints, station, np.concatenate([self.heads, other.heads]))


def checked_grid(
    extent: Extent,
    rig: RigDescription,
    arm: ArmModel | None,
    is_free: Callable[[Viewpoint], bool] | None,
    progress: Progress,
    most: int = MOST_CANDIDATES,
) -> tuple[Candidates, IntArray]:
    """Return candidates all around the part, within reach, and the indices of those at which nothing touches.

    They are elevations, rolls and distances of the head, places of the guide, angles of the table, the most useful first, until ``most`` are
    free. Viewpoints that only differ by guide and table share a station: these axes are about ten times more accurate than the robot.

    Parameters
    ----------
    is_free : whether nothing touches at a viewpoint; None: not checked
    """
    head = Head.of(rig)
    slides, angles = slides_mm(extent, head), table_angles_deg(rig)
    found, free = as_candidates([], rig), np.zeros(0, int)
    wanted = list(aims(extent, head))
    for number, aim in enumerate(wanted):
        progress.report(number, len(wanted), "reach and collisions")
        station = reachable_station(aim, rig, arm)
        if station is not None:
            more = as_candidates([(station, slides, angles)], rig)
            free = np.concatenate([free, len(found) + free_of_contact(more, is_free, progress)])
            found = found.joined(more)
        if len(free) >= most:
            break
    return found, free


def grid_candidates(
    extent: Extent, rig: RigDescription, arm: ArmModel | None, progress: Progress, most: int = MOST_CANDIDATES
) -> Candidates:
    """Return the candidates of `checked_grid` without a check of collisions."""
    return checked_grid(extent, rig, arm, None, progress, most)[0]


def as_candidates(stations: Iterable[tuple[Station, Sequence[float], Sequence[float]]], rig: RigDescription) -> Candidates:
    """Return the viewpoints of stations, each with the offsets of its guide in mm and the angles of the table in degrees."""
    low, high = rig.guide.limits_mm
    viewpoints: list[Viewpoint] = []
    numbers: list[int] = []
    for number, (station, slides, angles) in enumerate(stations):
        for slide, angle in product(slides, angles):
            guide_mm = round(station.guide_mm + slide, 1)
            if low <= guide_mm <= high:
                viewpoints.append(Viewpoint(id=f"c{len(viewpoints):04d}", flange=station.flange, guide_mm=guide_mm, table_deg=angle))
                numbers.append(number)
    return Candidates(tuple(viewpoints), np.array(numbers, int), heads_at(viewpoints, rig))


def table_angles_deg(rig: RigDescription) -> tuple[float, ...]:
    """Return angles within the range of the table, evenly spread over a full turn where it can make one."""
    low, high = rig.table.limits_deg
    if high - low >= 360.0:
        middle = min(max(0.0, low + 180.0), high - 180.0)
        angles = middle - 180.0 + 360.0 / TABLE_STEPS * (np.arange(TABLE_STEPS) + 0.5)
    else:
        angles = np.linspace(low, high, max(2, round((high - low) / 360.0 * TABLE_STEPS) + 1))
    return tuple(round(float(angle), 3) for angle in angles)


def free_of_contact(candidates: Candidates, is_free: Callable[[Viewpoint], bool] | None, progress: Progress) -> IntArray:
    """Return the indices of the candidates at which nothing touches; all of them without a check."""
    if is_free is None:
        return np.arange(len(candidates))
    free = []
    for viewpoint in candidates.viewpoints:
        progress.check()
        free.append(is_free(viewpoint))
    return np.flatnonzero(free)
