"""Projects with a damaged file, or without what is to be processed."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.rig_file import read_rig
from measureapp.resources import resource
from tests.cli.refusal import refused


@pytest.mark.parametrize("content", [b"", b"[]", b"{}", b"null", b'{"schema_version": 1', b"\xff\xfe\x00"])
@pytest.mark.parametrize(
    "damaged", ["project.json", "plan.json", "calibration/rig.json", "calibration/cameras.json", "results/measurement.json"]
)
def test_a_damaged_project_is_refused_by_the_name_of_the_file(damaged: str, content: bytes, demo, tmp_path: Path, capsys) -> None:
    project = tmp_path / "project"
    for name in ("project.json", "plan.json", "calibration/rig.json", "calibration/cameras.json", "results/measurement.json"):
        (project / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(demo.folder / name, project / name)
    (project / damaged).write_bytes(content)
    command = "report" if damaged.startswith(("calibration", "results")) else "process" if damaged == "project.json" else None
    if command is None:  # the plan is read by a scan only
        plan = shutil.copyfile(demo.folder / "plan.json", tmp_path / "plan.json")
        (project / "stacks" / "view01").mkdir(parents=True)
        shutil.copyfile(demo.folder / "stacks" / "view01" / "stack.json", project / "stacks" / "view01" / "stack.json")
        rig = tmp_path / "rig.toml"
        rig.write_text(resource("rigs/paper.toml").read_text().replace("= 2592", "= 648").replace("= 1944", "= 486"))
        said = refused(capsys, ["scan", str(plan), "--rig", str(rig), "--project", str(project), "--resume"])
    else:
        said = refused(capsys, [command, str(project)])
    assert Path(damaged).name in said or str(Path(damaged).parent) in said
    assert not (project / "report").exists()


def test_a_project_without_images_has_nothing_to_process(tmp_path: Path, capsys) -> None:
    ProjectFolder.create(tmp_path / "bare", ProjectSettings(name="bare", part="gear", rig=read_rig("paper")))
    said = refused(capsys, ["process", str(tmp_path / "bare")])
    assert "neither a calibration nor images of the board" in said
