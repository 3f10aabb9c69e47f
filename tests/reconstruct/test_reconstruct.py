from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.data.point_state import PointState
from measureapp.errors import ReconstructError
from measureapp.geometry.transform import RigidTransform
from measureapp.progress import CallbackProgress, Cancelled
from measureapp.reconstruct.reconstruct import Reconstruction, reconstruct
from measureapp.reconstruct.rectification.rectifier import Rectifier
from measureapp.reconstruct.settings import ReconstructSettings
from tests.reconstruct.conftest import Head, Surface, make_head, nearest, plane, sphere

SIGMA_RAD = 0.012
NORMAL = np.array([-0.2, -0.1, 1.0]) / np.linalg.norm([-0.2, -0.1, 1.0])
FLOAT32_PHASE_MM = 3e-3  # half a unit of a float32 phase near 200 rad and the rounding of float32 rays, in depth, six-fold


@pytest.fixture(scope="module")
def rectifier(head: Head) -> Rectifier:
    return Rectifier(head.cameras)


def off_plane(head: Head, made: Reconstruction) -> np.ndarray:
    """Signed distance to the plane through (0, 0, 550) along the viewing ray of the first camera."""
    points = head.head_from_reference.apply(made.cloud.points_mm)
    rays = head.head_from_reference.rotate(made.cloud.points_mm / np.linalg.norm(made.cloud.points_mm, axis=1)[:, None])
    return ((points - [0, 0, 550]) @ NORMAL) / (rays @ NORMAL)


def test_a_plane_without_noise_is_recovered_to_the_resolution_of_its_phase(head: Head, rectifier: Rectifier) -> None:
    maps = head.phase_maps(plane(550, 0.2, 0.1))
    made = reconstruct(maps, head.cameras, rectifier=rectifier)
    assert len(made.cloud) > 0.99 * maps["left"].valid.sum()
    assert np.abs(off_plane(head, made)).max() < FLOAT32_PHASE_MM
    normals = head.head_from_reference.rotate(made.cloud.normals)
    assert np.degrees(np.arccos(np.clip(-normals @ NORMAL, -1, 1))).max() < 0.1
    assert made.cloud.frame == "camera"
    assert np.allclose(made.cloud.grey, 0.4)
    assert all(pair.epipolar_rms_px is not None and pair.epipolar_rms_px < 1e-3 for pair in made.pairs)
    assert [pair.names for pair in made.pairs] == [("left", "right"), ("left", "upper"), ("right", "upper")]


def test_the_scatter_of_a_noisy_plane_is_the_predicted_one_for_every_set_of_cameras(head: Head, rectifier: Rectifier) -> None:
    made = reconstruct(head.phase_maps(plane(550, 0.2, 0.1), SIGMA_RAD, 1), head.cameras, rectifier=rectifier)
    score = off_plane(head, made)[made.cloud.cameras != 6] / made.cloud.sigma_mm[made.cloud.cameras != 6]
    assert score.std() == pytest.approx(1.0, abs=0.1)
    for bits, least in ((7, 50_000), (5, 1_000)):
        chosen = made.cloud.cameras == bits
        assert chosen.sum() > least
        assert (off_plane(head, made)[chosen] / made.cloud.sigma_mm[chosen]).std() == pytest.approx(1.0, abs=0.1)


def test_a_third_camera_lowers_the_noise(head: Head, rectifier: Rectifier) -> None:
    maps = head.phase_maps(plane(550, 0.2, 0.1), SIGMA_RAD, 1)
    three = reconstruct(maps, head.cameras, rectifier=rectifier)
    two = reconstruct(
        {name: maps[name] for name in ("left", "right")}, head.cameras, ReconstructSettings(grid="image"), rectifier=rectifier
    )
    assert np.median(three.cloud.sigma_mm) < np.median(two.cloud.sigma_mm)
    assert two.pairs[0].epipolar_rms_px is None


def test_a_sphere_before_a_wall_has_no_false_points(head: Head, rectifier: Rectifier) -> None:
    maps = head.phase_maps(nearest(sphere((20, -10, 500), 40), plane(560)), SIGMA_RAD, 2)
    made = reconstruct(maps, head.cameras, rectifier=rectifier)
    points = head.head_from_reference.apply(made.cloud.points_mm)
    off = np.minimum(np.abs(np.linalg.norm(points - [20, -10, 500], axis=1) - 40), np.abs(points[:, 2] - 560))
    assert (off > np.maximum(6 * made.cloud.sigma_mm, 0.3)).mean() < 1e-4
    assert made.rejected["contradicted"] > 0
    assert set(np.unique(made.cloud.cameras)) <= {3, 5, 6, 7}
    unique = np.unique(made.cloud.pixel[made.cloud.cameras != 6], axis=0)
    assert len(unique) == (made.cloud.cameras != 6).sum()


