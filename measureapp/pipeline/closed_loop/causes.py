"""Why samples of the nominal are not measured, from the images of the views that should have seen them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from measureapp.arrays import BoolArray, IntArray
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.pipeline.closed_loop.coverage import MeasuredCoverage
from measureapp.pipeline.why import REASONS, ExplainedView
from measureapp.planning.coverage.samples import SurfaceSamples
from measureapp.planning.coverage.unreachable import LINK_FACTOR, touches_support
from measureapp.progress import Progress

MOST_EXPLAINED = 8  # views whose images are decoded again
MOST_AREAS = 12


class Cause(StrEnum):
    """Why a sample is not measured, or not well enough."""

    SUPPORT = "touches the support"
    UNSEEN = "no viewpoint sees it"
    SATURATED = "saturated"
    DARK = "too dark"
    LOST = "visible, but its pixels have no point"
    NOISY = "standard deviation above the required one"


CAUSES = tuple(Cause)
BRIGHT_REASONS = ("saturated", "blooming")
DARK_REASONS = ("weak modulation", "uncertain", "order conflict")


@dataclass(frozen=True, slots=True)
class Hole:
    """A connected area of the nominal that is not measured."""

    cause: Cause
    area_mm2: float
    share: float  # of the surface
    place_mm: tuple[float, float, float]  # nearest sample to its centroid, frame `part` of planning


@dataclass(frozen=True, slots=True, eq=False)
class Explained:
    """Causes of all missing samples, and which view lost which of them for lack or excess of light."""

    cause: IntArray  # (N,), index in `CAUSES`; -1 where enough is measured
    too_dark: BoolArray  # (V, N)
    too_bright: BoolArray  # (V, N)

    def of(self, cause: Cause) -> BoolArray:
        """Return the samples with a cause, (N,)."""
        return np.asarray(self.cause == CAUSES.index(cause))


def explain_holes(
    coverage: MeasuredCoverage, pinhole: PinholeCamera, explain: Callable[[str], ExplainedView] | None, progress: Progress
) -> Explained:
    """Find out why samples are missing.

    Parameters
    ----------
    pinhole : of the reference camera
    explain : decodes a view again and keeps the state of every pixel; called for the views that lost the largest areas. None: causes
        in the images are not looked for
    """
    missing = ~coverage.sufficient
    lost = coverage.visible & ~coverage.by_view & ~coverage.measured
    dark, bright = np.zeros_like(lost), np.zeros_like(lost)
    areas = lost @ coverage.samples.areas_mm2
    worst = [int(number) for number in np.argsort(-areas)[:MOST_EXPLAINED] if areas[number] > 0] if explain is not None else []
    for step, number in enumerate(worst):
        assert explain is not None  # otherwise there are none to explain
        progress.report(step, len(worst), f"holes of {coverage.viewpoints[number].id}")
        words = _reasons_at(explain(coverage.viewpoints[number].id), pinhole, coverage, number)
        dark[number] = lost[number] & np.isin(words, [REASONS.index(reason) for reason in DARK_REASONS])
        bright[number] = lost[number] & np.isin(words, [REASONS.index(reason) for reason in BRIGHT_REASONS])
    progress.report(1, 1, "holes explained")
    tests = [
        (touches_support(coverage.samples, coverage.scene), Cause.SUPPORT),
        (coverage.measured, Cause.NOISY),
        (~coverage.predicted, Cause.UNSEEN),
        (bright.any(axis=0) & (bright.sum(axis=0) >= dark.sum(axis=0)), Cause.SATURATED),
        (dark.any(axis=0), Cause.DARK),
    ]
    cause = np.select([mask for mask, _ in tests], [CAUSES.index(one) for _, one in tests], CAUSES.index(Cause.LOST))
    return Explained(np.where(missing, cause, -1), dark, bright)


def _reasons_at(explained: ExplainedView, pinhole: PinholeCamera, coverage: MeasuredCoverage, number: int) -> IntArray:
    """Return the index in `REASONS` of the reference camera's pixel at every sample, (N,); -1 outside its image."""
    codes = explained.codes(explained.cameras[0])
    seen = coverage.poses[number].inverse().apply(np.asarray(coverage.samples.points_mm, float))
    pixels = np.full((len(seen), 2), -1)
    ahead = seen[:, 2] > 0
    pixels[ahead] = np.rint(pinhole.project(seen[ahead])).astype(int)
    column, row = pixels.T
    inside = (row >= 0) & (column >= 0) & (row < codes.shape[0]) & (column < codes.shape[1])
    return np.where(inside, codes[np.where(inside, row, 0), np.where(inside, column, 0)], -1)


def holes_of(explained: Explained, samples: SurfaceSamples) -> tuple[Hole, ...]:
    """Group missing samples of one cause into connected areas, the largest first."""
    members = np.flatnonzero(explained.cause >= 0)
    if not len(members):
        return ()
    points, normals, cause = samples.points_mm[members], samples.normals[members], explained.cause[members]
    spacing = float(np.sqrt(np.median(samples.areas_mm2)))
    pairs = cKDTree(points).query_pairs(LINK_FACTOR * spacing, output_type="ndarray")
    facing = np.einsum("ni,ni->n", normals[pairs[:, 0]], normals[pairs[:, 1]])
    pairs = pairs[(cause[pairs[:, 0]] == cause[pairs[:, 1]]) & (facing > 0)]
    graph = coo_matrix((np.ones(len(pairs)), (pairs[:, 0], pairs[:, 1])), shape=(len(members), len(members)))
    count, label = connected_components(graph, directed=False)
    found = [_hole(members[label == group], samples, explained) for group in range(count)]
    return tuple(sorted(found, key=lambda hole: -hole.area_mm2)[:MOST_AREAS])


def _hole(members: IntArray, samples: SurfaceSamples, explained: Explained) -> Hole:
    area, points = samples.areas_mm2[members], np.asarray(samples.points_mm[members], float)
    centre = area @ points / float(area.sum())
    x, y, z = (float(value) for value in points[np.linalg.norm(points - centre, axis=1).argmin()])
    total = float(area.sum())
    return Hole(CAUSES[int(explained.cause[members[0]])], total, total / samples.area_mm2, (x, y, z))


def shares_by_cause(explained: Explained, coverage: MeasuredCoverage) -> dict[str, float]:
    """Return the share of the surface that is missing for each cause, the largest first."""
    shares = {str(cause): coverage.share(explained.of(cause)) for cause in CAUSES}
    return {words: share for words, share in sorted(shares.items(), key=lambda one: -one[1]) if share > 0}
