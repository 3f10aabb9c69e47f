"""Residuals of single points for colouring: computed once per view and stage, on a job's thread."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from measureapp.data.cloud import PointCloud, StitchedCloud
    from measureapp.register.point_residuals import MergedSurface


class Residuals:
    """Distances of the views' points from the merged cloud, cached for the same clouds."""

    def __init__(self) -> None:
        self._surface: MergedSurface | None = None
        self._kept: dict[int, tuple[PointCloud, np.ndarray, np.ndarray]] = {}  # by the cloud's identity

    def of(self, cloud: PointCloud, stitched: StitchedCloud) -> np.ndarray:
        """Return the signed distances (N,) in mm of a placed cloud's points; NaN without a merged point nearby."""
        return self._residuals_of(cloud, stitched)[0]

    def merged(self, clouds: Sequence[PointCloud], stitched: StitchedCloud, check: Callable[[], None]) -> np.ndarray:
        """Return the rms residual (M,) in mm of the registered clouds at each merged point."""
        found = []
        for cloud in clouds:
            check()
            found.append(self._residuals_of(cloud, stitched))
        surface = self._of(stitched)
        if not found:
            return np.full(len(stitched), np.nan)
        return surface.rms_per_point(np.concatenate([one for one, _ in found]), np.concatenate([one for _, one in found]))

    def _of(self, stitched: StitchedCloud) -> MergedSurface:
        from measureapp.register.point_residuals import MergedSurface

        if self._surface is None or self._surface.stitched is not stitched:
            self._surface, self._kept = MergedSurface(stitched), {}
        return self._surface

    def _residuals_of(self, cloud: PointCloud, stitched: StitchedCloud) -> tuple[np.ndarray, np.ndarray]:
        surface, kept = self._of(stitched), self._kept.get(id(cloud))
        if kept is None or kept[0] is not cloud:
            kept = self._kept[id(cloud)] = (cloud, *surface.residuals(cloud.points_mm))
        return kept[1], kept[2]
