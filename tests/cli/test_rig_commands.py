"""`rig teach`."""

from __future__ import annotations

import json

import pytest
from axis_peers import PATIENT_S

from measureapp.cli.main import main
from measureapp.data.rig import RigDescription
from measureapp.peers.modbus_axis import Drive, ToyoMemory
from measureapp.peers.modbus_device import ModbusDevice, on_serial
from measureapp.project.rig_file import read_rig


@pytest.fixture
def described(monkeypatch: pytest.MonkeyPatch):
    """Let the commands read a rig whose guide is a drive of our own and whose other devices are virtual."""

    def use(port: str, **settings: object) -> None:
        head = {"driver": "virtual_rig", "settings": {"link": "cell"}}
        guide = {"driver": "axis_modbus", "settings": {"drive": "toyo_xc100", "link": "bus", "absolute_encoder": True, **settings}}
        others = {"robot": {"driver": "robot_generic_tcp"}, "table": {"driver": "axis_modbus"}}
        devices = {**dict.fromkeys(("left", "right", "upper", "projector"), head), **others, "guide": guide}
        links = {"cell": {"part": "flat"}, "bus": {"port": port, "framing": "rtu", "reply_timeout_s": PATIENT_S}}
        document = read_rig("paper").at_resolution("quarter").model_dump() | {"driver": "", "devices": devices, "links": links}
        rig = RigDescription.model_validate(document)
        monkeypatch.setattr("measureapp.project.rig_file.read_rig", lambda name: rig)

    return use


@pytest.fixture
def only_the_guide(monkeypatch: pytest.MonkeyPatch) -> None:
    """Connect the guide with its driver and everything else as the virtual rig."""
    from dataclasses import replace

    from measureapp.devices.connect import connect_rig as genuine
    from measureapp.devices.links import Links
    from measureapp.devices.plugin_loader import load_driver
    from measureapp.devices.request import DeviceRequest
    from measureapp.devices.rig import Rig

    def connect_rig(description: RigDescription) -> Rig:
        links = Links(description.links)
        loaded = load_driver(None, "axis_modbus", "linear-guide")
        settings = loaded.settings.model_validate(description.devices["guide"].settings)
        guide = loaded.entry(DeviceRequest("guide", description, settings, links))
        plain = description.model_copy(update={"driver": "virtual_rig", "driver_settings": {"part": "flat"}, "devices": {}, "links": {}})
        return replace(genuine(plain), guide=guide, release=links.close)

    monkeypatch.setattr("measureapp.devices.connect.connect_rig", connect_rig)


def test_a_guide_with_a_wrong_scale_and_sense_is_taught_by_one_step(described, only_the_guide, capsys: pytest.CaptureFixture[str]) -> None:
    drive = Drive(speed=1e6, acceleration=1e9)
    with on_serial(ModbusDevice(ToyoMemory(drive)), "rtu") as port:
        described(port, counts_per_unit=50.0, sense=1)
        code = main(["rig", "teach", "mine", "guide", "--step", "2", "--observed", "-1.0", "--json"])
    assert drive.moves == [100]  # 2 mm at the wrong scale, which at the true 100 counts per mm are 1 mm, the wrong way
    assert code == 0
    taught = json.loads(capsys.readouterr().out)
    assert taught == {"counts_per_unit": 100.0, "sense": -1, "relative_uncertainty": pytest.approx(0.1)}


def test_a_rig_that_states_no_scale_is_refused_before_anything_moves(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["rig", "teach", "paper", "guide"]) == 2
    assert "state no counts_per_unit" in capsys.readouterr().err
