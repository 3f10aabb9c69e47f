"""The projector fills what only one camera sees, and only where it agrees with the cameras."""

from __future__ import annotations

from dataclasses import replace
from math import tau

import numpy as np
import pytest

from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.cloud import PROJECTOR_BIT
from measureapp.data.phase import PhaseMap
from measureapp.errors import ReconstructError
from measureapp.geometry.transform import RigidTransform
from measureapp.reconstruct.projector.fill import FillSettings, fill_with_projector
from measureapp.reconstruct.projector.lit_camera import LitCamera
from tests.reconstruct.conftest import plane
from tests.reconstruct.projector_scene import ProjectorHead, make_head

PLANE = plane(550, 0.2, 0.1)
CAMERA_SIGMA_MM = 0.02


@pytest.fixture(scope="module")
def head() -> ProjectorHead:
    return make_head(binning=8)


@pytest.fixture(scope="module")
def phase_map(head: ProjectorHead) -> PhaseMap:
    return head.phase_maps(PLANE, noise_seed=5)["left"]


def seen_by_cameras(head: ProjectorHead, phase_map: PhaseMap) -> tuple[np.ndarray, np.ndarray]:
    """What the cameras measured: all but a stripe that only one of them sees."""
    depth = head.depth_mm("left", PLANE) + np.random.default_rng(1).normal(0, CAMERA_SIGMA_MM, phase_map.phase_rad.shape)
    hole = np.zeros(depth.shape, bool)
    hole[60:120, 100:180] = True
    there = phase_map.valid & ~hole
    return np.where(there, depth, 0).astype(np.float32), np.where(there, CAMERA_SIGMA_MM, 0).astype(np.float32)


def turned(cameras: CameraArrayCalibration, angle_rad: float) -> CameraArrayCalibration:
    assert cameras.projector is not None
    pose = cameras.projector.reference_from_projector
    turn = RigidTransform.from_vector([0, angle_rad, 0], [0, 0, 0], pose.from_frame, pose.from_frame)
    return replace(cameras, projector=replace(cameras.projector, reference_from_projector=pose @ turn))


def test_a_hole_is_filled_with_true_points_that_are_marked(head: ProjectorHead, phase_map: PhaseMap) -> None:
    depth, sigma = seen_by_cameras(head, phase_map)
    made = fill_with_projector(depth, sigma, LitCamera.of(phase_map, head.cameras))
    hole = phase_map.valid & (depth == 0)
    assert hole.sum() == 4800
    assert made.filled.sum() == len(made.cloud) > 0.99 * hole.sum()
    assert not (made.filled & ~hole).any()
    assert set(np.unique(made.cloud.cameras)) == {PROJECTOR_BIT | 1}
    off = made.cloud.points_mm[:, 2] - head.depth_mm("left", PLANE)[made.filled]
    assert (off / made.cloud.sigma_mm).std() == pytest.approx(1.0, abs=0.1)
    assert made.agreement.refused == ""
    assert abs(made.agreement.bias_mm) < 0.01
    assert made.agreement.disagreement_mm < 0.02
    np.testing.assert_array_equal(made.cloud.pixel, np.argwhere(made.filled))


def test_a_projector_out_of_calibration_fills_nothing_and_says_by_how_much(head: ProjectorHead, phase_map: PhaseMap) -> None:
    depth, sigma = seen_by_cameras(head, phase_map)
    made = fill_with_projector(depth, sigma, LitCamera.of(phase_map, turned(head.cameras, 2e-3)))
    assert len(made.cloud) == 0
    assert "disagree by" in made.agreement.refused
    assert made.agreement.disagreement_mm > made.agreement.limit_mm > 0.09
    tolerant = fill_with_projector(
        depth, sigma, LitCamera.of(phase_map, turned(head.cameras, 2e-3)), fill=FillSettings(max_disagreement_mm=50)
    )
    assert len(tolerant.cloud) > 4000
    off = tolerant.cloud.points_mm[:, 2] - head.depth_mm("left", PLANE)[tolerant.filled]
    assert np.median(off) == pytest.approx(tolerant.agreement.bias_mm, abs=0.3 * abs(tolerant.agreement.bias_mm))


def test_where_cameras_and_projector_disagree_locally_nothing_is_filled(head: ProjectorHead, phase_map: PhaseMap) -> None:
    depth, sigma = seen_by_cameras(head, phase_map)
    order = np.zeros(depth.shape, np.float32)
    order[30:150, 60:220] = tau  # a region of one wrong fringe order, round the hole
    wrong = replace(phase_map, phase_rad=np.where(phase_map.valid, phase_map.phase_rad + order, 0).astype(np.float32))
    made = fill_with_projector(depth, sigma, LitCamera.of(wrong, head.cameras))
    assert made.agreement.refused == ""
    assert len(made.cloud) == 0
    assert made.rejected["disagreement of projector and cameras"] > 4000


def test_pixels_that_must_not_be_filled_stay_empty(head: ProjectorHead, phase_map: PhaseMap) -> None:
    depth, sigma = seen_by_cameras(head, phase_map)
    fillable = np.zeros(depth.shape, bool)
    fillable[:, :140] = True
    made = fill_with_projector(depth, sigma, LitCamera.of(phase_map, head.cameras), fillable=fillable)
    assert 2000 < made.filled.sum() <= 2400
    assert not made.filled[:, 140:].any()


def test_without_points_of_cameras_nothing_is_filled(head: ProjectorHead, phase_map: PhaseMap) -> None:
    nothing = np.zeros_like(phase_map.phase_rad)
    made = fill_with_projector(nothing, nothing, LitCamera.of(phase_map, head.cameras))
    assert len(made.cloud) == 0
    assert made.agreement.refused.startswith("only 0 points")


def test_without_a_calibrated_projector_filling_is_refused(head: ProjectorHead, phase_map: PhaseMap) -> None:
    depth, sigma = seen_by_cameras(head, phase_map)
    with pytest.raises(ReconstructError, match="projector is not calibrated"):
        fill_with_projector(depth, sigma, LitCamera.of(phase_map, head.without_projector()))
