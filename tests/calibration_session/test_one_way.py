"""One way to calibrate: command line, wizard and automatic run give the same estimates and standard deviations from the same images."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import numpy as np
import pytest
from found_boards import found_once
from recording_export import views_named

from measureapp.calibrate.draft.draft import Known, Setup
from measureapp.calibrate.kinds.table import KINDS
from measureapp.calibrate.motions.axis_noise import AxisNoise, expected_noise
from measureapp.calibration_session.recorded import add_views
from measureapp.calibration_session.session import CalibrationSession
from measureapp.cli import main
from measureapp.pipeline.calibrate import calibrate_from_views
from measureapp.progress import NoProgress
from measureapp.project.calibration.camera_file import read_cameras, write_cameras
from measureapp.project.calibration.recorded_boards import find_recorded
from measureapp.project.tables import write_poses

VIEWS = (
    *(f"pose{number:02d}" for number in (1, 3, 5, 7, 9, 12, 15, 18, 21, 23)),
    "axis01",
    "axis05",
    "axis09",
    "axis13",
    "guide01",
    "guide06",
    "guide11",
)
NOISE = {"--robot-sigma-mm": "0.2", "--robot-sigma-deg": "0.012", "--robot-repeat-mm": "0.01", "--robot-alike-mm": "300"}


@pytest.fixture(scope="module", autouse=True)
def _boards_are_found_once():
    with found_once():
        yield


@pytest.fixture(scope="module")
def filmed(demo, tmp_path_factory):
    """Views of the board as a project keeps them, in one folder for each camera, with tables of the read-backs."""
    folder = tmp_path_factory.mktemp("filmed")
    chosen = list(views_named(demo.project, VIEWS))
    recorded = {one.name: one for one in find_recorded(demo.folder / "calibration" / "views")}
    for number, view in enumerate(chosen):
        for camera, path in recorded[view.viewpoint_id].files.items():
            (folder / camera).mkdir(exist_ok=True)
            (folder / camera / f"{number:02d}.png").write_bytes(Path(path).read_bytes())
    names = [f"{number:02d}" for number in range(len(chosen))]
    write_poses(folder / "robot.csv", {name: view.readback.base_from_flange for name, view in zip(names, chosen, strict=True)})
    tables = {
        "guide.csv": ("name", "position_mm", [repr(float(view.readback.guide_mm)) for view in chosen]),
        "angles.csv": ("position", "angle_deg", [repr(float(np.rad2deg(view.readback.table_rad))) for view in chosen]),
    }
    for name, (first, second, values) in tables.items():
        with (folder / name).open("w", newline="") as file:
            csv.writer(file).writerows([(first, second), *zip(names, values, strict=True)])
    return folder, chosen


@pytest.fixture(scope="module")
def solved_rigs(demo, filmed, tmp_path_factory):
    """The rig by the automatic run, and by a session as a wizard collects it."""
    views, rig, board = filmed[1], demo.project.rig(), demo.project.settings.board
    names = tuple(camera.name for camera in rig.cameras)
    setup = Setup.on_rig(KINDS["rig"], board, names, Known(), rig)
    return calibrate_from_views(views, board, rig, NoProgress()), as_wizard(tmp_path_factory.mktemp("whole") / "session", setup, views)


def run(capsys, *arguments):
    code = main(["calibrate", *map(str, arguments), "--json"])
    answer = json.loads(capsys.readouterr().out)
    assert code in (0, 1), answer
    return answer


def images(folder):
    return [part for camera in ("left", "right", "upper") for part in ("--images", f"{camera}={folder / camera}/*.png")]


def board_options(board):
    return ["--board", f"{board.columns}x{board.rows}", "--square-mm", repr(board.square_mm)]


def as_wizard(folder, setup, views):
    """Collect views one after the other and solve, as a wizard does."""
    session = CalibrationSession.create(folder, setup)
    for view in views:
        session.add(view.images, view.readback)
    session.identify_parts()
    session.solve_with_parts(afresh=True)
    return session


def test_the_automatic_run_and_a_session_give_the_same_rig(solved_rigs):
    automatic, session = solved_rigs
    found = session.solved.solution
    assert found.parameters == automatic.parameters
    np.testing.assert_array_equal(found.covariance, automatic.covariance)
    kind = KINDS["rig"]
    for mine, theirs in zip(kind.estimates(found.calibration), kind.estimates(automatic.calibration), strict=True):
        assert (mine.value, mine.sigma) == (theirs.value, theirs.sigma), mine.name


def test_cameras_by_command_by_session_and_by_the_automatic_run_are_the_same(demo, filmed, solved_rigs, tmp_path, capsys):
    folder, views = filmed
    automatic, whole = solved_rigs
    board = demo.project.settings.board
    run(capsys, "cameras", *images(folder), *board_options(board), "--out", tmp_path / "cameras.json")
    session = as_wizard(tmp_path / "session", Setup(KINDS["cameras"], board, whole.setup.camera_names), views)
    found = (read_cameras(tmp_path / "cameras.json"), session.solved.cameras, automatic.calibration.cameras)
    estimates = [[(one.name, one.value, one.sigma) for one in KINDS["cameras"].estimates(cameras)] for cameras in found]
    assert estimates[0] == estimates[1] == estimates[2]


@pytest.mark.parametrize("kind", ["axis", "hand-eye", "guide", "rig"])
def test_axes_by_command_and_by_session_have_the_same_values_and_standard_deviations(demo, filmed, solved_rigs, tmp_path, capsys, kind):
    """With the covariance of the cameras, which both of them propagate."""
    folder, views = filmed
    board = demo.project.settings.board
    chosen = {"axis": "axis", "hand-eye": "pose", "guide": "guide", "rig": ""}[kind]
    some = [number for number, view in enumerate(views) if view.viewpoint_id.startswith(chosen)]
    known = solved_rigs[0].calibration
    assert known.cameras.covariance is not None
    write_cameras(tmp_path / "cameras.json", known.cameras)
    cut = tmp_path / "cut"
    for camera in ("left", "right", "upper"):
        (cut / camera).mkdir(parents=True)
        for number in some:
            (cut / camera / f"{number:02d}.png").write_bytes((folder / camera / f"{number:02d}.png").read_bytes())
    for table in ("robot.csv", "guide.csv", "angles.csv"):
        rows = (folder / table).read_text().splitlines()
        (cut / table).write_text("\n".join([rows[0], *(rows[number + 1] for number in some)]) + "\n")
    tables = {
        "robot": ["--robot-poses", cut / "robot.csv"],
        "guide": ["--guide-positions", cut / "guide.csv"],
        "angles": ["--angles", cut / "angles.csv"],
    }
    hand_eye = tmp_path / "hand_eye.json"
    hand_eye.write_text(json.dumps({"hand_eye": link(known.hand_eye)}))
    needed = {"axis": ("angles",), "hand-eye": ("robot",), "guide": ("robot", "guide"), "rig": ("robot", "guide", "angles")}[kind]
    options = [*(part for name in needed for part in tables[name]), *(["--hand-eye", hand_eye] if kind == "guide" else [])]
    command = [kind, *images(cut), "--cameras", tmp_path / "cameras.json", *board_options(board), *options]
    answer = run(capsys, *command, "--out", tmp_path / "answer.json")
    collect = [*images(cut), "--cameras", tmp_path / "cameras.json", *board_options(board), *options, "--solve"]
    collected = run(capsys, "collect", kind, "--session", tmp_path / "session", *collect)
    sigmas = {one["name"]: (one["value"], one["standard_deviation"]) for one in collected["estimates"]}
    for name, value, sigma in stated(kind, answer):
        assert sigmas[name][0] == value, name
        assert sigma is None or sigmas[name][1] == sigma, name
    session = CalibrationSession.open(tmp_path / "session")
    read = {one.id: one.readback for one in session.observations}
    setup = Setup(
        KINDS[kind], board, session.setup.camera_names, read_cameras(tmp_path / "cameras.json"), session.setup.hand_eye, session.setup.noise
    )
    wizard = CalibrationSession.create(tmp_path / "wizard", setup)
    for number, one in zip(some, session.observations, strict=True):
        wizard.add(views[number].images, read[one.id])
    solved = wizard.solve()
    by_hand = {one.name: (one.value, one.sigma) for one in setup.kind.estimates(setup.kind.result(solved))}
    assert by_hand == sigmas


def link(hand_eye):
    from measureapp.project.documents import link_document

    return json.loads(json.dumps(link_document(hand_eye), default=lambda value: value.tolist()))


def stated(kind, answer):
    """Return name, value and standard deviation (None where the answer states several) of what both answers have."""
    if kind == "axis":
        best = answer["maximum_likelihood"]
        sigma = np.deg2rad(best["standard_deviations"]["direction_deg"])
        yield from ((f"axis direction {axis}", value, None) for axis, value in zip("xyz", best["direction"], strict=True))
        yield from (
            (f"axis point {axis}", value, best["standard_deviations"]["point_mm"])
            for axis, value in zip("xyz", best["point_mm"], strict=True)
        )
        assert sigma > 0
    elif kind == "guide":
        yield from ((f"guide direction {axis}", value, None) for axis, value in zip("xyz", answer["direction"], strict=True))
        yield "guide scale", answer["scale"], answer["standard_deviations"]["scale"]
    else:
        matrix = np.array(answer["refined"]["flange_from_camera"] if kind == "hand-eye" else answer["flange_from_camera"])
        yield from ((f"camera on the flange, place {axis}", value, None) for axis, value in zip("xyz", matrix[:3, 3], strict=True))


@pytest.mark.slow
def test_views_of_a_project_are_collected_as_its_automatic_run_solves_them(demo, tmp_path):
    """All views, by the way of `calibrate collect --views`: the same rig as the project's own, to the last digit."""
    project = demo.project
    rig = project.rig()
    names = tuple(camera.name for camera in rig.cameras)
    session = CalibrationSession.create(tmp_path / "session", Setup.on_rig(KINDS["rig"], project.settings.board, names, Known(), rig))
    add_views(session, demo.folder / "calibration" / "views")
    session.identify_parts()
    session.solve_with_parts(afresh=True)
    found, kept = session.solved.solution.calibration, project.calibration()
    assert [one.value for one in KINDS["rig"].estimates(found)] == [one.value for one in KINDS["rig"].estimates(kept)]
    assert [one.sigma for one in KINDS["rig"].estimates(found)] == [one.sigma for one in KINDS["rig"].estimates(kept)]
    assert expected_noise(rig) != AxisNoise()
