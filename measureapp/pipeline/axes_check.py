"""Whether the positions that axes read back agree with what the cameras see, before any view is laid onto another.

A point of one view that lies clearly in front of the surface which another view sees in its direction would hide that surface: then one of both
was taken elsewhere than its axes say. Points behind a surface are hidden, and contradict nothing. Registration does not notice exchanged
read-backs on parts that look alike from several sides: it finds some position for each view.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.calibration import RigCalibration
from measureapp.data.fringe import AxisReadback
from measureapp.data.measurement import ViewResult
from measureapp.errors import RegistrationError

POINTS = 600  # of a view, looked at from all others
REFERENCE = 1  # bit of the camera in whose frame clouds are; only along its rays is nothing in front of what was seen
CELL = 0.01  # of the directions, on the plane z = 1
CLEARLY = 0.01  # of the depth: more than axes and calibration err by
CONTRADICTING, AGREEING = 0.01, 0.002  # share of points in front of other views' surfaces: none where axes are right, but for outliers
MOST_LEFT_OUT = 1 / 3  # of the views: more are no single mistakes
EXPLAINS = 0.3  # of the contradictions may be left by a cause that is named
CONTRADICTED = "its axes contradict the images"
Readbacks = Sequence[AxisReadback]
CAUSES: Mapping[str, Callable[[Readbacks], list[AxisReadback]]] = {
    "the table turned the other way: check the sign of its angle": lambda found: [replace(one, table_rad=-one.table_rad) for one in found],
    "every view had the read-back of the next one: check when positions are stored": lambda found: [*found[1:], found[0]],
    "every view had the read-back of the one before: check when positions are stored": lambda found: [found[-1], *found[:-1]],
    "the order were reversed: check the order of positions and images": lambda found: list(reversed(found)),
}


@dataclass(frozen=True, slots=True, eq=False)
class _Seen:
    """Points of a view in its camera's frame, and the nearest surface by direction."""

    points_mm: FloatArray  # (N, 3)
    corner: FloatArray  # (2,), of the grid of directions
    nearest_mm: FloatArray  # (R, C): infinite where nothing was seen

    @classmethod
    def of(cls, view: ViewResult) -> _Seen:
        points = view.cloud.points_mm
        own = points[view.cloud.cameras & REFERENCE == REFERENCE]
        if not len(own):
            return cls(points[:0], np.zeros(2), np.full((1, 1), np.inf))
        towards = own[:, :2] / own[:, 2:]
        corner = towards.min(axis=0) - 2 * CELL
        cell = ((towards - corner) / CELL).astype(int)
        depth = np.full(cell.max(axis=0) + 3, np.inf)
        np.minimum.at(depth, tuple(cell.T), own[:, 2])
        around = [np.roll(depth, (a, b), (0, 1)) for a in (-1, 0, 1) for b in (-1, 0, 1)]
        nearest = np.where(np.isfinite(np.stack(around)).all(axis=0), np.min(around, axis=0), np.inf)
        chosen = np.linspace(0, len(points) - 1, min(POINTS, len(points))).astype(int)
        return cls(points[chosen], corner, nearest)

    def in_front(self, points_mm: FloatArray) -> tuple[FloatArray, int]:
        """Return by how many mm points (N, 3) lie clearly in front of the surface, and how many have one in their direction."""
        points_mm = points_mm[points_mm[:, 2] > 1.0]
        cell = np.floor((points_mm[:, :2] / points_mm[:, 2:] - self.corner) / CELL).astype(int)
        inside = np.all((cell >= 0) & (cell < self.nearest_mm.shape), axis=1)
        nearest = self.nearest_mm[tuple(cell[inside].T)]
        known = np.isfinite(nearest)
        before = (nearest - points_mm[inside, 2])[known]
        return before[before > CLEARLY * nearest[known]], int(known.sum())


