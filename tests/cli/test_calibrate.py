"""`measureapp calibrate …` from files, as users run it."""

from __future__ import annotations

import json

import cv2
import numpy as np
import pytest
from recorded import recorded

from measureapp.cli import main
from measureapp.data.calibration import LinearGuide, RotationAxis
from measureapp.geometry.transform import RigidTransform
from measureapp.project.calibration.camera_file import read_cameras, write_cameras
from measureapp.project.tables import write_poses
from tests.cli.drawn_board import SMALL_HEAD, drawn_views

X = RigidTransform.from_vector([0.2, -1.2, 0.3], [100, -150, 80], "flange", "camera")
GUIDE = LinearGuide(np.array([0.003, 1.0, -0.002]), 1.0004)
GUIDE_FROM_BOARD = RigidTransform.from_vector([2.0, 0.3, -0.4], [600, 50, 100], "guide", "board")


def run(capsys, *arguments):
    """Return exit code and JSON document of a command."""
    code = main(["calibrate", *map(str, arguments), "--json"])
    return code, json.loads(capsys.readouterr().out)


@pytest.fixture
def tables(tmp_path):
    """Robot and board poses before a standing board, with slide positions."""
    generator = np.random.default_rng(5)
    robot, boards, slides = {}, {}, ["name,position_mm"]
    for number in range(8):
        name, slide = f"p{number}", 60.0 * number - 200
        turn = generator.uniform(-0.6, 0.6, 3)
        seen = RigidTransform.from_vector(turn, [*generator.uniform(-80, 80, 2), 550], "camera", "board")
        flange = GUIDE.guide_from_base(slide).inverse() @ GUIDE_FROM_BOARD @ seen.inverse() @ X.inverse()
        robot[name], boards[name] = flange, seen
        slides.append(f"{name},{slide}")
    write_poses(tmp_path / "robot.csv", robot)
    write_poses(tmp_path / "board.csv", boards)
    standing = {name: RigidTransform((GUIDE_FROM_BOARD @ boards[name].inverse() @ X.inverse()).matrix, "base", "flange") for name in robot}
    write_poses(tmp_path / "standing.csv", standing)
    write_poses(tmp_path / "x.csv", {"x": X})
    (tmp_path / "guide.csv").write_text("\n".join(slides))
    return tmp_path


def test_hand_eye_and_guide_follow_from_tables(capsys, tables):
    solved = tables / "hand_eye.json"
    arguments = ["hand-eye", "--robot-poses", tables / "standing.csv", "--board-poses", tables / "board.csv", "--out", solved]
    code, answer = run(capsys, *arguments)
    assert code == 0, answer
    assert set(answer["methods"]) == {"tsai_lenz", "park_martin", "horaud", "daniilidis", "andreff", "shah", "li_wang_wu"}
    for entry in (*answer["methods"].values(), answer["refined"]):
        np.testing.assert_allclose(entry["flange_from_camera"], X.matrix, atol=1e-5)
        assert entry["residual_mm"]["max"] < 1e-4
    assert answer["degeneracy"]["verdict"] == "good"
    assert answer["refined"]["standard_deviations"]["x_mm"] > 0
    common = [
        "guide",
        "--robot-poses",
        tables / "robot.csv",
        "--guide-positions",
        tables / "guide.csv",
        "--board-poses",
        tables / "board.csv",
    ]
    for hand_eye in (solved, tables / "x.csv"):
        code, answer = run(capsys, *common, "--hand-eye", hand_eye)
        assert code == 0, answer
        np.testing.assert_allclose(answer["direction"], GUIDE.direction, atol=1e-6)
        assert answer["scale"] == pytest.approx(GUIDE.scale, abs=1e-6)
        assert answer["paper_cost_mm"] > 1.0


def test_answers_for_people_name_every_method(capsys, tables):
    assert main(["calibrate", "hand-eye", "--robot-poses", str(tables / "standing.csv"), "--board-poses", str(tables / "board.csv")]) == 0
    said = capsys.readouterr().out
    for name in ("tsai_lenz", "park_martin", "horaud", "daniilidis", "andreff", "refined"):
        assert name in said


def test_a_moving_guide_makes_hand_eye_alone_fit_badly(capsys, tables):
    _, answer = run(capsys, "hand-eye", "--robot-poses", tables / "robot.csv", "--board-poses", tables / "board.csv")
    assert answer["refined"]["residual_mm"]["mean"] > 10


def test_names_that_do_not_match_are_refused(capsys, tables):
    table = tables / "board.csv"
    table.write_text(table.read_text().replace("p3,", "q3,"))
    code, answer = run(capsys, "hand-eye", "--robot-poses", tables / "robot.csv", "--board-poses", table)
    assert code == 2
    assert "'p3' is missing" in answer["error"]["message"]