def test_points_unseen_by_the_reference_camera_come_from_the_others_without_doubling(head: Head, rectifier: Rectifier) -> None:
    maps = head.phase_maps(plane(550, 0.2, 0.1))
    blind = maps["left"].state.copy()
    blind[:, :100] = PixelState.SATURATED
    maps["left"] = replace(maps["left"], state=blind)
    made = reconstruct(maps, head.cameras, rectifier=rectifier)
    extra = made.cloud.cameras == 6
    assert extra.sum() > 5_000
    assert np.abs(off_plane(head, made)[~extra]).max() < FLOAT32_PHASE_MM
    left = head.cameras.cameras["left"].pinhole.project(made.cloud.points_mm[extra])
    inside = (left > 0.5).all(axis=1) & (left[:, 0] < 323) & (left[:, 1] < 242)
    assert (left[inside, 0] < 100.0).all()


def test_two_cameras_give_the_same_plane_on_the_rectified_grid(head: Head, rectifier: Rectifier) -> None:
    maps = head.phase_maps(plane(550, 0.2, 0.1), SIGMA_RAD, 3)
    made = reconstruct({name: maps[name] for name in ("left", "right")}, head.cameras, rectifier=rectifier)
    off = off_plane(head, made)
    assert (off / made.cloud.sigma_mm).std() == pytest.approx(1.0, abs=0.1)
    assert abs(off.mean()) < 4 * off.std() / np.sqrt(len(off) / 4)
    native = head.cameras.cameras["left"].pinhole.project(made.cloud.points_mm)
    assert np.abs(native - made.cloud.pixel[:, ::-1]).max() < 0.75


def test_a_phase_that_another_camera_contradicts_gives_no_point(head: Head, rectifier: Rectifier) -> None:
    maps = head.phase_maps(plane(550, 0.2, 0.1))
    wrong = maps["left"].phase_rad.copy()
    wrong[100:130, 150:180] += np.float32(2.5)  # a patch of the reference camera has a wrong order
    maps["left"] = replace(maps["left"], phase_rad=wrong)
    shifted = maps["right"].phase_rad + np.float32(0.0)
    maps["right"] = replace(maps["right"], phase_rad=shifted)
    made = reconstruct(maps, head.cameras, rectifier=rectifier)
    assert made.rejected["contradicted"] > 300
    assert np.abs(off_plane(head, made)).max() < 0.05


def test_a_point_that_stands_alone_is_removed(head: Head, rectifier: Rectifier) -> None:
    maps = head.phase_maps(plane(550, 0.2, 0.1))
    state = np.full_like(maps["left"].state, PixelState.SHADOW)
    state[50:200, 50:250] = PixelState.VALID
    state[60:80, 60:80] = PixelState.SHADOW
    state[70, 70] = PixelState.VALID
    state[68:73, 61:66] = PixelState.VALID
    made = reconstruct(
        {"left": replace(maps["left"], state=state), "right": maps["right"]},
        head.cameras,
        ReconstructSettings(grid="image"),
        rectifier=rectifier,
    )
    assert made.rejected["flying"] >= 1
    assert made.rejected["flying"] + made.rejected["island"] == 26
    lone = (made.cloud.pixel[:, 0] > 62) & (made.cloud.pixel[:, 0] < 78) & (made.cloud.pixel[:, 1] > 60) & (made.cloud.pixel[:, 1] < 78)
    assert not lone.any()


def test_grazing_surfaces_are_rejected_beyond_the_limit(head: Head, rectifier: Rectifier) -> None:
    maps = head.phase_maps(plane(550, 0.2, 0.1))
    made = reconstruct(maps, head.cameras, ReconstructSettings(max_incidence_deg=15.0), rectifier=rectifier)
    cosine = -(made.cloud.normals * made.cloud.points_mm).sum(axis=1) / np.linalg.norm(made.cloud.points_mm, axis=1)
    left = made.cloud.cameras != 6
    assert np.degrees(np.arccos(cosine[left].min())) < 15.5
    assert made.rejected["grazing"] > 0


