"""Default folders."""

from __future__ import annotations

from pathlib import Path

from measureapp.data.length_unit import LengthUnit
from measureapp.data.sample_worlds import DEFAULT_WORLD
from ui.look.demo_settings import DemoSettings
from ui.look.pattern_words import RECOMMENDED


def demo_folder(settings: DemoSettings) -> Path:
    """Return the folder of the demo project with these settings."""
    name = f"demo-{Path(settings.part).stem}-{settings.resolution}-{settings.viewpoints}-views-rig-{settings.seed}"
    if settings.patterns != RECOMMENDED:
        name += f"-{settings.patterns}"
    if settings.world != DEFAULT_WORLD:
        name += f"-{settings.world}"
    if settings.unit is not LengthUnit.MM:
        name += f"-{settings.unit}"
    return Path.home() / "MeasureApp" / name


def sample_folder(name: str) -> Path:
    """Return the folder into which a sample project is unpacked."""
    return Path.home() / "MeasureApp" / f"sample-{name}"


def next_demo_folder(wanted: Path) -> Path:
    """Return ``wanted`` if it is new or contains an unfinished demo, which is continued; else the next numbered folder."""
    number, folder = 1, wanted
    while (folder / "report" / "report.pdf").exists():
        number += 1
        folder = wanted.with_name(f"{wanted.name}-{number}")
    return folder
