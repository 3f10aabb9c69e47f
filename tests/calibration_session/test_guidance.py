"""What the coach asks for, in situations made to lack one thing."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from measureapp.calibrate.draft.advice import outline_px
from measureapp.calibrate.draft.draft import Setup
from measureapp.calibrate.guidance.advise import advise
from measureapp.calibrate.guidance.next_view import best_view, candidates, gain_of
from measureapp.calibrate.kinds.table import KINDS
from measureapp.calibration_session.session import CalibrationSession
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration, HandEye
from measureapp.data.fringe import AxisReadback, Readback
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform, rotation_about
from tests.calibration_session.shown_board import SIGMA_PX

WIDTH, HEIGHT, FOCAL = 1296, 972, 2045.0
LENS = PinholeCamera(WIDTH, HEIGHT, np.array([[FOCAL, 0, 648.0], [0, FOCAL, 486.0], [0, 0, 1]]), np.array([-0.1, 0.05, 0, 0, 0]))
ALL_TILTS = ((0.45, 0), (-0.45, 0), (0, 0.45), (0, -0.45))  # of the board about the camera's x and y, rad
EVERYWHERE = tuple(itertools.product((-1, 0, 1), (-1, 0, 1)))


@pytest.fixture
def one_camera(tmp_path, board):
    return CalibrationSession.create(tmp_path / "session", Setup(KINDS["cameras"], board, ("left",)))


def place(board, at, tilt, distance_mm=800.0, roll=0.1):
    """A board whose middle lies at thirds of the image, turned about x and y of the camera."""
    turn = rotation_about([1, 0, 0], tilt[0]) @ rotation_about([0, 1, 0], tilt[1]) @ rotation_about([0, 0, 1], roll)
    middle = np.array([at[0] * 150.0, at[1] * 105.0, 1.0 * distance_mm])
    return RigidTransform.from_parts(turn, middle - turn @ board.middle_mm, "camera", "board")


def show(shown, collection, poses, generator):
    board = collection.setup.board
    for pose in poses:
        pixels = LENS.project(pose.apply(board.corners_mm)) + generator.normal(scale=SIGMA_PX, size=(board.count, 2))
        shown.add(collection, {"left": pixels})


def asked(collection):
    return " | ".join(advise(collection.draft).sentences)


def full_set(board):
    """Views that lack nothing: every place, every tilt, two distances."""
    tilts = itertools.cycle(ALL_TILTS)
    return [place(board, at, next(tilts), 700.0 if number % 2 else 850.0) for number, at in enumerate((*EVERYWHERE, (0, 0)))]


def test_a_full_set_of_views_leaves_nothing_to_ask(shown, one_camera, board, generator):
    show(shown, one_camera, full_set(board), generator)
    advice = advise(one_camera.draft)
    assert advice.enough, advice.sentences
    assert all(gauge.reached for gauge in advice.gauges), advice.gauges


@pytest.mark.parametrize(
    ("column", "row", "wanted"),
    [
        (-1, None, "on the right side"),
        (1, None, "on the left side"),
        (None, -1, "in the lower part"),
        (None, 1, "in the upper part"),
    ],
)
def test_a_board_shown_only_at_one_side_is_asked_for_at_the_other(shown, one_camera, board, generator, column, row, wanted):
    spots = [(column if column is not None else at[0], row if row is not None else at[1]) for at in EVERYWHERE]
    near_edge = 1.35  # beyond the thirds, so that the middle of the image stays free of it
    spots = [(x * near_edge if column is not None else x, y * near_edge if row is not None else y) for x, y in spots]
    show(
        shown, one_camera, [place(board, at, tilt, 1100.0) for at, tilt in zip(spots, itertools.cycle(ALL_TILTS), strict=False)], generator
    )
    assert f"Show the board {wanted} of the image" in asked(one_camera)


@pytest.mark.parametrize(
    ("corner", "wanted"),
    [
        ((1, -1), "upper right corner"),
        ((-1, -1), "upper left corner"),
        ((1, 1), "lower right corner"),
        ((-1, 1), "lower left corner"),
    ],
)
def test_the_only_corner_without_the_board_is_asked_for(shown, one_camera, board, generator, corner, wanted):
    far = 1200.0  # so small that it lies in one corner's cells only
    spots = [at for at in itertools.product((-2.2, 0, 2.2), (-2.2, 0, 2.2)) if (np.sign(at[0]), np.sign(at[1])) != corner]
    middle = [at for at in spots if abs(corner[0] - np.sign(at[0])) + abs(corner[1] - np.sign(at[1])) > 1]
    show(shown, one_camera, [place(board, at, tilt, far) for at, tilt in zip(middle, itertools.cycle(ALL_TILTS), strict=False)], generator)
    assert f"Show the board in the {wanted} of the image" in asked(one_camera)


@pytest.mark.parametrize(
    ("missing", "wanted"),
    [
        ((-0.45, 0), "upwards (its upper edge away"),
        ((0.45, 0), "downwards (its lower edge away"),
        ((0, 0.45), "to the left (its left edge away"),
        ((0, -0.45), "to the right (its right edge away"),
    ],
)
def test_the_tilt_that_was_never_shown_is_asked_for_and_named_by_the_edge_that_moves_away(
    shown, one_camera, board, generator, missing, wanted
):
    others = [tilt for tilt in ALL_TILTS if tilt != missing]
    poses = [place(board, at, tilt) for at, tilt in zip(EVERYWHERE, itertools.cycle(others), strict=False)]
    show(shown, one_camera, poses, generator)
    assert f"Tilt the board more {wanted} from the camera)" in asked(one_camera)
    tilted = place(board, (0, 0), missing, roll=0.0)  # the words checked against the geometry
    corners = tilted.apply(board.corners_mm)[:, 2].reshape(board.rows, board.columns)
    away = {"upper": corners[0].mean(), "lower": corners[-1].mean(), "left": corners[:, 0].mean(), "right": corners[:, -1].mean()}
    assert max(away, key=away.get) == wanted.split("its ")[1].split()[0]


def test_views_at_one_distance_ask_for_nearer_and_farther_ones(shown, one_camera, board, generator):
    poses = [place(board, at, tilt, 800.0) for at, tilt in zip(EVERYWHERE, itertools.cycle(ALL_TILTS), strict=False)]
    show(shown, one_camera, poses, generator)
    assert "once 8% nearer to the camera and once 8% farther away" in asked(one_camera)
    show(shown, one_camera, [place(board, (0, 0), (0.3, 0), 860.0)], generator)
    assert "Hold the board nearer to the camera" in asked(one_camera)


def test_a_wish_of_one_of_several_cameras_names_it(shown, tmp_path, head, board, simulate, generator):
    session = CalibrationSession.create(tmp_path / "session", Setup(KINDS["cameras"], board, ("left", "right")))
    for _ in range(4):
        corners = simulate.corners(head, board, simulate.board_pose(generator), SIGMA_PX, generator)
        shown.add(session, {"left": corners["left"]})
    text = asked(session)
    assert "Show the board where cameras left and right both see it, 5 more times" in text


def test_before_the_solution_the_outline_lies_where_the_board_is_asked_for(shown, one_camera, board, generator):
    spots = [(-1.5, -1), (-1.5, 0), (-1.5, 1)]
    show(shown, one_camera, [place(board, at, tilt, 1100.0) for at, tilt in zip(spots, ALL_TILTS, strict=False)], generator)
    advice = advise(one_camera.draft)
    assert "on the right side" in " ".join(advice.sentences)
    assert advice.ghost.outlines_px["left"][:, 0].min() > WIDTH / 3
    assert advice.ghost.outlines_px["left"][:, 0].max() < WIDTH


def test_no_outline_is_drawn_where_the_distortion_found_turns_back_on_itself(board):
    """With k3 = -60 the radius in the image is largest where the ray is at r = (7 * 60) ** (-1 / 6) = 0.365 and falls beyond."""
    folding = PinholeCamera(WIDTH, HEIGHT, LENS.matrix * [[0.6, 0, 1], [0, 0.6, 1], [0, 0, 1]], np.array([0, 0, 0, 0, -60.0]))
    assert outline_px(folding, place(board, (0, 0), (0, 0), 700.0), board) is not None
    assert outline_px(folding, place(board, (1.6, 0), (0, 0), 700.0), board) is None


def test_the_proposed_view_shrinks_the_uncertainty_more_than_most_others(shown, one_camera, board, generator):
    """The promised gain is the real one: solved again with the view, the confidence ellipsoid has shrunk by it."""
    flat = [place(board, (0.2 * k, 0.1 * k), (0.1, 0.05 * k)) for k in range(-2, 3)]
    show(shown, one_camera, flat, generator)
    before = one_camera.solve().solution
    proposed = best_view(before, 800.0, before.calibration.names)
    gains = [gain_of(before, one, before.calibration.names) for one in candidates(before, 800.0, before.calibration.names)]
    assert gain_of(before, proposed, before.calibration.names) == max(gains)
    show(shown, one_camera, [proposed], generator)
    after = one_camera.solve(afresh=True).solution
    lens = slice(0, 9)
    shrunk = np.linalg.slogdet(before.covariance[lens, lens])[1] - np.linalg.slogdet(after.covariance[lens, lens])[1]
    noise = 2 * 9 * np.log(before.sigma_px / after.sigma_px)  # the estimated noise scales both covariances
    assert shrunk - noise == pytest.approx(max(gains), rel=0.25)


# axes


@pytest.fixture
def single():
    return CameraArrayCalibration("left", {"left": CameraCalibration("left", LENS, RigidTransform.identity("camera", "left"))})


def turned_views(shown, session, single, board, angles_deg, generator, read=True):
    axis = np.array([0.0, -0.8, -0.6])
    for angle in angles_deg:
        turn = rotation_about(axis, np.deg2rad(angle))
        centre = np.array([0.0, 20.0, 900.0])
        start = place(board, (0, 0), (0.5, 0), 880.0)
        pose = RigidTransform.from_parts(turn, centre - turn @ centre, "camera", "camera") @ start
        pixels = LENS.project(pose.apply(board.corners_mm)) + generator.normal(scale=SIGMA_PX, size=(board.count, 2))
        shown.add(session, {"left": pixels}, Readback(table_rad=float(np.deg2rad(angle)) if read else None))


def test_a_short_sweep_asks_for_positions_beyond_its_end(shown, tmp_path, single, board, generator):
    session = CalibrationSession.create(tmp_path / "session", Setup(KINDS["axis"], board, ("left",), cameras=single))
    turned_views(shown, session, single, board, (-30, -15, 0, 30, 60), generator)
    assert "Turn the table further: two more positions beyond −30°" in asked(session)
    session.solve()
    ghost = advise(session.draft).ghost
    assert np.rad2deg(ghost.table_rad) < -30  # the end that has room
    assert set(ghost.outlines_px) == {"left"}


def test_the_outline_for_the_axis_is_where_the_board_then_appears(shown, tmp_path, single, board, generator):
    session = CalibrationSession.create(tmp_path / "session", Setup(KINDS["axis"], board, ("left",), cameras=single))
    turned_views(shown, session, single, board, (0, 10, 20, 30), generator)
    session.solve()
    ghost = advise(session.draft).ghost
    turned_views(shown, session, single, board, [np.rad2deg(ghost.table_rad)], generator)
    seen = session.observations[-1].seen["left"].corners_px
    outline = ghost.outlines_px["left"]
    np.testing.assert_allclose([outline[:, 0].min(), outline[:, 0].max()], [seen[:, 0].min(), seen[:, 0].max()], atol=3.0)


def test_a_wide_gap_between_table_positions_is_named(shown, tmp_path, single, board, generator):
    session = CalibrationSession.create(tmp_path / "session", Setup(KINDS["axis"], board, ("left",), cameras=single))
    turned_views(shown, session, single, board, (-60, -50, -40, 50, 60), generator)
    assert "Add a position near 5°: there is none between -40° and 50°" in asked(session)


def test_poses_turned_about_one_axis_ask_for_the_others(shown, tmp_path, single, board, generator):
    session = CalibrationSession.create(tmp_path / "session", Setup(KINDS["hand-eye"], board, ("left",), cameras=single))
    flange = RigidTransform.from_vector([0.1, 0.2, 0.3], [500, 0, 700], "base", "flange")
    for roll in np.linspace(-0.6, 0.6, 5):
        pixels = LENS.project(place(board, (0, 0), (0.2, 0), 800.0, roll).apply(board.corners_mm))
        shown.add(session, {"left": pixels}, Readback(base_from_flange=flange))
    text = asked(session)
    assert "View the board from higher up and from lower down" in text
    assert "View the board more from the left and from the right" in text
    assert "Roll the camera" not in text


def test_a_short_travel_of_the_guide_asks_for_more_and_for_a_robot_that_stands_still(shown, tmp_path, single, board, generator):
    setup = Setup(KINDS["guide"], board, ("left",), cameras=single, hand_eye=HandEye(RigidTransform.identity("flange", "camera")))
    session = CalibrationSession.create(tmp_path / "session", setup)
    for slide in (0.0, 20.0, 40.0):
        pixels = LENS.project(place(board, (slide / 200, 0), (0.2, 0)).apply(board.corners_mm))
        flange = RigidTransform.from_vector([0.1, 0.2, 0.3], [500, slide / 10, 700], "base", "flange")
        shown.add(session, {"left": pixels}, AxisReadback(flange, slide, 0.0))
    text = asked(session)
    assert "Move the guide further: two more positions beyond 0 mm" in text
    assert "Keep the robot still" in text
