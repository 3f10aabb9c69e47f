"""What all clouds err by alike: as large as their form, and followed by the views as stitching follows it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from measureapp.arrays import FloatArray
from measureapp.data.cloud import PointCloud, StitchedCloud
from measureapp.data.view_errors import SystematicErrors
from measureapp.register.joint.pose_graph import relative_motion_projector
from measureapp.register.joint.pose_prior import PosePrior
from measureapp.register.stitch import stitch
from tests.register.conftest import Scan, impeller

DRAWN_MM = 0.005  # far above what is found to be common, and small enough for weights to stay


def stitched(scan: Scan, clouds: list[PointCloud]) -> StitchedCloud:
    return stitch(clouds, scan.truth, prior=PosePrior(scan.stations))


def displaced(cloud: PointCloud, common: SystematicErrors, drawn: FloatArray) -> PointCloud:
    normals = np.asarray(cloud.normals, float)
    along = common.along(cloud.points_mm, normals) @ drawn
    return replace(cloud, points_mm=cloud.points_mm + along[:, None] * normals)


def moved(before: StitchedCloud, after: StitchedCloud) -> FloatArray:
    """Motions (6V,) of the views about their centres, beside what all have in common."""
    assert before.errors is not None
    motions = []
    for old, new, centre in zip(before.placements, after.placements, before.errors.centres_mm, strict=True):
        change = new.part_from_camera @ old.part_from_camera.inverse()
        motions.append(np.concatenate([change.apply(centre) - centre, change.rotation_vector]))
    return np.asarray(relative_motion_projector(before.errors.centres_mm) @ np.concatenate(motions))


@pytest.fixture(scope="module")
def scan(scanned: Callable[..., Scan]) -> Scan:
    return scanned(impeller(), [60.0 * k for k in range(6)], [40.0], noise_mm=0.01, step_mm=0.6)


@pytest.fixture(scope="module")
def before(scan: Scan) -> StitchedCloud:
    return stitched(scan, scan.clouds)


def test_systematic_errors_are_as_large_as_form_errors_in_every_orientation(before: StitchedCloud) -> None:
    assert before.errors is not None and before.errors.form is not None and before.errors.systematic is not None
    common, form = before.errors.systematic, before.errors.form
    assert common.size_mm == pytest.approx(np.sqrt(np.mean(form.sizes_mm**2)))
    turned = np.random.default_rng(1).normal(size=(200, 3)) + np.array([0, 0, -1.5])
    turned /= np.linalg.norm(turned, axis=1, keepdims=True)
    places = np.tile([0.0, 0.0, 500.0], (200, 1))
    sizes = np.linalg.norm(common.along(places, turned)[turned[:, 2] < -0.3], axis=1)
    assert (sizes > 0.9 * common.size_mm).all() and (sizes < 1.01 * common.size_mm).all()
    np.testing.assert_array_equal(common.along(places, -turned), -common.along(places, turned))  # the same side of the surface


@pytest.mark.parametrize("seed", [1, *(pytest.param(seed, marks=pytest.mark.slow) for seed in (2, 3))])
def test_views_respond_to_systematic_errors_as_predicted(scan: Scan, before: StitchedCloud, seed: int) -> None:
    assert before.errors is not None and before.errors.systematic is not None
    common = before.errors.systematic
    drawn = np.random.default_rng(seed).standard_normal(common.count) * DRAWN_MM / common.size_mm
    after = stitched(scan, [displaced(cloud, common, drawn) for cloud in scan.clouds])
    told, found = common.motions @ drawn, moved(before, after)
    assert np.linalg.norm(found - told) < 0.25 * np.linalg.norm(told)
