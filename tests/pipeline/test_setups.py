"""Projects joined into one: measured, stored, opened, reported and recomputed like another project."""

from __future__ import annotations

import json
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
from without_pictures import without_surface_and_pictures

from measureapp.cli import main
from measureapp.pipeline.setups import SETUPS, JoinOptions, join_projects
from measureapp.progress import NoProgress
from measureapp.project import upkeep
from measureapp.project.folder import ProjectFolder
from tests.cli.refusal import refused
from tests.pipeline.joined_projects import project_of
from tests.register.setups.conftest import scan_turned_over

STEP_MM = 1.4  # joining itself is proven with points three times as dense


@pytest.fixture(scope="module")
def projects(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    turned_over = scan_turned_over(STEP_MM)
    folder = tmp_path_factory.mktemp("set-ups")
    return project_of(folder / "up", turned_over.up, mesh=turned_over.mesh), project_of(folder / "down", turned_over.down)


@pytest.fixture(scope="module", autouse=True)
def _without_surface_and_pictures() -> Iterator[None]:
    with without_surface_and_pictures():
        yield


@pytest.fixture(scope="module")
def joined(projects: tuple[Path, Path]) -> Path:
    out = projects[0].parent / "joined"
    join_projects(projects, out, JoinOptions(), lambda event: None, NoProgress())
    return out


@pytest.fixture
def copied(projects: tuple[Path, Path], joined: Path, tmp_path: Path) -> Path:
    """The joined project with its set-ups, to be changed."""
    for folder in (*projects, joined):
        shutil.copytree(folder, tmp_path / folder.name)
    return tmp_path / "joined"


def test_a_dimension_across_set_ups_is_within_its_uncertainty_which_contains_the_joint(joined: Path) -> None:
    measurement = ProjectFolder.open(joined).measurement()
    assert measurement is not None and measurement.inspection is not None
    height, wall = measurement.inspection.dimensions
    assert height.measured is not None and wall.measured is not None and height.uncertainty and wall.uncertainty
    assert abs(height.measured - 70.0) < height.uncertainty
    assert abs(wall.measured - 40.0) < wall.uncertainty
    for one, true in (
        (height, 70.0),
        (wall, 40.0),
    ):  # the views are where they are said to be: without their share, 3 standard uncertainties
        others = [value for name, value in one.budget.items() if name != "stitching"]
        assert abs(one.measured - true) < 1.5 * sum(value**2 for value in others) ** 0.5
    assert height.budget["setups"] > 1e-4  # the foot is seen in one set-up, the top of the wall in the other
    assert wall.budget["setups"] < 1e-6  # both faces are seen upright


def test_the_joined_project_is_opened_with_its_set_ups_and_all_their_views(joined: Path) -> None:
    measurement = ProjectFolder.open(joined).measurement()
    assert measurement is not None
    assert [setup.name for setup in measurement.setups] == ["up", "down"]
    assert {view.viewpoint_id.split(".")[0] for view in measurement.views} == {"up", "down"}
    assert measurement.stitched.errors is not None and measurement.stitched.errors.setup_motions is not None


def test_the_report_states_how_the_set_ups_were_joined(joined: Path) -> None:
    report = json.loads((joined / "report" / "report.json").read_text(encoding="utf-8"))
    assert [setup["name"] for setup in report["setups"]] == ["up", "down"]
    assert report["dimensions"][0]["uncertainty_budget"]["setups"] > 0
    assert (joined / "report" / "report.pdf").read_bytes().startswith(b"%PDF")


def test_processing_joins_the_present_results_of_the_set_ups_again(copied: Path, capsys) -> None:
    before = json.loads((copied / "results" / "measurement.json").read_text(encoding="utf-8"))
    assert main(["process", str(copied), "--json"]) in (0, 1)
    document = json.loads(capsys.readouterr().out)
    assert document["dimensions"][0]["measured"] == pytest.approx(before["inspection"]["dimensions"][0]["measured"], abs=1e-9)


def test_clouds_of_a_set_up_that_changed_since_are_refused(copied: Path, capsys) -> None:
    cloud = copied.parent / "down" / "results" / "stitched_cloud.ply"
    content = bytearray(cloud.read_bytes())
    content[len(content) // 2] ^= 1
    cloud.write_bytes(content)
    assert f"{cloud.resolve()} is damaged" in refused(capsys, ["process", str(copied)])


def test_a_set_up_that_is_missing_and_a_damaged_description_are_refused(copied: Path, capsys) -> None:
    shutil.rmtree(copied.parent / "down")
    assert "down does not exist" in refused(capsys, ["process", str(copied)])
    (copied / SETUPS).write_text('{"schema_version": 1, "sources": []}', encoding="utf-8")
    assert SETUPS in refused(capsys, ["process", str(copied)])


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        (["UP"], "Only one set-up"),
        (["UP", "UP"], "named twice"),
        (["UP", "JOINED"], "itself joined"),
        (["UP", "OTHER"], "different parts: 'bracket' and 'drum'"),
        (["UP", "DOWN", "--turned", "side=90,0,0"], "no set-up 'side'"),
        (["UP", "DOWN", "--turned", "down=90"], "not a name and three angles"),
        (["UP", "DOWN", "--by", "spheres"], "diameter of the spheres"),
        (["UP", "DOWN", "--by", "spheres", "--sphere-diameter-mm", "20"], "reference spheres were found in up"),
        (["UP", "DOWN", "--program", "nowhere.toml"], "does not exist"),
    ],
)
def test_a_wrong_join_is_refused_and_leaves_nothing(projects, joined: Path, tmp_path: Path, capsys, arguments, reason) -> None:
    known = {"UP": str(projects[0]), "DOWN": str(projects[1]), "JOINED": str(joined)}
    if "OTHER" in arguments:
        shutil.copytree(projects[1], tmp_path / "other")
        settings = tmp_path / "other" / "project.json"
        settings.write_text(settings.read_text(encoding="utf-8").replace('"part": "bracket"', '"part": "drum"'), encoding="utf-8")
        upkeep.accept_changes(tmp_path / "other", ["project.json"])
        known["OTHER"] = str(tmp_path / "other")
    given = [known.get(word, word) for word in arguments]
    assert reason in refused(capsys, ["join", *given, "--out", str(tmp_path / "new")])
    assert not (tmp_path / "new").exists()


def test_a_folder_that_holds_something_is_no_place_for_a_joined_project(projects, tmp_path: Path, capsys) -> None:
    (tmp_path / "note.txt").write_text("mine", encoding="utf-8")
    assert "is not an empty folder" in refused(capsys, ["join", *map(str, projects), "--out", str(tmp_path)])


@pytest.mark.slow
def test_by_the_nominal_the_set_ups_are_joined_too(projects, tmp_path: Path, capsys) -> None:
    code = main(["join", *map(str, projects), "--by", "nominal", "--out", str(tmp_path / "new"), "--json"])
    document = json.loads(capsys.readouterr().out)
    assert code in (0, 1), document
    height = document["dimensions"][0]
    assert abs(height["measured"] - 70.0) < height["uncertainty"]
