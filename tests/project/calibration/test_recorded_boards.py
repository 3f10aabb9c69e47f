"""Recorded images of the board are taken apart into cameras and positions, however they are named."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest

from measureapp.arrays import processors
from measureapp.data.board import BoardView
from measureapp.data.conditions import Conditions
from measureapp.data.fringe import AxisReadback
from measureapp.errors import InputError
from measureapp.geometry.transform import RigidTransform
from measureapp.progress import Cancelled, NoProgress
from measureapp.project.calibration import board_views
from measureapp.project.calibration.recorded_boards import cameras_of, find_recorded


def touch(folder: Path, *names: str) -> Path:
    for name in names:
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        cv2.imwrite(str(path), np.zeros((4, 6), np.uint8))
    return folder


@pytest.mark.parametrize(
    "names",
    [
        ("left01.png", "left02.png", "left10.png", "right01.png", "right02.png", "right10.png"),
        ("left_01.jpg", "left_02.jpg", "left_10.jpg", "right_01.jpg", "right_02.jpg", "right_10.jpg"),
        ("left/01.png", "left/02.png", "left/10.png", "right/01.png", "right/02.png", "right/10.png"),
        ("left/left01.png", "left/left02.png", "left/left10.png", "right/right01.png", "right/right02.png", "right/right10.png"),
    ],
)
def test_images_belong_together_by_their_number(tmp_path, names):
    found = find_recorded(touch(tmp_path, *names))
    assert cameras_of(found) == ("left", "right")
    assert [position.name for position in found] == ["01", "02", "10"]
    assert all(set(position.files) == {"left", "right"} for position in found)


def test_an_image_of_one_camera_may_be_missing_and_other_files_are_passed_over(tmp_path):
    (touch(tmp_path, "left01.png", "left02.png", "right02.png") / "notes.txt").write_text("lamp on", encoding="utf-8")
    assert [set(position.files) for position in find_recorded(tmp_path)] == [{"left"}, {"left", "right"}]


def test_numbers_alone_are_one_camera(tmp_path):
    assert cameras_of(find_recorded(touch(tmp_path, "1.png", "2.png"))) == ("camera",)


def test_what_a_project_keeps_comes_with_its_read_backs(tmp_path):
    readback = AxisReadback(RigidTransform.identity("base", "flange"), 12.5, 0.25)
    board_views.save(tmp_path, BoardView("pose01", {"left": np.zeros((4, 6), np.uint8)}, readback))
    (position,) = find_recorded(tmp_path)
    assert (position.name, position.readback.guide_mm, position.readback.table_rad) == ("pose01", 12.5, 0.25)
    assert position.files["left"].is_file()


def test_what_a_project_keeps_comes_in_the_order_it_was_taken(tmp_path):
    """A robot that went to and fro came to each pose anew, with another error: by name its two visits of "station1" would look like one."""
    for second, name in enumerate(("station1-1", "station2-1", "station1-2")):
        readback = AxisReadback(RigidTransform.identity("base", "flange"), float(second), 0.0)
        taken = Conditions(f"2031-05-01T10:00:00.{second}50+02:00")
        board_views.save(tmp_path, BoardView(name, {"left": np.zeros((4, 6), np.uint8)}, readback, taken))
    assert [one.name for one in find_recorded(tmp_path)] == ["station1-1", "station2-1", "station1-2"]
    assert [one.viewpoint_id for one in board_views.load_all(tmp_path)] == ["station1-1", "station2-1", "station1-2"]


def test_reading_what_a_project_keeps_can_be_cancelled_between_two_views(tmp_path):
    readback, checks = AxisReadback(RigidTransform.identity("base", "flange"), 0.0, 0.0), []

    class CancelledFromTheSecond(NoProgress):
        def check(self) -> None:
            checks.append("")
            if len(checks) >= 2:
                raise Cancelled

    for number in range(20):
        board_views.save(tmp_path, BoardView(f"pose{number}", {"left": np.zeros((4, 6), np.uint8)}, readback))
    with pytest.raises(Cancelled):
        board_views.load_all(tmp_path, CancelledFromTheSecond())
    assert 2 <= len(checks) <= 1 + processors()  # each thread ends at its next view


@pytest.mark.parametrize(
    "names, said", [((), "There are no images in"), (("left01.png", "left_01.png"), "are both image 01 of camera left")]
)
def test_a_folder_that_cannot_be_understood_is_refused(tmp_path, names, said):
    with pytest.raises(InputError, match=said) as refused:
        find_recorded(touch(tmp_path, *names))
    assert "left01.png" in refused.value.hint


def test_a_folder_that_is_not_there_is_named(tmp_path):
    with pytest.raises(InputError, match="There is no folder"):
        find_recorded(tmp_path / "nothing")
