"""Axis, hand-eye, guide and rig collected from a simulated rig: the truth comes back, and what moved is left out by name."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
import pytest

from measureapp.calibrate.draft.draft import Limits, Setup
from measureapp.calibrate.draft.verdict import compare, evaluate
from measureapp.calibrate.guidance.advise import advise
from measureapp.calibrate.kinds.table import KINDS
from measureapp.calibrate.motions.axis_noise import AxisNoise
from measureapp.calibrate.poses import apply_changes
from measureapp.calibration_session.accepting import accept, read_result
from measureapp.calibration_session.session import CalibrationSession
from measureapp.data.calibration import HandEye
from measureapp.data.fringe import AxisReadback
from measureapp.errors import CalibrationError, InputError, StorageError
from measureapp.geometry.transform import RigidTransform, orthonormalise
from measureapp.pipeline.recalculate import is_collected, recalculate_session
from measureapp.progress import NoProgress
from tests.calibration_session.shown_board import SIGMA_PX

NOISE = AxisNoise(robot_mm=0.05, robot_rad=5e-5)


@pytest.fixture
def start(tmp_path, board, head, rig):
    """Start a session of a kind with what it needs to know."""

    def made(kind, cameras=True, name="session", hand_eye=None):
        hand_eye = hand_eye or (HandEye(rig.flange_from_camera) if kind == "guide" else None)
        known = head if cameras else None
        return CalibrationSession.create(tmp_path / name, Setup(KINDS[kind], board, ("left", "right", "upper"), known, hand_eye, NOISE))

    return made


def show(shown, session, rig, simulate, readbacks, generator, moved_board=None):
    """Show the board from read-backs; robot poses are wrong by what `NOISE` says; ``moved_board`` moves it in the last one."""
    errors = {}
    for number, readback in enumerate(readbacks):
        sigma = np.array([NOISE.robot_rad] * 3 + [NOISE.robot_mm] * 3)
        error = errors.setdefault(readback.base_from_flange.matrix.tobytes(), generator.normal(size=6) * sigma)
        seen = rig.camera_from_board(readback, error)
        if moved_board is not None and number == len(readbacks) - 1:
            seen = RigidTransform(orthonormalise(apply_changes(seen.matrix, np.array(moved_board))), "camera", "board")
        shown.add(session, simulate.corners(rig.head, rig.board, seen, SIGMA_PX, generator), readback)


def chosen(simulate, rig, start):
    return [readback for name, readback in simulate.readbacks(rig).items() if name.startswith(start)]


def standing(simulate, rig):
    """The robot's poses of the calibration, as read where the guide stands at 0."""
    poses = chosen(simulate, rig, "pose")
    carried = [rig.guide.guide_from_base(one.guide_mm) @ one.base_from_flange for one in poses]
    return [AxisReadback(RigidTransform(pose.matrix, "base", "flange"), 0.0, 0.0) for pose in carried]


def values(session, result):
    return [one.value for one in session.setup.kind.estimates(result)]


def test_the_axis_collected_is_the_true_one_and_its_verdict_covers_the_error(shown, start, rig, simulate, generator):
    session = start("axis")
    show(shown, session, rig, simulate, chosen(simulate, rig, "axis"), generator)
    axis = session.solve().solution.best.axis
    readback = session.observations[0].readback.full()
    camera_from_guide = (rig.guide.guide_from_base(readback.guide_mm) @ readback.base_from_flange @ rig.flange_from_camera).inverse()
    direction = camera_from_guide.rotate(rig.axis.direction)
    assert np.arccos(min(1.0, abs(direction @ axis.direction))) < 5 * axis.direction_sigma_rad + 3 * NOISE.robot_rad
    verdict = evaluate(session.draft)
    assert verdict.level == "good", verdict
    assert "half a turn apart" in verdict.sentence
    assert all(one.residual_mm < 0.05 for one in session.observations)  # 154 corners of 0.05 px at 550 mm are 0.003 mm


def test_a_board_that_slipped_on_the_table_is_rejected_by_name(shown, start, rig, simulate, generator):
    session = start("axis")
    show(shown, session, rig, simulate, chosen(simulate, rig, "axis"), generator, moved_board=[0, 0, 0, 1.5, 0, 0])
    solved = session.solve()
    assert list(solved.rejected) == ["09"]
    assert "moved or was detected wrongly" in session.observation("09").reason


