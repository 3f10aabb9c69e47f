"""Surfaces that the reference camera cannot see, and cameras that the horizontal fringes contradict."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.arrays import BoolArray, FloatArray
from measureapp.data.phase import PhaseMap
from measureapp.reconstruct.reconstruct import Reconstruction, reconstruct
from measureapp.reconstruct.rectification.rectifier import Rectifier
from tests.reconstruct.conftest import Head, Surface, nearest, plane, sphere

SIGMA_RAD, WALL_MM = 0.012, 560.0
ONE_PIXEL = 2  # of the border between two surfaces, on each side, that no camera sees undivided


@pytest.fixture(scope="module")
def rectifier(head: Head) -> Rectifier:
    return Rectifier(head.cameras)


def seen_places(head: Head, name: str, surface: Surface) -> FloatArray:
    """The point (H, W, 3) that every pixel of a camera sees, in the head's frame."""
    camera = head.cameras.cameras[name]
    y, x = np.mgrid[0 : camera.pinhole.height_px, 0 : camera.pinhole.width_px]
    head_from_camera = head.head_from_reference @ camera.reference_from_camera
    rays = head_from_camera.rotate(camera.pinhole.rays(np.column_stack([x.ravel(), y.ravel()]).astype(float)))
    points = head_from_camera.translation_mm + rays * surface(head_from_camera.translation_mm, rays)[:, None]
    return np.asarray(points.reshape(*y.shape, 3))


def visible(head: Head, name: str, points: FloatArray, surface: Surface) -> BoolArray:
    """Whether nothing stands between a camera and points (…, 3)."""
    origin = (head.head_from_reference @ head.cameras.cameras[name].reference_from_camera).translation_mm
    reach = np.linalg.norm(points - origin, axis=-1)
    met = surface(origin, (points - origin).reshape(-1, 3) / reach.reshape(-1, 1)).reshape(reach.shape)
    return np.asarray(np.abs(met - reach) < 1e-6)


def flying(points: FloatArray, sigma_mm: FloatArray, distances: list[FloatArray]) -> int:
    """How many points lie on none of the surfaces."""
    return int((np.min(np.abs(distances), axis=0) > np.maximum(6 * sigma_mm, 0.3)).sum())


def in_head(head: Head, made: Reconstruction) -> FloatArray:
    return head.head_from_reference.apply(made.cloud.points_mm)


@pytest.mark.parametrize("ball", [((-60, 0, 470), 30), ((-60, -40, 440), 30), ((-90, 0, 480), 30)], ids=["beside", "near", "outer"])
def test_what_something_hides_from_the_reference_camera_alone_comes_from_the_two_others(
    head: Head, rectifier: Rectifier, ball: tuple[tuple[float, float, float], float]
) -> None:
    (centre, radius), occluder = ball, sphere(*ball)
    scene = nearest(occluder, plane(WALL_MM))
    maps = head.phase_maps(scene, SIGMA_RAD, 7)
    made = reconstruct(maps, head.cameras, rectifier=rectifier)
    points = in_head(head, made)
    assert flying(points, made.cloud.sigma_mm, [np.linalg.norm(points - centre, axis=1) - radius, points[:, 2] - WALL_MM]) == 0
    places = seen_places(head, "right", scene)
    wanted = maps["right"].valid & (np.abs(places[..., 2] - WALL_MM) < 1e-6)
    wanted &= visible(head, "upper", places, scene) & ~visible(head, "left", places, scene)
    whole = np.lib.stride_tricks.sliding_window_view(np.pad(wanted, ONE_PIXEL), (2 * ONE_PIXEL + 1,) * 2).all(axis=(2, 3))
    assert whole.sum() > 500
    got = np.zeros(wanted.shape, bool)
    theirs = made.cloud.cameras == 6
    got[tuple(made.cloud.pixel[theirs].T)] = True
    assert got[whole].mean() > 0.9  # before the occluder edge the line of sight is judged with a margin


