"""A session of collected observations: kept after every change, undone and redone, and solved again from disk."""

from __future__ import annotations

import json

import numpy as np
import pytest
from recorded import recorded

from measureapp.calibrate.draft.draft import Setup
from measureapp.calibrate.kinds.table import KINDS
from measureapp.calibration_session.recorded import ReadbackFiles, add_recorded
from measureapp.calibration_session.session import CalibrationSession
from measureapp.data.board import CheckerboardDescription
from measureapp.data.calibration import HandEye
from measureapp.errors import CalibrationError, InputError, StorageError
from measureapp.geometry.transform import RigidTransform
from measureapp.project.calibration.board_images import find_board_images
from tests.calibrate.virtual_board import CHECKER, shot
from tests.calibration_session.shown_board import SIGMA_PX


@pytest.fixture
def session(tmp_path, board):
    return CalibrationSession.create(tmp_path / "session", Setup(KINDS["cameras"], board, ("left", "right", "upper")))


def fill(session, shown, head, board, simulate, generator, views):
    for _ in range(views):
        shown.add(session, simulate.corners(head, board, simulate.board_pose(generator), SIGMA_PX, generator))


def test_what_is_collected_is_there_when_the_session_is_opened_again(session, shown, head, board, simulate, generator):
    fill(session, shown, head, board, simulate, generator, 4)
    session.remove("02")
    again = CalibrationSession.open(session.folder)
    assert [one.status for one in again.observations] == ["new", "removed", "new", "new"]
    for mine, theirs in zip(session.observations, again.observations, strict=True):
        for camera, found in mine.seen.items():
            np.testing.assert_array_equal(found.corners_px, theirs.seen[camera].corners_px)
            np.testing.assert_array_equal(mine.images[camera].pixels(), theirs.images[camera].pixels())
    assert again.setup.board == board
    assert again.snapshot().can_undo
    assert not again.snapshot().can_redo
    again.undo()
    assert CalibrationSession.open(session.folder).observation("02").status == "new"


def test_undo_and_redo_walk_through_every_change_and_a_new_one_ends_the_redoing(session, shown, head, board, simulate, generator):
    fill(session, shown, head, board, simulate, generator, 3)
    session.remove("01")
    session.undo()
    session.undo()
    assert [one.id for one in session.observations] == ["01", "02"]
    session.redo()
    assert [one.id for one in session.observations] == ["01", "02", "03"]
    fill(session, shown, head, board, simulate, generator, 1)
    assert [one.id for one in session.observations] == ["01", "02", "03", "04"]
    with pytest.raises(InputError, match="nothing to redo"):
        session.redo()
    for _ in range(4):
        session.undo()
    with pytest.raises(InputError, match="nothing to undo"):
        session.undo()


def test_an_image_without_a_usable_board_is_kept_with_its_cause_and_the_other_cameras_count(
    session, shown, head, board, simulate, generator
):
    fill(session, shown, head, board, simulate, generator, 4)
    corners = simulate.corners(head, board, simulate.board_pose(generator), SIGMA_PX, generator)
    part = shown.add(session, corners | {"upper": "blurred"})
    none = shown.add(session, dict.fromkeys(corners, "over-exposed"))
    assert part.status == "new"
    assert part.refused["upper"].cause == "blurred"
    assert none.status == "no board"
    assert "over-exposed" in none.reason
    solved = session.solve()
    assert part.id in solved.used
    assert none.id not in solved.of
    assert set(session.observation(part.id).residuals_px) == {"left", "right"}


@pytest.mark.parametrize(
    ("cause", "image"),
    [
        ("over-exposed", lambda: shot(CHECKER, exposure_us=900_000).image),
        ("too dark", lambda: shot(CHECKER, exposure_us=2_000).image),
        ("part", lambda: _covered(shot(CHECKER).image)),
        ("wrong board", lambda: shot(CheckerboardDescription(columns=9, rows=6, square_mm=20.0), 30, 10, 70).image),
        ("blurred", lambda: _blurred(shot(CHECKER).image)),
    ],
)
def test_each_bad_image_is_refused_by_its_name(tmp_path, cause, image):
    session = CalibrationSession.create(tmp_path / "session", Setup(KINDS["cameras"], CHECKER, ("left",)))
    observation = session.add({"left": image()})
    assert observation.refused["left"].cause == cause, observation.reason
    assert observation.refused["left"].hint