def test_a_calibration_of_other_cameras_is_refused_in_words(head: Head) -> None:
    maps = head.phase_maps(plane(550))
    with pytest.raises(ReconstructError, match="324 × 243"):
        reconstruct(maps, make_head(16).cameras)
    with pytest.raises(ReconstructError, match="'front' is not in the calibration"):
        reconstruct({"front": maps["left"], "right": maps["right"]}, head.cameras)
    with pytest.raises(ReconstructError, match="points need two"):
        reconstruct({"left": maps["left"]}, head.cameras)
    with pytest.raises(ReconstructError, match="different pitches"):
        reconstruct({"left": maps["left"], "right": replace(maps["right"], pitch_px=33.0)}, head.cameras)
    with pytest.raises(ReconstructError, match="needs two cameras"):
        reconstruct(maps, head.cameras, ReconstructSettings(grid="rectified"))


def test_empty_phase_maps_give_an_empty_cloud(head: Head, rectifier: Rectifier) -> None:
    maps = {name: replace(each, state=np.full_like(each.state, PixelState.SHADOW)) for name, each in head.phase_maps(plane(550)).items()}
    made = reconstruct(maps, head.cameras, rectifier=rectifier)
    assert len(made.cloud) == 0


def test_it_can_be_cancelled(head: Head, rectifier: Rectifier) -> None:
    def stop(done: float, total: float, note: str) -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        reconstruct(head.phase_maps(plane(550)), head.cameras, progress=CallbackProgress(stop), rectifier=rectifier)


def test_horizontal_fringes_match_the_pairs_whose_epipolar_lines_cross_them_and_skip_the_others_in_words(
    head: Head, rectifier: Rectifier
) -> None:
    maps = head.phase_maps(plane(550, 0.2, 0.1), horizontal=True)
    made = reconstruct(maps, head.cameras, rectifier=rectifier)
    assert len(made.cloud) > 0.7 * maps["left"].valid.sum()
    assert np.abs(off_plane(head, made)[made.cloud.cameras != 6]).max() < 2 * FLOAT32_PHASE_MM
    skipped = {pair.names: pair.skipped for pair in made.pairs}
    assert "direction of the fringes" in skipped["left", "right"]
    assert skipped["left", "upper"] == skipped["right", "upper"] == ""
    two = {name: maps[name] for name in ("left", "right")}
    with pytest.raises(ReconstructError, match="cannot match the cameras left and right"):
        reconstruct(two, head.cameras, ReconstructSettings(grid="image"), rectifier=rectifier)


def test_phase_noise_is_not_taken_for_a_shifted_camera_but_a_shifted_camera_is(head: Head, rectifier: Rectifier) -> None:
    maps = head.phase_maps(plane(550, 0.2, 0.1), SIGMA_RAD, 4)
    quiet = reconstruct(maps, head.cameras, rectifier=rectifier)
    shaken = reconstruct(maps, turned(head, "upper", (0, 0.3 / 511, 0)))  # 0.3 px
    for before, after in zip(quiet.pairs, shaken.pairs, strict=True):
        assert before.epipolar_px is not None and before.epipolar_rms_px is not None and after.epipolar_px is not None
        assert before.epipolar_px < before.epipolar_rms_px
        assert before.epipolar_px < 0.03
        assert after.epipolar_px > 0.1


def test_pixels_that_one_camera_has_wrong_are_not_all_that_the_figure_of_the_other_pair_is_taken_from(
    head: Head, rectifier: Rectifier
) -> None:
    maps = head.phase_maps(plane(550, 0.2, 0.1), SIGMA_RAD, 7)
    phase = maps["left"].phase_rad.copy()
    phase[: int(0.3 * len(phase))] += np.float32(2 * np.pi)  # there the others have points of their own, and left differs from all of them
    maps["left"] = replace(maps["left"], phase_rad=phase)
    made = reconstruct(maps, head.cameras, rectifier=rectifier)
    figures = made.pairs[2]
    assert figures.names == ("right", "upper") and figures.epipolar_px is not None and figures.epipolar_rms_px is not None
    # Half of all samples are 0.5 / 0.7 of the right ones: those below 1.57 standard deviations
    # instead of 0.67, as if there were an error of √(1.57² / 0.67² − 1) = 2.1 of them; the rms is of samples in which wrong ones are few.
    assert figures.epipolar_px < 1.2 * 2.1 * figures.epipolar_rms_px


