"""`measureapp calibrate rig` and `calibrate check` from images and tables, as users run them."""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from measureapp.cli import main
from measureapp.data.calibration import LinearGuide, RotationAxis
from measureapp.geometry.transform import RigidTransform
from measureapp.project.calibration.camera_file import write_cameras
from measureapp.project.tables import write_poses
from tests.cli.drawn_board import SMALL_HEAD, drawn_views

X = RigidTransform.from_vector([0.2, -1.2, 0.3], [100, -150, 80], "flange", "camera")
GUIDE = LinearGuide(np.array([0.003, 1.0, -0.002]), 1.0004)
AXIS = RotationAxis(np.array([700.0, 20, 100]), np.array([0.003, -0.002, 1]), "guide")
TURN = np.column_stack([[0, -1, 0], [np.sqrt(0.5), 0, -np.sqrt(0.5)], [np.sqrt(0.5), 0, np.sqrt(0.5)]])
GUIDE_FROM_BOARD = RigidTransform.from_parts(TURN, [660, 70, 190], "guide", "board")
# After eight robot poses the robot stands still: where the slide (mm) and the table (degrees) go from there.
MOVED = ((0.0, -30.0), (0.0, 0.0), (0.0, 30.0), (-30.0, 0.0), (30.0, 0.0))


@dataclass(frozen=True)
class SolvedRig:
    """The files of the sightings, the arguments that name them, and the answer of `calibrate rig`."""

    folder: Path
    arguments: tuple[Any, ...]
    code: int
    answer: dict[str, Any]


def run(capsys, *arguments):
    """Return exit code and JSON document of a command."""
    code = main(["calibrate", *map(str, arguments), "--json"])
    return code, json.loads(capsys.readouterr().out)


def flange_before(camera_from_board: RigidTransform) -> RigidTransform:
    """Return where the robot stands when the camera sees the board so, with slide and table at 0."""
    flange = GUIDE_FROM_BOARD @ camera_from_board.inverse() @ X.inverse()
    return RigidTransform(flange.matrix, "base", "flange")


def write_sightings(folder: Path) -> tuple[Any, ...]:
    """Write images, cameras and tables; return the arguments that name them."""
    generator, poses = np.random.default_rng(6), []
    for _ in range(8):
        vector = generator.uniform(-0.45, 0.45, 3)
        view = RigidTransform.from_vector(vector, [*generator.uniform(-60, -40, 2), 430], "camera", "board")
        poses.append((flange_before(view), 0.0, 0.0))
    still = flange_before(RigidTransform.from_vector([0.1, 0.1, 0], [-30, -30, 470], "camera", "board"))
    poses += [(still, slide, angle) for slide, angle in MOVED]
    write_poses(folder / "robot.csv", {f"v{number:02d}": flange for number, (flange, _, _) in enumerate(poses)})
    slides = [f"v{number:02d},{slide}" for number, (_, slide, _) in enumerate(poses)]
    angles = [f"{number},{angle}" for number, (_, _, angle) in enumerate(poses)]
    (folder / "guide.csv").write_text("\n".join(["name,position_mm", *slides]))
    (folder / "angles.csv").write_text("\n".join(["position,angle_deg", *angles]))
    write_cameras(folder / "cameras.json", SMALL_HEAD)
    seen = [
        (GUIDE.guide_from_base(slide) @ flange @ X).inverse() @ AXIS.turned(np.deg2rad(angle)) @ GUIDE_FROM_BOARD
        for flange, slide, angle in poses
    ]
    drawn_views(folder, SMALL_HEAD, (9, 6), seen)
    return (
        *("--robot-poses", folder / "robot.csv", "--guide-positions", folder / "guide.csv", "--angles", folder / "angles.csv"),
        *("--images", f"left={folder}/left*.png", "--images", f"right={folder}/right*.png"),
        *("--cameras", folder / "cameras.json", "--board", "9x6", "--square-mm", 12),
    )


@pytest.fixture(scope="module")
def rig(tmp_path_factory) -> SolvedRig:
    folder = tmp_path_factory.mktemp("rig")
    arguments = write_sightings(folder)
    noise = ("--robot-sigma-mm", "0.01", "--robot-sigma-deg", "0.001")
    code = main(["calibrate", "rig", *map(str, arguments), *noise, "--out", str(folder / "rig.json")])
    return SolvedRig(folder, arguments, code, json.loads((folder / "rig.json").read_text()))


def test_the_whole_rig_follows_from_images(rig):
    assert rig.code == 0
    sigma = rig.answer["standard_deviations"]
    shift = np.array(rig.answer["flange_from_camera"])[:3, 3] - X.translation_mm
    assert np.all(np.abs(shift) < 5 * np.array([sigma[f"hand_eye.{name}_mm"] for name in "xyz"]) + 0.05)
    assert np.linalg.norm(np.cross(rig.answer["axis"]["direction"], AXIS.direction)) < np.deg2rad(0.1)
    assert np.array(rig.answer["covariance"]).shape == (len(rig.answer["parameters"]),) * 2
    assert rig.answer["not_observable"] == []
    assert len(rig.answer["weak_directions"]) == 3


def test_the_check_finds_a_sound_rig_good(capsys, rig):
    code, answer = run(capsys, "check", "--calibration", rig.folder / "rig.json", *rig.arguments)
    assert code == 0, answer
    assert answer["good"] and len(answer["views"]) == 13


def test_the_check_names_the_axis_that_was_knocked(capsys, rig, tmp_path):
    knocked = json.loads((rig.folder / "rig.json").read_text())
    knocked["axis"]["point_mm"][0] += 8
    knocked["stations"] = []
    (tmp_path / "knocked.json").write_text(json.dumps(knocked))
    code, answer = run(capsys, "check", "--calibration", tmp_path / "knocked.json", *rig.arguments)
    assert code == 1
    assert answer["suspect"] == "axis"
    assert "calibrate the axis again" in answer["verdict"]


def test_the_check_refuses_what_is_no_rig_and_tables_of_other_views(capsys, rig, tmp_path):
    code, answer = run(capsys, "check", "--calibration", rig.folder / "cameras.json", *rig.arguments)
    assert code == 2
    assert "holds no calibrated rig" in answer["error"]["message"]
    (tmp_path / "angles.csv").write_text("position,angle_deg\n0,0\n1,10")
    others = [tmp_path / "angles.csv" if one == rig.folder / "angles.csv" else one for one in rig.arguments]
    code, answer = run(capsys, "check", "--calibration", rig.folder / "rig.json", *others)
    assert code == 2
    assert "2 table angles do not belong to 13 robot poses" in answer["error"]["message"]
