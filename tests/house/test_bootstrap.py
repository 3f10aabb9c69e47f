"""The first words of the set-up, and the libraries of the system: refused in words, installed or named."""

from __future__ import annotations

import ast
import subprocess
from pathlib import Path

import pytest

INSTALLER = Path(__file__).resolve().parents[2] / "installer"


def test_old_pythons_can_read_the_first_file() -> None:
    tree = ast.parse((INSTALLER / "bootstrap.py").read_text(encoding="utf-8"), feature_version=(3, 4))
    newer = (ast.JoinedStr, ast.AnnAssign, ast.NamedExpr, ast.AsyncFunctionDef)
    assert not [node for node in ast.walk(tree) if isinstance(node, newer) or getattr(node, "returns", None)]


@pytest.mark.parametrize("version", [(2, 7, 18), (3, 10, 1), (3, 14, 0)])
def test_a_python_that_does_not_fit_is_refused_in_words(installer, monkeypatch, capsys, version) -> None:
    monkeypatch.setattr(installer.bootstrap.sys, "version_info", version)
    assert installer.bootstrap.main(["run"]) == 2
    assert "needs Python 3.11, 3.12 or 3.13" in capsys.readouterr().err


def test_help_and_unknown_commands_set_nothing_up(installer, capsys) -> None:
    assert installer.bootstrap.main(["--help"]) == 0
    assert "bootstrap.py test" in capsys.readouterr().out
    assert installer.bootstrap.main(["instal"]) == 2
    assert "no command 'instal'" in capsys.readouterr().err


# ---- system libraries


def test_nothing_is_missing_where_every_library_loads(installer) -> None:
    assert installer.system_libraries.missing_packages(True, loads=lambda name: True, fonts=lambda: True) == []


def test_a_missing_library_is_named_by_its_package(installer) -> None:
    missing = installer.system_libraries.missing_packages
    assert missing(False, loads=lambda name: name != "libEGL.so.1", fonts=lambda: False) == ["libegl1", "fonts-dejavu-core"]
    assert missing(True, loads=lambda name: "xcb-cursor" not in name, fonts=lambda: True) == ["libxcb-cursor0"]
    assert missing(False, loads=lambda name: "xcb-cursor" not in name, fonts=lambda: True) == []


def test_the_driver_of_a_graphics_card_stands_in_for_mesa(installer) -> None:
    assert installer.system_libraries.missing_packages(False, loads=lambda name: "mesa" not in name, fonts=lambda: True) == []


def test_without_root_the_exact_line_is_given(installer, monkeypatch) -> None:
    monkeypatch.setattr(installer.system_libraries.shutil, "which", lambda name: "apt-get")
    monkeypatch.setattr(installer.system_libraries.os, "geteuid", lambda: 1000, raising=False)
    with pytest.raises(installer.trouble.SetupTrouble) as caught:
        installer.system_libraries.install(["libegl1", "libgl1"])
    assert "\n    sudo apt-get install -y --no-install-recommends libegl1 libgl1\n" in caught.value.remedy


@pytest.mark.parametrize("works", [True, False])
def test_root_updates_once_and_installs_without_questions(installer, monkeypatch, works) -> None:
    calls = []

    def run(command, env, **_):
        calls.append((command, env["DEBIAN_FRONTEND"]))
        return subprocess.CompletedProcess(command, 0 if works else 100)

    monkeypatch.setattr(installer.system_libraries.shutil, "which", lambda name: "apt-get")
    monkeypatch.setattr(installer.system_libraries.os, "geteuid", lambda: 0, raising=False)
    monkeypatch.setattr(installer.system_libraries.subprocess, "run", run)
    if works:
        installer.system_libraries.install(["libegl1"])
    else:
        with pytest.raises(installer.trouble.SetupTrouble, match="package lists could not be updated"):
            installer.system_libraries.install(["libegl1"])
    assert [command[:2] + command[-1:] for command, _ in calls] == [["apt-get", "update", "-qq"], ["apt-get", "-qq", "libegl1"]]
    assert {mode for _, mode in calls} == {"noninteractive"}


@pytest.mark.parametrize(("user", "works"), [(0, True), (0, False), (1000, True)])
def test_what_single_tests_need_is_installed_by_root_alone_and_never_stops_the_others(installer, monkeypatch, capsys, user, works) -> None:
    libraries, asked = installer.system_libraries, []

    def install(packages):
        asked.extend(packages)
        if not works:
            raise installer.trouble.SetupTrouble("apt-get could not install system packages.", "")

    monkeypatch.setattr(libraries.shutil, "which", lambda name: "apt-get" if name == "apt-get" else None)
    monkeypatch.setattr(libraries.os, "geteuid", lambda: user, raising=False)
    monkeypatch.setattr(libraries.sys, "platform", "linux")
    monkeypatch.setattr(libraries, "_loads", lambda name: False)
    monkeypatch.setattr(libraries, "install", install)
    libraries.ensure_for_tests()
    assert asked == (["libaravis-0.8-0", "aravis-tools"] if user == 0 else [])
    assert ("skipped" in capsys.readouterr().out) == (not works)


def test_without_apt_the_packages_are_named(installer, monkeypatch) -> None:
    monkeypatch.setattr(installer.system_libraries.shutil, "which", lambda name: None)
    with pytest.raises(installer.trouble.SetupTrouble, match="libegl1"):
        installer.system_libraries.install(["libegl1"])
