"""`verify`: every stored byte against its checksum."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from measureapp.arrays import read_only
from measureapp.cli import main
from measureapp.data.board import BoardView
from measureapp.data.fringe import AxisReadback, FringeStack
from measureapp.data.pattern_sets import PAPER_PATTERNS
from measureapp.geometry.transform import RigidTransform
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.rig_file import read_rig

READBACK = AxisReadback(RigidTransform.from_vector([0.1, 0.2, 0.3], [400, 0, 500], "base", "flange"), 12.5, 0.25)


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """Two viewpoints and one sighting of the board, with images of 16 × 12 px."""
    rng = np.random.default_rng(1)
    folder = ProjectFolder.create(tmp_path / "project", ProjectSettings(name="small", part="gypsum", rig=read_rig("paper")))
    for name in ("view01", "view02"):
        images = {camera: read_only(rng.integers(0, 255, (2, 8, 12, 16), np.uint8)) for camera in ("left", "right")}
        folder.frames.store(FringeStack(name, PAPER_PATTERNS, (100_000, 50_000), images, 255, READBACK))
    folder.save_board_view(BoardView("board01", {"left": read_only(rng.integers(0, 255, (12, 16), np.uint8))}, READBACK))
    return folder.path


def verified(capsys: pytest.CaptureFixture[str], project: Path) -> tuple[int, dict]:
    code = main(["verify", str(project), "--json"])
    return code, json.loads(capsys.readouterr().out)


def flip(path: Path, place: int) -> None:
    content = bytearray(path.read_bytes())
    content[place] ^= 1
    path.write_bytes(content)


def test_a_project_as_it_was_stored_is_whole(project: Path, capsys) -> None:
    code, document = verified(capsys, project)
    assert (code, document["checked"], document["damaged"]) == (0, ["view01", "view02", "board01"], {})
    assert document["unknown"] == document["stale"] == []
    assert main(["verify", str(project)]) == 0
    assert capsys.readouterr().out == "9 files checked, among them those of 3 views: no damage.\n"


@pytest.mark.parametrize("place", [-1, 200, 1000])
def test_one_flipped_bit_of_a_fringe_image_is_found(place: int, project: Path, capsys) -> None:
    flip(project / "stacks" / "view02" / "right.npy", place)
    code, document = verified(capsys, project)
    assert code == 1
    assert list(document["damaged"]) == ["view02"]
    assert "right.npy differs from its stored checksum" in document["damaged"]["view02"][0]
    assert main(["verify", str(project)]) == 1
    assert "1 file is damaged" in capsys.readouterr().out


def test_a_missing_image_is_found(project: Path, capsys) -> None:
    (project / "stacks" / "view01" / "left.npy").unlink()
    code, document = verified(capsys, project)
    assert code == 1
    assert "left.npy is missing" in document["damaged"]["view01"][0]


@pytest.mark.parametrize("content", ["", "[]", "{}", '{"checksums": 3}', "\x00\x01"])
def test_a_damaged_description_is_found_like_a_damaged_image(content: str, project: Path, capsys) -> None:
    (project / "stacks" / "view01" / "stack.json").write_text(content)
    code, document = verified(capsys, project)
    assert code == 1
    assert "stack.json" in document["damaged"]["view01"][0]


def test_a_changed_image_of_the_board_is_found(project: Path, capsys) -> None:
    import cv2

    path = project / "calibration" / "views" / "board01" / "left.png"
    pixels = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
    pixels[3, 4] ^= 1
    cv2.imwrite(str(path), pixels)
    code, document = verified(capsys, project)
    assert code == 1
    assert "left.png differs from its stored checksum" in document["damaged"]["board01"][0]


def test_an_image_of_the_board_cut_in_half_is_found(project: Path, capsys) -> None:
    path = project / "calibration" / "views" / "board01" / "left.png"
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])
    code, document = verified(capsys, project)
    assert code == 1
    assert "left.png differs from its stored checksum" in document["damaged"]["board01"][0]


@pytest.mark.parametrize("content", ["", "[]", "{}", '{"cameras": ["left"], "viewpoint_id": "x", "readback": 3}'])
def test_a_damaged_description_of_a_sighting_is_found(content: str, project: Path, capsys) -> None:
    (project / "calibration" / "views" / "board01" / "view.json").write_text(content)
    code, document = verified(capsys, project)
    assert code == 1
    assert "view.json" in document["damaged"]["board01"][0]
