"""Every calibration takes every kind of board, by the same options."""

from __future__ import annotations

import json

import cv2
import pytest

from measureapp.cli import main
from measureapp.cli.calibrate.options import BoardChoice
from measureapp.data.board import CharucoDescription, CheckerboardDescription, CirclesDescription
from measureapp.errors import InputError
from tests.calibrate.virtual_board import CHARUCO, HALF, shot


def test_the_options_name_every_kind_of_board():
    assert BoardChoice("14x11", 15.0).description() == CheckerboardDescription(columns=14, rows=11, square_mm=15.0)
    charuco = BoardChoice("charuco:14x11", 15.0, marker_mm=11.0, dictionary="DICT_6x6_250").description()
    assert charuco == CharucoDescription(kind="charuco", columns=14, rows=11, square_mm=15.0, marker_mm=11.0, dictionary="6X6_250")
    circles = BoardChoice("circles:4x11", 20.0, diameter_mm=12.0).description()
    assert circles == CirclesDescription(kind="circles", columns=4, rows=11, spacing_mm=20.0, diameter_mm=12.0)


@pytest.mark.parametrize(
    ("choice", "words"),
    [
        (BoardChoice("14", 15.0), "--board '14' is not a board"),
        (BoardChoice("dots:4x11", 15.0), "is not a board"),
        (BoardChoice("14x11"), "--square-mm"),
        (BoardChoice("charuco:14x11", 15.0), "--marker-mm"),
        (BoardChoice("circles:4x11", 15.0), "--diameter-mm"),
        (BoardChoice("charuco:14x11", 15.0, marker_mm=16.0), "do not fit"),
        (BoardChoice("charuco:14x11", 15.0, marker_mm=11.0, dictionary="5x5_50"), "needs 90 markers"),
    ],
)
def test_a_board_option_that_is_wrong_is_named(choice, words):
    with pytest.raises(InputError, match=words):
        choice.description()


@pytest.mark.parametrize("command", ["cameras", "axis", "hand-eye", "guide", "rig"])
def test_every_calibration_offers_the_options_of_the_board(command, capsys):
    assert main(["calibrate", command, "--help"]) == 0
    said = capsys.readouterr().out
    for option in ("--board", "--square-mm", "--marker-mm", "--dictionary", "--diameter-mm"):
        assert option in said


def test_a_camera_is_calibrated_from_a_charuco_board_partly_out_of_its_images(tmp_path, capsys):
    views = [(30, 10, 5), (35, 100, 40), (40, 190, 80), (35, 280, -30), (25, 55, 160), (40, 145, 200), (45, 235, 20), (20, 325, 100)]
    for number, view in enumerate(views):
        aside = (85.0, 0.0) if number % 2 else (-75.0, 45.0)
        cv2.imwrite(str(tmp_path / f"view{number}.png"), shot(CHARUCO, *view, HALF, aside_mm=aside).image)
    arguments = ["cameras", "--images", f"left={tmp_path}/view*.png", "--board", "charuco:14x11", "--square-mm", "15", "--marker-mm", "11"]
    assert main(["calibrate", *arguments, "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert len(answer["views"]) == len(views)
    assert min(view["corners"] for view in answer["views"]) < 140
    focal = answer["cameras"]["left"]["parameters"]["fx"]
    assert abs(focal["value"] - 2045.0) < 4 * focal["standard_deviation"]
    assert focal["standard_deviation"] < 5.0
    assert answer["joint_rms_px"] < 0.08
