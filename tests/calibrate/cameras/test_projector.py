"""The projector is recovered as an inverse camera from the phases around the corners of a board."""

from __future__ import annotations

from dataclasses import replace
from math import tau

import numpy as np
import pytest

from measureapp.calibrate.cameras.array import CameraArrayProblem, solve
from measureapp.calibrate.cameras.projector import solve_head
from measureapp.calibrate.cameras.projector_sightings import ProjectorPixels, interpolate_at, projector_sighting
from measureapp.calibrate.sightings import Rejection, Sighting
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.errors import CalibrationError
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform, rotation_about
from tests.calibrate import paper_head

PROJECTOR = PinholeCamera(1024, 768, np.array([[1609.0, 0, 515], [0, 1607.0, 380], [0, 0, 1]]), [-0.05, 0.03, 4e-4, -3e-4, 0.0])
CAMERA_FROM_PROJECTOR = RigidTransform.from_parts(rotation_about([0, 1, 0], -0.30), [165.0, 20.0, 60.0], "camera", "projector")
PITCH_PX, SIGMA_RAD, CORNER_SIGMA_PX = 32.0, 0.01, 0.05
SIZE = (648, 486)


def small_head():
    """The paper's left and right cameras at a quarter of their resolution (fewer rays to follow)."""
    head = paper_head.drawn_head(np.random.default_rng(2))
    cameras = {}
    for name in ("left", "right"):
        lens = head.cameras[name].pinhole
        matrix = np.array(lens.matrix) / 4
        matrix[:2, 2] -= 0.375
        matrix[2, 2] = 1
        cameras[name] = replace(head.cameras[name], pinhole=PinholeCamera(*SIZE, matrix, lens.distortion))
    return replace(head, cameras=cameras)


def phase_map(values_px, sigma_px, valid, across=None) -> PhaseMap:
    scale = np.float32(tau / PITCH_PX)
    state = np.where(valid, PixelState.VALID, PixelState.SHADOW).astype(np.uint8)
    phase, sigma = (np.where(valid, one * scale, 0).astype(np.float32) for one in (values_px, sigma_px))
    level = np.full(phase.shape, 80, np.uint8)
    return PhaseMap("left", "v", phase, sigma, level, level, state, np.zeros(phase.shape, np.int8), PITCH_PX, 1024, orthogonal=across)


def phases_of(camera_rays, pose, board, generator) -> PhaseMap:
    """What the left camera decodes of both fringe directions on the board; dark squares are five times noisier."""
    normal, origin = pose.rotation[:, 2], pose.translation_mm
    points = camera_rays * ((origin @ normal) / (camera_rays @ normal))[..., None]
    on_board = ((points - origin) @ pose.rotation)[..., :2] / board.square_mm
    inside = np.all((on_board > -1) & (on_board < [board.columns, board.rows]), axis=-1)
    pixels = np.zeros((*inside.shape, 2))
    pixels[inside] = PROJECTOR.project(CAMERA_FROM_PROJECTOR.inverse().apply(points[inside]))
    lit = inside & np.all((pixels > 0) & (pixels < [1023, 767]), axis=-1)
    dark = np.floor(on_board).astype(int).sum(axis=-1) % 2 == 0
    sigma = np.where(dark, 5.0, 1.0) * SIGMA_RAD * PITCH_PX / tau
    noisy = pixels + generator.normal(size=pixels.shape) * sigma[..., None]
    return phase_map(noisy[..., 0], sigma, lit, phase_map(noisy[..., 1], sigma, lit))


@pytest.fixture(scope="module")
def captured():
    """Sightings of both cameras and the phases of the left one over 12 views."""
    generator = np.random.default_rng(8)
    head, board = small_head(), paper_head.BOARD
    lens = head.cameras["left"].pinhole
    rays = lens.rays(np.stack(np.meshgrid(np.arange(SIZE[0]), np.arange(SIZE[1])), -1).reshape(-1, 2).astype(float))
    rays = rays.reshape(SIZE[1], SIZE[0], 3)
    sightings, phases = [], {}
    for view in range(12):
        pose = paper_head.board_pose(generator)
        points = pose.apply(board.corners_mm)
        for name, camera in head.cameras.items():
            pixels = camera.pinhole.project(camera.reference_from_camera.inverse().apply(points))
            pixels = pixels + generator.normal(scale=CORNER_SIGMA_PX, size=pixels.shape)
            ids = np.flatnonzero(np.all((pixels > 8) & (pixels < np.array(SIZE) - 8), axis=1))
            sightings.append(Sighting(name, f"{view:02d}", pixels[ids], ids))
        phases["left", f"{view:02d}"] = phases_of(rays, pose, board, generator)
    return CameraArrayProblem(board, "left", dict.fromkeys(head.cameras, SIZE), tuple(sightings)), phases


