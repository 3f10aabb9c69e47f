"""Deviation of a project's cloud from its nominal, computed once for window, report and `process`."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.surface.deviation import NEAR_MM, Deviation, compute_deviation
from measureapp.progress import NoProgress
from measureapp.project.kept_arrays import hash_of, keep, read_kept
from measureapp.project.results import DEVIATION

if TYPE_CHECKING:
    from measureapp.data.cloud import StitchedCloud
    from measureapp.data.measurement import Alignment
    from measureapp.data.mesh import Mesh
    from measureapp.progress import Progress
    from measureapp.project.folder import ProjectFolder


def deviation_of(
    project: ProjectFolder,
    stitched: StitchedCloud,
    nominal: Mesh,
    alignment: Alignment,
    *,
    progress: Progress = NoProgress(),  # noqa: B008 - stateless
) -> Deviation:
    """Return the deviation of a cloud, the kept one where it was computed from equal numbers; otherwise compute and keep it.

    Raises
    ------
    InspectionError
        As `compute_deviation`.
    """
    path, matrix = project.results / DEVIATION, alignment.nominal_from_part.matrix
    made_from = hash_of({"near_mm": NEAR_MM}, matrix, stitched.points_mm, stitched.normals, nominal.vertices_mm, nominal.triangles)

    def build(arrays: Mapping[str, Any]) -> Deviation:
        points = MeasuredPoints.of(stitched).seen_from(alignment.nominal_from_part).points_mm
        return Deviation.of(points, arrays["distances_mm"], arrays["nominal_normals"], float(arrays["unmeasured_share"]), alignment)

    kept = read_kept(path, project.journal, made_from, build)
    if kept is not None:
        return kept
    found = compute_deviation(stitched, nominal, alignment, progress=progress)
    share = np.array(found.unmeasured_share)
    keep(path, made_from, {"distances_mm": found.distances_mm, "nominal_normals": found.nominal_normals, "unmeasured_share": share})
    return found
