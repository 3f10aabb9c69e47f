"""What spoils a calibration is named by every command that takes images, with what to do, and never absorbed into a worse result."""

from __future__ import annotations

import json
import shutil

import cv2
import numpy as np
import pytest

from measureapp.cli import main
from measureapp.geometry.transform import RigidTransform
from measureapp.project.tables import read_poses, write_poses
from tests.cli.drawn_board import SMALL_HEAD, drawn_views
from tests.cli.test_calibrate_rig import AXIS, GUIDE, GUIDE_FROM_BOARD, MOVED, X, write_sightings

VIEWS = {"cameras": range(8), "axis": range(8, 11), "hand-eye": range(8), "guide": (9, 11, 12), "rig": range(13)}
AXES = ("axis", "hand-eye", "guide", "rig")
ROBOT = ("hand-eye", "guide", "rig")
BOARD = ("--board", "9x6", "--square-mm", "12")


@pytest.fixture(scope="module")
def all_sightings(tmp_path_factory):
    """Images of the board and tables of the axes: robot poses, slide positions and table angles."""
    folder = tmp_path_factory.mktemp("sightings")
    write_sightings(folder)
    return folder


@pytest.fixture
def sightings(all_sightings, tmp_path):
    """Return a function that copies the views of one kind of calibration, numbered from 0."""

    def copied(kind, count=None):
        chosen = list(VIEWS[kind])[:count]
        poses = list(read_poses(all_sightings / "robot.csv", "base", "flange").values())
        axes = [MOVED[view - 8] if view >= 8 else (0.0, 0.0) for view in chosen]
        for number, view in enumerate(chosen):
            for camera in SMALL_HEAD.cameras:
                shutil.copy(all_sightings / f"{camera}{view}.png", tmp_path / f"{camera}{number:02d}.png")
        write_poses(tmp_path / "robot.csv", {f"v{number:02d}": poses[view] for number, view in enumerate(chosen)})
        slides = [f"v{number:02d},{slide}" for number, (slide, _) in enumerate(axes)]
        angles = [f"{number},{angle}" for number, (_, angle) in enumerate(axes)]
        (tmp_path / "guide.csv").write_text("\n".join(["name,position_mm", *slides]))
        (tmp_path / "angles.csv").write_text("\n".join(["position,angle_deg", *angles]))
        (tmp_path / "hand_eye.json").write_text(json.dumps({"flange_from_camera": X.matrix.tolist()}))
        shutil.copy(all_sightings / "cameras.json", tmp_path)
        return tmp_path

    return copied


def run(capsys, kind, folder, board=BOARD, images=("left=left", "right=right")):
    """Calibrate one kind from the files in ``folder``."""
    robot = ("--robot-poses", folder / "robot.csv")
    noise = ("--robot-sigma-mm", "0.01", "--robot-sigma-deg", "0.001")
    tables = {
        "cameras": (),
        "axis": ("--angles", folder / "angles.csv"),
        "hand-eye": (*robot, *noise),
        "guide": (*robot, "--guide-positions", folder / "guide.csv", "--hand-eye", folder / "hand_eye.json"),
        "rig": (*robot, "--guide-positions", folder / "guide.csv", "--angles", folder / "angles.csv", *noise),
    }[kind]
    known = () if kind == "cameras" else ("--cameras", folder / "cameras.json")
    named = (word for one in images for word in ("--images", f"{one.partition('=')[0]}={folder}/{one.partition('=')[2]}*.png"))
    code = main([str(word) for word in ("calibrate", kind, *tables, *named, *known, *board, "--json")])
    return code, json.loads(capsys.readouterr().out)


def show_moved(folder, view, place):
    """Put the board 2.5 mm beside its place in the images of one view; ``place`` is the number of its axes."""
    slide, angle = MOVED[place - 8] if place >= 8 else (0.0, 0.0)
    flange = read_poses(folder / "robot.csv", "base", "flange")[f"v{view:02d}"]
    aside = RigidTransform.from_parts(np.eye(3), [2.0, 1.5, 0.0], "board", "board")
    seen = (GUIDE.guide_from_base(slide) @ flange @ X).inverse() @ AXIS.turned(np.deg2rad(angle)) @ GUIDE_FROM_BOARD @ aside
    (folder / "moved").mkdir()
    drawn_views(folder / "moved", SMALL_HEAD, (9, 6), [seen])
    for camera in SMALL_HEAD.cameras:
        shutil.copy(folder / "moved" / f"{camera}0.png", folder / f"{camera}{view:02d}.png")


@pytest.mark.parametrize("kind", VIEWS)
def test_a_board_of_another_size_is_named_with_the_size_that_is_seen(capsys, sightings, kind):
    code, answer = run(capsys, kind, sightings(kind, 3), board=("--board", "8x5", "--square-mm", "12"))  # it is found in none of them
    assert code == 2
    assert "looks like one of 9 × 6 corners" in answer["error"]["message"]


