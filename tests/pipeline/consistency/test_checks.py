"""The checks of a whole scan: a sound one is explained, one that errs otherwise than its model is not."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from measureapp.data.cloud import CloudQuality, PointCloud
from measureapp.data.consistency import Consistency
from measureapp.data.fringe import AxisReadback
from measureapp.data.measurement import ViewResult
from measureapp.geometry.transform import RigidTransform
from measureapp.pipeline.consistency.check import check_consistency, with_unexplained
from measureapp.project.documents import consistency_document, consistency_from
from tests.pipeline.scanned_clouds import ScannedPart, scanned_part

WAVE_MM = 0.08  # of the error that the model lacks


@cache
def scan() -> ScannedPart:
    return scanned_part(3, "gypsum", step_mm=1.0, noise_mm=0.01, views=8)


def checked(clouds: list[PointCloud]) -> Consistency:
    quality = CloudQuality(1, 1.0, 0.01, 0.0, 1.0, True, "")
    views = [
        ViewResult(
            cloud.viewpoint_id,
            cloud,
            quality,
            pose,
            {},
            (),
            {},
            AxisReadback(RigidTransform.identity("base", "flange"), 0.0, 2 * np.pi * number / len(clouds)),
        )
        for number, (cloud, pose) in enumerate(zip(clouds, scan().kinematic, strict=True))
    ]
    return check_consistency(views, scan().stitched)


def test_a_sound_scan_is_explained_and_adds_nothing() -> None:
    found = checked(scan().clouds)
    assert {check.name for check in found.checks} >= {"camera pixel", "surface direction", "table angle", "loop closure"}
    assert found.unexplained_mm == 0 and "agrees" in found.sentence


def test_waves_of_a_lens_are_not_explained_and_become_a_contribution() -> None:
    bent = [
        replace(
            cloud,
            points_mm=cloud.points_mm + WAVE_MM * np.sin(cloud.pixel[:, 1, None] * 2 * np.pi / 60) * np.asarray(cloud.normals, float),
        )
        for cloud in scan().clouds
    ]
    found = checked(bent)
    by_pixel = next(check for check in found.checks if check.name == "camera pixel")
    assert by_pixel.unexplained_mm == pytest.approx(WAVE_MM / np.sqrt(2), rel=0.5) and "lens model" in by_pixel.sentence
    assert found.unexplained_mm >= by_pixel.unexplained_mm and "added to U" in found.sentence
    errors = with_unexplained(scan().stitched, found).errors
    assert errors is not None
    few = scan().stitched.where(np.arange(0, len(scan().stitched), 500))
    columns = errors.along(few.points_mm, np.asarray(few.normals, float), np.asarray(few.view))
    sizes = {name: float(np.sqrt(np.mean(np.sum(columns[name] ** 2, axis=1)))) for name in ("unexplained", "common")}
    assert errors.systematic is not None
    assert sizes["unexplained"] / sizes["common"] == pytest.approx(found.unexplained_mm / errors.systematic.size_mm)
    assert consistency_from(consistency_document(found)) == found