def test_order_errors_of_patches_spoil_no_other_point(head: Head, rectifier: Rectifier) -> None:
    maps = head.phase_maps(plane(550, 0.2, 0.1), SIGMA_RAD, 5)
    random = np.random.default_rng(6)
    wrong = {}
    for name, each in maps.items():
        phase, hit = each.phase_rad.copy(), np.zeros(each.state.shape, bool)
        for row, column in zip(random.integers(0, 238, 60), random.integers(0, 319, 60), strict=True):
            phase[row : row + 3, column : column + 3] += np.float32(2 * np.pi * random.choice([-1, 1]))
            hit[row : row + 3, column : column + 3] = True
        maps[name] = replace(each, phase_rad=phase)
        wrong[name] = hit
    made = reconstruct(maps, head.cameras, rectifier=rectifier)
    off = np.abs(off_plane(head, made))
    assert (off > np.maximum(6 * made.cloud.sigma_mm, 0.3)).sum() < 10
    assert len(made.cloud) > 0.97 * (maps["left"].valid & ~wrong["left"]).sum()


def test_a_surface_that_another_camera_cannot_see_for_something_before_it_is_no_contradiction(head: Head, rectifier: Rectifier) -> None:
    ball = sphere((60, 0, 470), 30)  # hides parts of the wall from the right camera alone
    maps = head.phase_maps(nearest(ball, plane(560)), SIGMA_RAD, 7, shadows=False)
    made = reconstruct(maps, head.cameras, rectifier=rectifier)
    points = head.head_from_reference.apply(made.cloud.points_mm)
    off = np.minimum(np.abs(np.linalg.norm(points - [60, 0, 470], axis=1) - 30), np.abs(points[:, 2] - 560))
    assert (off > np.maximum(6 * made.cloud.sigma_mm, 0.3)).mean() < 2e-4
    right = (head.head_from_reference @ head.cameras.cameras["right"].reference_from_camera).translation_mm
    away = np.linalg.norm(points - right, axis=1)
    hidden = (np.abs(points[:, 2] - 560) < 1) & (ball(right, (points - right) / away[:, None]) < away - 20)
    assert hidden.sum() > 500
    assert (made.cloud.cameras[hidden] == 5).mean() > 0.95


def test_every_pixel_of_every_camera_has_a_state_and_the_points_are_the_valid_ones(head: Head, rectifier: Rectifier) -> None:
    maps = head.phase_maps(nearest(sphere((20, -10, 500), 40), plane(560)), SIGMA_RAD, 2)
    made = reconstruct(maps, head.cameras, rectifier=rectifier)
    assert set(made.states) == set(maps)
    assert sum(int((state == PointState.VALID).sum()) for state in made.states.values()) == len(made.cloud)
    for name, state in made.states.items():
        assert ((state == PointState.NO_PHASE) == (maps[name].state != PixelState.VALID)).all()
    first = made.cloud.cameras != 6
    assert (made.states["left"][tuple(made.cloud.pixel[first].T)] == PointState.VALID).all()
    assert made.rejected["flying"] == sum(int((made.states[name] == PointState.FLYING).sum()) for name in ("left", "right"))
    assert (made.states["right"] == PointState.SEEN_BY_ANOTHER).mean() > 0.5


def test_a_perfect_head_has_no_epipolar_residual_in_any_pair_and_a_turned_camera_its_true_one(head: Head, rectifier: Rectifier) -> None:
    surface = plane(550, 0.2, 0.1)
    for sigma_rad in (1e-4, SIGMA_RAD, 0.04):
        made = reconstruct(head.phase_maps(surface, sigma_rad, 11), head.cameras, rectifier=rectifier)
        assert all(pair.epipolar_px is not None and pair.epipolar_px < 0.03 for pair in made.pairs)
    quiet = reconstruct(head.phase_maps(surface, 1e-4, 11), turned(head, "right", (0, 0.3 / 511, 0)))
    noisy = reconstruct(head.phase_maps(surface, SIGMA_RAD, 11), turned(head, "right", (0, 0.3 / 511, 0)))
    for true, seen in zip(quiet.pairs, noisy.pairs, strict=True):
        assert true.epipolar_rms_px is not None and true.epipolar_rms_px > 0.2  # without noise the rms is the residual itself
        assert seen.epipolar_px == pytest.approx(true.epipolar_rms_px, rel=0.1)


