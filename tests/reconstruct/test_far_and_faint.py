"""No point is thrown away for being far or faint: limits follow the standoff, and can be set."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from recorded import recorded

from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration
from measureapp.data.fringe import FringeStack, GrayCodeGroup, PatternSet, PhaseShiftGroup
from measureapp.data.phase import PhaseMap
from measureapp.data.point_state import PointState
from measureapp.fringe.decode import decode
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.project.images import read_image
from measureapp.reconstruct.reconstruct import Reconstruction, reconstruct
from measureapp.reconstruct.settings import ReconstructSettings
from measureapp.reconstruct.why import why
from tests.reconstruct.conftest import Head, plane
from tests.reconstruct.diagnosis.test_diagnose_decoded import cameras_of

ROWS = slice(312, 712)  # of the recorded images: points enough, in two fifths of the time
FAINT_RAD = 0.18  # four steps of a modulation of 5 grey levels in the light of a room


def pair_of(maps: dict[str, PhaseMap]) -> dict[str, PhaseMap]:
    return {name: maps[name] for name in ("left", "right")}


def points_of_plane(head: Head, z_mm: float, settings: ReconstructSettings | None = None) -> tuple[dict[str, PhaseMap], Reconstruction]:
    maps = pair_of(head.phase_maps(plane(z_mm, 0.1, 0.05), FAINT_RAD, 3))
    return maps, reconstruct(maps, head.cameras, settings)


@pytest.mark.parametrize("z_mm", [550.0, 1100.0])
def test_a_faint_plane_becomes_points_at_any_standoff_with_their_true_scatter(head: Head, z_mm: float) -> None:
    _, made = points_of_plane(head, z_mm)
    _, sharp = reconstruct_without_noise(head, z_mm)
    assert made.rejected["uncertain"] < 0.001 * len(made.cloud)
    assert len(made.cloud) > 0.95 * len(sharp.cloud)
    points = head.head_from_reference.apply(made.cloud.points_mm)
    normal = np.array([-0.1, -0.05, 1.0])
    rays = head.head_from_reference.rotate(made.cloud.points_mm / np.linalg.norm(made.cloud.points_mm, axis=1)[:, None])
    off = ((points - [0, 0, z_mm]) @ normal) / (rays @ normal)
    inner = np.abs(off / made.cloud.sigma_mm) < 6
    assert inner.mean() > 0.999
    assert (off / made.cloud.sigma_mm)[inner].std() == pytest.approx(1.0, abs=0.15)


def reconstruct_without_noise(head: Head, z_mm: float) -> tuple[dict[str, PhaseMap], Reconstruction]:
    maps = pair_of(head.phase_maps(plane(z_mm, 0.1, 0.05)))
    return maps, reconstruct(maps, head.cameras)


def test_the_limit_grows_with_the_square_of_the_standoff_and_is_told(head: Head) -> None:
    near, far = (points_of_plane(head, z_mm)[1].max_sigma_mm["left"] for z_mm in (550.0, 1100.0))
    assert far / near == pytest.approx(4.0, rel=0.3)


def test_a_limit_that_is_set_is_kept_and_named(head: Head) -> None:
    settings = ReconstructSettings(max_sigma_mm=0.05)
    maps, made = points_of_plane(head, 550.0, settings)
    assert len(made.cloud) == 0
    assert made.max_sigma_mm == {"left": 0.05}
    row, column = np.argwhere(made.states["left"] == PointState.UNCERTAIN)[0]
    assert "exceeds 0.05 mm" in why(maps, made, "left", int(row), int(column), settings).sentence


def dimmed(images: np.ndarray, share: float, seed: int) -> np.ndarray:
    """The same scene with a share of its light and some light of the room, seen by a camera of 10 000 electrons."""
    random = np.random.default_rng(seed)
    electrons = (images * share + 6.0) * 10_000 / 255
    grey = (random.poisson(electrons) + random.normal(0, 7, images.shape)) * 255 / 10_000
    return np.clip(np.rint(grey), 0, 255).astype(np.uint8)


def cut_to_rows(camera: CameraCalibration) -> CameraCalibration:
    """The camera of which only ROWS are read."""
    matrix = np.array(camera.pinhole.matrix)
    matrix[1, 2] -= ROWS.start
    return replace(camera, pinhole=PinholeCamera(camera.pinhole.width_px, ROWS.stop - ROWS.start, matrix, camera.pinhole.distortion))


@pytest.fixture(scope="module")
def rendered() -> tuple[CameraArrayCalibration, FringeStack]:
    folder = recorded("slmaster_render_stereo")
    groups = (PhaseShiftGroup(pitch_px=30, steps=4), GrayCodeGroup(planes=7, complementary=True))
    numbers = [0, 3, 6, 9, *range(12, 19)]
    images = {
        name: np.array([read_image(folder / name[0].upper() / f"{number:02d}.png")[ROWS] for number in numbers])[None]
        for name in ("left", "right")
    }
    patterns = PatternSet(name="r", projector_px=1920, groups=groups, shift_sign=1)
    whole = cameras_of(folder)
    cameras = replace(whole, cameras={name: cut_to_rows(camera) for name, camera in whole.cameras.items()})
    return cameras, FringeStack("v", patterns, (1000,), images, 255)


def test_a_recorded_pair_with_fringes_of_seven_grey_levels_keeps_its_points(rendered: tuple[CameraArrayCalibration, FringeStack]) -> None:
    cameras, stack = rendered
    faint = replace(stack, images={name: dimmed(images, 0.08, 1) for name, images in stack.images.items()})
    bright, maps = decode(stack), decode(faint)
    first, _, third = (faint.images["left"][0, n].astype(float) for n in (0, 1, 2))
    second, fourth = (faint.images["left"][0, n].astype(float) for n in (1, 3))
    plain = np.hypot(second - fourth, first - third) / 2  # modulation, by the formula for four steps
    assert 5 < np.median(plain[bright["left"].valid]) < 8
    wanted = bright["left"].valid & (plain >= 5)
    assert maps["left"].valid[wanted].mean() > 0.99
    seen = np.zeros(wanted.shape, bool)
    seen[tuple(reconstruct(bright, cameras).cloud.pixel.T)] = True
    kept = np.zeros(wanted.shape, bool)
    kept[tuple(reconstruct(maps, cameras).cloud.pixel.T)] = True
    assert kept[wanted & seen].mean() > 0.95
