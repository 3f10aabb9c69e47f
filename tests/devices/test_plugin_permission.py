"""A plugin from elsewhere is loaded only after a person allowed exactly its code."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from measureapp.cli.main import main
from measureapp.devices.plugin_loader import discover, examine, load_driver
from measureapp.devices.plugin_permission import allow, fingerprint
from measureapp.errors import PluginError

MANIFEST = """id = "cam"
name = "A camera"
version = "1"
api = 2

[drives.camera]
entry = "driver:connect"
settings = "driver:Settings"
"""
DRIVER = "from measureapp.data.model import Model\nclass Settings(Model): ...\ndef connect(request): return 'connected'\n"


@pytest.fixture
def permissions(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The home of a user who has allowed nothing yet."""
    home = tmp_path / "home"
    home.mkdir()
    monkeypatch.setattr(Path, "home", lambda: home)
    return home


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    home = tmp_path / "plugins"
    (home / "cam").mkdir(parents=True)
    (home / "cam" / "plugin.toml").write_text(MANIFEST, encoding="utf-8")
    (home / "cam" / "driver.py").write_text(DRIVER, encoding="utf-8")
    return home


def test_the_drivers_of_the_program_need_no_permission(permissions: Path) -> None:
    assert not any("allowed" in row.problem for row in discover())


def test_a_foreign_plugin_is_not_imported_before_it_was_allowed(folder: Path, permissions: Path) -> None:
    (folder / "cam" / "driver.py").write_text("raise SystemExit('imported')", encoding="utf-8")
    (row,) = examine(folder)
    assert "was not allowed" in row.problem
    assert "--allow cam" in row.hint
    with pytest.raises(PluginError, match="was not allowed"):
        load_driver(folder, "cam", "camera")


def test_an_allowed_plugin_is_loaded_until_any_of_its_files_changes(folder: Path, permissions: Path) -> None:
    allow(folder / "cam")
    assert load_driver(folder, "cam", "camera").entry(None) == "connected"  # type: ignore[arg-type]
    (folder / "cam" / "notes.txt").write_text("new", encoding="utf-8")
    with pytest.raises(PluginError, match="was not allowed"):
        load_driver(folder, "cam", "camera")


def test_a_renamed_file_is_another_plugin_although_its_contents_are_the_same(folder: Path) -> None:
    before = fingerprint(folder / "cam")
    (folder / "cam" / "driver.py").rename(folder / "cam" / "other.py")
    assert fingerprint(folder / "cam") != before


def test_a_copy_elsewhere_has_to_be_allowed_itself(folder: Path, permissions: Path) -> None:
    allow(folder / "cam")
    twin = folder.parent / "elsewhere"
    folder.rename(twin)
    assert "was not allowed" in discover(twin)[0].problem


def test_a_damaged_file_of_permissions_allows_nothing(folder: Path, permissions: Path) -> None:
    allow(folder / "cam")
    (permissions / "MeasureApp" / "allowed_plugins.json").write_text("[", encoding="utf-8")
    assert "was not allowed" in discover(folder)[0].problem


def test_the_command_line_allows_by_name(folder: Path, permissions: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["plugins", "--folder", str(folder)]) == 0
    assert "NOT LOADED" in capsys.readouterr().out
    assert main(["plugins", "--folder", str(folder), "--allow", "cam"]) == 0
    assert "may be loaded" in capsys.readouterr().out
    assert main(["plugins", "--folder", str(folder)]) == 0
    assert "NOT LOADED" not in capsys.readouterr().out


def test_a_plugin_that_is_not_there_cannot_be_allowed(folder: Path, permissions: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["plugins", "--folder", str(folder), "--allow", "robot"]) == 2
    assert "no plugin robot" in capsys.readouterr().err


def own_plugin(home: Path, plugin_id: str) -> Path:
    own = home / "MeasureApp" / "plugins" / "mine"
    own.mkdir(parents=True)
    (own / "plugin.toml").write_text(MANIFEST.replace('"cam"', f'"{plugin_id}"'), encoding="utf-8")
    (own / "driver.py").write_text(DRIVER, encoding="utf-8")
    return own


def test_plugins_of_the_user_are_searched_beside_those_of_the_program(permissions: Path) -> None:
    own = own_plugin(permissions, "cam")
    (row,) = [row for row in discover() if row.folder == own]
    assert not row.allowed
    allow(own)
    assert load_driver(None, "cam", "camera").entry(None) == "connected"  # type: ignore[arg-type]


def test_a_plugin_of_the_user_cannot_take_the_place_of_one_of_the_program(permissions: Path) -> None:
    own = own_plugin(permissions, "camera_folder")
    allow(own)
    shipped, refused = [row for row in discover() if row.id == "camera_folder"]
    assert shipped.problem == ""
    assert "camera_folder, which comes with the program, has the same id" in refused.problem
    assert str(own / "plugin.toml") in refused.hint
    assert load_driver(None, "camera_folder", "camera").module.__file__ != str(own / "driver.py")


def test_a_plugin_that_changed_since_a_person_saw_its_fingerprint_is_not_allowed(folder: Path, permissions: Path) -> None:
    seen = fingerprint(folder / "cam")
    (folder / "cam" / "driver.py").write_text("evil = True", encoding="utf-8")
    with pytest.raises(PluginError, match="have changed"):
        allow(folder / "cam", seen)
    assert not discover(folder)[0].allowed


def test_the_command_line_searches_the_folder_of_the_user(permissions: Path, capsys: pytest.CaptureFixture[str]) -> None:
    own_plugin(permissions, "cam")
    assert main(["plugins", "--allow", "cam"]) == 0
    capsys.readouterr()
    assert main(["plugins", "--json"]) == 0
    listed = {row["id"]: row for row in json.loads(capsys.readouterr().out)["plugins"]}
    assert listed["cam"]["loaded"]
    assert listed["camera_folder"]["loaded"]


def test_the_command_line_does_not_allow_a_twin(permissions: Path, capsys: pytest.CaptureFixture[str]) -> None:
    own_plugin(permissions, "camera_folder")
    assert main(["plugins", "--allow", "camera_folder"]) == 2
    assert "has the same id" in capsys.readouterr().err
