"""Driver plugins: folders found by their manifest and loaded by path under private package names."""

from __future__ import annotations

import importlib
import importlib.util
import sys
import tomllib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from importlib.machinery import ModuleSpec
from pathlib import Path
from types import ModuleType
from typing import Any, Literal

from pydantic import Field, ValidationError

from measureapp.data.model import Model, first_problem
from measureapp.devices.plugin_permission import is_allowed
from measureapp.devices.request import DeviceRequest
from measureapp.errors import PluginError
from measureapp.resources import plugin_folder, user_plugin_folder

MANIFEST = "plugin.toml"
PRIVATE_PACKAGE = "_measureapp_plugins"
MEMBER = r"^[A-Za-z_]\w*:[A-Za-z_]\w*$"
PluginKind = Literal["rig", "camera", "projector", "robot", "linear-guide", "rotary-table"]


class DriverEntry(Model):
    """A table ``[drives.KIND]`` of the manifest: how a device of this kind is connected."""

    entry: str = Field(pattern=MEMBER, description="module:function, called with a DeviceRequest; returns the device")
    settings: str = Field(pattern=MEMBER, description="module:class, the pydantic model of the driver's settings")
    link: str | None = Field(
        default=None, pattern=MEMBER, description="module:class, the model of the table [links.NAME] that the setting `link` names"
    )


class PluginManifest(Model):
    """Contents of `plugin.toml`; read without importing the driver."""

    id: str = Field(pattern=r"^[a-z][a-z0-9_]*$")
    name: str = Field(min_length=1)
    version: str = Field(min_length=1)
    api: Literal[2]
    drives: dict[PluginKind, DriverEntry] = Field(min_length=1)


UNALLOWED = "It does not come with the program and was not allowed as it is now."


@dataclass(frozen=True, slots=True)
class PluginRow:
    """One plugin folder; ``problem`` is empty if it is sound."""

    id: str
    name: str
    version: str
    kinds: tuple[str, ...]
    folder: Path
    problem: str = ""
    hint: str = ""
    allowed: bool = True  # False: sound as far as its manifest goes, but nobody has allowed its code


@dataclass(frozen=True, slots=True, eq=False)
class LoadedDriver:
    """A loaded driver for one kind of device: its entry function and the model of its settings."""

    manifest: PluginManifest
    module: ModuleType  # of the entry function
    entry: Callable[[DeviceRequest], Any]
    settings: type[Model]
    link: type[Model] | None = None  # model of the table [links.NAME] that it opens


@dataclass(frozen=True, slots=True, eq=False)
class PluginOffer:
    """A plugin with its loaded drivers, by kind of device; there are none if its row has a problem."""

    row: PluginRow
    drivers: Mapping[PluginKind, LoadedDriver]


def discover(folder: Path | None = None) -> tuple[PluginRow, ...]:
    """List the plugins below ``folder``, sorted by folder; imports nothing.

    Without a folder these are the plugins shipped with the program, then those of this user. One that does not come with the program
    and was not allowed as it is now has this as its problem; so has the later one of two with the same id.
    """
    rows: list[PluginRow] = []
    for place in (folder,) if folder is not None else (plugin_folder(), user_plugin_folder()):
        for path in sorted(place.glob(f"*/{MANIFEST}")):
            row = _row(path)
            if not row.problem and not is_allowed(row.folder):
                allow = f"If you trust it, run: measureapp plugins --folder {row.folder.parent} --allow {row.id}"
                row = replace(row, problem=UNALLOWED, hint=allow, allowed=False)
            twin = next((other for other in rows if other.id == row.id), None)
            rows.append(row if twin is None else _refused_as_twin(row, twin))
    return tuple(rows)


def _refused_as_twin(row: PluginRow, twin: PluginRow) -> PluginRow:
    where = twin.folder.name if twin.folder.parent == row.folder.parent else f"{twin.folder.name}, which comes with the program,"
    return replace(
        row, problem=f"Plugin {where} has the same id {row.id}.", hint=f"Change the id in {row.folder / MANIFEST}.", allowed=True
    )


def examine(folder: Path | None = None) -> tuple[PluginRow, ...]:
    """List the plugins and try to load each one; the row of a plugin that fails states the reason."""
    return tuple(offer.row for offer in load_all(folder))