def corner_table(path, noise_mm=0.0):
    axis = RotationAxis(np.array([170.0, 90.0, 600.0]), np.array([0.05, -0.8, -0.6]), "camera")
    points = RigidTransform.from_vector([0.3, -0.25, 0.1], [90, -20, 560], "camera", "board").apply(
        np.array([[x, y, 0.0] for y in range(0, 121, 40) for x in range(0, 161, 40)])
    )
    generator = np.random.default_rng(2)
    lines = ["position,corner,x_mm,y_mm,z_mm,angle_deg"]
    for position, angle in enumerate(range(0, 91, 15)):
        turned = axis.turned(np.deg2rad(angle)).apply(points) + generator.normal(scale=noise_mm, size=points.shape)
        lines += [f"{position},{corner},{x!r},{y!r},{z!r},{angle}" for corner, (x, y, z) in enumerate(turned.tolist())]
    path.write_text("\n".join(lines))
    return axis


def test_the_axis_follows_from_a_corner_table(capsys, tmp_path):
    axis = corner_table(tmp_path / "corners.csv", 0.01)
    code, answer = run(capsys, "axis", "--corners", tmp_path / "corners.csv", "--power", 3, "--out", tmp_path / "axis.json")
    assert code == 0, answer
    for method in ("least_squares", "distance_weighted", "maximum_likelihood"):
        entry = answer[method]
        assert np.linalg.norm(np.cross(entry["direction"], axis.direction)) < np.deg2rad(0.1)
        away = np.array(entry["point_mm"]) - axis.point_mm
        assert np.linalg.norm(away - axis.direction * (away @ axis.direction)) < 0.1
        assert entry["standard_deviations"]["direction_deg"] > 0
        assert len(entry["residuals"]["positions"]) == 7
    assert answer["distance_weighted"]["p"] == 3
    closure = answer["diagnostics"]["closure"]
    assert closure["board_mm"] == pytest.approx(0.01 * np.sqrt(3 * 6 / 7), rel=0.2)
    assert closure["angles_were_read"] and closure["radius_mm"] == 250
    assert len(answer["diagnostics"]["arcs"]["centre_sigma_mm"]) == 20
    assert len(answer["diagnostics"]["wobble_deg"]["positions"]) == 7
    assert json.loads((tmp_path / "axis.json").read_text())["schema_version"] == 1


def test_the_axis_wants_one_source(capsys, tmp_path):
    code, answer = run(capsys, "axis")
    assert (code, answer["error"]["type"]) == (2, "InputError")
    corner_table(tmp_path / "corners.csv")
    code, answer = run(capsys, "axis", "--corners", tmp_path / "corners.csv", "--power", 1)
    assert code == 2
    assert "p > 1" in answer["error"]["hint"]


def test_the_axis_follows_from_images_of_two_cameras(capsys, tmp_path):
    axis = RotationAxis(np.array([40.0, 20.0, 480.0]), np.array([0.05, -0.8, -0.6]), "camera")
    start = RigidTransform.from_vector([-0.2, 0.1, 0.05], [-10, -30, 450], "camera", "board")
    angles = [-30, -15, 0, 15, 30]
    drawn_views(tmp_path, SMALL_HEAD, (9, 6), [axis.turned(np.deg2rad(angle)) @ start for angle in angles])
    cv2.imwrite(str(tmp_path / "right1.png"), np.full((360, 480), 90, np.uint8))
    write_cameras(tmp_path / "cameras.json", SMALL_HEAD)
    (tmp_path / "angles.csv").write_text("position,angle_deg\n" + "\n".join(f"{n},{angle}" for n, angle in enumerate(angles, 1)))
    code, answer = run(
        capsys,
        *("axis", "--images", f"left={tmp_path}/left*.png", "--images", f"right={tmp_path}/right*.png"),
        *("--cameras", tmp_path / "cameras.json", "--board", "9x6", "--square-mm", 12, "--angles", tmp_path / "angles.csv"),
    )
    assert code == 0, answer
    likely = answer["maximum_likelihood"]
    assert np.linalg.norm(np.cross(likely["direction"], axis.direction)) < np.deg2rad(0.2)
    assert [entry["reason"].partition(". ")[0] for entry in answer["rejected"]] == ["The board of 9 × 6 corners was not found"]


