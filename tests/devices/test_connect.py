"""A rig is connected through one plugin, or device by device as its description says."""

from __future__ import annotations

from pathlib import Path

import pytest

from measureapp.data.rig import RigDescription
from measureapp.devices.connect import connect_rig
from measureapp.devices.rig import Rig
from measureapp.errors import DeviceError, InputError, PluginError
from measureapp.project.rig_file import read_rig

MANIFEST = 'id = "{id}"\nname = "A device"\nversion = "1"\napi = 2\n\n'
TABLE = '[drives.{kind}]\nentry = "driver:connect"\nsettings = "settings:Settings"\n\n'
SETTINGS = "from measureapp.data.model import Model\nclass Settings(Model):\n    port: int = 3\n    link: str = ''\n"
KINDS = ("camera", "projector", "robot", "linear-guide", "rotary-table")
DEVICE = """
class Device:
    closed = 0
    def __init__(self, request):
        self.name, self.settings, self.link = request.name, request.settings, None
        if request.settings.link:
            self.link = request.links.open(request.settings.link, list, lambda table: [table["port"]], lambda link: link.append("closed"))
    def close(self):
        Device.closed += 1

def connect(request):
    return Device(request)
"""

WHOLE = """
from measureapp.devices.rig import Rig

def connect(request):
    return Rig(request.rig, {}, request, None, None, None, lambda thing: None)
"""


def make_plugin(folder: Path, name: str, driver: str, kinds: tuple[str, ...] = KINDS) -> None:
    (folder / name).mkdir(parents=True)
    manifest = MANIFEST.format(id=name) + "".join(TABLE.format(kind=kind) for kind in kinds)
    (folder / name / "plugin.toml").write_text(manifest, encoding="utf-8")
    (folder / name / "driver.py").write_text(driver, encoding="utf-8")
    (folder / name / "settings.py").write_text(SETTINGS, encoding="utf-8")


def whole(name: str, **settings: object) -> RigDescription:
    return read_rig("paper").model_copy(update={"driver": name, "driver_settings": settings})


def composed(devices: dict[str, object], links: dict[str, object] | None = None) -> RigDescription:
    named = {name: {"driver": "thing"} for name in ("left", "right", "upper", "projector", "robot", "guide", "table")} | devices
    described = read_rig("paper").model_dump() | {"driver": "", "driver_settings": {}, "devices": named, "links": links or {}}
    return RigDescription.model_validate(described)


def test_a_driver_of_a_whole_rig_gets_the_description_and_its_checked_settings(tmp_path: Path) -> None:
    make_plugin(tmp_path, "cell", WHOLE, ("rig",))
    rig = connect_rig(whole("cell", port=7), tmp_path)
    request = rig.projector
    assert request.rig.name == read_rig("paper").name  # type: ignore[attr-defined]
    assert request.settings.port == 7  # type: ignore[attr-defined]
    rig.release()


def test_a_wrong_setting_is_refused_by_name_before_the_driver_is_called(tmp_path: Path) -> None:
    make_plugin(tmp_path, "cell", "def connect(request): raise AssertionError", ("rig",))
    with pytest.raises(InputError, match=r"driver_settings: colour: is not a known field \(driver cell\)"):
        connect_rig(whole("cell", colour="red"), tmp_path)


def test_a_driver_that_fails_without_words_becomes_a_device_failure(tmp_path: Path) -> None:
    make_plugin(tmp_path, "cell", "def connect(request): raise TimeoutError('nobody answers')", ("rig",))
    with pytest.raises(DeviceError, match="TimeoutError: nobody answers"):
        connect_rig(whole("cell"), tmp_path)


def test_a_driver_s_own_words_are_kept(tmp_path: Path) -> None:
    driver = "from measureapp.errors import InputError\ndef connect(request): raise InputError('no such port', 'name one')"
    make_plugin(tmp_path, "cell", driver, ("rig",))
    with pytest.raises(InputError, match="no such port"):
        connect_rig(whole("cell"), tmp_path)


def test_a_plugin_of_a_single_device_is_not_taken_for_a_rig(tmp_path: Path) -> None:
    make_plugin(tmp_path, "cell", "def connect(request): return 1", ("camera",))
    with pytest.raises(PluginError, match="drives a camera, not a rig"):
        connect_rig(whole("cell"), tmp_path)


def test_a_rig_is_composed_of_single_devices_each_with_its_settings(tmp_path: Path) -> None:
    make_plugin(tmp_path, "thing", DEVICE)
    rig = connect_rig(composed({"guide": {"driver": "thing", "settings": {"port": 9}}}), tmp_path)
    assert isinstance(rig, Rig)
    assert list(rig.cameras) == ["left", "right", "upper"]
    assert rig.cameras["upper"].name == "upper"
    assert (rig.guide.settings.port, rig.table.settings.port) == (9, 3)  # type: ignore[attr-defined]
    rig.close()


def test_drivers_share_a_link_by_name_and_it_is_closed_once_with_the_rig(tmp_path: Path) -> None:
    make_plugin(tmp_path, "thing", DEVICE)
    shared = {"driver": "thing", "settings": {"link": "bus"}}
    rig = connect_rig(composed({"guide": shared, "table": shared}, {"bus": {"port": "COM3"}}), tmp_path)
    assert rig.guide.link is rig.table.link  # type: ignore[attr-defined]
    rig.close()
    assert rig.guide.link == ["COM3", "closed"]  # type: ignore[attr-defined]


def test_a_link_that_is_not_described_is_named_with_those_that_are(tmp_path: Path) -> None:
    make_plugin(tmp_path, "thing", DEVICE)
    with pytest.raises(DeviceError, match=r"no link 'bus' \(described: other\)"):
        connect_rig(composed({"guide": {"driver": "thing", "settings": {"link": "bus"}}}, {"other": {}}), tmp_path)


def test_every_device_that_fails_is_reported_at_once_and_the_others_are_released(tmp_path: Path) -> None:
    make_plugin(tmp_path, "thing", DEVICE)
    make_plugin(tmp_path, "dead", "def connect(request): raise TimeoutError(f'{request.name} is silent')")
    with pytest.raises(DeviceError, match=r"3 devices cannot be connected.*no driver plugin gone.*guide is silent.*colour") as failed:
        connect_rig(
            composed({"guide": {"driver": "dead"}, "robot": {"driver": "gone"}, "table": {"driver": "thing", "settings": {"colour": 1}}}),
            tmp_path,
        )
    assert "7 devices" not in str(failed.value)


@pytest.mark.parametrize(
    ("change", "named"),
    [
        ({"driver": "virtual_rig"}, "either one driver for the whole rig"),
        ({"devices": {"left": {"driver": "x"}}}, r"\[devices.NAME\] is missing for right, upper, projector, robot, guide, table"),
        ({"reference": "top"}, "the reference camera 'top' is none of the cameras"),
    ],
)
def test_a_description_that_leaves_devices_open_is_refused(change: dict[str, object], named: str) -> None:
    with pytest.raises(ValueError, match=named):
        RigDescription.model_validate(composed({}).model_dump() | change)


@pytest.mark.parametrize("name", ["../../../evil", "/abs", "", "a/b", "robot"])
def test_a_camera_name_that_could_leave_the_project_or_is_taken_is_refused(name: str) -> None:
    described = read_rig("paper").model_dump()
    described["cameras"][1]["name"] = name
    with pytest.raises(ValueError, match=r"name"):
        RigDescription.model_validate(described)
