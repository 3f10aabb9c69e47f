from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.data.cloud import StitchedCloud
from measureapp.errors import RegistrationError
from measureapp.geometry.transform import RigidTransform
from measureapp.register.joint.pose_prior import KinematicPrior, PosePrior
from measureapp.register.settings import StitchSettings
from measureapp.register.stitch import stitch
from measureapp.register.surface.closed import reconstruct_surface

SIXTHS = [10.0, 70.0, 130.0, 190.0, 250.0, 310.0]


def best_fit(found: np.ndarray, true: np.ndarray) -> RigidTransform:
    """The motion that brings corresponding points together: where the whole part lies is not stitching's business."""
    a, b = found.mean(axis=0), true.mean(axis=0)
    u, _, vt = np.linalg.svd((found - a).T @ (true - b))
    rotation = (u @ np.diag([1, 1, np.linalg.det(u @ vt)]) @ vt).T
    return RigidTransform.from_parts(rotation, b - rotation @ a, "part", "part")


def judged(scan, stitched: StitchedCloud) -> tuple[float, float]:
    """Return rms distance of the merged points from the true surface, and the worst view's rms pose error, after best fit."""
    found, true = [], []
    for cloud, truth, placement in zip(scan.clouds, scan.truth, stitched.placements, strict=True):
        if placement.used:
            sample = np.asarray(cloud.points_mm)[::300]
            found.append(placement.part_from_camera.apply(sample))
            true.append(truth.apply(sample))
    whole = best_fit(np.vstack(found), np.vstack(true))
    poses = max(float(np.sqrt(np.mean(np.sum((whole.apply(a) - b) ** 2, axis=1)))) for a, b in zip(found, true, strict=True))
    return float(np.sqrt(np.mean(scan.distances_mm(whole.apply(np.asarray(stitched.points_mm))) ** 2))), poses


@pytest.fixture(scope="module")
def impeller_scan(scanned, impeller_mesh):
    return scanned(impeller_mesh, [0.0, 60.0, 120.0, 180.0, 240.0, 300.0], [35.0, 65.0], step_mm=0.7)


@pytest.fixture(scope="module")
def stitched_impeller(impeller_scan) -> StitchedCloud:
    return stitch(impeller_scan.clouds, impeller_scan.kinematic, prior=PosePrior(impeller_scan.stations))


def test_an_impeller_is_stitched_to_below_the_noise_of_its_points(impeller_scan, stitched_impeller):
    surface_rms, pose_error = judged(impeller_scan, stitched_impeller)
    kinematic_rms, kinematic_error = judged(
        impeller_scan, stitch(impeller_scan.clouds, impeller_scan.kinematic, StitchSettings(fine=False))
    )
    assert surface_rms < 0.04  # the noise of one point
    assert pose_error < 0.02
    assert kinematic_rms > 3 * surface_rms and kinematic_error > 0.2
    assert all(placement.verdict == "good" for placement in stitched_impeller.placements)


def test_corrections_are_relative_to_the_other_views(impeller_scan, stitched_impeller):
    samples = [np.asarray(cloud.points_mm)[::300] for cloud in impeller_scan.clouds]
    before = [placement.kinematic.apply(sample) for placement, sample in zip(stitched_impeller.placements, samples, strict=True)]
    after = [placement.part_from_camera.apply(sample) for placement, sample in zip(stitched_impeller.placements, samples, strict=True)]
    whole = best_fit(np.vstack(before), np.vstack(after))
    beside = [np.linalg.norm((b - whole.apply(a)).mean(axis=0)) for a, b in zip(before, after, strict=True)]
    in_all = [np.linalg.norm((b - a).mean(axis=0)) for a, b in zip(before, after, strict=True)]
    told = [placement.correction_mm for placement in stitched_impeller.placements]
    least, alone, most = (float(np.sqrt(np.mean(np.square(lengths)))) for lengths in (told, beside, in_all))
    assert least < most
    assert alone == pytest.approx(least, rel=0.25)  # views weigh by their centres there, by their points here


def test_a_cross_of_planes_is_stitched_within_eight_hundredths(scanned, cross_mesh):
    scan = scanned(cross_mesh, SIXTHS, [25.0, 60.0], step_mm=1.0, seed=4)
    stitched = stitch(scan.clouds, scan.kinematic, prior=PosePrior(scan.stations))
    surface_rms, _ = judged(scan, stitched)
    assert surface_rms < 0.08
    assert all(placement.verdict == "good" for placement in stitched.placements)


def test_the_order_of_the_views_does_not_matter(scanned, cross_mesh):
    scan = scanned(cross_mesh, [10.0, 100.0, 190.0], [40.0], step_mm=1.2)
    order = [2, 0, 1]
    first = stitch(scan.clouds, scan.kinematic)
    second = stitch([scan.clouds[i] for i in order], [scan.kinematic[i] for i in order])
    np.testing.assert_allclose(first.points_mm, second.points_mm, atol=1e-9)
    for place, i in enumerate(order):
        np.testing.assert_allclose(first.placements[i].part_from_camera.matrix, second.placements[place].part_from_camera.matrix, atol=1e-9)
    assert np.array_equal(np.array(order)[second.view], first.view)