def test_the_recorded_pairs_are_calibrated_from_the_command_line(capsys, tmp_path):
    folder = recorded("opencv_stereo")
    out = tmp_path / "cameras.json"
    code, answer = run(
        capsys,
        *("cameras", "--images", f"left={folder}/left[0-9]*.jpg", "--images", f"right={folder}/right[0-9]*.jpg"),
        *("--board", "9x6", "--square-mm", 1, "--out", out),
    )
    assert code == 0, answer
    assert answer["rms_px"]["left-right"] < 0.30
    assert answer["pairs"]["left-right"]["baseline_mm"] == pytest.approx(3.328, abs=0.02)
    assert len(answer["views"]) == 26
    assert answer["cameras"]["right"]["parameters"]["fx"]["standard_deviation"] > 0
    calibration = read_cameras(out)
    assert calibration.names == ("left", "right")
    assert len(calibration.provenance.inputs) == 26
    assert len(calibration.covariance.parameters) == 24  # two lenses of nine parameters and the right camera's place
    code, again = run(capsys, "again", out)
    assert code == 0, again["differences"][:3]
    assert again["same"]
    assert again["inputs"] == 26


def test_one_camera_alone_is_calibrated(capsys, tmp_path):
    generator = np.random.default_rng(4)
    poses = [
        RigidTransform.from_vector(
            [*generator.uniform(-0.5, 0.5, 2), generator.uniform(-0.3, 0.3)], [-50, -30, 380 + 10 * n], "camera", "board"
        )
        for n in range(7)
    ]
    drawn_views(tmp_path, SMALL_HEAD, (9, 6), poses)
    code, answer = run(capsys, "cameras", "--images", f"left={tmp_path}/left*.png", "--board", "9x6", "--square-mm", 12, "--distortion", 4)
    assert code == 0, answer
    focal = answer["cameras"]["left"]["parameters"]["fx"]
    assert abs(focal["value"] - 700) < 5 * focal["standard_deviation"] + 1.0
    assert list(answer["rms_px"]) == ["left"]


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (["--board", "9by6"], "is not a board"),
        (["--board", "9x6"], "--square-mm"),
        (["--board", "9x6", "--square-mm", "12"], "No images"),
        (["--board", "9x6", "--square-mm", "12", "--images", "left=/nowhere/*.png"], "No image matches"),
    ],
)
def test_bad_options_are_refused_in_words(capsys, options, said):
    code, answer = run(capsys, "cameras", *options)
    assert code == 2
    assert said in answer["error"]["message"] + answer["error"]["hint"]


def test_a_file_without_a_hand_eye_transform_is_refused(capsys, tables):
    (tables / "x.json").write_text("{}")
    code, answer = run(
        capsys,
        *("guide", "--robot-poses", tables / "robot.csv", "--guide-positions", tables / "guide.csv"),
        *("--board-poses", tables / "board.csv", "--hand-eye", tables / "x.json"),
    )
    assert code == 2
    assert "x.json holds no flange_from_camera" in answer["error"]["message"]


def test_the_requirement_for_a_figure_is_stated_and_can_be_set(capsys, tmp_path):
    corner_table(tmp_path / "corners.csv", 0.01)
    axis = ["axis", "--corners", tmp_path / "corners.csv"]
    _, answer = run(capsys, *axis)
    usual = {one["name"]: one for one in answer["limits"]}
    assert {name: one["asked"] for name, one in usual.items()} == {"axis direction": 0.002, "axis position": 0.005}
    sigma = usual["axis position"]["sigma"]
    assert sigma == answer["maximum_likelihood"]["standard_deviations"]["point_mm"]
    for share, code in ((1.01, 0), (0.99, 1)):
        found, answer = run(capsys, *axis, "--limit", f"axis position={share * sigma}")
        assert found == code
        assert next(one for one in answer["limits"] if one["name"] == "axis position")["met"] is (code == 0)
    code, answer = run(capsys, *axis, "--limit", "guide scale=1")
    assert code == 2 and "axis direction, axis position" in answer["error"]["hint"]


def test_a_hand_eye_limit_that_only_the_robot_exceeds_is_no_failure(capsys, tables):
    hand_eye = ["hand-eye", "--robot-poses", tables / "standing.csv", "--board-poses", tables / "board.csv"]
    code, answer = run(capsys, *hand_eye, "--limit", "hand-eye position=0.05", "--robot-sigma-mm", 0.3)
    position = next(one for one in answer["limits"] if one["name"] == "hand-eye position")
    assert 0.05 < position["axes_allow"] < position["sigma"]
    assert position["images_and_cameras_add"] == pytest.approx(np.sqrt(position["sigma"] ** 2 - position["axes_allow"] ** 2))
    assert not position["met"] and code == (0 if position["met_beyond_axes"] else 1)
    assert "the rig's axes alone allow" in position["sentence"]
