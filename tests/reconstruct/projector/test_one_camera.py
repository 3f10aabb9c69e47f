"""Camera and projector as a pair: simulated surfaces come back, with the noise that was predicted."""

from __future__ import annotations

from dataclasses import replace
from math import tau
from pathlib import Path

import cv2
import numpy as np
import pytest
from recorded import recorded

from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration, ProjectorCalibration
from measureapp.data.cloud import PROJECTOR_BIT
from measureapp.data.fringe import FringeStack, GrayCodeGroup, PatternSet, PhaseShiftGroup
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.errors import ReconstructError
from measureapp.fringe.decode import decode
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform
from measureapp.project.images import read_image
from measureapp.reconstruct.projector.depth import lens_of, triangulate_with_projector
from measureapp.reconstruct.projector.lit_camera import LitCamera
from measureapp.reconstruct.projector.one_camera import reconstruct_with_projector
from measureapp.reconstruct.projector.state import ProjectorState
from tests.reconstruct.conftest import nearest, plane, sphere
from tests.reconstruct.projector_scene import HEAD, PITCH_PX, SIGMA_RAD, ProjectorHead, make_head, projector_lens, wrong_sign

FLOAT32_PHASE_MM = 4e-3  # half a unit of a float32 phase near 200 rad and the rounding of float32 rays, in depth, six-fold
PLANE, BALL = plane(550, 0.2, 0.1), nearest(sphere((20, -10, 500), 40), plane(560))


@pytest.fixture(scope="module")
def head() -> ProjectorHead:
    return make_head()


@pytest.mark.parametrize("surface", [PLANE, BALL], ids=["plane", "ball before a wall"])
@pytest.mark.parametrize("origin_rad", [0.0, -np.pi], ids=["crest at column 0", "trough at column 0"])
@pytest.mark.parametrize("across", [False, True], ids=["vertical", "both directions"])
def test_a_surface_without_noise_is_recovered_to_the_resolution_of_its_phase(head, surface, origin_rad, across) -> None:
    for name, phase_map in head.phase_maps(surface, across=across, origin_rad=origin_rad).items():
        made = triangulate_with_projector(phase_map, head.cameras.cameras[name], head.projector)
        usable = made.state == ProjectorState.POINT
        # Above the projector its columns run along the rays: only rows measure there.
        if name != "upper" or across:
            assert usable.sum() == phase_map.valid.sum() > 5_000
            assert np.abs(made.depth_mm - head.depth_mm(name, surface))[usable].max() < FLOAT32_PHASE_MM
        else:
            assert made.rejected["parallel to the projector's fringe"] > 0.3 * phase_map.valid.sum()
        assert (made.depth_mm[~usable] == 0).all()
        assert np.isfinite(made.depth_mm).all()
        assert np.isfinite(made.sigma_mm).all()


@pytest.mark.parametrize(("name", "across"), [("left", False), ("right", False), ("left", True), ("right", True), ("upper", True)])
def test_the_scatter_of_a_noisy_plane_is_the_predicted_one(head, name, across) -> None:
    phase_map = head.phase_maps(PLANE, noise_seed=3, across=across)[name]
    made = triangulate_with_projector(phase_map, head.cameras.cameras[name], head.projector)
    usable = made.depth_mm > 0
    score = ((made.depth_mm - head.depth_mm(name, PLANE)) / np.maximum(made.sigma_mm, 1e-9))[usable]
    assert usable.sum() == phase_map.valid.sum()
    assert np.std(score) == pytest.approx(1.0, abs=0.05)
    if across:
        assert made.residual_rms_px == pytest.approx(SIGMA_RAD * PITCH_PX / tau, rel=0.05)
    else:
        assert made.residual_rms_px is None


def test_every_distortion_of_the_format_is_solved_exactly(head) -> None:
    fourteen = np.array([-0.1, 0.05, 1e-3, -8e-4, 0.02, 0.03, -0.01, 0.004, 1e-3, -5e-4, 8e-4, 4e-4, 0.03, -0.02])
    for length in (4, 5, 8, 12, 14):
        tilted = make_head({"left": HEAD["left"]}, lens=projector_lens(distortion=fourteen[:length]))
        phase_map = tilted.phase_maps(PLANE)["left"]
        made = triangulate_with_projector(phase_map, tilted.cameras.cameras["left"], tilted.projector)
        assert (made.depth_mm > 0).sum() == phase_map.valid.sum() > 5_000
        assert np.abs(made.depth_mm - tilted.depth_mm("left", PLANE))[made.depth_mm > 0].max() < FLOAT32_PHASE_MM


