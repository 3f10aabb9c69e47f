"""Copies of the suite's one demo, and what a simulated world of it really is."""

from __future__ import annotations

import json
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from demo_fixture import Demo, linked_copy
from found_boards import found_once

from measureapp.project import upkeep
from measureapp.simulate.parts import make_part
from measureapp.simulate.truth import Truth
from measureapp.simulate.world import World


@pytest.fixture(scope="module", autouse=True)
def _boards_are_found_once() -> Iterator[None]:
    with found_once():
        yield


@pytest.fixture
def raw_copy(demo: Demo, tmp_path: Path) -> Path:
    """The demo's project with its images only: nothing that was computed, and not even the seed of the virtual rig."""
    folder = tmp_path / "project"
    linked_copy(demo.folder, folder)
    for computed in ("results", "report"):
        shutil.rmtree(folder / computed)
    for computed in ("cameras.json", "rig.json"):
        (folder / "calibration" / computed).unlink()
    settings = json.loads((folder / "project.json").read_text(encoding="utf-8"))
    settings["rig"]["driver_settings"] = {}
    (folder / "project.json").unlink()  # a link until now
    (folder / "project.json").write_text(json.dumps(settings), encoding="utf-8")
    upkeep.accept_changes(folder, ["project.json"])
    return folder


@pytest.fixture(scope="session")
def truth(demo: Demo) -> Truth:
    """What the demo's rig really was, drawn again from its seed."""
    settings = demo.project.settings
    return World(settings.rig, make_part("gypsum"), 1, settings.board).truth()