@pytest.mark.parametrize("kind", AXES)
def test_exchanged_cameras_are_named(capsys, sightings, kind):
    code, answer = run(capsys, kind, sightings(kind), images=("left=right", "right=left"))
    assert code == 2
    assert "contradict the calibration of the cameras" in answer["error"]["message"]
    assert "no two cameras are exchanged" in answer["error"]["hint"]


@pytest.mark.parametrize("kind", ["hand-eye", "rig"])
def test_squares_of_another_size_are_named_where_the_robot_tells(capsys, sightings, kind):
    code, answer = run(capsys, kind, sightings(kind), board=("--board", "9x6", "--square-mm", "15"), images=("left=left",))
    assert code == 2
    assert "its squares seem to be 0." in answer["error"]["hint"]
    factor = float(answer["error"]["hint"].split("seem to be ")[1].split()[0])
    assert factor == pytest.approx(12 / 15, abs=0.01)


def test_squares_of_another_size_are_named_where_the_guide_tells(capsys, sightings):
    _, answer = run(capsys, "guide", sightings("guide"), board=("--board", "9x6", "--square-mm", "15"), images=("left=left",))
    assert any("check the stated size of the board's squares" in warning for warning in answer["warnings"])


@pytest.mark.parametrize("kind", ["hand-eye", "rig"])
def test_a_view_whose_board_moved_is_rejected_by_name(capsys, sightings, kind):
    folder = sightings(kind)
    show_moved(folder, 3, 3)
    code, answer = run(capsys, kind, folder)
    left_out = answer["moved"] if kind == "hand-eye" else answer["rejected"]
    assert code == 0
    assert list(left_out) == ["v03"]
    assert "the board moved" in left_out["v03"]
    assert np.allclose(np.array(_hand_eye(answer))[:3, 3], X.translation_mm, atol=0.3)


def _hand_eye(answer):
    return answer["flange_from_camera"] if "flange_from_camera" in answer else answer["refined"]["flange_from_camera"]


@pytest.mark.parametrize(("kind", "place", "said"), [("axis", 9, "contradict each other"), ("guide", 11, "off an even, straight travel")])
def test_a_moved_board_is_reported_also_where_three_views_cannot_say_which(capsys, sightings, kind, place, said):
    folder = sightings(kind)
    assert not [warning for warning in run(capsys, kind, folder)[1]["warnings"] if said in warning]
    show_moved(folder, 1, place)
    _, answer = run(capsys, kind, folder)
    assert [warning for warning in answer["warnings"] if said in warning and "board" in warning]


@pytest.mark.parametrize("kind", ["hand-eye", "rig"])
def test_a_view_in_which_the_cameras_contradict_each_other_is_rejected_by_name(capsys, sightings, kind):
    folder = sightings(kind)
    image = folder / "right03.png"
    cv2.imwrite(str(image), np.roll(cv2.imread(str(image), 0), 4, axis=1))
    code, answer = run(capsys, kind, folder)
    entries = answer["rejected"] if kind == "hand-eye" else answer["images_rejected"]
    assert code == 0
    assert [(one["position"], "contradict each other" in one["reason"], "take them again" in one["reason"]) for one in entries] == [
        (3, True, True)
    ]


@pytest.mark.parametrize("kind", ROBOT)
def test_poses_given_the_wrong_way_round_are_named(capsys, sightings, kind):
    folder = sightings(kind)
    poses = read_poses(folder / "robot.csv", "base", "flange")
    write_poses(folder / "robot.csv", {name: RigidTransform(pose.inverse().matrix, "base", "flange") for name, pose in poses.items()})
    code, answer = run(capsys, kind, folder)
    told = " ".join(answer["warnings"]) if kind == "guide" else answer["error"]["message"]
    assert (code == 2) == (kind != "guide")  # a robot that stands still does not tell; where the guide seems to run does
    assert "flange_from_base" in told


@pytest.mark.parametrize("kind", ROBOT)
def test_a_refused_image_that_leaves_too_few_is_named_with_its_remedy(capsys, sightings, kind):
    folder = sightings(kind)
    for image in sorted(folder.glob("*0[1-9].png")) + sorted(folder.glob("*1?.png")):
        cv2.imwrite(str(image), cv2.GaussianBlur(cv2.imread(str(image), 0), (0, 0), 3.5))
    code, answer = run(capsys, kind, folder)
    assert code == 2
    assert "blurred" in answer["error"]["message"]
    assert "Focus the camera" in answer["error"]["message"]


def test_tables_with_semicolons_and_decimal_commas_are_read(tmp_path):
    poses = {"v01": RigidTransform.from_vector([0.1, 0.2, 0.3], [100.5, -20.25, 7.0], "base", "flange")}
    write_poses(tmp_path / "poses.csv", poses)
    text = (tmp_path / "poses.csv").read_text(encoding="utf-8")
    (tmp_path / "sheet.csv").write_text(text.replace(",", ";").replace(".", ","), encoding="utf-8")
    read = read_poses(tmp_path / "sheet.csv", "base", "flange")
    assert np.array_equal(read["v01"].matrix, read_poses(tmp_path / "poses.csv", "base", "flange")["v01"].matrix)
