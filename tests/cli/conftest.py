"""The command line, built once per file, and sound inputs for the tests of refusals."""

from __future__ import annotations

import importlib
import json
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from typer.main import get_command

from measureapp.cli.main import build
from measureapp.planning.viewpoints import plan_around_part
from measureapp.project.rig_file import read_rig
from measureapp.simulate.truth import Truth
from tests.cli.board_fringes import SEED, shared_stacks, true_head
from tests.cli.fringe_sets import write_paper_set


@pytest.fixture(scope="module", autouse=True)
def _built_once() -> Iterator[None]:
    """Let all calls of a file share one command line, as it is when first built: building takes longer than most refusals."""
    command = get_command(build())
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(importlib.import_module("measureapp.cli.main"), "build", lambda: command)
        yield


@pytest.fixture(scope="session")
def shelf(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Sound files to go with the rubbish."""
    folder = tmp_path_factory.mktemp("shelf")
    plan = plan_around_part(read_rig("paper"), "plan", radius_mm=100, height_mm=80, count=2)
    (folder / "plan.json").write_text(plan.model_dump_json(), encoding="utf-8")
    rows = [f"view{i:02d},{100 * i},20,300,1,0,0,0" for i in range(1, 7)]
    (folder / "poses.csv").write_text("\n".join(["name,x_mm,y_mm,z_mm,qw,qx,qy,qz", *rows]), encoding="utf-8")
    write_paper_set(folder)
    lens = {"width": 256, "height": 40, "matrix": [[400, 0, 128], [0, 400, 20], [0, 0, 1]], "distortion": [0] * 5}
    camera = {**lens, "reference_from_camera": np.eye(4).tolist()}
    (folder / "cameras.json").write_text(json.dumps({"schema_version": 1, "reference": "left", "cameras": {"left": camera}}))
    return folder


@pytest.fixture(scope="session")
def truth() -> Truth:
    """The head before which `manifests` were recorded."""
    return true_head(SEED)


@pytest.fixture(scope="session")
def manifests(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    """Fringes of both directions on a board at several positions, rendered once for all; no test writes into them."""
    return shared_stacks(tmp_path_factory)


@pytest.fixture
def fringes(tmp_path: Path) -> Path:
    """The manifest of a small set that a test may damage."""
    return write_paper_set(tmp_path / "set")
