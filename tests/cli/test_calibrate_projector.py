"""`measureapp calibrate projector` from recorded fringes on a board, as users run it."""

from __future__ import annotations

import contextlib
import io
import json
import shutil

import numpy as np
import pytest
from found_boards import found_under_fringes_once

from measureapp.cli import main
from measureapp.project.calibration.camera_file import read_cameras, write_cameras
from tests.cli.board_fringes import BOARD, POSITIONS, in_sigmas

MOST_SIGMAS = 4.0  # of 12 parameters; noise alone passes it once in 1300 calibrations


def run(capsys, *arguments):
    code = main(["calibrate", "projector", *map(str, arguments), "--json"])
    return code, json.loads(capsys.readouterr().out)


@pytest.fixture(scope="module", autouse=True)
def _boards_are_found_once():
    with found_under_fringes_once():
        yield


@pytest.fixture(scope="module")
def together(manifests, tmp_path_factory):
    """Calibrate cameras and projector from all positions, once: the file, and what the command answered."""
    path, said = tmp_path_factory.mktemp("together") / "cameras.json", io.StringIO()
    with contextlib.redirect_stdout(said):
        code = main(["calibrate", "projector", *map(str, manifests), *BOARD, "--out", str(path), "--json"])
    assert code == 0, said.getvalue()
    return path, json.loads(said.getvalue())


def test_cameras_and_projector_are_recovered_together_and_serve_reconstruct(capsys, truth, manifests, together, tmp_path):
    path, answer = together
    found = read_cameras(path)
    assert np.abs(in_sigmas(truth, found.projector)).max() < MOST_SIGMAS
    assert set(found.cameras) == {"left", "right"}
    assert any(name.startswith("projector.") for name in found.covariance.parameters)
    assert answer["projector"]["views"] == POSITIONS
    assert answer["cross_validation"]["healthy"], answer["cross_validation"]["verdict"]
    assert "views held back fit with" in answer["cross_validation"]["verdict"]
    assert answer["camera_uncertainty_carried_on"]
    options = ["--cameras", str(path), "--out", str(tmp_path / "board.ply"), "--projector", "--json"]
    assert main(["reconstruct", str(manifests[0]), *options]) == 0
    agreement = json.loads(capsys.readouterr().out)["projector"]["agreement"]
    assert agreement


def test_known_cameras_stay_as_they_are_and_their_uncertainty_is_propagated(capsys, truth, manifests, together, tmp_path):
    path, _ = together
    code, answer = run(capsys, *manifests, *BOARD, "--cameras", path, "--out", tmp_path / "added.json")
    assert code == 0, answer
    known, added = read_cameras(path), read_cameras(tmp_path / "added.json")
    for name, camera in known.cameras.items():
        np.testing.assert_array_equal(added.cameras[name].pinhole.matrix, camera.pinhole.matrix)
        np.testing.assert_array_equal(added.cameras[name].reference_from_camera.matrix, camera.reference_from_camera.matrix)
    assert np.abs(in_sigmas(truth, added.projector)).max() < MOST_SIGMAS

    exact = truth.calibration.cameras
    write_cameras(tmp_path / "exact.json", exact)
    code, answer = run(capsys, *manifests, *BOARD, "--cameras", tmp_path / "exact.json", "--out", tmp_path / "conditional.json")
    assert code == 0, answer
    conditional = read_cameras(tmp_path / "conditional.json")
    assert not answer["camera_uncertainty_carried_on"]
    assert conditional.covariance is None
    assert set(conditional.cameras) == set(exact.cameras)  # also the one without fringes
    assert np.abs(in_sigmas(truth, conditional.projector)).max() < MOST_SIGMAS
    for name in ("fx", "x_mm", "z_mm"):
        assert conditional.projector.standard_deviations[name] < added.projector.standard_deviations[name]


def test_figures_are_stated_with_their_requirements_and_missing_one_is_exit_code_1(capsys, manifests):
    code, answer = run(capsys, *manifests[:5], *BOARD, "--limit", "projector position=0.000001")
    assert code == 1
    told = {one["name"]: one for one in answer["limits"]}
    assert set(told) == {"projector position", "projector rotation"}
    assert (told["projector position"]["asked"], told["projector position"]["met"]) == (1e-6, False)
    parameters = answer["projector"]["parameters"]
    largest = max(parameters[name]["standard_deviation"] for name in ("x_mm", "y_mm", "z_mm"))
    assert largest <= told["projector position"]["sigma"] <= 3**0.5 * largest  # in the direction that is least certain
    code, answer = run(capsys, *manifests[:5], *BOARD, "--limit", "axis position=0.1")
    assert code == 2
    assert "projector position" in answer["error"]["hint"]


def test_too_few_positions_are_refused(capsys, manifests):
    code, answer = run(capsys, *manifests[:2], *BOARD)
    assert code == 2
    assert "2 positions of the board do not determine the projector" in answer["error"]["message"]


def test_one_position_given_again_and_again_is_refused(capsys, manifests):
    code, answer = run(capsys, *[manifests[0]] * 4, *BOARD)
    assert code == 2
    assert "Views 01 and 02" in answer["error"]["message"]


def test_fringes_of_one_direction_are_refused(capsys, manifests, tmp_path):
    copied = []
    for number, manifest in enumerate(manifests[:3]):
        place = tmp_path / f"p{number}"
        shutil.copytree(manifest.parent, place)
        groups = (place / "MANIFEST.toml").read_text().split("\n  [[exposure.group]]")
        kept = [group for group in groups if 'direction = "horizontal"' not in group]
        (place / "MANIFEST.toml").write_text("\n  [[exposure.group]]".join(kept))
        copied.append(place / "MANIFEST.toml")
    code, answer = run(capsys, *copied, *BOARD)
    assert code == 2
    assert "has vertical fringes only" in answer["error"]["message"]


def test_a_board_of_another_size_is_refused(capsys, manifests):
    code, answer = run(capsys, *manifests[:3], "--board", "9x6", "--square-mm", "15")
    assert code == 2
    assert "0 views of the board" in answer["error"]["message"] or "was not found" in answer["error"]["message"]


def test_cameras_of_another_resolution_are_refused(capsys, truth, manifests, tmp_path):
    write_cameras(tmp_path / "cameras.json", truth.calibration.cameras)
    document = json.loads((tmp_path / "cameras.json").read_text())
    document["cameras"]["left"]["width"] *= 2
    (tmp_path / "cameras.json").write_text(json.dumps(document))
    code, answer = run(capsys, *manifests[:3], *BOARD, "--cameras", tmp_path / "cameras.json")
    assert code == 2
    assert "'left'" in answer["error"]["message"]


@pytest.mark.parametrize("size", ["1024", "0x768", "1024x-3", "wide"])
def test_a_projector_size_that_is_none_is_refused(capsys, manifests, size):
    code, answer = run(capsys, *manifests[:3], *BOARD, "--projector-px", size)
    assert code == 2
    assert "--projector-px" in answer["error"]["message"]
