"""The environment: made, kept in step with the lock file, repaired, and made anew where it is broken."""

from __future__ import annotations

import importlib
import json
import subprocess
import sys
from pathlib import Path
from types import ModuleType, SimpleNamespace

import pytest


class Workshop:
    """The environment module with its slow hands replaced: counts builds and installations."""

    def __init__(self, module: ModuleType, root: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.module, self.root, self.made, self.installed, self.pip_fails = module, root, 0, 0, 0
        self.inventory, self.problems = ["numpy==2.4"], []
        (root / "requirements.lock").write_text("numpy==2.4\n")
        (root / "pyproject.toml").write_text("[project]\n")
        monkeypatch.setattr(module, "ROOT", root)
        monkeypatch.setattr(module, "LOCK", root / "requirements.lock")
        monkeypatch.setattr(module.subprocess, "run", self._make)
        monkeypatch.setattr(module, "_pip", self._pip)
        monkeypatch.setattr(module, "_check_machine", lambda: None)
        monkeypatch.setattr(module, "_probe", lambda home: {"inventory": self.inventory, "problems": self.problems})

    def _make(self, command, **_):
        self.made += 1
        self.home.script("measureapp").parent.mkdir(parents=True)
        self.home.script("measureapp").touch()
        return subprocess.CompletedProcess(command, 0)

    def _pip(self, home, *arguments):
        if self.pip_fails:
            self.pip_fails -= 1
            raise self.module.SetupTrouble("pip failed", "again")
        self.installed += "--require-hashes" in arguments

    @property
    def home(self):
        return self.module.Environment(self.root / ".venv")

    def done(self) -> tuple[int, int]:
        """Ensure the environment; return how often it was made and the lock file installed."""
        self.made = self.installed = 0
        self.module.ensure()
        return self.made, self.installed


@pytest.fixture
def workshop(installer, tmp_path, monkeypatch) -> Workshop:
    ready = Workshop(installer.environment, tmp_path, monkeypatch)
    assert ready.done() == (1, 1)
    return ready


def test_a_second_start_does_nothing(workshop) -> None:
    assert workshop.done() == (0, 0)


def test_a_changed_lock_or_project_file_is_installed_into_the_same_environment(workshop) -> None:
    for name in ("requirements.lock", "pyproject.toml"):
        (workshop.root / name).write_text("# changed\n")
        assert workshop.done() == (0, 1)
    assert workshop.done() == (0, 0)


def test_an_update_that_fails_builds_anew(workshop) -> None:
    (workshop.root / "requirements.lock").write_text("# changed\n")
    workshop.pip_fails = 1
    assert workshop.done() == (1, 1)


def test_an_interrupted_installation_builds_anew(workshop) -> None:
    (workshop.root / "requirements.lock").write_text("# changed\n")
    workshop.pip_fails = 2
    with pytest.raises(workshop.module.SetupTrouble):
        workshop.done()
    assert workshop.done() == (1, 1)


@pytest.mark.parametrize(
    "harm",
    [
        lambda shop: shop.home.script("measureapp").unlink(),
        lambda shop: shop.home.stamp.unlink(),
        lambda shop: shop.home.stamp.write_text('{"maker": '),
        lambda shop: setattr(shop, "inventory", []),
        lambda shop: shop.home.stamp.write_text(
            json.dumps({**json.loads(shop.home.stamp.read_text()), "maker": {"python": "cpython 3.9", "folder": str(shop.root)}})
        ),
        lambda shop: shop.home.stamp.write_text(
            json.dumps({**json.loads(shop.home.stamp.read_text()), "maker": {**shop.module._maker(), "folder": "elsewhere"}})
        ),
    ],
    ids=["script gone", "half-finished", "stamp torn", "package gone", "other Python", "checkout moved"],
)
def test_a_broken_environment_is_built_anew(workshop, harm) -> None:
    harm(workshop)
    assert workshop.done() == (1, 1)


def test_an_environment_whose_packages_do_not_import_is_built_anew(workshop, monkeypatch) -> None:
    answers = iter([["cv2: broken"], []])
    monkeypatch.setattr(workshop.module, "_probe", lambda home: {"inventory": workshop.inventory, "problems": next(answers)})
    assert workshop.done() == (1, 1)


def test_too_little_space_is_refused_before_anything_is_made(installer, monkeypatch) -> None:
    monkeypatch.setattr(installer.environment.shutil, "disk_usage", lambda path: SimpleNamespace(free=1e9))
    with pytest.raises(installer.trouble.SetupTrouble, match=r"Only 1\.0 GB"):
        installer.environment._check_machine()


def test_an_old_linux_is_refused_in_words(installer, monkeypatch) -> None:
    monkeypatch.setattr(installer.environment.platform, "libc_ver", lambda: ("glibc", "2.31"))
    monkeypatch.setattr(installer.environment.platform, "machine", lambda: "x86_64")
    monkeypatch.setattr(installer.environment.shutil, "disk_usage", lambda path: SimpleNamespace(free=1e12))
    with pytest.raises(installer.trouble.SetupTrouble, match=r"glibc 2\.31"):
        installer.environment._check_machine()


def test_variables_that_lead_python_elsewhere_or_keep_it_from_storing_bytecode_are_kept_out(installer, monkeypatch, tmp_path) -> None:
    monkeypatch.setenv("PYTHONPATH", "elsewhere")
    monkeypatch.setenv("PIP_TARGET", "elsewhere")
    monkeypatch.setenv("PYTHONDONTWRITEBYTECODE", "1")
    variables = installer.environment.Environment(tmp_path).variables()
    assert not {"PYTHONPATH", "PIP_TARGET", "PYTHONDONTWRITEBYTECODE"} & variables.keys()
    assert variables["PATH"].startswith(str(tmp_path))


def test_a_lost_or_cut_file_of_a_package_is_found(installer, tmp_path) -> None:
    info = tmp_path / "thing-1.0.dist-info"
    info.mkdir()
    (tmp_path / "whole.py").write_text("12345")
    (tmp_path / "cut.py").write_text("123")
    (info / "METADATA").write_text("Name: thing\nVersion: 1.0\n")
    (info / "RECORD").write_text("whole.py,sha256=x,5\ncut.py,sha256=x,5\nlost.py,sha256=x,5\nwhole.pyc,,\nthing-1.0.dist-info/RECORD,,\n")
    (found,) = importlib.metadata.distributions(path=[str(tmp_path)])
    assert [Path(path).name for path in installer.probe.damaged_files(found)] == ["cut.py", "lost.py"]


@pytest.mark.parametrize("absent", ["ensurepip", "venv"])
def test_a_python_that_came_without_venv_gets_the_package_of_its_version(installer, monkeypatch, absent) -> None:
    asked: list[list[str]] = []
    monkeypatch.setattr(installer.environment.importlib.util, "find_spec", lambda name: None if name == absent else object())
    monkeypatch.setattr(installer.environment.system_libraries, "install", asked.append)
    installer.environment._ensure_venv_module()
    assert asked == [[f"python{sys.version_info.major}.{sys.version_info.minor}-venv"]]
