"""Driver plugins are found by manifest, loaded by path, and fail alone."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from measureapp.devices.plugin_loader import PRIVATE_PACKAGE, discover, examine, load_driver
from measureapp.errors import PluginError

MANIFEST = """id = "{id}"
name = "A camera"
version = "1.2"
api = 2

[drives.camera]
entry = "driver:connect"
settings = "settings:Settings"
"""
DRIVER = "from .settings import GREETING\ndef connect(request):\n    return GREETING, request\n"
SETTINGS = "from measureapp.data.model import Model\nclass Settings(Model):\n    port: int = 3\nGREETING = {!r}\n"


@pytest.fixture(autouse=True)
def _names_are_forgotten() -> Iterator[None]:
    before = set(sys.modules)
    yield
    for name in set(sys.modules) - before:
        if name.startswith(PRIVATE_PACKAGE):
            del sys.modules[name]


def plugin(folder: Path, name: str, driver: str = DRIVER, manifest: str = MANIFEST, greeting: str = "hello") -> Path:
    home = folder / name
    home.mkdir(parents=True)
    (home / "plugin.toml").write_text(manifest.format(id=name), encoding="utf-8")
    (home / "driver.py").write_text(driver, encoding="utf-8")
    (home / "settings.py").write_text(SETTINGS.format(greeting), encoding="utf-8")
    return home


def test_a_plugin_is_read_from_its_manifest_without_importing_it(tmp_path: Path) -> None:
    home = plugin(tmp_path, "cam", driver="raise RuntimeError('imported')")
    (row,) = discover(tmp_path)
    assert (row.id, row.name, row.version, row.kinds, row.folder, row.problem) == ("cam", "A camera", "1.2", ("camera",), home, "")


def test_a_plugin_is_loaded_with_its_neighbours_and_called(tmp_path: Path) -> None:
    plugin(tmp_path, "cam")
    assert load_driver(tmp_path, "cam", "camera").entry("request") == ("hello", "request")


def test_loading_leaks_no_name_outside_the_private_package(tmp_path: Path) -> None:
    plugin(tmp_path, "cam")
    before, path_before = set(sys.modules), list(sys.path)
    load_driver(tmp_path, "cam", "camera")
    new = set(sys.modules) - before
    assert new == {PRIVATE_PACKAGE, f"{PRIVATE_PACKAGE}.cam", f"{PRIVATE_PACKAGE}.cam.driver", f"{PRIVATE_PACKAGE}.cam.settings"} - before
    assert sys.path == path_before


def test_two_plugins_with_files_of_the_same_name_do_not_meet(tmp_path: Path) -> None:
    plugin(tmp_path, "left", greeting="left")
    plugin(tmp_path, "right", greeting="right")
    assert load_driver(tmp_path, "left", "camera").entry(0)[0] == "left"
    assert load_driver(tmp_path, "right", "camera").entry(0)[0] == "right"


def test_a_plugin_of_the_same_id_in_another_folder_is_loaded_anew(tmp_path: Path) -> None:
    plugin(tmp_path / "one", "cam", greeting="one")
    plugin(tmp_path / "two", "cam", greeting="two")
    assert load_driver(tmp_path / "one", "cam", "camera").entry(0)[0] == "one"
    assert load_driver(tmp_path / "two", "cam", "camera").entry(0)[0] == "two"


@pytest.mark.parametrize(
    ("driver", "reason"),
    [
        ("import no_such_vendor_library", "no_such_vendor_library"),
        ("from settings import GREETING", "settings"),
        ("raise RuntimeError('the licence ran out')", "the licence ran out"),
        ("import sys; sys.exit('not here')", "not here"),
        ("def connect(:", "invalid syntax"),
        ("connect = 3", "no function connect"),
        ("def connect(request): ...\nfrom . import settings\ndel settings.Settings", "no class Settings"),
        ("def connect(request): ...\nfrom . import settings\nsettings.Settings = dict", "not a model of settings"),
    ],
)
def test_a_plugin_that_cannot_be_imported_is_a_row_with_reason_and_hint_beside_the_others(tmp_path: Path, driver: str, reason: str) -> None:
    plugin(tmp_path, "broken", driver=driver)
    plugin(tmp_path, "sound")
    broken, sound = examine(tmp_path)
    assert reason in broken.problem
    assert broken.hint
    assert not sound.problem
    with pytest.raises(PluginError, match=reason):
        load_driver(tmp_path, "broken", "camera")


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        (("api = 2", "api = 1"), "api"),
        (("drives.camera", "drives.toaster"), "toaster"),
        (("driver:connect", "driver"), "entry"),
        (("driver:connect", "../x:connect"), "entry"),
        (('version = "1.2"\n', ""), "version"),
        (('id = "{id}"', 'id = "Has Blanks"'), "id"),
        (("api = 2", "api = "), "not valid TOML"),
        (("api = 2", "api = 2\ncolour = 3"), "colour"),
    ],
)
def test_a_wrong_manifest_is_named_with_its_field_and_hides_no_other(tmp_path: Path, change: tuple[str, str], reason: str) -> None:
    plugin(tmp_path, "broken", manifest=MANIFEST.replace(*change))
    plugin(tmp_path, "sound")
    broken, sound = discover(tmp_path)
    assert reason in broken.problem
    assert "plugin.toml" in broken.problem
    assert not sound.problem
    with pytest.raises(PluginError, match=reason):
        load_driver(tmp_path, "broken", "camera")


def test_a_manifest_that_is_not_text_is_a_row(tmp_path: Path) -> None:
    (plugin(tmp_path, "cam") / "plugin.toml").write_bytes(b"\xff\xfe\x00")
    (row,) = discover(tmp_path)
    assert "cannot be read" in row.problem


def test_the_second_plugin_of_one_id_is_refused_by_name(tmp_path: Path) -> None:
    plugin(tmp_path, "cam")
    plugin(tmp_path, "cam_copy", manifest=MANIFEST.replace("{id}", "cam"))
    first, second = discover(tmp_path)
    assert not first.problem
    assert "same id cam" in second.problem


def test_an_unknown_plugin_is_refused_with_those_there_are(tmp_path: Path) -> None:
    plugin(tmp_path, "cam")
    with pytest.raises(PluginError, match=r"no driver plugin robot_x \(available: cam\)"):
        load_driver(tmp_path, "robot_x", "camera")


def test_a_failed_import_leaves_no_half_made_module(tmp_path: Path) -> None:
    home = plugin(tmp_path, "cam", driver="raise RuntimeError('first try')")
    with pytest.raises(PluginError):
        load_driver(tmp_path, "cam", "camera")
    (home / "driver.py").write_text(DRIVER + "\n# now in order\n", encoding="utf-8")
    assert load_driver(tmp_path, "cam", "camera").entry(0)[0] == "hello"


def test_a_plugin_that_drives_another_kind_of_device_is_refused_with_those_that_fit(tmp_path: Path) -> None:
    plugin(tmp_path, "cam")
    plugin(tmp_path, "arm", manifest=MANIFEST.replace("drives.camera", "drives.robot"))
    with pytest.raises(PluginError, match=r"cam drives a camera, not a robot. Name a driver of a robot .*available: arm"):
        load_driver(tmp_path, "cam", "robot")


def test_one_plugin_may_drive_several_kinds_of_device(tmp_path: Path) -> None:
    plugin(
        tmp_path,
        "axis",
        manifest=MANIFEST + '\n[drives.rotary-table]\nentry = "driver:turn"\nsettings = "settings:Settings"\n',
        driver=DRIVER + "turn = connect\n",
    )
    (row,) = examine(tmp_path)
    assert row.kinds == ("camera", "rotary-table")
    assert load_driver(tmp_path, "axis", "rotary-table").entry(1) == ("hello", 1)
