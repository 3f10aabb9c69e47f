"""Driver plugins: folders found by their manifest and loaded by path under private package names."""

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
    """Contents of `plugin.toml`; read without importing the driver."""

    id: str = Field(pattern=r"^[a-z][a-z0-9_]*$")
    name: str = Field(min_length=1)
    version: str = Field(min_length=1)
    api: Literal[1]
    kind: PluginKind
    entry: str = Field(pattern=r"^[A-Za-z_]\w*:[A-Za-z_]\w*$", description="module:function")


@dataclass(frozen=True, slots=True)
class PluginRow:
    """One plugin folder; ``problem`` is empty if it is sound."""

    id: str
    name: str
    version: str
    kind: str
    folder: Path
    problem: str = ""
    hint: str = ""


@dataclass(frozen=True, slots=True, eq=False)
class LoadedPlugin:
    """A loaded driver with its entry function."""

    manifest: PluginManifest
    module: ModuleType
    entry: Callable[..., Any]


def discover(folder: Path | None = None) -> tuple[PluginRow, ...]:
    """List the plugins below ``folder`` (default: those shipped with the program), sorted by folder; imports nothing."""
    rows: list[PluginRow] = []
    for path in sorted((folder or plugin_folder()).glob(f"*/{MANIFEST}")):
        row = _row(path)
        twin = next((other for other in rows if other.id == row.id), None)
        if twin is not None:
            row = replace(row, problem=f"Plugin {twin.folder.name} has the same id {row.id}.", hint="Change one of the two ids.")
        rows.append(row)
    return tuple(rows)


def examine(folder: Path | None = None) -> tuple[PluginRow, ...]:
    """List the plugins and try to load each one; the row of a plugin that fails states the reason."""
    return tuple(_examine_row(row) for row in discover(folder))


def load_plugin(folder: Path | None, plugin_id: str) -> LoadedPlugin:
    """Load the plugin ``plugin_id`` below ``folder`` (None: those shipped with the program).

    Raises
    ------
    PluginError
        No such plugin, an invalid manifest, or a driver that cannot be imported.
    """
    rows = discover(folder)
    row = next((row for row in rows if row.id == plugin_id), None)
    if row is None:
        known = ", ".join(sorted(row.id for row in rows)) or "none"
        raise PluginError(
            f"There is no driver plugin {plugin_id} (available: {known}).", "Correct the driver's id, or add its folder to plugins."
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


def _examine_row(row: PluginRow) -> PluginRow:
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
    """Register the folder as a private package, after unloading one of the same name from another folder."""
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
