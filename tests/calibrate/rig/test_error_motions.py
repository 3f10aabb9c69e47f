"""Error motions of the table are recovered by the rig calibration, as well as it says; axes without them are told to have none."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.calibrate.motions.axis_motion import rigid_motion
from measureapp.calibrate.motions.error_motions import MotionModel, refine_scales
from measureapp.calibrate.rig.stitch_uncertainty import uncertainty_of, view_uncertainty
from measureapp.data.axis_motions import ARCSEC
from measureapp.data.fringe import AxisReadback
from measureapp.geometry.transform import RigidTransform
from measureapp.simulate.options import AxisEffects
from measureapp.simulate.worlds import read_world
from tests.calibrate.paper_rig import BOARD, NOISE, STRAIGHT, calibrated, planned

POINTS_MM = np.array([[0.0, 0, 20], [60, 0, 80], [-60, 0, 40], [0, 60, 80], [0, -60, 10]])
GOOD_TABLE = AxisEffects(table_radial_mm=0.005, table_axial_mm=0.003, table_tilt_arcsec=3)
SEEN_DEG = (-50.0, -40.0, -25.0, -10.0, 0.0, 20.0, 40.0, 50.0)  # to which the calibration turns the board
USUAL = read_world("usual").motions
CORNER_PX = 0.05
STOP_MM = 0.012
WITHOUT = replace(NOISE, table_radial_mm=0.0, table_axial_mm=0.0, table_tilt_rad=0.0, slide_mm=0.0, slide_rad=0.0)


def gaps(run, angles_deg=SEEN_DEG, stop_mm=0.0):
    """Return errors (G, 3) of the gaps between views at one station, the table turned, and their predicted covariances (G, 3, 3)."""
    scatter = np.random.default_rng(11)
    station = next(viewpoint for viewpoint in planned() if viewpoint.id.startswith("station"))
    views = tuple(station.model_copy(update={"id": f"v{angle}", "table_deg": angle}) for angle in angles_deg)
    reads = [AxisReadback(view.flange.transform(), view.guide_mm, float(np.deg2rad(view.table_deg))) for view in views]
    found = view_uncertainty(uncertainty_of(run.solution), reads)
    board, errors = run.cell.truth.table_from_board.matrix, []
    for (_, _, seen), placed in zip(run.cell.placed(views), found.part_from_camera, strict=True):
        in_camera = seen.matrix @ np.linalg.inv(board) @ np.column_stack([POINTS_MM, np.ones(len(POINTS_MM))]).T
        errors.append(placed.apply(in_camera[:3].T + scatter.normal(scale=stop_mm, size=3)) - POINTS_MM)
    pairs = list(zip(range(len(views) - 1), range(1, len(views)), strict=True))
    return np.concatenate([errors[a] - errors[b] for a, b in pairs]), np.concatenate([found.between(a, b, POINTS_MM) for a, b in pairs])


def course_mm(run, angles_deg=SEEN_DEG) -> float:
    """Return the rms error of the course of points on the turning board, by its shape alone: where the course lies is left to a rigid motion."""
    truth, found, state = run.cell.truth, run.solution.calibration, run.solution.state
    table, places = truth.calibration.table_from_guide.inverse(), {True: [], False: []}
    for angle in np.deg2rad(angles_deg):
        turned = RigidTransform.from_vector([0, 0, angle + truth.table.indexing_rad(angle)], np.zeros(3), "table", "table")
        group = run.solution.chain.table_group[np.argmin(np.abs(run.solution.chain.table_rad - angle))]
        moved = found.axis.turned(angle + state.table_changes[group])
        if found.motions is not None:
            moved = found.motions.table_motion(angle) @ moved
        places[True].append((table @ run.cell.table.at(angle) @ turned @ truth.table_from_board).apply(BOARD.corners_mm))
        places[False].append((moved @ run.solution.guide_from_board).apply(BOARD.corners_mm))
    true, seen = np.concatenate(places[True]), np.concatenate(places[False])
    fit = rigid_motion(seen, true)
    return rms(seen @ fit[:3, :3].T + fit[:3, 3] - true)


def misfit(errors, covariances) -> float:
    """Return the mean of squares over their prediction; 1 where it is right."""
    return float(np.mean(np.einsum("ni,ni->n", errors, np.linalg.solve(covariances, errors[..., None])[..., 0])) / 3)


def rms(errors) -> float:
    return float(np.sqrt(np.mean(np.sum(errors**2, axis=1))))


@pytest.fixture(scope="module")
def run():
    return quick_run(USUAL)


def quick_run(effects, noise=NOISE, **options):
    return calibrated(401, corner_sigma_px=CORNER_PX, camera_errors=False, effects=effects, noise=noise, **options)


def test_gaps_between_views_are_as_large_as_the_covariance_says(run) -> None:
    # 35 points of 7 gaps that share an approach, a station's error and some 40 coefficients: 1 within a factor of three
    assert 0.3 < misfit(*gaps(run)) < 3.0
    assert not run.solution.rejected


def test_the_course_of_the_table_is_recovered_although_nothing_but_the_board_shows_it(run) -> None:
    without = quick_run(USUAL, WITHOUT, stations=False)
    assert course_mm(run) < 0.6 * course_mm(without)
    assert course_mm(run) < 0.0025  # the table's own scatter, 3″ at 100 mm, and what 0.05 px leave


def test_the_motions_found_are_stated_with_their_amplitudes(run) -> None:
    motions = run.solution.calibration.motions
    found = motions.amplitudes
    assert 0.002 < found["radial"] < 0.03  # drawn with 7, 5 µm and 10″, a third of the turn seen
    assert 0.001 < found["axial"] < 0.02
    assert 1 * ARCSEC < found["tilt"] < 40 * ARCSEC
    assert motions.explained_mm > 0.005
    assert "radial ± " in motions.sentences[0]
    assert "µm rms" in motions.sentences[-1]


def test_axes_without_error_motions_are_found_to_have_almost_none(run) -> None:
    perfect, found = quick_run(STRAIGHT, stations=False).solution.calibration.motions, run.solution.calibration.motions
    for kind in ("radial", "axial", "tilt", "angles"):
        assert perfect.amplitudes[kind] < 0.4 * found.amplitudes[kind], kind
    assert np.all(perfect.table_sigma[2:] < 0.6 * found.table_sigma[2:])  # so that U is small where the axes are good


def test_the_scale_of_a_motion_follows_the_data_and_stays_where_they_tell_nothing(generator) -> None:
    sigma = np.array([1e-5, 1e-5, 0.002, 0.002, 0.002] + [0.0] * 6)
    model = MotionModel(np.zeros(3), np.eye(3), np.array([0.0, 1.0]), sigma)
    true = generator.normal(size=model.size) * model.prior_sigma * np.where(model.components < 2, 1.0, 4.0)
    seen = np.where(model.components < 2, 0.0, (0.05 * model.prior_sigma) ** -2.0)  # tilts are not seen at all
    spread = np.log(2.0)
    found = refine_scales(model, np.diag(seen), seen * true, spread)[0].sigma
    assert found[0] == pytest.approx(sigma[0] * np.exp(spread**2), rel=0.01)  # rms of a log-normal scale
    # of 24 and 12 coefficients: their sample standard deviation, drawn to what was stated
    assert 2.4 < found[2] / sigma[2] < 6.0
    assert 2.0 < found[4] / sigma[4] < 6.5


@pytest.mark.parametrize(("seen_well", "contradicting", "far", "deviations"), [(3, 4, 100.0, 6.0), (6, 2, 30.0, 5.0)])
def test_a_contradiction_that_the_poses_hardly_show_does_not_blow_up_a_scale(seen_well, contradicting, far, deviations) -> None:
    """As from a robot that grew warm: some coefficients, seen ``far`` times worse than they are stated to be large, are off by several standard deviations."""
    stated = np.array([0.0, 0.0, 0.002, 0.002] + [0.0] * 7)
    model = MotionModel(np.zeros(3), np.eye(3), np.array([0.0, 1.0]), stated)
    sigma, well, off = model.prior_sigma, slice(seen_well), slice(seen_well, seen_well + contradicting)
    precision, true = np.zeros(model.size), np.zeros(model.size)
    precision[well], true[well] = (0.3 * sigma[well]) ** -2.0, 3.0 * sigma[well]
    precision[off], true[off] = (far * sigma[off]) ** -2.0, deviations * far * sigma[off]
    found = refine_scales(model, np.diag(precision), precision * true, np.log(3.0))[0].sigma
    assert 2.0 < found[2] / stated[2] < 6.0  # 3 times what is stated, by what is seen


@pytest.mark.slow
@pytest.mark.parametrize("effects", ["issue", "good", "usual", "bad"])
def test_gaps_between_views_all_around_lie_within_u(effects, record_property) -> None:
    """Ten rigs each: of the gaps between views, also of angles that the calibration never saw, 90 % or more are within k = 2.

    The bad table turns by 30 µm and 30″, two thirds of it unseen: its positions before registration are known less well than they are said to be.
    """
    drawn = GOOD_TABLE if effects == "issue" else read_world(effects).motions
    angles, inside, sizes = tuple(range(0, 360, 45)), [], []
    for seed in range(501, 511):
        run = calibrated(seed, corner_sigma_px=CORNER_PX, camera_errors=False, effects=drawn)
        errors, covariances = gaps(run, angles)
        inside.append(np.abs(errors) <= 2 * np.sqrt(np.diagonal(covariances, axis1=1, axis2=2)))
        sizes.append(misfit(errors, covariances))
        assert not run.solution.rejected
    record_property("inside", float(np.mean(inside)))
    record_property("misfit", float(np.mean(sizes)))
    assert (0.82 if effects == "bad" else 0.90) <= np.mean(inside) <= 0.999


def test_motions_far_beyond_what_is_stated_are_named_with_their_size_and_likely_causes(run) -> None:
    assert not any("error motion" in words for words in run.solution.warnings)
    sloppy = quick_run(USUAL.model_copy(update={"table_radial_mm": 0.15}), stations=False)
    warned = [words for words in sloppy.solution.warnings if words.startswith("The table's radial error motion is")]
    found_mm = sloppy.solution.calibration.motions.amplitudes["radial"]
    assert len(warned) == 1 and f"± {found_mm:.3f} mm, {found_mm / NOISE.table_radial_mm:.0f} times" in warned[0]
    assert found_mm == pytest.approx(0.15, rel=0.5)  # which the virtual table spreads over its orders at random


def test_scatter_from_stop_to_stop_is_found_and_not_taken_for_error_motions(run) -> None:
    """Settling, for example: without an allowance for it, motions that swing between the views explain it, many times as large as the true ones."""
    scattered = quick_run(USUAL, stop_mm=STOP_MM)
    found = scattered.solution.chain.noise.stop_mm
    # 46 sightings share an approach with others, and leave about 100 of their 138 coordinates to the scatter: 7 %, three times that
    assert found == pytest.approx(STOP_MM, rel=0.25)
    assert 0.3 < misfit(*gaps(scattered, stop_mm=STOP_MM)) < 3.0
    here, there = (one.solution.calibration.motions.amplitudes for one in (run, scattered))
    assert there["radial"] < 2 * max(here["radial"], USUAL.table_radial_mm)


def test_stops_without_scatter_are_found_to_have_almost_none(run) -> None:
    assert run.solution.chain.noise.stop_mm < 0.0015  # less than the 0.05 px of a corner, 3 µm
