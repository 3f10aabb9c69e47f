"""`measureapp calibrate collect projector`, as users run it: fringes on the board in a session of several calls."""

from __future__ import annotations

import json

import numpy as np
import pytest
from found_boards import found_under_fringes_once

from measureapp.cli import main
from measureapp.project.calibration.camera_file import read_cameras, write_cameras
from tests.cli.board_fringes import BOARD, POSITIONS, in_sigmas

MOST_SIGMAS = 4.5  # of 12 parameters; noise alone passes it once in 12 000 calibrations


@pytest.fixture(scope="module", autouse=True)
def _boards_are_found_once():
    with found_under_fringes_once():
        yield


def run(capsys, *arguments):
    """Return exit code and JSON document of a call."""
    code = main(["calibrate", "collect", *map(str, arguments), "--json"])
    return code, json.loads(capsys.readouterr().out)


@pytest.fixture
def fringes(manifests):
    return f"{manifests[0].parent.parent}/*/MANIFEST.toml"


@pytest.fixture
def cameras(truth, tmp_path):
    write_cameras(tmp_path / "cameras.json", truth.calibration.cameras)
    return tmp_path / "cameras.json"


def test_fringes_are_collected_guided_solved_compared_and_accepted(capsys, truth, fringes, cameras, tmp_path):
    session = ("projector", "--session", tmp_path / "session")
    code, answer = run(capsys, *session, "--fringes", fringes, "--cameras", cameras, *BOARD, "--coach")
    assert code == 0, answer
    assert [one["standing"] for one in answer["observations"]] == ["new"] * POSITIONS
    assert set(answer["observations"][0]["images"]) == {"left", "right", "projector"}
    assert answer["observations"][0]["images"]["projector"]["name"] == "position00"
    assert [gauge["name"] for gauge in answer["coach"]["gauges"]][:2] == ["Views", "Coverage of the image"]
    assert any("projector" in sentence for sentence in answer["coach"]["sentences"])
    code, answer = run(capsys, *session, "--fringes", fringes)  # nothing is counted twice
    assert answer["added"] == []
    code, answer = run(capsys, *session, "--remove", "02", "--solve")
    assert "02" not in [one["id"] for one in answer["observations"] if one["standing"] == "used"]
    code, answer = run(capsys, *session, "--undo", "--validate", "--coach")
    assert [one["standing"] for one in answer["observations"]] == ["used"] * POSITIONS
    assert all(0 < one["residuals_px"]["projector"] < 0.3 for one in answer["observations"])
    assert "measured by camera" in answer["verdict"]["sentence"]
    assert any("cameras themselves" in reason for reason in answer["verdict"]["but"])  # these state no covariance
    assert not any("errors other than noise" in reason for reason in answer["verdict"]["but"])  # views held back fit as predicted
    assert (code == 1) == (answer["verdict"]["level"] == "bad")
    result = tmp_path / "head.json"
    code, answer = run(capsys, *session, "--accept", result, "--good-mm", "100")
    assert code == 0, answer
    found = read_cameras(result)
    assert len(found.projector.provenance.inputs) == 3 * POSITIONS
    np.testing.assert_array_equal(found.cameras["left"].pinhole.matrix, truth.calibration.cameras.cameras["left"].pinhole.matrix)
    assert np.abs(in_sigmas(truth, found.projector)).max() < MOST_SIGMAS
    assert_it_follows_again(capsys, result, tmp_path / "session")
    code, answer = run(capsys, *session, "--compare", result)
    assert answer["comparison"]["within"]
    assert answer["comparison"]["on_part_mm"] < 1e-3
    assert {change["name"] for change in answer["comparison"]["changes"]} >= {"projector fx", "projector x"}


def assert_it_follows_again(capsys, result, session):
    """From what the session keeps, also after more was collected; and a changed file of it is named."""
    again = ["calibrate", "again", str(result), "--json"]
    assert run(capsys, "projector", "--session", session, "--remove", "01")[0] == 0
    assert main(again) == 0
    answer = json.loads(capsys.readouterr().out)
    assert answer["same"] and answer["inputs"] == 3 * POSITIONS and answer["numbers"] > 50
    run(capsys, "projector", "--session", session, "--undo")
    lit = next((session / "lit").iterdir())
    kept = lit.read_bytes()
    with np.load(lit) as arrays:
        np.savez(lit, corner_px=arrays["corner_px"], pixels=arrays["pixels"] + np.float32(0.1), sigma_px=arrays["sigma_px"])
    assert main(again) == 2
    assert "its checksum differs" in json.loads(capsys.readouterr().out)["error"]["message"]
    lit.write_bytes(kept)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("projector", *BOARD), "needs fringes"),
        (("projector", *BOARD, "--fringes", "{fringes}"), "calibrated cameras are needed"),
        (("projector", *BOARD, "--fringes", "nowhere/*/MANIFEST.toml", "--cameras", "{cameras}"), "No manifest matches"),
        (("cameras", *BOARD, "--fringes", "{fringes}"), "Fringes calibrate a projector only"),
        (("projector", "--board", "13x11", "--square-mm", "15", "--fringes", "{fringes}", "--cameras", "{cameras}"), "under half a turn"),
    ],
)
def test_what_does_not_fit_is_refused_in_one_sentence(capsys, fringes, cameras, tmp_path, arguments, message):
    kind, *rest = [word.format(fringes=fringes, cameras=cameras) for word in arguments]
    code, answer = run(capsys, kind, "--session", tmp_path / "session", *rest)
    assert code == 2
    assert message in answer["error"]["message"]
    assert answer["error"]["hint"]
    assert not (tmp_path / "session").exists()


def test_plain_images_do_not_continue_a_session_for_the_projector(capsys, fringes, cameras, tmp_path):
    session = ("projector", "--session", tmp_path / "session")
    one = fringes.replace("*", "position00")
    assert run(capsys, *session, "--fringes", one, "--cameras", cameras, *BOARD)[0] == 0
    images = one.replace("MANIFEST.toml", "left/60000/000.png")
    code, answer = run(capsys, *session, "--images", f"left={images}")
    assert code == 2
    assert "calibrated from fringes" in answer["error"]["message"]
    assert len(run(capsys, *session)[1]["observations"]) == 1
