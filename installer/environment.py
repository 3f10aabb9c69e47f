"""The virtual environment `.venv` of the checkout: made, kept in step with the lock file, repaired."""

from __future__ import annotations

import hashlib
import importlib.util
import json
import os
import platform
import shutil
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import system_libraries
from trouble import SetupTrouble

ROOT = Path(__file__).resolve().parents[1]
LOCK = ROOT / "installer" / "requirements.lock"
NEEDED_GB = 5.0
# The last one would let each of the many processes of the tests translate all sources, and rewrite all tests, for itself.
UNFIT = ("PYTHONPATH", "PYTHONHOME", "PIP_TARGET", "PIP_PREFIX", "PYTHONDONTWRITEBYTECODE")
NEEDED_GLIBC = {"x86_64": (2, 35), "aarch64": (2, 39)}


@dataclass(frozen=True)
class Environment:
    """A virtual environment and what lies in it."""

    folder: Path

    @property
    def python(self) -> Path:
        """Its interpreter."""
        return self.script("python")

    @property
    def stamp(self) -> Path:
        """Written when an installation is complete: from what it was made and what it holds."""
        return self.folder / "measureapp-stamp.json"

    def script(self, name: str) -> Path:
        """Return one of its commands."""
        return self.folder / "Scripts" / f"{name}.exe" if sys.platform == "win32" else self.folder / "bin" / name

    def variables(self) -> dict[str, str]:
        """Return the process environment without what would lead Python or pip elsewhere, or keep Python from storing its bytecode."""
        kept = {key: value for key, value in os.environ.items() if key not in UNFIT}
        path = os.pathsep.join((str(self.python.parent), kept.get("PATH", "")))
        return kept | {"PYTHONNOUSERSITE": "1", "PIP_USER": "0", "VIRTUAL_ENV": str(self.folder), "PATH": path}


def ensure() -> Environment:
    """Return a working environment: as it is when nothing changed, else brought up to date, else built anew."""
    home = Environment(ROOT / ".venv")
    stamp = _read_stamp(home)
    if stamp is None or stamp["maker"] != _maker() or _problems(home, stamp):
        return _build(home)
    if stamp["inputs"] != _inputs():
        print("The lock file or the project file changed; bringing .venv up to date.", flush=True)
        try:
            _install(home)
        except SetupTrouble:
            return _build(home)
    return home


def _build(home: Environment) -> Environment:
    _check_machine()
    started = time.monotonic()
    if home.folder.exists():
        print("The environment .venv is incomplete, damaged or made by another Python; building it anew.", flush=True)
        shutil.rmtree(home.folder, ignore_errors=True)
    _ensure_venv_module()
    print(f"Setting up {home.folder} (several minutes the first time).", flush=True)
    base_python = getattr(sys, "_base_executable", None) or sys.executable
    if subprocess.run([base_python, "-m", "venv", "--clear", str(home.folder)], check=False).returncode != 0:
        raise SetupTrouble(
            f"{home.folder} could not be made.", "Check the permissions of the checkout, close programs that run from it, and try again."
        )
    _install(home)
    print(f"Set up in {time.monotonic() - started:.0f} s.", flush=True)
    return home


def _install(home: Environment) -> None:
    """Install the lock file and the checkout; the stamp is gone until all of it succeeded."""
    home.stamp.unlink(missing_ok=True)
    _pip(home, "--require-hashes", "--requirement", str(LOCK))
    _pip(home, "--no-deps", "--no-build-isolation", "--editable", str(ROOT))
    report = _probe(home)
    if report["problems"]:
        raise SetupTrouble(
            f"The installed packages do not work: {'; '.join(report['problems'][:3])}.",
            "Start the command again; if it stays, delete .venv and check the disk.",
        )
    stamp = {"maker": _maker(), "inputs": _inputs(), "inventory": report["inventory"]}
    home.stamp.write_text(json.dumps(stamp, indent=1), encoding="utf-8")


def _pip(home: Environment, *arguments: str) -> None:
    quiet = () if sys.stdout.isatty() else ("--quiet",)
    # Python compiles what it imports, a small part of all packages, to bytecode by itself; compiling everything is a third of the set-up.
    command = [str(home.python), "-m", "pip", "install", "--no-input", "--disable-pip-version-check", "--no-compile", *quiet, *arguments]
    if subprocess.run(command, env=home.variables(), cwd=ROOT, check=False).returncode != 0:
        raise SetupTrouble(
            "pip could not install the packages; its reason stands above.",
            "Check the connection to the package index and the free disk space, then start again: it continues from there.",
        )


def _check_machine() -> None:
    free_gb = shutil.disk_usage(ROOT).free / 1e9
    if free_gb < NEEDED_GB:
        raise SetupTrouble(f"Only {free_gb:.1f} GB are free under {ROOT}; the set-up needs {NEEDED_GB:.0f} GB.", "Free some space.")
    name, version = platform.libc_ver()
    needed = NEEDED_GLIBC.get(platform.machine())
    if name == "glibc" and needed and tuple(int(part) for part in version.split(".")[:2]) < needed:
        raise SetupTrouble(
            f"This Linux has glibc {version}; the locked packages need {needed[0]}.{needed[1]} or newer.",
            "Use a newer release, for example Debian 12 or Ubuntu 22.04 on x86_64, Ubuntu 24.04 on aarch64.",
        )


def _ensure_venv_module() -> None:
    """Debian and Ubuntu ship Python without `ensurepip`, which a new environment needs."""
    if importlib.util.find_spec("ensurepip") is None or importlib.util.find_spec("venv") is None:
        system_libraries.install([f"python{sys.version_info.major}.{sys.version_info.minor}-venv"])


def _problems(home: Environment, stamp: dict[str, Any]) -> list[str]:
    if not home.script("measureapp").is_file():
        return ["the script measureapp is missing"]
    try:
        report = _probe(home)
    except SetupTrouble as trouble:
        return [trouble.message]
    lost = sorted(set(stamp["inventory"]) - set(report["inventory"]))
    return [*report["problems"], *(f"{name} is gone" for name in lost)]


def _probe(home: Environment) -> dict[str, Any]:
    """Ask the environment what it holds and whether it works."""
    command = [str(home.python), str(ROOT / "installer" / "probe.py")]
    try:
        done = subprocess.run(command, env=home.variables(), cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, check=False)
        return json.loads(done.stdout)
    except (OSError, ValueError) as error:
        raise SetupTrouble("The Python of .venv does not work.", "Delete .venv and start again.") from error


def _read_stamp(home: Environment) -> dict[str, Any] | None:
    try:
        stamp = json.loads(home.stamp.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    return stamp if isinstance(stamp, dict) and {"maker", "inputs", "inventory"} <= stamp.keys() else None


def _maker() -> dict[str, str]:
    """Name what makes an environment unusable when it changes: the Python and the place."""
    return {"python": f"{sys.implementation.name} {sys.version_info.major}.{sys.version_info.minor}", "folder": str(ROOT)}


def _inputs() -> str:
    """Return the fingerprint of what the environment is made from."""
    return hashlib.sha256(LOCK.read_bytes() + (ROOT / "pyproject.toml").read_bytes()).hexdigest()
