"""What a calibration leaves open is the same after it was on disk."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from measureapp.calibrate.rig.stitch_uncertainty import RigUncertainty, uncertainty_of, view_uncertainty
from measureapp.errors import StorageError
from measureapp.project.calibration.rig_uncertainty_file import read_rig_uncertainty, write_rig_uncertainty
from tests.calibrate.paper_rig import calibrated
from tests.calibrate.rig.test_stitch_uncertainty import readback_of, views


@pytest.fixture(scope="module")
def rig() -> RigUncertainty:
    return uncertainty_of(calibrated(11, camera_errors=False).solution)


def test_views_are_as_uncertain_after_a_round_trip(rig: RigUncertainty, tmp_path: Path) -> None:
    path = tmp_path / "rig_uncertainty.npz"
    write_rig_uncertainty(path, rig)
    again = read_rig_uncertainty(path, rig.calibration)
    places = [readback_of(viewpoint) for viewpoint in views()]
    np.testing.assert_array_equal(view_uncertainty(again, places).covariance, view_uncertainty(rig, places).covariance)


def test_a_damaged_file_is_refused_in_words(rig: RigUncertainty, tmp_path: Path) -> None:
    path = tmp_path / "rig_uncertainty.npz"
    write_rig_uncertainty(path, rig)
    path.write_bytes(path.read_bytes()[:1000])
    with pytest.raises(StorageError, match="cannot be read") as refused:
        read_rig_uncertainty(path, rig.calibration)
    assert "Calibrate again" in refused.value.hint
    np.savez(path, covariance=np.eye(3))
    with pytest.raises(StorageError):
        read_rig_uncertainty(path, rig.calibration)


def test_motions_of_the_cameras_scatter_as_their_covariance_says(rig: RigUncertainty) -> None:
    found = view_uncertainty(rig, [readback_of(viewpoint) for viewpoint in views()])
    count = len(found.part_from_camera)
    drawn = np.random.default_rng(0).multivariate_normal(np.zeros(6 * count), found.covariance.reshape(6 * count, -1), 4000, method="svd")
    turns, shifts = drawn.reshape(-1, count, 2, 3)[:, :, 0], drawn.reshape(-1, count, 2, 3)[:, :, 1]
    rotations = np.array([pose.rotation for pose in found.part_from_camera])
    in_camera = np.concatenate([np.einsum("vji,nvj->nvi", rotations, part) for part in (shifts, turns)], axis=2).reshape(len(drawn), -1)
    scatter = in_camera.T @ in_camera / len(drawn)
    size = np.sqrt(np.diag(found.pose_covariance))
    # correlations of 4000 draws scatter by 1/sqrt(4000) = 0.016 each; 5 of these
    np.testing.assert_allclose(scatter / np.outer(size, size), found.pose_covariance / np.outer(size, size), atol=0.08)
