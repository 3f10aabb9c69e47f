"""`exposures` prints and returns the valid pixels of each exposure, beside both rules of selection."""

from __future__ import annotations

import json

import pytest

from measureapp.cli.main import main
from tests.fringe_project import EXPOSURES_US, fringe_project, shiny_stack, valid_in_each


@pytest.fixture(scope="module")
def project(tmp_path_factory) -> str:
    return str(fringe_project(tmp_path_factory.mktemp("exposures") / "p", "view01", "view02").path)


def test_the_document_has_every_exposure_of_every_camera_and_both_rules(project, capsys) -> None:
    assert main(["exposures", project, "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert list(told["viewpoints"]) == ["view01", "view02"] and told["failed"] == {}
    left = told["viewpoints"]["view01"]["left"]
    assert [one["exposure_us"] for one in left["exposures"]] == list(EXPOSURES_US)
    assert [one["valid_ratio"] for one in left["exposures"]] == pytest.approx(valid_in_each(shiny_stack(), "left").mean(axis=(1, 2)))
    assert set(left["rules"]) == {"combined", "paper"}


def test_the_lines_name_exposures_and_rules(project, capsys) -> None:
    assert main(["exposures", project, "--viewpoint", "view02"]) == 0
    said = capsys.readouterr().out
    assert "view02 left: 80 ms " in said and "view01" not in said
    assert "brightest unsaturated exposure: composite" in said and "all unsaturated exposures: composite" in said


@pytest.mark.parametrize("name", ["", "view99", "../view01", "…"])
def test_a_viewpoint_that_is_not_stored_is_refused_with_those_that_are(project, capsys, name) -> None:
    assert main(["exposures", project, "--viewpoint", name]) == 2
    assert "Stored are: view01, view02" in capsys.readouterr().err
