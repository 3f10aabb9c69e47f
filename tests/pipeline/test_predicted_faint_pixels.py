"""Which faint pixels are predicted to be decodable, against fringe images of the same brightness that are really decoded."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.data.fringe import FringeStack, PatternSet, PhaseShiftGroup
from measureapp.fringe.decode import decode
from measureapp.fringe.noise.model import CameraNoise
from measureapp.fringe.settings import DecodeSettings
from measureapp.pipeline.prediction.light import CameraExposures
from tests.fringe.conftest import images_of

EXPOSURES_US = (40_000, 20_000)
THREE, TWO = (16.0, 17.84, 18.14), (32.0, 33.0)


@pytest.mark.parametrize(
    ("pitches", "mean", "modulation", "found"),
    [
        (THREE, 20.0, 5.0, True),  # below the least modulation of 10, but its neighbours settle the orders
        (THREE, 20.0, 1.2, False),  # below the faintest
        (TWO, 20.0, 9.0, True),
        (TWO, 20.0, 4.0, False),  # half a period is worth too little for a vote
        (THREE, 120.0, 60.0, True),
    ],
)
def test_faint_pixels_are_predicted_as_they_are_decoded(pitches: tuple[float, ...], mean: float, modulation: float, found: bool) -> None:
    patterns = PatternSet(name="faint", projector_px=1024, groups=tuple(PhaseShiftGroup(pitch_px=pitch) for pitch in pitches))
    settings = DecodeSettings(edge_step_rad=1e6, noise_from_images=False)
    camera = CameraExposures(patterns, EXPOSURES_US, EXPOSURES_US[0], CameraNoise(), 255.0)
    level, swing = np.array([mean / 255]), np.array([modulation / 255])
    noise = camera.phase_noise(level, swing)
    too_weak = noise.of_all[0] * 255 < settings.faint_modulation_grey(255) or noise.sigma_rad[0] > camera.largest_sigma_rad(settings)
    assert too_weak != found

    shape = (100, 240)
    columns = np.broadcast_to(np.linspace(300.0, 540.0, shape[1]), shape)
    images = images_of(columns, patterns, EXPOSURES_US, np.full(shape, mean), np.full(shape, modulation), 5)
    decoded = decode(FringeStack("v", patterns, EXPOSURES_US, {"left": images}, 255), settings)["left"]
    right = decoded.valid & (np.abs(decoded.column_px - columns) < patterns.finest_pitch_px / 2)
    assert (right.mean() > 0.95) == found
    if found:
        assert float(np.median(decoded.sigma_rad[decoded.valid])) == pytest.approx(noise.sigma_rad[0], rel=0.15)
