"""Driver plugins: folders that are found by their manifest and loaded by path, so that their names never meet others."""

from __future__ import annotations

import importlib
import importlib.util
import sys
import tomllib
from collections.abc import Callable
from dataclasses import dataclass, replace
from importlib.machinery import ModuleSpec
from pathlib import Path
from types import ModuleType
from typing import Any, Literal

from pydantic import Field, ValidationError

from measureapp.data.model import Model, first_problem
from measureapp.errors import PluginError
from measureapp.resources import plugin_folder

MANIFEST = "plugin.toml"
PRIVATE_PACKAGE = "_measureapp_plugins"
PluginKind = Literal["rig", "camera", "projector", "robot", "linear-guide", "rotary-table"]


class PluginManifest(Model):
    """What `plugin.toml` says; read without importing the driver."""

    id: str = Field(pattern=r"^[a-z][a-z0-9_]*$")
    name: str = Field(min_length=1)
    version: str = Field(min_length=1)
    api: Literal[1]
    kind: PluginKind
    entry: str = Field(pattern=r"^[A-Za-z_]\w*:[A-Za-z_]\w*$", description="module:function")


@dataclass(frozen=True, slots=True)
class PluginRow:
    """One plugin folder; ``problem`` is empty where nothing is wrong with it."""

    id: str
    name: str
    version: str
    kind: str
    folder: Path
    problem: str = ""
    hint: str = ""


@dataclass(frozen=True, slots=True, eq=False)
class LoadedPlugin:
    """A driver ready to be called."""

    manifest: PluginManifest
    module: ModuleType
    entry: Callable[..., Any]


def discover(folder: Path | None = None) -> tuple[PluginRow, ...]:
    """Return a row for every plugin below ``folder`` (default: those that come with the program), sorted by folder; imports nothing."""
    rows: list[PluginRow] = []
    for path in sorted((folder or plugin_folder()).glob(f"*/{MANIFEST}")):
        row = _row(path)
        twin = next((other for other in rows if other.id == row.id), None)
        if twin is not None:
            row = replace(row, problem=f"The plugin {twin.folder.name} has the same id {row.id}.", hint="Give one of them another id.")
        rows.append(row)
    return tuple(rows)


def examine(folder: Path | None = None) -> tuple[PluginRow, ...]:
    """Return the rows of `discover` after an attempt to load each plugin; one that fails carries the reason and hides no other."""
    return tuple(_examined(row) for row in discover(folder))


def load_plugin(folder: Path | None, plugin_id: str) -> LoadedPlugin:
    """Load the plugin called ``plugin_id`` below ``folder`` (None: those that come with the program).

    Raises
    ------
    PluginError
        No such plugin, a wrong manifest, or a driver that cannot be imported; says why.
    """
    rows = discover(folder)
    row = next((row for row in rows if row.id == plugin_id), None)
    if row is None:
        known = ", ".join(sorted(row.id for row in rows)) or "none"
        raise PluginError(
            f"There is no driver plugin {plugin_id} (found: {known}).", "Correct the driver's id, or add its folder to plugins."
        )
    if row.problem:
        raise PluginError(f"Plugin {row.id}: {row.problem}", row.hint)
    return _load(row.folder)


def _row(path: Path) -> PluginRow:
    try:
        manifest = _read(path)
    except PluginError as error:
        return PluginRow(path.parent.name, path.parent.name, "", "", path.parent, error.message, error.hint)
    return PluginRow(manifest.id, manifest.name, manifest.version, manifest.kind, path.parent)


def _examined(row: PluginRow) -> PluginRow:
    if row.problem:
        return row
    try:
        _load(row.folder)
    except PluginError as error:
        return replace(row, problem=error.message, hint=error.hint)
    return row


def _read(path: Path) -> PluginManifest:
    try:
        return PluginManifest.model_validate(tomllib.loads(path.read_text(encoding="utf-8")))
    except (OSError, UnicodeDecodeError) as error:
        raise PluginError(f"{path} cannot be read: {error}.", "Check the file and its permissions.") from error
    except tomllib.TOMLDecodeError as error:
        raise PluginError(f"{path} is not valid TOML: {error}.", "Correct the line named.") from error
    except ValidationError as error:
        raise PluginError(f"{path}: {first_problem(error, 'the manifest')}.", "Correct this field.") from error


def _load(folder: Path) -> LoadedPlugin:
    manifest = _read(folder / MANIFEST)
    module_name, function_name = manifest.entry.split(":")
    package = _private_package(manifest.id, folder)
    try:
        module = importlib.import_module(f"{package}.{module_name}")
    except ModuleNotFoundError as error:
        _forget(package)
        missing = (error.name or "").removeprefix(f"{package}.")
        raise PluginError(
            f"Plugin {manifest.id} needs the module {missing}, which is missing.",
            f"Install it, or put {missing}.py into {folder} and import it with a leading dot.",
        ) from error
    except (Exception, SystemExit) as error:  # foreign code may raise anything
        _forget(package)
        raise PluginError(f"Plugin {manifest.id} cannot be imported: {type(error).__name__}: {error}.", f"Correct {folder}.") from error
    entry = getattr(module, function_name, None)
    if not callable(entry):
        raise PluginError(
            f"Plugin {manifest.id} has no function {function_name} in {module_name}.py.", f"Correct `entry` in {folder / MANIFEST}."
        )
    return LoadedPlugin(manifest, module, entry)


def _private_package(plugin_id: str, folder: Path) -> str:
    """Make the folder a package of a private name; one of that name from another folder is forgotten first."""
    name = f"{PRIVATE_PACKAGE}.{plugin_id}"
    place = [str(folder.resolve())]
    if name in sys.modules and sys.modules[name].__path__ != place:
        _forget(name)
    for package, search in ((PRIVATE_PACKAGE, []), (name, place)):
        if package not in sys.modules:
            spec = ModuleSpec(package, loader=None, is_package=True)
            spec.submodule_search_locations = search
            sys.modules[package] = importlib.util.module_from_spec(spec)
    importlib.invalidate_caches()
    return name


def _forget(package: str) -> None:
    for name in [name for name in sys.modules if name == package or name.startswith(f"{package}.")]:
        del sys.modules[name]