def test_hand_eye_is_found_within_its_uncertainty_and_a_moved_view_is_rejected(shown, start, rig, simulate, generator):
    session = start("hand-eye")
    show(shown, session, rig, simulate, standing(simulate, rig), generator, moved_board=[0, 0.02, 0, 4.0, 0, 0])
    solved = session.solve()
    assert list(solved.rejected) == ["20"]
    hand_eye = solved.solution.hand_eye
    part = np.array([[0.0, 0.0, 550.0]])
    off = np.linalg.norm(hand_eye.flange_from_camera.apply(part) - rig.flange_from_camera.apply(part))
    assert off <= 2.0 * evaluate(session.draft).expanded_mm  # four standard deviations
    ghost = advise(session.draft).ghost
    assert ghost.base_from_flange is not None
    x, board = hand_eye.flange_from_camera, solved.solution.base_from_board
    seen = simulate.corners(rig.head, rig.board, (ghost.base_from_flange @ x).inverse() @ board, 0.0, generator)
    for camera, outline in ghost.outlines_px.items():
        assert outline[:, 0].min() == pytest.approx(seen[camera][:, 0].min(), abs=1.0)


def test_the_guide_collected_is_the_true_one(shown, start, rig, simulate, generator):
    session = start("guide")
    show(shown, session, rig, simulate, chosen(simulate, rig, "guide"), generator)
    solution = session.solve().solution
    # the robot's constant pose error turns the direction, as its rotation error does
    assert np.arccos(solution.guide.direction @ rig.guide.direction) < 5 * (solution.guide.direction_sigma_rad + NOISE.robot_rad)
    assert solution.guide.scale == pytest.approx(rig.guide.scale, abs=5 * solution.guide.scale_sigma)
    assert "mm of the guide apart" in evaluate(session.draft).sentence
    assert advise(session.draft).ghost is not None


@pytest.mark.parametrize("cameras", [True, False])
def test_the_rig_is_solved_with_known_cameras_or_with_its_own(shown, start, rig, simulate, generator, cameras):
    session = start("rig", cameras)
    show(shown, session, rig, simulate, list(simulate.readbacks(rig).values()), generator)
    solved = session.solve()
    hand_eye = solved.solution.calibration.hand_eye
    off = hand_eye.flange_from_camera.translation_mm - rig.flange_from_camera.translation_mm
    assert np.linalg.norm(off) < 5 * np.sqrt(3) * hand_eye.translation_sigma_mm
    assert set(solved.used) == {one.id for one in session.observations}
    verdict = evaluate(session.draft)
    assert "Views of one part fit together" in verdict.sentence
    assert compare(solved.solution.calibration, session.draft).on_part_mm == pytest.approx(0.0, abs=1e-6)


def test_what_was_accepted_is_read_back_and_compared(shown, start, rig, simulate, generator, tmp_path):
    session = start("axis")
    show(shown, session, rig, simulate, chosen(simulate, rig, "axis"), generator)
    accepted = accept(session, tmp_path / "axis.json")
    read = read_result(tmp_path / "axis.json")
    assert values(session, read) == values(session, accepted)
    again = start("axis", name="again")
    show(shown, again, rig, simulate, chosen(simulate, rig, "axis")[1:], generator)
    again.solve()
    comparison = compare(read, again.draft)
    assert comparison.expanded_mm > 0
    with pytest.raises(CalibrationError, match="not one of the rotation axis"):
        compare(HandEye(rig.flange_from_camera), again.draft)
    (tmp_path / "no.json").write_text('{"axis": {}}')
    with pytest.raises(InputError, match="holds no calibration"):
        read_result(tmp_path / "no.json")


def test_the_rig_accepted_into_a_folder_is_read_back(shown, start, rig, simulate, generator, tmp_path):
    session = start("rig")
    show(shown, session, rig, simulate, list(simulate.readbacks(rig).values()), generator)
    accepted = accept(session, tmp_path / "result", valid_days=30)
    read = read_result(tmp_path / "result")
    assert values(session, read) == values(session, accepted)
    assert read.provenance.valid_days == 30
    assert len(read.provenance.inputs) == 3 * len(session.observations)


