"""`plugins`, `rig check` and `gui`."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

from measureapp.cli.main import main
from measureapp.project.rig_file import read_rig
from measureapp.resources import resource

MANIFEST = """id = "{id}"
name = "{id}"
version = "1"
api = 2

[drives.rig]
entry = "driver:connect"
settings = "driver:Settings"
"""
SETTINGS = """
from measureapp.data.model import Model

class Settings(Model):
    part: str = ""
"""
HALF_DEAD = """
from types import SimpleNamespace
from measureapp.devices.rig import Rig
from measureapp.devices.status import DeviceStatus

def device(status):
    return SimpleNamespace(status=status, close=lambda: print("closed"))

def alive(*_):
    return device(lambda: DeviceStatus(True, "ready"))

def dead(*_):
    return device(lambda: DeviceStatus(False, "no answer.", "Switch it on."))

def broken():
    raise OSError("reset by peer")

def connect(request):
    return Rig(request.rig, {"left": dead()}, alive(), dead(), alive(), device(broken), lambda thing: None)
"""


@pytest.fixture(autouse=True)
def _everything_is_allowed(monkeypatch) -> None:
    monkeypatch.setattr("measureapp.devices.plugin_loader.is_allowed", lambda folder: True)


def plugin(folder: Path, name: str, driver: str) -> None:
    (folder / name).mkdir(parents=True)
    (folder / name / "plugin.toml").write_text(MANIFEST.format(id=name), encoding="utf-8")
    (folder / name / "driver.py").write_text(SETTINGS + driver, encoding="utf-8")


def answer(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, dict]:
    code = main([*arguments, "--json"])
    return code, json.loads(capsys.readouterr().out)


def test_the_virtual_rig_is_listed_and_loads(capsys) -> None:
    code, document = answer(capsys, "plugins")
    assert code == 0
    assert {row["id"]: row["loaded"] for row in document["plugins"]}["virtual_rig"]


def test_a_broken_driver_is_listed_with_its_reason_beside_the_others(capsys, tmp_path) -> None:
    plugin(tmp_path, "broken", "import no_such_vendor_library")
    plugin(tmp_path, "sound", "def connect(description, settings): ...")
    code, document = answer(capsys, "plugins", "--folder", str(tmp_path))
    broken, sound = document["plugins"]
    assert code == 0
    assert (broken["loaded"], sound["loaded"]) == (False, True)
    assert "no_such_vendor_library" in broken["problem"]
    assert main(["plugins", "--folder", str(tmp_path)]) == 0
    assert "NOT LOADED" in capsys.readouterr().out


def test_a_plugin_folder_that_is_absent_is_bad_input(capsys, tmp_path) -> None:
    code, document = answer(capsys, "plugins", "--folder", str(tmp_path / "nowhere"))
    assert (code, document["error"]["type"]) == (2, "InputError")


def test_the_paper_s_rig_answers_with_every_device(capsys) -> None:
    code, document = answer(capsys, "rig", "check", "paper")
    assert code == 0
    kinds = [device["kind"] for device in document["devices"]]
    assert kinds == ["camera"] * len(read_rig("paper").cameras) + ["projector", "robot", "linear guide", "rotary table"]


def test_all_devices_that_fail_are_named_at_once_and_the_rig_is_closed(capsys, tmp_path) -> None:
    plugin(tmp_path / "plugins", "half_dead", HALF_DEAD)
    text = resource("rigs/paper.toml").read_text(encoding="utf-8")
    (tmp_path / "mine.toml").write_text(text.replace('"virtual_rig"', '"half_dead"'), encoding="utf-8")
    code = main(["rig", "check", str(tmp_path / "mine.toml"), "--plugins", str(tmp_path / "plugins")])
    output = capsys.readouterr()
    assert code == 3
    assert "left: no answer." in output.err
    assert "robot: no answer. Switch it on." in output.err
    assert "table: The table failed: OSError: reset by peer." in output.err
    assert output.out.count("closed") == 5


def test_a_rig_whose_driver_is_absent_is_a_device_failure(capsys, tmp_path) -> None:
    code, document = answer(capsys, "rig", "check", "paper", "--plugins", str(tmp_path))
    assert (code, document["error"]["type"]) == (3, "PluginError")
    assert "virtual_rig" in document["error"]["message"]


def test_an_unknown_rig_is_bad_input(capsys) -> None:
    code, document = answer(capsys, "rig", "check", "no-such-rig")
    assert code == 2
    assert "no-such-rig" in document["error"]["message"]


def test_without_a_screen_the_window_is_refused_in_words(capsys, monkeypatch) -> None:
    monkeypatch.setattr("sys.platform", "linux")
    for name in ("QT_QPA_PLATFORM", "DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    assert main(["gui"]) == 2
    assert "There is no screen" in capsys.readouterr().err


@pytest.fixture
def with_a_display(monkeypatch) -> None:
    monkeypatch.setattr("sys.platform", "linux")
    for name in ("QT_QPA_PLATFORM", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("DISPLAY", ":4711")


def test_a_screen_that_does_not_answer_is_named(capsys, monkeypatch, with_a_display) -> None:
    monkeypatch.setattr("measureapp.cli.gui._x_server_answers", lambda: False)
    assert main(["gui"]) == 2
    assert "The screen :4711 named by DISPLAY does not answer." in capsys.readouterr().err


def test_a_library_that_qt_lacks_is_named(capsys, monkeypatch, with_a_display) -> None:
    def lacking() -> bool:
        raise OSError("libxcb-icccm.so.4: cannot open shared object file")

    monkeypatch.setattr("measureapp.cli.gui._x_server_answers", lacking)
    assert main(["gui"]) == 2
    assert "libxcb-icccm.so.4" in capsys.readouterr().err


def test_without_qt_the_window_is_refused_in_words(capsys, monkeypatch) -> None:
    monkeypatch.setitem(sys.modules, "PySide6.QtWidgets", None)
    assert main(["gui"]) == 2
    assert "Qt cannot start" in capsys.readouterr().err


def test_a_project_that_is_no_folder_is_refused_before_the_window_opens(capsys, tmp_path) -> None:
    assert main(["gui", str(tmp_path / "nothing")]) == 2
    assert "not a project folder" in capsys.readouterr().err


def test_the_window_gets_the_project_and_its_answer_is_the_exit_code(monkeypatch, tmp_path) -> None:
    calls = []
    window = type("window", (), {"run": staticmethod(lambda project, demo: calls.append((project, demo)) or 7)})
    (tmp_path / "project.json").write_text("{}")
    monkeypatch.setattr("measureapp.cli.gui._window", lambda: window)
    assert main(["gui", str(tmp_path), "--demo"]) == 7
    assert calls == [(tmp_path, True)]