@dataclass(frozen=True, slots=True, eq=False)
class Contradictions:
    """Points of views (first index) in front of what other views see (second index)."""

    found: FloatArray  # (V, V), numbers of points
    asked: FloatArray  # (V, V)
    typical_mm: float  # median of how far they lie in front

    def share(self, views: Sequence[int]) -> float:
        """Share of contradicting points among some of the views."""
        some = np.ix_(views, views)
        return float(self.found[some].sum() / max(self.asked[some].sum(), 1.0))

    def worst(self, views: Sequence[int]) -> int:
        """Return the view with the greatest share of contradictions among some of them."""
        some = np.ix_(views, views)
        found, asked = self.found[some], self.asked[some]
        shares = (found.sum(axis=0) + found.sum(axis=1)) / np.maximum(asked.sum(axis=0) + asked.sum(axis=1), 1.0)
        return views[int(np.argmax(shares))]


def without_contradictions(views: Sequence[ViewResult], calibration: RigCalibration) -> tuple[ViewResult, ...]:
    """Return the views; those that contradict all others are not accepted, with the reason.

    Raises
    ------
    RegistrationError
        Many views contradict each other; names the cause that explains it, if one does.
    """
    usable = [index for index, view in enumerate(views) if view.quality.accepted and len(view.cloud)]
    if len(usable) < 3:
        return tuple(views)
    reads = [views[index].readback for index in usable]
    seen = [_Seen.of(views[index]) for index in usable]
    now = contradictions(seen, reads, calibration)
    kept = list(range(len(usable)))
    if now.share(kept) < CONTRADICTING:
        return tuple(views)
    cause = _cause(seen, reads, calibration, now)
    while not cause and len(kept) > 2 and now.share(kept) >= AGREEING:
        kept.remove(now.worst(kept))
    out = [usable[index] for index in range(len(usable)) if index not in kept]
    if cause or len(out) > MOST_LEFT_OUT * len(usable):
        raise _disagreement(now, cause)
    reason = f"{CONTRADICTED}: its points lie {now.typical_mm:.0f} mm in front of what other views see there"
    return tuple(
        replace(view, quality=replace(view.quality, accepted=False, reason=reason)) if index in out else view
        for index, view in enumerate(views)
    )


def before_axes_check(view: ViewResult) -> ViewResult:
    """Return a view as it was before `without_contradictions` refused it, which another calibration may not do."""
    if not view.quality.reason.startswith(CONTRADICTED):
        return view
    return replace(view, quality=replace(view.quality, accepted=True, reason=""))


def contradictions(seen: Sequence[_Seen], reads: Readbacks, calibration: RigCalibration) -> Contradictions:
    """Compare all views with each other at these positions."""
    poses = [calibration.part_from_camera(read) for read in reads]
    found, asked = np.zeros((len(seen), len(seen))), np.zeros((len(seen), len(seen)))
    apart: list[FloatArray] = [np.zeros(1)]
    for one, pose in enumerate(poses):
        points = pose.apply(seen[one].points_mm)
        for other, there in enumerate(poses):
            if other != one:
                before, known = seen[other].in_front(there.inverse().apply(points))
                found[one, other], asked[one, other] = len(before), known
                apart.append(before)
    far = np.concatenate(apart)
    return Contradictions(found, asked, float(np.median(far[far > 0.0])) if (far > 0.0).any() else 0.0)


def _cause(seen: Sequence[_Seen], reads: Readbacks, calibration: RigCalibration, now: Contradictions) -> str:
    """Return the mistake that explains most contradictions; empty if none does."""
    every = range(len(seen))
    left = {cause: contradictions(seen, other(reads), calibration).share(every) for cause, other in CAUSES.items()}
    best = min(left, key=lambda cause: left[cause])
    return best if left[best] < EXPLAINS * now.share(every) else ""


def _disagreement(now: Contradictions, cause: str) -> RegistrationError:
    said = (
        f"The axes and the images disagree: {now.share(range(len(now.found))):.0%} of the points of a view lie in front of what other views see "
        f"there, by {now.typical_mm:.0f} mm in the middle."
    )
    if cause:
        return RegistrationError(
            f"{said} They would agree if {cause}.", "Correct the read-backs, and process the images again; they are kept."
        )
    return RegistrationError(
        said, "Check whether part or head moved between the views and whether the calibration is of this rig; the images are kept."
    )
