"""What is kept under version control holds nothing of the machine it was written on."""

from __future__ import annotations

import importlib.metadata
import re
import subprocess
import tomllib
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

import measureapp

ROOT = Path(__file__).resolve().parents[2]
LOCK = ROOT / "installer" / "requirements.lock"
PLACES = re.compile("|".join("/" + place + "/" for place in ("work", "root", "home", "tmp", "opt/pypi")) + r"|[A-Z]:\\Users|file:/" + "/")
INDEX = re.compile(r"--(extra-)?index-" + r"url\b|pypi\.org/" + r"simple|--find-" + "links|--trusted-" + "host")
NOT_YET_IMPORTED = {"pymodbus", "pyserial", "pyvista"}  # for drivers to come
TEXT = {".py", ".toml", ".md", ".lock", ".yaml", ".yml", ".typ", ".qss", ".json", ".csv", ".txt", ""}


def tracked_texts() -> dict[str, str]:
    done = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        pytest.skip("not a git checkout")
    paths = [ROOT / name for name in done.stdout.split("\0") if name]
    return {str(path.relative_to(ROOT)): path.read_text(encoding="utf-8") for path in paths if path.suffix in TEXT and path.is_file()}


def test_no_tracked_file_names_a_place_of_one_machine_or_a_package_index() -> None:
    found = {
        name: match.group() for name, text in tracked_texts().items() for pattern in (PLACES, INDEX) if (match := pattern.search(text))
    }
    assert not found


def locked() -> dict[str, list[str]]:
    """Return the hashes of every pinned requirement."""
    blocks = re.split(r"\n(?=\S)", re.sub(r"^ *#.*\n", "", LOCK.read_text(encoding="utf-8"), flags=re.MULTILINE))
    return {block.split(" \\")[0]: re.findall(r"--hash=sha256:([0-9a-f]{64})", block) for block in blocks if block.strip()}


def test_every_locked_requirement_is_pinned_and_has_hashes() -> None:
    pins = locked()
    assert len(pins) > 50
    assert not [pin for pin, hashes in pins.items() if not hashes]
    assert not [pin for pin in pins if not re.fullmatch(r"[a-z0-9][a-z0-9-]*==[^ ;]+( ; .+)?", pin)]


def test_the_lock_file_holds_no_address() -> None:
    assert not re.search(r"://|@ |^-", LOCK.read_text(encoding="utf-8"), flags=re.MULTILINE)


def test_the_lock_file_meets_every_requirement_of_the_project() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    pins: dict[str, list[str]] = {}
    for pin in locked():
        name, version = pin.split(" ;")[0].split("==")
        pins.setdefault(name, []).append(version)
    wanted = [Requirement(text) for text in (*project["dependencies"], *project["optional-dependencies"]["dev"])]
    unmet = [str(need) for need in wanted if not any(need.specifier.contains(v) for v in pins.get(canonicalize_name(need.name), []))]
    assert not unmet


def test_the_program_imports_every_dependency_it_declares() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    sources = "\n".join(text for name, text in tracked_texts().items() if name.startswith(("measureapp/", "ui/", "plugins/")))
    imported = set(re.findall(r"^ *(?:from|import) (\w+)", sources, flags=re.MULTILINE))
    modules = importlib.metadata.packages_distributions()
    provides = {canonicalize_name(name) for module in imported for name in (module, *modules.get(module, ()))}
    unused = {canonicalize_name(Requirement(text).name) for text in project["dependencies"]} - provides
    assert unused <= NOT_YET_IMPORTED, sorted(unused - NOT_YET_IMPORTED)


def test_the_version_is_the_same_wherever_it_stands() -> None:
    assert f"## [{measureapp.__version__}]" in (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    try:
        installed = importlib.metadata.version("measureapp")
    except importlib.metadata.PackageNotFoundError:
        pytest.skip("the project is not installed")
    assert installed == measureapp.__version__
