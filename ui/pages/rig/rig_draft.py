"""A rig description while it is edited, valid or not, and what is wrong with it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

from pydantic import ValidationError

from measureapp.data.model import toml_values
from measureapp.data.rig import OTHER_DEVICES, RECORDED, RigDescription
from measureapp.devices.connect import KINDS
from measureapp.devices.plugin_loader import LoadedDriver, PluginKind, PluginOffer
from ui.look.field_words import place_words, problem_words
from ui.look.language.words import tr
from ui.widgets.field_editors import table_problem

Part = Literal["fields", "driver", "link"]
RIG, MOTION, RULES, LINKS, DRIVERS = "rig", "motion", "calibration_rules", "links", "drivers"


@dataclass(frozen=True)
class Problem:
    """What is wrong, and where: section of the editor, part of it, field."""

    section: str
    part: Part
    place: tuple[int | str, ...]
    words: str

    @property
    def sentence(self) -> str:
        """The problem with its field."""
        where = place_words(self.place)
        return tr("{where}: {problem}", where=where, problem=self.words) if where else self.words


def kind_of(device: str) -> PluginKind:
    """Return which kind of plugin drives a device."""
    return KINDS.get(device, "camera")


def loaded(offers: Sequence[PluginOffer], driver: str, kind: PluginKind) -> LoadedDriver | None:
    """Return a driver with its models; None if it is not loaded."""
    return next((offer.drivers[kind] for offer in offers if offer.row.id == driver and kind in offer.drivers), None)


@dataclass
class RigDraft:
    """Values of a description by field; drivers for the whole rig and for each device side by side, until one of both is saved."""

    values: dict[str, Any]  # everything but drivers and links
    by_device: bool
    whole: dict[str, Any]
    devices: dict[str, dict[str, Any]]
    links: dict[str, Any]
    offers: Sequence[PluginOffer] = field(default=())
    link_names_problem: str = ""

    @classmethod
    def of(cls, rig: RigDescription, offers: Sequence[PluginOffer]) -> RigDraft:
        """Return the draft of a description."""
        values = rig.model_dump()
        whole = {"driver": values.pop("driver"), "settings": values.pop("driver_settings")}
        named = values.pop("devices")
        names = (*(camera.name for camera in rig.cameras), *OTHER_DEVICES)
        devices = {name: dict(named.get(name, {"driver": "", "settings": {}})) for name in names}
        return cls(values, bool(rig.devices), whole, devices, values.pop("links"), offers)

    @property
    def choices(self) -> dict[str, tuple[PluginKind, dict[str, Any]]]:
        """The drivers in use with their settings, by section."""
        if self.by_device:
            return {name: (kind_of(name), choice) for name, choice in self.devices.items()}
        return {RIG: ("rig", self.whole)}

    def link_models(self) -> dict[str, LoadedDriver]:
        """Return for each link that a driver in use names the driver that knows its settings."""
        found = {}
        for kind, choice in self.choices.values():
            driver = loaded(self.offers, choice["driver"], kind)
            name = self._link_of(driver, choice)
            if driver is not None and name:
                found[name] = driver
        return found

    def check(self) -> RigDescription | Problem:
        """Return the description, or the first problem."""
        if self.link_names_problem:
            return Problem(LINKS, "link", (), self.link_names_problem)
        for name, table in self.links.items():
            if table_problem(table):
                return Problem(LINKS, "link", (name,), table_problem(table))
        for section, (kind, choice) in self.choices.items():
            problem = self._driver_problem(section, kind, choice)
            if problem is not None:
                return problem
        problem = self._link_problem()
        if problem is not None:
            return problem
        try:
            return RigDescription.model_validate(self._document())
        except ValidationError as error:
            return self._located(error.errors(include_url=False)[0])

    def _document(self) -> dict[str, Any]:
        used: dict[str, Any] = {"driver": self.whole["driver"], "driver_settings": self._short(self.whole, "rig")}
        if self.by_device:
            devices = {name: {**choice, "settings": self._short(choice, kind_of(name))} for name, choice in self.devices.items()}
            used = {"devices": devices}
        return {**self.values, **used, "links": self._short_links()}

    def _short(self, choice: Mapping[str, Any], kind: PluginKind) -> dict[str, Any]:
        """Return settings as they are written: without defaults, where the driver's model is known."""
        driver = loaded(self.offers, choice["driver"], kind)
        return dict(choice["settings"]) if driver is None else toml_values(driver.settings.model_validate(dict(choice["settings"])))

    def _short_links(self) -> dict[str, Any]:
        known = {name: driver.link for name, driver in self.link_models().items() if driver.link is not None}
        return {
            name: toml_values(known[name].model_validate(dict(table))) if name in known else table for name, table in self.links.items()
        }

    def _driver_problem(self, section: str, kind: PluginKind, choice: Mapping[str, Any]) -> Problem | None:
        if not choice["driver"]:
            return Problem(section, "driver", ("driver",), "Choose a driver.")
        if table_problem(choice["settings"]):
            return Problem(section, "driver", ("settings",), table_problem(choice["settings"]))
        driver = loaded(self.offers, choice["driver"], kind)
        if driver is None or choice["driver"] == RECORDED:
            return None
        try:
            driver.settings.model_validate(dict(choice["settings"]))
        except ValidationError as error:
            found = error.errors(include_url=False)[0]
            return Problem(section, "driver", ("settings", *found["loc"]), problem_words(found))
        name = self._link_of(driver, choice)
        if name and name not in self.links:
            return Problem(section, "driver", ("settings", "link"), tr("There is no link {name}. Add it under Links.", name=name))
        return None

    def _link_problem(self) -> Problem | None:
        for name, driver in self.link_models().items():
            assert driver.link is not None
            try:
                driver.link.model_validate(dict(self.links[name]))
            except ValidationError as error:
                found = error.errors(include_url=False)[0]
                return Problem(LINKS, "link", (name, *found["loc"]), problem_words(found))
        return None

    def _link_of(self, driver: LoadedDriver | None, choice: Mapping[str, Any]) -> str:
        if driver is None or driver.link is None or "link" not in driver.settings.model_fields or table_problem(choice["settings"]):
            return ""
        default = driver.settings.model_fields["link"].get_default()
        return str(choice["settings"].get("link", default if isinstance(default, str) else ""))

    def _located(self, error: Any) -> Problem:
        place, words = tuple(error["loc"]), problem_words(error)
        first = place[0] if place else ""
        if first == "cameras" and len(place) > 1:
            return Problem(list(self.devices)[place[1]], "fields", place[2:], words)
        if first in OTHER_DEVICES or first in (MOTION, RULES):
            return Problem(str(first), "fields", place[1:], words)
        if first == "devices" and len(place) > 1:
            return Problem(str(place[1]), "driver", place[2:], words)
        return Problem(LINKS, "link", place[1:], words) if first == "links" else Problem(RIG, "fields", place, words)
