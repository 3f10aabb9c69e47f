"""What every rig driver must do."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.devices.rig import Rig
from measureapp.errors import DeviceError


def test_every_described_camera_is_connected(rig: Rig) -> None:
    assert set(rig.cameras) == {camera.name for camera in rig.description.cameras}
    for described in rig.description.cameras:
        camera = rig.cameras[described.name]
        assert (camera.serial, camera.width_px, camera.height_px, camera.bit_depth) == (
            described.serial,
            described.width_px,
            described.height_px,
            described.bit_depth,
        )


def test_the_readback_gathers_every_axis(rig: Rig) -> None:
    rig.guide.move_to(30.0, timeout_s=10.0)
    rig.table.move_to(0.5, timeout_s=10.0)
    readback = rig.readback()
    assert readback.guide_mm == rig.guide.position_mm()
    assert readback.table_rad == rig.table.angle_rad()
    assert (readback.base_from_flange.matrix == rig.robot.pose().matrix).all()


def test_the_table_takes_board_and_part_and_refuses_anything_else(rig: Rig) -> None:
    for thing in ("board", "part", "empty"):
        rig.place_on_table(thing)
    with pytest.raises(DeviceError, match="teapot"):
        rig.place_on_table("teapot")


def test_all_devices_can_be_stopped_at_rest(rig: Rig) -> None:
    for device in rig.devices:
        device.stop()
    rig.guide.move_to(1.0, timeout_s=10.0)
    assert rig.guide.position_mm() == pytest.approx(1.0, abs=0.01)


def test_the_conditions_name_every_camera_and_the_day(rig: Rig) -> None:
    conditions = rig.conditions("2031-05-01T08:00:00+00:00")
    assert conditions.taken_at == "2031-05-01T08:00:00+00:00"
    assert conditions.serials == {name: camera.serial for name, camera in rig.cameras.items()}
    reported = [value for camera in rig.cameras.values() if (value := camera.temperature_c()) is not None]
    assert (conditions.temperature_c is None) == (not reported)


def test_a_stopped_projector_leaves_the_scene_dark(rig: Rig) -> None:
    rig.place_on_table("part")
    rig.projector.load(np.full((1, rig.projector.height_px, rig.projector.width_px), 200, np.uint8))
    camera = rig.cameras[rig.description.reference]
    camera.set_exposure_us(100_000)
    camera.arm(2, "software")
    rig.projector.show(0, timeout_s=1.0)
    camera.trigger()
    camera.wait_ready(timeout_s=1.0)
    rig.projector.stop()
    camera.trigger()
    lit, dark = (camera.next_frame(timeout_s=5.0).pixels.mean() for _ in range(2))
    assert dark < 0.3 * lit
