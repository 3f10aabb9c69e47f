"""A rig description is written as TOML and read back equal."""

from __future__ import annotations

from pathlib import Path

import pytest

from measureapp.data.rig import DriverChoice, HeadRules, KeepOutBox, MotionRules, ParkPose, RigDescription
from measureapp.errors import StorageError
from measureapp.project.rig_file import read_rig, write_rig


def composed() -> RigDescription:
    names = ("left", "right", "upper", "projector", "robot", "guide", "table")
    devices = {name: DriverChoice(driver="axis_modbus", settings={"drive": 'a "b" \\ ü', "speed": 0.5, "on": True}) for name in names}
    box = KeepOutBox(name="wall", low_mm=(0, 0, 0), high_mm=(1, 2, 3))
    motion = MotionRules(keep_out=(box,), settle_s=0.5, park=ParkPose(position_mm=(1, 2, 3), quaternion_wxyz=(1, 0, 0, 0)))
    changes = {"driver": "", "driver_settings": {}, "devices": devices, "links": {"bus": {"port": "COM3", "tries": [1, 2]}}}
    return read_rig("paper").model_copy(update={**changes, "motion": motion, "head": HeadRules(sequence="hardware")})


@pytest.mark.parametrize("rig", [read_rig("paper"), composed()], ids=["whole", "composed"])
def test_what_was_written_reads_back_equal(rig: RigDescription, tmp_path: Path) -> None:
    write_rig(tmp_path / "mine.toml", rig)
    assert read_rig(tmp_path / "mine.toml") == rig


def test_defaults_are_not_spelled_out(tmp_path: Path) -> None:
    write_rig(tmp_path / "mine.toml", read_rig("paper"))
    assert "keep_out" not in (tmp_path / "mine.toml").read_text(encoding="utf-8")


def test_a_folder_that_is_not_there_is_told(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("", encoding="utf-8")
    with pytest.raises(StorageError):
        write_rig(tmp_path / "file" / "mine.toml", read_rig("paper"))