@pytest.mark.parametrize("orders", [1, -1], ids=["too far", "too near"])
def test_a_wrong_order_that_two_cameras_share_is_not_taken_for_a_hidden_surface(head: Head, rectifier: Rectifier, orders: int) -> None:
    dome = sphere((0, 0, 700), 180)
    maps = head.phase_maps(dome, SIGMA_RAD, 7)
    for name in ("right", "upper"):
        with np.errstate(invalid="ignore"):
            places = seen_places(head, name, dome)
        spots = np.random.default_rng(3).uniform(-80, 80, (25, 2))
        hit = maps[name].valid & (np.linalg.norm(places[..., None, :2] - spots, axis=-1) < 8).any(axis=-1)
        phase = np.where(hit, maps[name].phase_rad + np.float32(2 * np.pi * orders), maps[name].phase_rad)
        maps[name] = replace(maps[name], phase_rad=phase)
        assert hit.sum() > 2000
    made = reconstruct(maps, head.cameras, rectifier=rectifier)
    theirs = made.cloud.cameras == 6
    points = in_head(head, made)[theirs]
    assert flying(points, made.cloud.sigma_mm[theirs], [np.linalg.norm(points - [0, 0, 700], axis=1) - 180]) == 0


def both_directions(head: Head, surface: Surface) -> dict[str, PhaseMap]:
    across = head.phase_maps(surface, SIGMA_RAD, 12, horizontal=True)
    return {name: replace(each, orthogonal=across[name]) for name, each in head.phase_maps(surface, SIGMA_RAD, 13).items()}


def with_wrong_rows(maps: dict[str, PhaseMap], name: str, box: tuple[slice, slice]) -> dict[str, PhaseMap]:
    across = maps[name].orthogonal
    assert across is not None
    wrong = across.phase_rad.copy()
    wrong[box] += np.float32(0.8)
    return maps | {name: replace(maps[name], orthogonal=replace(across, phase_rad=wrong))}


@pytest.mark.parametrize(("name", "left_with"), [("right", 5), ("upper", 3)])
def test_one_camera_that_the_horizontal_fringes_contradict_leaves_the_point_to_the_two_others(
    head: Head, rectifier: Rectifier, name: str, left_with: int
) -> None:
    maps = both_directions(head, plane(550, 0.2, 0.1))
    whole = reconstruct(maps, head.cameras, rectifier=rectifier)
    made = reconstruct(with_wrong_rows(maps, name, (slice(100, 120), slice(140, 180))), head.cameras, rectifier=rectifier)
    assert len(made.cloud) > 0.998 * len(whole.cloud)
    before, after = whole.cloud.cameras == 7, made.cloud.cameras == left_with
    assert 500 < (after.sum() - (whole.cloud.cameras == left_with).sum()) <= 21 * 41
    assert before.sum() - (made.cloud.cameras == 7).sum() < 21 * 41 * 1.3  # pixels of the reference camera are of another size
    off = distance_from_plane(head, made)
    assert (off[after] / made.cloud.sigma_mm[after]).std() == pytest.approx(1.0, abs=0.1)
    assert np.abs(off / made.cloud.sigma_mm).max() < 6


def test_two_cameras_that_agree_keep_their_points_against_the_reference_camera(head: Head, rectifier: Rectifier) -> None:
    maps = both_directions(head, plane(550, 0.2, 0.1))
    whole = reconstruct(maps, head.cameras, rectifier=rectifier)
    made = reconstruct(with_wrong_rows(maps, "left", (slice(100, 120), slice(140, 180))), head.cameras, rectifier=rectifier)
    theirs = (made.cloud.cameras == 6).sum() - (whole.cloud.cameras == 6).sum()
    assert theirs > 0.8 * 20 * 40
    off = distance_from_plane(head, made)
    assert np.abs(off / made.cloud.sigma_mm).max() < 6


def test_of_two_cameras_that_contradict_each_other_neither_is_believed(head: Head, rectifier: Rectifier) -> None:
    maps = {name: each for name, each in both_directions(head, plane(550, 0.2, 0.1)).items() if name != "upper"}
    whole = reconstruct(maps, head.cameras, rectifier=rectifier)
    made = reconstruct(with_wrong_rows(maps, "right", (slice(100, 120), slice(140, 180))), head.cameras, rectifier=rectifier)
    assert len(whole.cloud) - len(made.cloud) > 0.8 * 20 * 40


def distance_from_plane(head: Head, made: Reconstruction) -> FloatArray:
    """Signed distance along the first camera's viewing ray."""
    normal = np.array([-0.2, -0.1, 1.0])
    centres = np.array([camera.reference_from_camera.translation_mm for camera in head.cameras.cameras.values()])
    bits = made.cloud.cameras.astype(int)
    centres = centres[np.log2(bits & -bits).astype(int)]  # the lowest bit is the camera in whose image the point stands
    rays = made.cloud.points_mm - centres
    rays = head.head_from_reference.rotate(rays / np.linalg.norm(rays, axis=1)[:, None])
    return np.asarray(((in_head(head, made) - [0, 0, 550]) @ normal) / (rays @ normal))
