"""One link of a rig from recorded images, with tables that tell where the axes stood."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from measureapp.acquire.engine import Engine
from measureapp.acquire.tasks.board import BoardTask
from measureapp.planning.calibration_views import calibration_viewpoints
from measureapp.progress import NoProgress
from measureapp.project.rig_file import read_rig
from tests.ui.board_pictures import BOARD, record
from ui.controllers.rig_connection import connect, truth_of
from ui.wizards.wizard import COLLECT, SETUP

PATIENCE_MS = 120_000
POSES = 6


@pytest.fixture(scope="module")
def filmed(tmp_path_factory):
    """Return a folder with images and robot poses of the virtual rig, and its true calibration."""
    from measureapp.simulate.world import PAPER_BOARD

    folder = tmp_path_factory.mktemp("hand_eye")
    rig = read_rig("paper").at_resolution("quarter")
    connection = connect(rig, PAPER_BOARD)
    lines = ["name,x_mm,y_mm,z_mm,qw,qx,qy,qz"]
    viewpoints = calibration_viewpoints(rig, motions=("robot",), guide_at_zero=True)[:POSES]
    views = []
    Engine(connection.rig).run("board", viewpoints, BoardTask(views.append), lambda event: None, NoProgress())
    for number, (viewpoint, view) in enumerate(zip(viewpoints, views, strict=True), start=1):
        for camera, pixels in view.images.items():
            cv2.imwrite(str(folder / f"{camera}{number:02d}.png"), pixels)
        pose = viewpoint.flange
        lines.append(",".join([f"p{number:02d}", *(repr(value) for value in (*pose.position_mm, *pose.quaternion_wxyz))]))
    (folder / "poses.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    connection.rig.close()
    return folder, truth_of(rig, PAPER_BOARD)


@pytest.fixture
def opened(application, window, rig):
    """Return a function that opens a wizard with recorded images as its source."""
    wizards = []

    def made(kind, calibration):
        application.session.set_rig(rig)
        application.session.set_calibration(calibration)
        page = window.pages["calibration"]
        page.open_wizard(kind)
        wizards.append(page.wizards[kind])
        wizards[-1].setup.source.setValue("images")
        return wizards[-1]

    yield made
    for wizard in wizards:
        wizard.close()


def test_hand_eye_is_found_from_a_folder_of_images_and_a_table_of_robot_poses(qtbot, opened, filmed):
    folder, truth = filmed
    wizard = opened("hand-eye", truth)
    wizard.setup.folder.setValue(folder)
    wizard.setup.tables["base_from_flange"].setValue(folder / "poses.csv")
    wizard.footer.primary.click()
    assert wizard.step == COLLECT, wizard.footer.message.words.text()
    collecting = wizard.collecting
    qtbot.waitUntil(lambda: not (collecting.is_collecting or collecting.solver.is_running), timeout=PATIENCE_MS)
    assert len(collecting.views) == POSES
    found = collecting.solver.interim.solved.solution.hand_eye
    apart = found.flange_from_camera.inverse() @ truth.hand_eye.flange_from_camera
    assert np.linalg.norm(apart.translation_mm) < 5 * found.translation_sigma_mm


@pytest.mark.parametrize(
    ("table", "said"),
    [
        (None, "The images have no read-back of: the robot's pose"),
        ("nonsense", "poses.csv"),
        ("name,x_mm,y_mm,z_mm,qw,qx,qy,qz\na,450,2,500,1,0,0,0\n", "has 1 lines for 3 board positions"),
    ],
)
def test_a_table_that_is_missing_or_rubbish_is_said_and_nothing_begins(opened, calibration, tmp_path, table, said):
    wizard = opened("hand-eye", calibration)
    wizard.setup.board.setValue(BOARD)
    wizard.setup.folder.setValue(record(tmp_path / "images", 3))
    if table is not None:
        (tmp_path / "poses.csv").write_text(table, encoding="utf-8")
        wizard.setup.tables["base_from_flange"].setValue(tmp_path / "poses.csv")
    wizard.footer.primary.click()
    words = wizard.footer.message.words.text()
    assert said in words
    assert words.count(".") >= 2  # what happened, and what to do
    assert wizard.step == SETUP
    assert wizard.collecting.kept() is None


def test_the_whole_rig_asks_for_every_axis(opened, calibration, tmp_path):
    wizard = opened("rig", calibration)
    wizard.setup.board.setValue(BOARD)
    wizard.setup.folder.setValue(record(tmp_path / "images", 3))
    wizard.footer.primary.click()
    assert "the robot's pose, the guide's position, the table's angle" in wizard.footer.message.words.text()
