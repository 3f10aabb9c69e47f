"""The predicted uncertainty of stitched points agrees with what repeated simulations show."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.calibrate.rig.stitch_uncertainty import point_sigma_mm, uncertainty_of, view_uncertainty
from measureapp.data.fringe import AxisReadback
from measureapp.data.plan import FlangePose, Viewpoint
from tests.calibrate.paper_rig import calibrated, planned

SEEDS = range(101, 106)
POINTS_MM = np.array([[0.0, 0, 20], [60, 0, 80], [-60, 0, 40], [0, 60, 80], [0, -60, 10]])


def moved_off(viewpoint: Viewpoint) -> Viewpoint:
    """Return a place beside a station, which the calibration never saw."""
    x, y, z = viewpoint.flange.position_mm
    flange = FlangePose(position_mm=(x - 40.0, y + 50.0, z + 30.0), quaternion_wxyz=viewpoint.flange.quaternion_wxyz)
    return Viewpoint(id="beside", flange=flange, guide_mm=viewpoint.guide_mm + 20, table_deg=77.0)


def views() -> tuple[Viewpoint, ...]:
    """Three views at a station, the table turned, and one beside it."""
    station = next(viewpoint for viewpoint in planned() if viewpoint.id.startswith("station"))
    turned = [Viewpoint(id=f"v{angle}", flange=station.flange, guide_mm=station.guide_mm, table_deg=float(angle)) for angle in (0, 90, 180)]
    return (*turned, moved_off(station))


def readback_of(viewpoint: Viewpoint) -> AxisReadback:
    return AxisReadback(viewpoint.flange.transform(), viewpoint.guide_mm, float(np.deg2rad(viewpoint.table_deg)))


def placed_truly(run, viewpoints):
    """Return where the camera truly stands on the part at every view, as part_from_camera matrices."""
    board = run.cell.truth.table_from_board.matrix
    return [board @ np.linalg.inv(seen.matrix) for _, _, seen in run.cell.placed(viewpoints)]


@pytest.fixture(scope="module")
def runs():
    return [calibrated(seed, camera_errors=False) for seed in SEEDS]


def squares(run):
    """Return squared errors over predicted variance: of points in each view, and of the gaps between pairs of views."""
    chosen = views()
    uncertainty = view_uncertainty(uncertainty_of(run.solution), [readback_of(one) for one in chosen])
    errors = []
    for truth, found in zip(placed_truly(run, chosen), uncertainty.part_from_camera, strict=True):
        in_camera = np.linalg.inv(truth) @ np.column_stack([POINTS_MM, np.ones(len(POINTS_MM))]).T
        errors.append(found.apply(in_camera[:3].T) - POINTS_MM)
    single = [share(error, uncertainty.point_covariance(index, POINTS_MM)) for index, error in enumerate(errors)]
    pairs = [share(errors[a] - errors[b], uncertainty.between(a, b, POINTS_MM)) for a, b in ((0, 1), (0, 2), (0, 3))]
    return single, pairs


def share(errors, covariances) -> float:
    """Return the mean squared length of errors (N, 3) over what covariances (N, 3, 3) predict."""
    return float(np.sum(errors**2) / np.sum(np.trace(covariances, axis1=1, axis2=2)))


def test_errors_of_points_and_gaps_between_views_are_as_large_as_predicted(runs):
    single, pairs = (np.mean(values, axis=0) for values in zip(*(squares(run) for run in runs), strict=True))
    # five runs, whose points share most of their error: mean 1 within a factor of about two
    assert np.all((single > 0.4) & (single < 2.2)), single
    assert np.all((pairs > 0.4) & (pairs < 2.2)), pairs


def test_views_at_one_station_are_known_better_against_each_other_than_beside_it(runs):
    uncertainty = view_uncertainty(uncertainty_of(runs[0].solution), [readback_of(one) for one in views()])
    turned, beside = (np.sqrt(np.trace(uncertainty.between(0, other, POINTS_MM)[0])) for other in (1, 3))
    assert turned < 0.5 * beside


def test_the_prior_of_a_view_predicts_its_points(runs):
    rig, read = uncertainty_of(runs[0].solution), readback_of(views()[3])
    uncertainty = view_uncertainty(rig, [read])
    prior, place = uncertainty.view(0), uncertainty.part_from_camera[0].translation_mm
    drawn = np.random.default_rng(0).multivariate_normal(np.zeros(6), prior, 20000)
    shifts = np.cross(drawn[:, :3], POINTS_MM[1] - place) + drawn[:, 3:]
    largest = np.sqrt(np.linalg.eigvalsh(np.cov(shifts.T))[-1])
    assert point_sigma_mm(rig, read, POINTS_MM)[1] == pytest.approx(largest, rel=0.03)


def test_the_relative_covariance_places_the_parts_origin(runs):
    uncertainty = view_uncertainty(uncertainty_of(runs[0].solution), [readback_of(one) for one in views()])
    origin = np.zeros((1, 3))
    np.testing.assert_allclose(uncertainty.relative(0, 2)[3:, 3:], uncertainty.between(0, 2, origin)[0], rtol=1e-6, atol=1e-12)


def test_views_of_one_approach_share_its_scatter_and_views_of_several_do_not(runs):
    rig = uncertainty_of(runs[0].solution)
    rig = replace(rig, chain=replace(rig.chain, noise=replace(rig.chain.noise, robot_repeat_rad=0.0)))
    turned = [readback_of(view) for view in views()[:2]]  # by 90°
    once, told, twice = (view_uncertainty(rig, turned, approaches) for approaches in (None, ["a", "a"], ["a", "b"]))
    np.testing.assert_array_equal(once.covariance, told.covariance)
    np.testing.assert_allclose(once.view(0), twice.view(0), rtol=1e-9)
    more = np.trace(twice.between(0, 1, POINTS_MM)[0] - once.between(0, 1, POINTS_MM)[0])
    # of the variance of one coordinate: 2 · 3 for shifts of their own, 2 · (1 - cos 90°) · 2 for one that turns with the table
    assert more == pytest.approx((6 - 4) * rig.chain.noise.robot_repeat_mm**2, rel=1e-6)
