"""Brightness of a part as a scan has measured it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from measureapp.data.calibration import RigCalibration
from measureapp.data.measurement import ViewResult
from measureapp.data.rig import RigDescription
from measureapp.pipeline.prediction.light import PartLight
from measureapp.pipeline.prediction.phase_maps import WHITE
from measureapp.pipeline.prediction.seen import projector_of

POINTS = 2000  # of each view
LEAST_FACING = 0.5  # cosine at the projector; oblique places depend on gloss


def light_of_views(views: Sequence[ViewResult], calibration: RigCalibration, rig: RigDescription) -> PartLight | None:
    """Return the light of a measured part: the median over its points that face the projector; None without such points.

    Valid for the exposures of that scan: its longest one is what grey levels of clouds refer to.
    """
    usual = PartLight()
    source = np.asarray(projector_of(calibration.cameras, rig).reference_from_projector.translation_mm)
    found = []
    for view in views:
        cloud = view.cloud.where(np.arange(0, len(view.cloud), max(1, len(view.cloud) // POINTS)))
        away = source - cloud.points_mm
        distance = np.linalg.norm(away, axis=1)
        facing = np.einsum("ij,ij->i", np.asarray(cloud.normals, float), away) / np.maximum(distance, 1e-9)
        chosen = facing > LEAST_FACING
        irradiance = facing[chosen] * (rig.standoff_mm / distance[chosen]) ** 2
        found.append((np.asarray(cloud.grey, float)[chosen] - usual.ambient) / (WHITE * irradiance))
    values = np.concatenate(found) if found else np.empty(0)
    white = float(np.median(values)) if len(values) else 0.0
    return PartLight(white=white) if white > 0 else None
