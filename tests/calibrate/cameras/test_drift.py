"""A camera that turned since the calibration is found from the contradictions of a scan, and named."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.calibrate.cameras.drift import DRIFTED_FACTOR, WATCH_FACTOR, camera_drift
from measureapp.data.camera_shift import ShiftEvidence, sum_evidence

NAMES = ("left", "right", "upper")
FOCAL_PX, SIGMA_PX, SAMPLES = 2000.0, 0.1, 2000
RMS_PX = 0.1


@pytest.fixture
def calibrated(head):
    return replace(head, cameras={name: replace(camera, rms_px=RMS_PX) for name, camera in head.cameras.items()})


def evidence(generator, turned=None, alike=1.0) -> ShiftEvidence:
    """One view: residuals of noise ``SIGMA_PX``, each camera's turn with a field of its own; ``alike`` 0 makes those of two the same."""
    fields = generator.normal(size=(SAMPLES, 9)) * FOCAL_PX
    fields[:, 3:6] = (1 - alike) * fields[:, :3] + alike * fields[:, 3:6]
    residuals = generator.normal(0.0, SIGMA_PX, SAMPLES)
    for name, turn in (turned or {}).items():
        first = 3 * NAMES.index(name)
        residuals += fields[:, first : first + 3] @ turn
    design, residuals = fields / SIGMA_PX, residuals / SIGMA_PX
    square = np.broadcast_to(np.eye(3), (3, 3, 3))
    return ShiftEvidence(
        NAMES,
        SAMPLES,
        design.T @ design,
        design.T @ residuals,
        float(residuals @ residuals),
        SAMPLES,
        square * FOCAL_PX**2,
        square * 550.0**2,
    )


def turn_of(size_px):
    return np.array([0.0, size_px / FOCAL_PX, 0.0])


def test_noise_alone_is_good_and_as_small_as_noise_lets_it_be(calibrated, generator):
    found = camera_drift([evidence(generator) for _ in range(4)], calibrated)
    assert found.status == "good" and found.cameras == ()
    assert found.shift_px < 5 * SIGMA_PX * np.sqrt(3 / (4 * SAMPLES))  # five standard deviations of three fitted angles
    assert "passed" in found.sentence


@pytest.mark.parametrize("name", NAMES)
def test_the_camera_that_turned_is_named_in_pixels_and_millimetres(calibrated, generator, name):
    size = 1.5 * DRIFTED_FACTOR * RMS_PX
    found = camera_drift([evidence(generator, {name: turn_of(size)}) for _ in range(3)], calibrated)
    assert (found.status, found.cameras) == ("drifted", (name,))
    assert found.shift_px == pytest.approx(size, rel=0.05)
    assert found.error_mm == pytest.approx(550.0 * size / FOCAL_PX, rel=0.05)
    assert f"Camera {name} has turned" in found.sentence and "calibrate the cameras again" in found.sentence


def test_a_small_turn_asks_for_a_check_only(calibrated, generator):
    found = camera_drift([evidence(generator, {"right": turn_of(0.5 * (WATCH_FACTOR + DRIFTED_FACTOR) * RMS_PX)})], calibrated)
    assert (found.status, found.cameras) == ("watch", ("right",))
    assert "board" in found.sentence


def test_cameras_that_the_images_cannot_distinguish_are_both_named(calibrated, generator):
    found = camera_drift([evidence(generator, {"left": turn_of(1.0)}, alike=0.0)], calibrated)
    assert set(found.cameras) == {"left", "right"}
    assert "One of the cameras" in found.sentence


def seen_from_upright_fringes(generator, turned=None):
    """As `evidence`, but a pitch moves the image along the fringes but for a twentieth."""
    whole = evidence(generator)
    along = np.diag([0.05, 1.0, 1.0])
    every = np.kron(np.eye(3), along)
    turns = np.concatenate([(turned or {}).get(name, np.zeros(3)) for name in NAMES])
    information = every @ whole.information @ every
    gradient = every @ whole.gradient + information @ turns
    misfit = whole.misfit + 2 * turns @ every @ whole.gradient + turns @ information @ turns
    return replace(whole, information=information, gradient=gradient, misfit=misfit, image_px2=along @ whole.image_px2 @ along)


@pytest.mark.parametrize("motion", [0, 1, 2])
def test_a_turn_is_seen_from_the_size_on_that_is_said(calibrated, generator, motion):
    clean = camera_drift([seen_from_upright_fringes(generator)], calibrated)
    least = list(clean.undetectable_deg["left"].values())[motion]
    for share, standings in ((1.2, ("watch", "drifted")), (0.5, ("good",))):
        turn = np.zeros(3)
        turn[motion] = np.deg2rad(share * least)
        found = camera_drift([seen_from_upright_fringes(generator, {"left": turn})], calibrated)
        assert found.status in standings, (share, least, found.sentence)


def test_the_insensitivity_along_the_fringes_is_reported(calibrated, generator):
    blind, seeing = (camera_drift([one], calibrated) for one in (seen_from_upright_fringes(generator), evidence(generator)))
    for name in NAMES:
        assert blind.undetectable_deg[name]["pitch"] == pytest.approx(20 * seeing.undetectable_deg[name]["pitch"], rel=0.1)
        assert f"a pitch of {name} below" in blind.undetectable
    assert "would not show" in blind.undetectable and "fringes of both directions" in blind.undetectable


def test_without_evidence_nothing_is_claimed(calibrated):
    found = camera_drift([], calibrated)
    assert (found.status, found.cameras) == ("unknown", ())
    assert "cannot show" in found.sentence


def test_the_evidence_of_views_adds_up(generator):
    views = [evidence(generator, {"upper": turn_of(0.4)}) for _ in range(2)]
    whole = sum_evidence(views)
    np.testing.assert_allclose(whole.information, views[0].information + views[1].information)
    assert (whole.samples, whole.freedom) == (2 * SAMPLES, 2 * SAMPLES)
    np.testing.assert_allclose(whole.image_px2, views[0].image_px2)
