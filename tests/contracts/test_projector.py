"""What every projector driver must do."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.devices.projector import DARK, PLAIN_LIGHT, Projector, TriggeringProjector
from measureapp.errors import DeviceError, LimitError


def sequence(projector: Projector, count: int = 2) -> np.ndarray:
    return np.full((count, projector.height_px, projector.width_px), 200, np.uint8)


def test_what_is_shown_reads_back(projector: Projector) -> None:
    projector.load(sequence(projector))
    for index in (0, 1, PLAIN_LIGHT, DARK):
        projector.show(index, timeout_s=1.0)
        assert projector.shown() == index


def test_images_of_another_size_are_refused(projector: Projector) -> None:
    with pytest.raises(DeviceError, match="does not support"):
        projector.load(sequence(projector)[:, :-1])


def test_an_image_beyond_the_sequence_is_refused_and_nothing_changes(projector: Projector) -> None:
    projector.load(sequence(projector))
    projector.show(1, timeout_s=1.0)
    with pytest.raises(DeviceError, match="2 images"):
        projector.show(2, timeout_s=1.0)
    assert projector.shown() == 1


def test_a_stopped_projector_is_dark(projector: Projector) -> None:
    projector.load(sequence(projector))
    projector.show(0, timeout_s=1.0)
    projector.stop()
    assert projector.shown() == DARK


def test_a_projector_tells_its_state(projector: Projector) -> None:
    assert projector.status().ready
    assert projector.status().text


def test_one_that_triggers_counts_its_pulses_and_refuses_an_impossible_period(projector: Projector) -> None:
    if not isinstance(projector, TriggeringProjector):
        pytest.skip("it does not trigger cameras")
    projector.load(sequence(projector, 3))
    projector.play(0, 3, exposure_us=20_000, period_us=100_000)
    assert projector.triggers_sent() <= 3
    with pytest.raises(LimitError):
        projector.play(0, 3, exposure_us=20_000, period_us=10_000)
