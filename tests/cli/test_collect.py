"""`measureapp calibrate collect`, as users run it: a session in several calls."""

from __future__ import annotations

import json

import cv2
import pytest
from recorded import recorded

from measureapp.cli import main
from measureapp.project.folder_lock import lock_folder
from tests.calibrate.virtual_board import CHECKER, shot

BOARD = ("--board", "14x11", "--square-mm", "15")
VIEWS = ((0, 0), (30, 0), (30, 90), (30, 180), (30, 270))


def run(capsys, *arguments):
    """Return exit code and JSON document of a call."""
    code = main(["calibrate", "collect", *map(str, arguments), "--json"])
    return code, json.loads(capsys.readouterr().out)


@pytest.fixture
def images(tmp_path):
    """Photographs of a board by one camera, and one in which it is over-exposed."""
    folder = tmp_path / "images"
    folder.mkdir()
    for number, (tilt, towards) in enumerate(VIEWS):
        cv2.imwrite(str(folder / f"view{number}.png"), shot(CHECKER, tilt, towards).image)
    cv2.imwrite(str(folder / "view9.png"), shot(CHECKER, exposure_us=900_000).image)
    return folder


def test_a_session_is_collected_guided_solved_and_accepted_in_several_calls(capsys, images, tmp_path):
    session = ("cameras", "--session", tmp_path / "session")
    code, answer = run(capsys, *session, "--images", f"left={images}/view*.png", *BOARD, "--coach")
    assert code == 0, answer
    assert len(answer["added"]) == 6
    assert [one["standing"] for one in answer["observations"]] == ["new"] * 5 + ["no board"]
    assert answer["observations"][5]["images"]["left"]["refused"] == "over-exposed"
    assert answer["coach"]["sentences"]
    assert answer["coach"]["ghost"]["outlines_px"]["left"]
    code, answer = run(capsys, *session, "--images", f"left={images}/view*.png")  # nothing is counted twice
    assert answer["added"] == []
    code, answer = run(capsys, *session, "--remove", "06")
    assert answer["observations"][5]["standing"] == "removed"
    code, answer = run(capsys, *session, "--undo")
    assert answer["undone"] == ["06"]
    assert answer["can_redo"]
    code, answer = run(capsys, *session, "--redo", "--solve")
    assert code in (0, 1)
    assert answer["verdict"]["level"] in ("good", "usable", "bad")
    assert (code == 1) == (answer["verdict"]["level"] == "bad")
    assert all(one["residuals_px"]["left"] < 0.5 for one in answer["observations"] if one["standing"] == "used")
    focal = next(one for one in answer["estimates"] if one["name"] == "left fx")
    assert abs(focal["value"] - 2045.0) < 5 * focal["standard_deviation"] + 0.001 * 2045  # the image's own blur and quantisation
    expanded = answer["verdict"]["expanded_mm"]
    code, answer = run(capsys, *session, "--solve", "--usable-mm", expanded * 0.99)
    assert (code, answer["verdict"]["level"], answer["verdict"]["good_mm"]) == (1, "bad", pytest.approx(expanded * 0.99 / 4))
    result = tmp_path / "cameras.json"
    code, answer = run(capsys, *session, "--accept", result)
    assert result.is_file()
    assert len(json.loads(result.read_text())["provenance"]["inputs"]) == 5
    code, answer = run(capsys, *session, "--compare", result)
    assert answer["comparison"]["within"]
    assert answer["comparison"]["on_part_mm"] < 1e-3