@pytest.fixture(scope="module")
def found(captured):
    """The whole head, solved from all of them."""
    problem, phases = captured
    return solve_head(problem, readings(problem, phases), (1024, 768))


def readings(problem, phases):
    return [reading(one, phases[one.camera, one.view]) for one in problem.sightings if (one.camera, one.view) in phases]


def reading(sighting, phase):
    return projector_sighting(sighting, ProjectorPixels.around(sighting, phase))


def test_the_projector_is_recovered_within_its_standard_deviations(found):
    projector = found.calibration.projector
    sigma = projector.standard_deviations
    matrix = projector.pinhole.matrix - PROJECTOR.matrix
    errors = {"fx": matrix[0, 0], "fy": matrix[1, 1], "cx": matrix[0, 2], "cy": matrix[1, 2]}
    errors |= dict(zip(("k1", "k2", "p1", "p2", "k3"), projector.pinhole.distortion - PROJECTOR.distortion, strict=True))
    shift = projector.reference_from_projector.translation_mm - CAMERA_FROM_PROJECTOR.translation_mm
    errors |= dict(zip(("x_mm", "y_mm", "z_mm"), shift, strict=True))
    in_sigma = {name: error / sigma[name] for name, error in errors.items()}
    assert max(map(abs, in_sigma.values())) < 4, in_sigma
    assert 0.3 < np.sqrt(np.mean(np.square(list(in_sigma.values())))) < 2.0
    assert sigma["fx"] < 2.0
    assert np.linalg.norm(shift) < 0.5
    assert set(found.calibration.cameras) == {"left", "right"}
    assert set(found.calibration.pair_rms_px) == {"left-right"}
    assert found.solution.sigmas_px["left"] == pytest.approx(CORNER_SIGMA_PX, rel=0.1)
    assert found.solution.sigmas_px["projector"] < 0.1  # that of the corners is 0.08 of the projector's larger pixels; phases add little


def test_the_projector_does_not_spoil_the_cameras(captured, found):
    alone, together = solve(captured[0]), found.solution
    for name in ("left", "right"):
        for key in ("fx", "cx", "k1"):
            less = together.calibration.cameras[name].standard_deviations[key]
            assert less <= 1.05 * alone.calibration.cameras[name].standard_deviations[key]


def test_a_map_is_read_between_its_pixels():
    y, x = np.mgrid[0:60, 0:80].astype(float)
    values = 3 + 0.5 * x - 0.2 * y + 0.003 * x * x + 0.002 * x * y
    places = np.array([[20.3, 30.7], [55.1, 12.4], [0.2, 30.0]])
    sigma = np.full(values.shape, 0.1)
    read, deviations = interpolate_at(values, sigma, np.ones(values.shape, bool), places, np.array([8.0, 8.0, 8.0]))
    px, py = places[:2].T
    np.testing.assert_allclose(read[:2], 3 + 0.5 * px - 0.2 * py + 0.003 * px**2 + 0.002 * px * py, atol=1e-9)
    assert np.isnan(read[2])  # at the border there are pixels on one side only
    assert np.all((deviations[:2] > 0.01) & (deviations[:2] < 0.03))  # 0.1 over 200 pixels, times what a quadratic costs


def test_the_deviation_of_a_reading_is_its_scatter():
    generator = np.random.default_rng(0)
    read = []
    for _ in range(200):
        values = 0.4 * np.mgrid[0:30, 0:30][1] + generator.normal(scale=0.2, size=(30, 30))
        read.append(interpolate_at(values, np.full((30, 30), 0.2), np.ones((30, 30), bool), np.array([[14.6, 15.2]]), np.array([7.0])))
    values, deviations = np.array(read)[:, :, 0].T
    assert np.std(values) == pytest.approx(np.mean(deviations), rel=0.2)


def test_fringes_that_start_dark_place_the_projector_at_the_same_pixels(captured):
    problem, phases = captured

    def dark(phase: PhaseMap) -> PhaseMap:
        shifted = np.where(phase.valid, phase.phase_rad - np.float32(np.pi), 0).astype(np.float32)
        return replace(phase, phase_rad=shifted, details={"origin_rad": -np.pi})

    phase = phases["left", "00"]
    bright = reading(problem.sightings[0], phase)
    shifted = reading(problem.sightings[0], replace(dark(phase), orthogonal=dark(phase.orthogonal)))
    assert np.abs(shifted.corners_px - bright.corners_px).max() < 1e-3


def test_fringes_in_one_direction_do_not_place_the_projector(captured):
    problem, phases = captured
    one_way = {key: replace(phase, orthogonal=None) for key, phase in phases.items()}
    found = reading(problem.sightings[0], one_way["left", "00"])
    assert isinstance(found, Rejection)
    assert "one direction only" in found.reason
    with pytest.raises(CalibrationError, match="Projector has 0 views"):
        solve_head(problem, readings(problem, one_way), (1024, 768))