def turned(head: Head, name: str, by_rad: tuple[float, float, float]) -> CameraArrayCalibration:
    """Return the head's calibration with one camera turned about its own axes."""
    camera = head.cameras.cameras[name]
    turn = RigidTransform.from_parts(Rotation.from_rotvec(by_rad).as_matrix(), np.zeros(3), name, name)
    moved = replace(camera, reference_from_camera=camera.reference_from_camera @ turn)
    return replace(head.cameras, cameras={**head.cameras.cameras, name: moved})


def both_directions(head: Head, surface: Surface) -> dict[str, PhaseMap]:
    across = head.phase_maps(surface, SIGMA_RAD, 12, horizontal=True)
    return {name: replace(each, orthogonal=across[name]) for name, each in head.phase_maps(surface, SIGMA_RAD, 13).items()}


def test_horizontal_fringes_see_across_the_epipolar_lines_what_vertical_ones_cannot(head: Head, rectifier: Rectifier) -> None:
    maps = both_directions(head, plane(550, 0.2, 0.1))
    straight = reconstruct(maps, head.cameras, rectifier=rectifier)
    assert all(pair.across_px is not None and pair.across_px < 0.03 for pair in straight.pairs)
    assert straight.rejected["contradicted"] == 0
    shaken = reconstruct(maps, turned(head, "right", (0.3 / 511, 0, 0)))  # 0.3 px across the lines of left and right
    pair = shaken.pairs[0]
    assert pair.epipolar_px is not None and pair.epipolar_px < 0.03
    assert pair.across_px == pytest.approx(0.3, abs=0.05)
    two = reconstruct({name: maps[name] for name in ("left", "right")}, head.cameras, rectifier=rectifier)
    assert two.pairs[0].across_px is not None and two.pairs[0].across_px < 0.03


def test_two_cameras_alarm_for_a_turned_one_when_fringes_of_both_directions_show_it(head: Head, rectifier: Rectifier) -> None:
    maps = {name: each for name, each in both_directions(head, plane(550, 0.2, 0.1)).items() if name != "upper"}
    straight = reconstruct(maps, head.cameras, rectifier=rectifier).pairs[0]
    assert straight.epipolar_px is not None and straight.epipolar_rms_px is not None
    assert straight.epipolar_px < 0.01 < straight.epipolar_rms_px  # phase noise is seen, and known as such
    shaken = reconstruct(maps, turned(head, "right", (0.3 / 511, 0, 0))).pairs[0]
    assert shaken.epipolar_px == pytest.approx(0.3, abs=0.05)
    one_direction = {name: replace(each, orthogonal=None) for name, each in maps.items()}
    assert reconstruct(one_direction, head.cameras, rectifier=rectifier).pairs[0].epipolar_px is None


def test_points_whose_horizontal_phases_differ_are_contradicted(head: Head, rectifier: Rectifier) -> None:
    maps = both_directions(head, plane(550, 0.2, 0.1))
    across = maps["left"].orthogonal
    assert across is not None
    wrong = across.phase_rad.copy()
    wrong[100:120, 100:140] += np.float32(0.8)
    maps["left"] = replace(maps["left"], orthogonal=replace(across, phase_rad=wrong))
    made = reconstruct(maps, head.cameras, rectifier=rectifier)
    state = made.states["left"]
    assert (state[100:120, 100:140] == PointState.CONTRADICTED).mean() > 0.95
    assert made.rejected["contradicted"] <= 20 * 40


def test_a_cloud_is_the_same_to_the_last_bit_however_many_processors_share_the_work(
    head: Head, rectifier: Rectifier, monkeypatch: pytest.MonkeyPatch
) -> None:
    maps = head.phase_maps(nearest(sphere((-60, 0, 470), 30), plane(560)), 0.012, 7)
    clouds = []
    for processors in (1, 2, 5, 5):
        monkeypatch.setattr("measureapp.arrays.processors", lambda count=processors: count)
        clouds.append(reconstruct(maps, head.cameras, rectifier=rectifier).cloud)
    for cloud in clouds[1:]:
        for name in ("points_mm", "normals", "sigma_mm", "grey", "pixel", "cameras"):
            assert np.array_equal(getattr(clouds[0], name), getattr(cloud, name))
