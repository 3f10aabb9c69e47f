"""What every projector driver must do."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.devices.rig import Rig
from measureapp.errors import DeviceError


def sequence(rig: Rig, count: int = 2) -> np.ndarray:
    return np.full((count, rig.projector.height_px, rig.projector.width_px), 200, np.uint8)


def test_what_is_shown_reads_back(rig: Rig) -> None:
    rig.projector.load(sequence(rig))
    for index in (0, 1, -1):
        rig.projector.show(index, timeout_s=1.0)
        assert rig.projector.shown() == index


def test_images_of_another_size_are_refused(rig: Rig) -> None:
    with pytest.raises(DeviceError, match="does not support"):
        rig.projector.load(sequence(rig)[:, :-1])


def test_an_image_beyond_the_sequence_is_refused_and_nothing_changes(rig: Rig) -> None:
    rig.projector.load(sequence(rig))
    rig.projector.show(1, timeout_s=1.0)
    with pytest.raises(DeviceError, match="2 images"):
        rig.projector.show(2, timeout_s=1.0)
    assert rig.projector.shown() == 1


def test_a_stopped_projector_is_dark(rig: Rig) -> None:
    rig.place_on_table("part")
    rig.projector.load(sequence(rig))
    rig.projector.show(0, timeout_s=1.0)
    camera = rig.cameras[rig.description.reference]
    camera.set_exposure_us(100_000)
    lit = camera.grab(timeout_s=5.0).pixels.mean()
    rig.projector.stop()
    assert rig.projector.shown() < -1
    assert camera.grab(timeout_s=5.0).pixels.mean() < 0.3 * lit