def _covered(image):
    covered = image.copy()
    covered[:, image.shape[1] // 2 :] = 60
    return covered


def _blurred(image):
    import cv2

    return cv2.GaussianBlur(image, (0, 0), 7)


def test_the_same_image_cannot_count_twice(tmp_path):
    session = CalibrationSession.create(tmp_path / "session", Setup(KINDS["cameras"], CHECKER, ("left",)))
    image = shot(CHECKER).image
    session.add({"left": image})
    with pytest.raises(InputError, match="the same as in observation 01"):
        session.add({"left": image})
    assert len(list((session.folder / "images").glob("*.png"))) == 1
    session.remove("01")
    assert session.add({"left": image}).id == "02"  # stored once, counted once
    assert len(list((session.folder / "images").glob("*.png"))) == 1


def test_an_image_of_another_size_or_camera_is_refused(session, shown, head, board, simulate, generator):
    fill(session, shown, head, board, simulate, generator, 1)
    with pytest.raises(InputError, match="1296 × 972 px are expected"):
        session.add({"left": np.zeros((10, 20), np.uint8)})
    with pytest.raises(InputError, match="no camera 'middle'"):
        session.add({"middle": np.zeros((972, 1296), np.uint8)})


def test_a_session_is_not_started_over_something_else_and_a_damaged_one_is_named(session):
    with pytest.raises(InputError, match="not an empty folder"):
        CalibrationSession.create(session.folder, session.setup)
    with pytest.raises(InputError, match="no calibration session"):
        CalibrationSession.open(session.folder / "images")
    document = json.loads((session.folder / "session.json").read_text())
    (session.folder / "session.json").write_text(json.dumps(document | {"done": 5}))
    with pytest.raises(StorageError, match=r"session\.json"):
        CalibrationSession.open(session.folder)


def test_solving_while_collecting_gives_what_solving_afresh_gives(session, shown, head, board, simulate, generator):
    fill(session, shown, head, board, simulate, generator, 6)
    session.solve()
    fill(session, shown, head, board, simulate, generator, 4)
    warm = session.solve().solution
    cold = session.solve(afresh=True).solution
    for name, camera in cold.calibration.cameras.items():  # both stop far below the noise
        sigma = camera.standard_deviations["fx"]
        assert abs(camera.pinhole.matrix[0, 0] - warm.calibration.cameras[name].pinhole.matrix[0, 0]) < 0.1 * sigma
    assert warm.joint_rms_px == pytest.approx(cold.joint_rms_px, rel=1e-3)


def test_a_view_whose_board_moved_between_the_cameras_is_rejected_with_the_reason(session, shown, head, board, simulate, generator):
    fill(session, shown, head, board, simulate, generator, 7)
    still = simulate.corners(head, board, simulate.board_pose(generator), SIGMA_PX, generator)
    moved = simulate.corners(head, board, simulate.board_pose(generator), SIGMA_PX, generator)
    odd = shown.add(session, {"left": still["left"], "right": moved["right"]})
    solved = session.solve()
    judged = session.observation(odd.id)
    assert judged.status == "rejected" or len(judged.residuals_px) == 1
    assert "different board position" in judged.reason or "moved" in judged.reason, judged.reason
    assert len(solved.used) >= 7


def test_too_few_observations_say_what_is_missing(session, shown, head, board, simulate, generator):
    with pytest.raises(CalibrationError, match="not detected yet"):
        session.solve()
    fill(session, shown, head, board, simulate, generator, 2)
    with pytest.raises(CalibrationError, match="at least 3"):
        session.solve()
    assert any("1 more views are needed" in sentence for sentence in session.draft.shortfalls)


def test_a_symmetric_board_is_refused_before_anything_is_collected():
    with pytest.raises(CalibrationError, match="half a turn"):
        Setup(KINDS["cameras"], CheckerboardDescription(columns=9, rows=7, square_mm=10.0), ("left", "right"))


def test_the_recorded_pairs_collected_give_the_published_baseline(tmp_path):
    folder = recorded("opencv_stereo")
    board = CheckerboardDescription(columns=9, rows=6, square_mm=1.0)
    session = CalibrationSession.create(tmp_path / "session", Setup(KINDS["cameras"], board, ("left", "right")))
    images = find_board_images([f"{camera}={folder}/{camera}??.jpg" for camera in ("left", "right")])
    assert len(add_recorded(session, images, ReadbackFiles())) == 13
    assert add_recorded(session, images, ReadbackFiles()) == ()  # they are there already
    solved = session.solve()
    assert np.linalg.norm(solved.cameras.cameras["right"].reference_from_camera.translation_mm) == pytest.approx(3.328, abs=0.02)
    assert solved.solution.joint_rms_px < 0.30


def test_recorded_pairs_with_wrongly_refined_corners_are_rejected_with_the_reason(tmp_path, monkeypatch):
    """With a window of 11 px, corners of two of the views are drawn to the neighbouring squares; the views are found and left out."""
    import cv2

    from measureapp.calibrate.sightings import Sighting
    from measureapp.calibration_session import detection

    def wide(image, board):
        _, corners = cv2.findChessboardCorners(image, (board.columns, board.rows))
        corners = cv2.cornerSubPix(image, corners, (11, 11), (-1, -1), (3, 30, 0.01)).reshape(-1, 2)
        return Sighting("", "", corners.astype(float), sigma_px=np.full(board.count, 0.1), edge_px=2.5)

    monkeypatch.setattr(detection, "find_board", wide)
    folder = recorded("opencv_stereo")
    board = CheckerboardDescription(columns=9, rows=6, square_mm=1.0)
    session = CalibrationSession.create(tmp_path / "session", Setup(KINDS["cameras"], board, ("left", "right")))
    add_recorded(session, find_board_images([f"{camera}={folder}/{camera}??.jpg" for camera in ("left", "right")]), ReadbackFiles())
    session.solve()
    wrong = {one.id for one in session.observations if "found in a wrong place" in one.reason}
    assert wrong == {"02", "05"}
    assert session.observation("02").status == "rejected"  # in both cameras
    assert set(session.observation("05").residuals_px) == {"left"}


def test_a_session_of_the_first_version_opens_with_its_hand_eye_transform(tmp_path, board, head):
    transform = RigidTransform.from_vector([0.0, 0.3, 0.0], [-174.2, 1.3, 81.2], "flange", "camera")
    session = CalibrationSession.create(
        tmp_path / "s", Setup(KINDS["guide"], board, ("left", "right", "upper"), head, HandEye(transform, 1e-4, 0.02))
    )
    stored = session.folder / "session.json"
    document = json.loads(stored.read_text(encoding="utf-8"))
    kept = document.pop("hand_eye")
    stored.write_text(json.dumps(document | {"schema_version": 1, "flange_from_camera": kept["flange_from_camera"]}), encoding="utf-8")
    known = CalibrationSession.open(session.folder).setup.hand_eye
    assert np.allclose(known.flange_from_camera.matrix, transform.matrix)
    assert known.rotation_sigma_rad == 0.0