def test_exchanged_cameras_are_reported_instead_of_solved(shown, start, rig, simulate, generator):
    session = start("axis")
    for readback in chosen(simulate, rig, "axis")[:4]:
        corners = simulate.corners(rig.head, rig.board, rig.camera_from_board(readback), SIGMA_PX, generator)
        shown.add(session, {"left": corners["right"], "right": corners["left"], "upper": corners["upper"]}, readback)
    with pytest.raises(CalibrationError, match="no two cameras are exchanged"):
        session.solve()
    assert any("exchanged" in sentence for sentence in advise(session.draft).sentences)


def test_a_read_back_that_is_missing_is_named(start, shown, rig, simulate, generator):
    session = start("rig")
    corners = simulate.corners(rig.head, rig.board, rig.camera_from_board(chosen(simulate, rig, "axis")[0]), SIGMA_PX, generator)
    with pytest.raises(CalibrationError, match="lacks the robot's pose and the guide's position and the table's angle"):
        shown.add(session, corners)


def test_an_angle_that_contradicts_the_images_is_refused_with_the_observation_s_name(shown, start, rig, simulate, generator):
    session = start("axis")
    readbacks = chosen(simulate, rig, "axis")
    show(shown, session, rig, simulate, readbacks, generator)
    session.remove("01")
    first, wrong = session.observation("02"), session.observation("05")
    assert first.readback.table_rad != wrong.readback.table_rad
    said = replace(wrong.readback, table_rad=wrong.readback.table_rad + np.deg2rad(10.0))
    session._replace(replace(wrong, readback=said))
    with pytest.raises(CalibrationError, match="Position 05 turned by"):
        session.solve()


@pytest.mark.parametrize("kind", ["axis", "guide"])
def test_the_verdict_on_one_link_separates_its_own_contribution_from_that_of_robot_and_hand_eye(
    shown, start, rig, simulate, generator, kind
):
    hand_eye = HandEye(rig.flange_from_camera, rotation_sigma_rad=1e-4, translation_sigma_mm=0.03)
    session = start(kind, hand_eye=hand_eye)
    show(shown, session, rig, simulate, chosen(simulate, rig, kind), generator)
    solution = session.solve().solution
    turn_rad = np.hypot(hand_eye.rotation_sigma_rad, NOISE.robot_rad)
    verdict = evaluate(session.draft)
    if kind == "guide":
        assert solution.guide.direction_sigma_rad > turn_rad  # as it is kept
        assert verdict.robot_adds_mm == pytest.approx(2 * 500.0 * turn_rad)  # k = 2, over a stroke of 500 mm
        own_rad = np.sqrt(solution.guide.direction_sigma_rad**2 - turn_rad**2)
        assert verdict.expanded_mm == pytest.approx(2 * 500.0 * np.hypot(own_rad, solution.guide.scale_sigma))
    else:
        shift_mm = np.linalg.norm([hand_eye.translation_sigma_mm, NOISE.robot_mm, turn_rad * np.linalg.norm(solution.best.axis.point_mm)])
        assert (
            verdict.robot_adds_mm > 0.999 * 2 * 2 * shift_mm
        )  # half a turn shows an axis beside its place twice; a tilt moves points across
        assert verdict.expanded_mm < 2 * 2 * shift_mm
    assert "robot and hand–eye add" in verdict.sentence
    assert "whole rig" in evaluate(session.draft, Limits(verdict.expanded_mm * 1.01, 1.0, "a test")).remedy
    assert CalibrationSession.open(session.folder).setup.hand_eye.rotation_sigma_rad == hand_eye.rotation_sigma_rad


@pytest.mark.parametrize("kind", ["axis", "rig"])
def test_an_accepted_calibration_follows_again_from_the_images_of_its_session(shown, start, rig, simulate, generator, tmp_path, kind):
    session = start(kind, name="sessions/one")
    readbacks = list(simulate.readbacks(rig).values()) if kind == "rig" else chosen(simulate, rig, "axis")
    show(shown, session, rig, simulate, readbacks, generator)
    session.remove("02")
    result = tmp_path / "results" / ("rig" if kind == "rig" else "axis.json")
    accept(session, result, valid_days=30)
    session.undo()  # what is collected afterwards does not matter
    assert is_collected(result)
    again = recalculate_session(result, NoProgress())
    assert again.differences == () and again.numbers > 20
    assert again.images == 3 * (len(readbacks) - 1)
    image = session.observation("03").images["left"].path
    cv2.imwrite(str(image), np.full((972, 1296), 7, np.uint16))
    with pytest.raises(StorageError, match="its checksum differs"):
        recalculate_session(result, NoProgress())