def load_all(folder: Path | None = None) -> tuple[PluginOffer, ...]:
    """Load every plugin that `discover` lists; the row of one that fails states the reason."""
    return tuple(_offer(row) for row in discover(folder))


def load_driver(folder: Path | None, plugin_id: str, kind: PluginKind) -> LoadedDriver:
    """Load the driver of plugin ``plugin_id`` below ``folder`` (None: as `discover` searches) for one kind of device.

    Raises
    ------
    PluginError
        No such plugin, an invalid manifest, a plugin for other kinds of device, or a driver that cannot be imported.
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
    manifest = _read(row.folder / MANIFEST)
    if kind not in manifest.drives:
        fitting = ", ".join(sorted(row.id for row in rows if kind in row.kinds)) or "none"
        raise PluginError(
            f"The plugin {plugin_id} drives a {' or '.join(row.kinds)}, not a {kind}.",
            f"Name a driver of a {kind} in the rig description (available: {fitting}).",
        )
    return _load(manifest, kind, row.folder)


def _row(path: Path) -> PluginRow:
    try:
        manifest = _read(path)
    except PluginError as error:
        return PluginRow(path.parent.name, path.parent.name, "", (), path.parent, error.message, error.hint)
    return PluginRow(manifest.id, manifest.name, manifest.version, tuple(manifest.drives), path.parent)


def _offer(row: PluginRow) -> PluginOffer:
    if row.problem:
        return PluginOffer(row, {})
    try:
        manifest = _read(row.folder / MANIFEST)
        return PluginOffer(row, {kind: _load(manifest, kind, row.folder) for kind in manifest.drives})
    except PluginError as error:
        return PluginOffer(replace(row, problem=error.message, hint=error.hint), {})


def _read(path: Path) -> PluginManifest:
    try:
        return PluginManifest.model_validate(tomllib.loads(path.read_text(encoding="utf-8")))
    except (OSError, UnicodeDecodeError) as error:
        raise PluginError(f"{path} cannot be read: {error}.", "Check the file and its permissions.") from error
    except tomllib.TOMLDecodeError as error:
        raise PluginError(f"{path} is not valid TOML: {error}.", "Correct the line named.") from error
    except ValidationError as error:
        raise PluginError(f"{path}: {first_problem(error, 'the manifest')}.", "Correct this field.") from error


def _load(manifest: PluginManifest, kind: PluginKind, folder: Path) -> LoadedDriver:
    described = manifest.drives[kind]
    module, entry = _import_member(manifest.id, described.entry, "function", folder)
    settings = _import_model(manifest.id, described.settings, folder)
    link = None if described.link is None else _import_model(manifest.id, described.link, folder)
    return LoadedDriver(manifest, module, entry, settings, link)


def _import_model(plugin_id: str, member: str, folder: Path) -> type[Model]:
    _, found = _import_member(plugin_id, member, "class", folder)
    if not (isinstance(found, type) and issubclass(found, Model)):
        raise PluginError(f"Plugin {plugin_id}: {member} is not a model of settings.", "Derive it from measureapp.data.model.Model.")
    return found


def _import_member(plugin_id: str, member: str, what: Literal["function", "class"], folder: Path) -> tuple[ModuleType, Any]:
    """Import ``member`` ("module:name") of a plugin; return its module and the member."""
    module_name, name = member.split(":")
    package = _private_package(plugin_id, folder)
    try:
        module = importlib.import_module(f"{package}.{module_name}")
    except ModuleNotFoundError as error:
        _forget(package)
        missing = (error.name or "").removeprefix(f"{package}.")
        raise PluginError(
            f"Plugin {plugin_id} needs the module {missing}, which is missing.",
            f"Install it, or put {missing}.py into {folder} and import it with a leading dot.",
        ) from error
    except (Exception, SystemExit) as error:  # foreign code may raise anything
        _forget(package)
        raise PluginError(f"Plugin {plugin_id} cannot be imported: {type(error).__name__}: {error}.", f"Correct {folder}.") from error
    found = getattr(module, name, None)
    if not callable(found):
        raise PluginError(f"Plugin {plugin_id} has no {what} {name} in {module_name}.py.", f"Correct {folder / MANIFEST}.")
    return module, found


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