def test_the_matrix_of_a_tilted_imager_is_that_of_opencv() -> None:
    lens = projector_lens(distortion=np.array([0.0] * 12 + [0.05, -0.03]))
    points = np.column_stack([np.linspace(-0.3, 0.3, 9), np.linspace(0.2, -0.25, 9), np.ones(9)])
    pixels = points @ lens_of(lens)[1].T
    np.testing.assert_allclose(pixels[:, :2] / pixels[:, 2:], lens.project(points), atol=1e-9)


def test_rows_alone_measure_where_the_camera_stands_above_the_projector(head) -> None:
    rows = head.phase_maps(PLANE, across=True)["upper"].orthogonal
    assert rows is not None
    made = triangulate_with_projector(rows, head.cameras.cameras["upper"], head.projector)
    assert (made.depth_mm > 0).sum() == rows.valid.sum()
    assert np.abs(made.depth_mm - head.depth_mm("upper", PLANE))[made.depth_mm > 0].max() < FLOAT32_PHASE_MM


def test_a_row_that_does_not_belong_to_the_column_is_a_contradiction(head) -> None:
    phase_map = head.phase_maps(PLANE, across=True)["left"]
    assert phase_map.orthogonal is not None
    spoiled = phase_map.orthogonal.phase_rad.copy()
    spoiled[40:50] += np.float32(tau)  # a wrong fringe order
    wrong = replace(phase_map, orthogonal=replace(phase_map.orthogonal, phase_rad=spoiled))
    made = triangulate_with_projector(wrong, head.cameras.cameras["left"], head.projector)
    assert (made.state[40:50][phase_map.valid[40:50]] == ProjectorState.CONTRADICTED).all()
    assert (made.state[50:][phase_map.valid[50:]] == ProjectorState.POINT).all()


def test_columns_that_meet_the_rays_nowhere_are_rejected_with_a_reason(head) -> None:
    phase_map = head.phase_maps(PLANE)["left"]
    for shift_px, reason in ((1500.0, "behind"), (-1500.0, "outside")):
        moved = np.where(phase_map.valid, phase_map.phase_rad + np.float32(shift_px * tau / PITCH_PX), 0)
        made = triangulate_with_projector(replace(phase_map, phase_rad=moved), head.cameras.cameras["left"], head.projector)
        assert not (made.depth_mm > 0).any()
        rejected = {words: count for words, count in made.rejected.items() if count}
        assert sum(rejected.values()) == phase_map.valid.sum()
        assert any(reason in words for words in rejected), rejected


def test_a_camera_in_the_projectors_place_measures_nothing() -> None:
    coaxial = make_head({"one": ((0, 0, 0), (0, 0, 0))})
    phase_map = coaxial.phase_maps(PLANE)["one"]
    made = triangulate_with_projector(phase_map, coaxial.cameras.cameras["one"], coaxial.projector)
    assert made.rejected["parallel to the projector's fringe"] == phase_map.valid.sum()
    assert np.isfinite(made.sigma_mm).all()


def test_one_camera_and_the_projector_give_a_cloud_with_normals_marked_as_the_projectors(head) -> None:
    phase_map = head.phase_maps(PLANE, noise_seed=1)["right"]
    made = reconstruct_with_projector(LitCamera.of(phase_map, head.cameras))
    assert len(made.cloud) > 0.98 * phase_map.valid.sum()
    assert set(np.unique(made.cloud.cameras)) == {PROJECTOR_BIT | 2}
    points = head.head_from_reference.apply(made.cloud.points_mm)
    normal = np.array([-0.2, -0.1, 1.0]) / np.linalg.norm([-0.2, -0.1, 1.0])
    off = (points - [0, 0, 550]) @ normal
    assert off.std() < 1.1 * np.median(made.cloud.sigma_mm)
    found = head.head_from_reference.rotate(made.cloud.normals)
    assert np.median(np.degrees(np.arccos(np.clip(-found @ normal, -1, 1)))) < 1.5
    rows, columns = made.cloud.pixel.T
    assert phase_map.valid[rows, columns].all()


def test_what_is_missing_is_refused_in_words(head) -> None:
    maps = head.phase_maps(PLANE)
    with pytest.raises(ReconstructError, match="projector is not calibrated"):
        reconstruct_with_projector(LitCamera.of(maps["left"], head.without_projector()))
    with pytest.raises(ReconstructError, match="'lower' is not in the calibration"):
        reconstruct_with_projector(LitCamera.of(replace(maps["left"], camera="lower"), head.cameras))
    dark = replace(maps["left"], state=np.full_like(maps["left"].state, PixelState.SHADOW))
    with pytest.raises(ReconstructError, match="no pixel with a phase"):
        reconstruct_with_projector(LitCamera.of(dark, head.cameras))
    small = replace(maps["left"], phase_rad=maps["left"].phase_rad[:, :100])
    with pytest.raises(ReconstructError, match="100 × 162 px"):
        reconstruct_with_projector(LitCamera.of(small, head.cameras))
    beside = replace(maps["left"], phase_rad=np.where(maps["left"].valid, maps["left"].phase_rad - 300, 0).astype(np.float32))
    with pytest.raises(ReconstructError, match="outside the projector's image") as raised:
        reconstruct_with_projector(LitCamera.of(beside, head.cameras))
    assert "shift_sign" in raised.value.hint


