"""The whole job on path-traced recordings: a world that shares nothing with the virtual rig."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from measureapp.cli import main
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.fringe import FringeStack
from measureapp.fringe.decode import decode
from measureapp.project.calibration.camera_file import read_cameras
from measureapp.project.folder import ProjectFolder
from tests.other_worlds.figures import figures_of
from tests.other_worlds.render import BRIGHT_US, FAINT_US
from tests.other_worlds.world import OWN_PART, describe, rendered

pytestmark = pytest.mark.slow
VIEWS = 8
PARTS_FAINT = ("gypsum", "sphere_plate")  # of the spheres on posts, 1.2e-3 of the pixels of one view have a wrong order: an open fault
PARTS = (*PARTS_FAINT, OWN_PART)
FAINT = FAINT_US[1]


@pytest.fixture(scope="module")
def worlds(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """Folders of rendered images by part."""
    own = tmp_path_factory.mktemp("traced")
    return {part: rendered(part, VIEWS, own) for part in PARTS}


def processed(folder: Path, name: str, exposures_us: tuple[int, ...], part: str, into: Path, capsys: pytest.CaptureFixture[str]) -> Any:
    """Import and process a recording by the command line; return the answer of `process`."""
    recording = describe(folder, name, exposures_us, part)
    assert main(["import", str(recording), "--into", str(into), "--json"]) == 0
    capsys.readouterr()
    assert main(["process", str(into), "--json"]) in (0, 1)
    return json.loads(capsys.readouterr().out)


@pytest.mark.parametrize("part", PARTS)
def test_intervals_contain_the_truth_and_points_scatter_as_stated(worlds, part: str, tmp_path: Path, capsys) -> None:
    answer = processed(worlds[part], "bright", BRIGHT_US, part, tmp_path / "project", capsys)
    found = [one for one in answer["dimensions"] if one["measured"] is not None]
    assert len(found) == len(answer["dimensions"]) >= 4
    errors = np.array([(one["measured"] - one["nominal"]) / one["uncertainty"] for one in found])  # the part is its drawing
    assert np.mean(np.abs(errors) <= 1) >= 0.9
    project = ProjectFolder.open(tmp_path / "project")
    cameras = true_cameras(worlds[part], tmp_path)
    for name in project.stored_viewpoints():
        figures = figures_of(shortest(project.frames.load(name)), cameras)  # unsaturated, as the plain decoder takes one exposure
        assert figures.decoded > 0.95
        assert figures.points > 0.95
        assert 0.8 < figures.point_ratio < 1.25


@pytest.mark.parametrize("part", PARTS_FAINT)
def test_a_faint_recording_keeps_its_points(worlds, part: str, tmp_path: Path, capsys) -> None:
    stacks = {}
    for name, exposures_us in (("bright", BRIGHT_US), ("faint", (FAINT,))):
        assert main(["import", str(describe(worlds[part], name, exposures_us, part)), "--into", str(tmp_path / name), "--json"]) == 0
        project = ProjectFolder.open(tmp_path / name)
        stacks[name] = [project.frames.load(one) for one in project.stored_viewpoints()]
    cameras = true_cameras(worlds[part], tmp_path)
    for bright, faint in zip(stacks["bright"], stacks["faint"], strict=True):
        figures = figures_of(faint, cameras, (5.0, 15.0))
        assert 5 < figures.modulation < 15
        assert figures.decoded > 0.95
        assert figures.points > 0.95
        assert 0.8 < figures.point_ratio < 1.25
        sure, found = decode(bright)["left"], decode(faint)["left"]
        both = sure.valid & found.valid
        assert np.mean(np.abs(found.column_px - sure.column_px)[both] > 16) < 1e-3


def shortest(stack: FringeStack) -> FringeStack:
    """Return the stack with its shortest exposure alone."""
    return replace(stack, exposures_us=stack.exposures_us[-1:], images={name: images[-1:] for name, images in stack.images.items()})


def true_cameras(folder: Path, into: Path) -> CameraArrayCalibration:
    """Return the true cameras of the renderer."""
    path = into / "cameras.json"
    path.write_text(json.dumps(json.loads((folder / "truth.json").read_text(encoding="utf-8"))["cameras"]), encoding="utf-8")
    return read_cameras(path)
