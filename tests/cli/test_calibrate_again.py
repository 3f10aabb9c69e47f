"""`measureapp calibrate again`: a stored calibration follows from its stored inputs to the last bit, or what differs is named."""

from __future__ import annotations

import json
import shutil

import numpy as np
import pytest

from measureapp.cli import main
from tests.cli.test_calibrate import corner_table


@pytest.fixture
def axis_file(tmp_path, capsys, monkeypatch):
    """An axis calibration whose input lies beside it."""
    monkeypatch.chdir(tmp_path)
    corner_table(tmp_path / "corners.csv", 0.01)
    assert main(["calibrate", "axis", "--corners", "corners.csv", "--power", "3", "--out", "results/axis.json"]) == 0
    capsys.readouterr()
    return tmp_path / "results" / "axis.json"


def again(capsys, *arguments):
    code = main(["calibrate", "again", *map(str, arguments), "--json"])
    return code, json.loads(capsys.readouterr().out)


def test_an_unchanged_calibration_follows_again_bit_for_bit_also_from_another_folder(capsys, axis_file, tmp_path, monkeypatch):
    elsewhere = tmp_path.parent / f"{tmp_path.name}-moved"
    shutil.copytree(tmp_path, elsewhere)
    monkeypatch.chdir("/")
    code, answer = again(capsys, elsewhere / "results" / "axis.json")
    assert code == 0, answer
    assert answer["same"]
    assert answer["inputs"] == 1
    assert answer["numbers"] > 50


def test_a_number_changed_by_one_bit_is_named_with_exit_code_1(capsys, axis_file):
    document = json.loads(axis_file.read_text())
    point = document["maximum_likelihood"]["point_mm"]
    stored = point[1]
    point[1] = float(np.nextafter(stored, np.inf))
    axis_file.write_text(json.dumps(document))
    code, answer = again(capsys, axis_file)
    assert code == 1
    assert answer["differences"] == [{"place": "maximum_likelihood.point_mm[1]", "stored": point[1], "again": stored}]


def test_an_input_that_changed_is_named(capsys, axis_file, tmp_path):
    table = tmp_path / "corners.csv"
    table.write_text(table.read_text() + "\n")
    code, answer = again(capsys, axis_file)
    assert code == 2
    assert "corners.csv is not the file" in answer["error"]["message"]
    table.unlink()
    code, answer = again(capsys, axis_file)
    assert code == 2
    assert "corners.csv is missing" in answer["error"]["message"]


@pytest.mark.parametrize("content", ["{}", "[]", "no json", '{"made_from": {"arguments": ["demo"], "folder": ".", "inputs": {}}}'])
def test_files_that_do_not_say_how_they_were_made_are_refused(capsys, tmp_path, content):
    file = tmp_path / "some.json"
    file.write_text(content)
    code, answer = again(capsys, file)
    assert code == 2
    assert "some.json" in answer["error"]["message"]