def test_the_kernel_agrees_with_its_readable_statement(head) -> None:
    phase_map = wrong_sign(head.phase_maps(PLANE)["left"], 1024)  # mirrored columns: steep solutions all over the image
    camera = head.cameras.cameras["left"]
    made = triangulate_with_projector(phase_map, camera, head.projector)
    rows, columns = np.nonzero(made.depth_mm > 0)
    assert len(rows) > 500
    projector_from_camera = head.projector.reference_from_projector.inverse() @ camera.reference_from_camera
    flat = camera.pinhole.normalise(np.column_stack([columns, rows]).astype(float))
    depth = made.depth_mm[rows, columns].astype(np.float64)
    points = np.column_stack([flat, np.ones(len(flat))]) * depth[:, None]
    pixels = head.projector.pinhole.project(projector_from_camera.apply(points))
    nearer = head.projector.pinhole.project(projector_from_camera.apply(points * (1 - 1e-4)))
    per_mm = np.abs(pixels - nearer)[:, 0] / (1e-4 * depth)
    column = phase_map.phase_rad[rows, columns] * PITCH_PX / tau
    assert np.abs(pixels[:, 0] - column).max() < 3e-3
    predicted = SIGMA_RAD * PITCH_PX / tau / per_mm
    np.testing.assert_allclose(made.sigma_mm[rows, columns], predicted, rtol=0.02)


def real_set(folder: Path, distortion: bool) -> tuple[PhaseMap, CameraArrayCalibration]:
    """The recorded camera and projector; Rlp and Tlp take the camera's coordinates to the projector's."""
    file = cv2.FileStorage(str(folder / "caliInfo.yml"), cv2.FILE_STORAGE_READ)
    node = {name: file.getNode(name).mat() for name in ("M1", "D1", "M4", "D4", "Rlp", "Tlp")}
    file.release()
    camera = CameraCalibration("one", PinholeCamera(1280, 1024, node["M1"], node["D1"]), RigidTransform.identity("camera", "one"))
    pose = RigidTransform.from_parts(node["Rlp"], node["Tlp"].ravel(), "projector", "camera").inverse()
    lens = PinholeCamera(1920, 1080, node["M4"], node["D4"] if distortion else np.zeros(5))
    groups = (PhaseShiftGroup(pitch_px=60, steps=12), GrayCodeGroup(planes=6, complementary=True))
    patterns = PatternSet(name="real", projector_px=1920, groups=groups, shift_sign=1)
    images = np.array([read_image(folder / f"{number:02d}.png") for number in range(18)])[None]
    maps = decode(FringeStack("v", patterns, (1000,), {"one": images}, 255))
    return maps["one"], CameraArrayCalibration("one", {"one": camera}, projector=ProjectorCalibration(lens, pose))


def test_the_real_camera_and_projector_give_the_recorded_depth() -> None:
    """The figures that came with the set leave the distortion of the projector (up to 0.6 mm of depth there) out."""
    folder = recorded("slmaster_real_mono")
    phase_map, cameras = real_set(folder, distortion=False)
    made = triangulate_with_projector(phase_map, cameras.cameras["one"], cameras.projector)
    depth = made.depth_mm[(made.depth_mm > 0) & (phase_map.modulation > 10)]  # the set counts no fainter pixel; ours does, with its σ
    assert len(depth) == pytest.approx(214_654, rel=0.02)
    assert np.percentile(depth, [1, 50, 99]) == pytest.approx([694.7, 727.9, 775.4], abs=0.3)


def test_the_real_camera_and_projector_give_a_smooth_surface() -> None:
    phase_map, cameras = real_set(recorded("slmaster_real_mono"), distortion=True)
    made = reconstruct_with_projector(LitCamera.of(phase_map, cameras))
    assert len(made.cloud) > 0.85 * phase_map.valid.sum()
    assert np.percentile(made.cloud.points_mm[:, 2], 50) == pytest.approx(727.4, abs=5)
    grid = np.full(phase_map.phase_rad.shape, np.nan)
    grid[made.cloud.pixel[:, 0], made.cloud.pixel[:, 1]] = made.cloud.points_mm[:, 2]
    second = grid[:, 2:] - 2 * grid[:, 1:-1] + grid[:, :-2]
    noise = 1.4826 * np.nanmedian(np.abs(second)) / np.sqrt(6)
    assert noise < 1.1 * np.median(made.cloud.sigma_mm)