def test_words_for_people_name_every_observation(capsys, images, tmp_path):
    code = main(
        ["calibrate", "collect", "cameras", "--session", str(tmp_path / "s"), "--images", f"left={images}/view*.png", *BOARD, "--coach"]
    )
    said = capsys.readouterr().out
    assert code == 0
    assert "01  new" in said
    assert "over-exposed" in said
    assert "Next:" in said


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("lens", "--session", "s"), "not a kind of calibration"),
        (("cameras", "--session", "s"), "A new session needs images"),
        (("axis", "--session", "s", "--images", "left={images}/view*.png", *BOARD), "calibrated cameras are needed"),
        (("cameras", "--session", "s", "--images", "left={images}/view*.png", *BOARD, "--reference", "right"), "--reference 'right'"),
        (("cameras", "--session", "s", "--images", "left={images}/view*.png"), "is not a board"),
        (("cameras", "--session", "s", "--images", "left={images}/view*.png", *BOARD, "--remove", "77"), "no observation '77'"),
        (("cameras", "--session", "s", "--images", "left={images}/view*.png", *BOARD, "--undo"), "nothing to undo"),
        (("cameras", "--session", "s", "--good-mm", "0.2", "--usable-mm", "0.1"), "no limits"),
    ],
)
def test_bad_input_is_refused_in_one_sentence(capsys, images, tmp_path, arguments, message):
    filled = [str(tmp_path / "s") if word == "s" else word.format(images=images) for word in arguments]
    code, answer = run(capsys, *filled)
    assert code == 2
    assert message in answer["error"]["message"]
    assert answer["error"]["hint"]


def test_a_session_that_another_window_holds_is_refused_and_stays(capsys, images, tmp_path):
    session = ("cameras", "--session", tmp_path / "session")
    assert run(capsys, *session, "--images", f"left={images}/view[01].png", *BOARD)[0] == 0
    with lock_folder(tmp_path / "session"):
        code, answer = run(capsys, *session, "--remove", "01")
    assert code == 2
    assert "another window or command" in answer["error"]["message"]
    assert [one["standing"] for one in run(capsys, *session)[1]["observations"]] == ["new", "new"]


def test_another_kind_or_board_does_not_continue_a_session(capsys, images, tmp_path):
    session = tmp_path / "session"
    run(capsys, "cameras", "--session", session, "--images", f"left={images}/view0.png", *BOARD)
    code, answer = run(capsys, "axis", "--session", session)
    assert code == 2
    assert "a session for cameras" in answer["error"]["message"]
    code, answer = run(capsys, "cameras", "--session", session, "--board", "9x6", "--square-mm", "15")
    assert code == 2
    assert "14 × 11" in answer["error"]["message"]


def test_the_recorded_hand_eye_images_give_the_published_place(capsys, tmp_path):
    folder = recorded("visp_eye_in_hand")
    robot, cameras = visp_tables(folder, tmp_path)
    images = f"camera={folder}/franka_image-?.png"
    board = ("--board", "9x6", "--square-mm", "23.6")
    noise = ("--robot-sigma-mm", "2", "--robot-sigma-deg", "0.3")
    session = ("hand-eye", "--session", tmp_path / "session")
    code, answer = run(
        capsys, *session, "--images", images, *board, "--cameras", cameras, "--robot-poses", robot, *noise, "--solve", "--coach"
    )
    assert code == 1, answer  # this robot's poses are some millimetres off: the verdict says so
    assert answer["verdict"]["level"] == "bad"
    place = [one["value"] for one in answer["estimates"] if ", place" in one["name"]]
    assert place == pytest.approx([57.72, -33.92, -42.28], abs=2.5)  # the methods themselves differ by 1.9 mm
    assert any("more robot poses" in sentence for sentence in answer["coach"]["sentences"])


def visp_tables(folder, tmp_path):
    """Write the recorded poses and the factory camera as the command reads them."""
    import re

    import numpy as np

    from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration
    from measureapp.geometry.pinhole import PinholeCamera
    from measureapp.geometry.transform import RigidTransform
    from measureapp.project.calibration.camera_file import write_cameras
    from measureapp.project.tables import write_poses

    poses = {}
    for number in range(1, 9):
        values = [float(x) for x in re.findall(r"\[([-0-9.e]+)\]", (folder / f"franka_pose_rPe_{number}.yaml").read_text())]
        poses[f"p{number}"] = RigidTransform.from_vector(values[3:], 1000 * np.array(values[:3]), "base", "flange")
    write_poses(tmp_path / "robot.csv", poses)
    matrix = np.array([[607.5931396484375, 0, 323.46282958984375], [0, 607.574951171875, 243.25529479980469], [0, 0, 1]])
    camera = CameraCalibration("camera", PinholeCamera(640, 480, matrix, np.zeros(5)), RigidTransform.identity("camera", "camera"))
    write_cameras(tmp_path / "cameras.json", CameraArrayCalibration("camera", {"camera": camera}))
    return tmp_path / "robot.csv", tmp_path / "cameras.json"