def test_a_displaced_view_is_named_and_excluded(scanned, impeller_mesh):
    scan = scanned(impeller_mesh, SIXTHS, [45.0], step_mm=0.8)
    slipped = RigidTransform.from_parts(np.eye(3), [1.2, 1.2, 1.05], "camera", "camera")  # 2 mm
    kinematic = [pose @ slipped if i == 2 else pose for i, pose in enumerate(scan.kinematic)]
    stitched = stitch(scan.clouds, kinematic)
    assert [placement.used for placement in stitched.placements] == [True, True, False, True, True, True]
    assert "excluded" in stitched.placements[2].verdict
    assert 2 not in stitched.view
    assert judged(scan, stitched)[0] < 0.05


def test_nothing_slides_on_a_turned_part(scanned):
    import trimesh

    disc = trimesh.util.concatenate([trimesh.creation.cylinder(60, 20, sections=720), trimesh.creation.cylinder(25, 60, sections=360)])
    scan = scanned(disc, [0.0, 90.0, 180.0, 270.0], [40.0], step_mm=0.8, station_mm=0.2, station_deg=0.01)
    stitched = stitch(scan.clouds, scan.kinematic)
    turns = []
    for truth, placement in zip(scan.truth, stitched.placements, strict=True):
        turns.append((placement.part_from_camera @ truth.inverse()).rotation_vector[2])
    assert np.ptp(turns) < np.radians(0.05)  # one standard deviation of the axes


def test_a_view_without_overlap_stays_where_the_axes_say(scanned, cross_mesh):
    scan = scanned(cross_mesh, [10.0, 70.0], [40.0], step_mm=1.0)
    far = replace(scan.clouds[0], viewpoint_id="far")
    away = RigidTransform.from_parts(np.eye(3), [0, 0, 900.0], "part", "part") @ scan.kinematic[0]
    stitched = stitch([*scan.clouds, far], [*scan.kinematic, away])
    lonely = stitched.placements[2]
    assert "no overlap" in lonely.verdict and lonely.used and lonely.correction_mm == pytest.approx(0, abs=1e-9)
    assert stitched.placements[0].verdict == "good"


def test_clouds_without_points_are_refused_or_excluded(scanned, cross_mesh):
    scan = scanned(cross_mesh, [10.0, 70.0], [40.0], step_mm=1.0)
    nothing = scan.clouds[0].where(np.arange(1))
    with pytest.raises(RegistrationError, match="enough points"):
        stitch([nothing], scan.kinematic[:1])
    stitched = stitch([nothing, scan.clouds[1]], scan.kinematic)
    assert not stitched.placements[0].used and "only 1 points" in stitched.placements[0].verdict
    assert set(np.unique(stitched.view)) == {1}


def test_the_surface_follows_the_points_and_says_where_it_was_filled(impeller_scan, stitched_impeller):
    mesh = reconstruct_surface(stitched_impeller)
    points = np.asarray(stitched_impeller.points_mm)
    from scipy.spatial import cKDTree

    distance, _ = cKDTree(points).query(mesh.vertices_mm)
    assert distance[mesh.measured].max() < 3 * stitched_impeller.notes["spacing_mm"]
    assert distance.max() < 10 * stitched_impeller.notes["spacing_mm"]
    assert 0.5 < mesh.measured.mean() < 1
    inside = mesh.vertices_mm[mesh.measured]
    assert np.median(impeller_scan.distances_mm(inside)) < 0.15


def test_a_surface_that_does_not_fit_into_memory_is_refused_before_it_is_made(stitched_impeller):
    with pytest.raises(RegistrationError, match="GiB"):
        reconstruct_surface(stitched_impeller, free_bytes=lambda: 1000)


@pytest.mark.parametrize("displaced", [1, pytest.param(4, marks=pytest.mark.slow)])
def test_precise_axes_do_not_hide_a_displaced_view(scanned, impeller_mesh, displaced):
    scan = scanned(impeller_mesh, SIXTHS, [45.0], step_mm=1.0, station_mm=0.02, station_deg=0.002)
    covariance = KinematicPrior(0.02, np.radians(0.002), 0.02, np.radians(0.002)).covariance(scan.stations)
    clean = stitch(scan.clouds, scan.kinematic, prior=PosePrior(covariance=covariance))
    assert [placement.verdict for placement in clean.placements] == ["good"] * 6
    assert all(placement.sigma_mm < 0.05 for placement in clean.placements)
    slipped = RigidTransform.from_parts(np.eye(3), [1.2, 1.2, 1.05], "camera", "camera")  # 2 mm
    kinematic = [pose @ slipped if i == displaced else pose for i, pose in enumerate(scan.kinematic)]
    stitched = stitch(scan.clouds, kinematic, prior=PosePrior(covariance=covariance))
    assert [i for i, placement in enumerate(stitched.placements) if not placement.used] == [displaced]
    assert "times the limit: excluded" in stitched.placements[displaced].verdict
    accepted = stitch(scan.clouds, kinematic, prior=PosePrior(covariance=covariance), accepted=["v0" + str(displaced)])
    assert all(placement.used for placement in accepted.placements)
    assert accepted.placements[displaced].verdict.endswith("accepted by hand")


def test_a_covariance_of_other_poses_is_refused(scanned, cross_mesh):
    scan = scanned(cross_mesh, [10.0, 100.0], [40.0], step_mm=1.5)
    with pytest.raises(RegistrationError, match="covariance of"):
        stitch(scan.clouds, scan.kinematic, prior=PosePrior(covariance=np.eye(6)))
