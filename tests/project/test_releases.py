"""A release holds for exactly one content of a part program; a project says which release it follows."""

from __future__ import annotations

from dataclasses import replace

import pytest

from measureapp.cli import main
from measureapp.errors import InputError
from measureapp.pipeline.part_program import store_part_program
from measureapp.pipeline.sample_program import SAMPLES, sample_program
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.part_program_file import (
    is_released,
    read_part_program,
    release_part_program,
    with_former_revision,
    write_part_program,
)
from measureapp.project.program_record import program_words
from measureapp.project.rig_file import read_rig

AT = "2026-11-25T10:00:00+00:00"


@pytest.fixture(scope="module")
def program():
    return sample_program(SAMPLES[0])


@pytest.fixture
def project(tmp_path):
    return ProjectFolder.create(tmp_path / "part", ProjectSettings(name="part", part="gypsum", rig=read_rig("paper")))


def test_a_release_survives_the_file_and_counts_on(program, tmp_path):
    assert not is_released(program)
    first = release_part_program(program, " Ada  Lovelace ", AT)
    path = write_part_program(first, tmp_path / "p.mpart")
    found = read_part_program(path)
    assert is_released(found) and found.facts.revision == 1 and found.facts.release.by == "Ada Lovelace"
    assert release_part_program(found, "Somebody else", AT) is found
    again = with_former_revision(replace(program, inspection=program.inspection + b"\n"), path)
    assert not is_released(again) and again.facts.revision == 1
    assert release_part_program(again, "Ada", AT).facts.revision == 2
    assert with_former_revision(program, tmp_path / "new").facts.revision == 0


@pytest.mark.parametrize("change", ["plan", "inspection", "nominal", "facts", "drawing"])
def test_whatever_changes_a_program_ends_its_release(program, change):
    released = release_part_program(program, "Ada", AT)
    facts = released.facts
    changed = {
        "plan": {"plan": released.plan.model_copy(update={"viewpoints": released.plan.viewpoints[1:]})},
        "inspection": {"inspection": b'name = "other"\n'},
        "nominal": {"nominal": (".stl", b"solid")},
        "facts": {"facts": facts.model_copy(update={"remarks": "Other side up."})},
        "drawing": {"facts": facts.model_copy(update={"identification": facts.identification.model_copy(update={"revision": "C"})})},
    }[change]
    assert not is_released(replace(released, **changed))


def test_what_an_operator_states_about_a_part_does_not_end_it(program):
    released = release_part_program(program, "Ada", AT)
    stated = released.facts.identification.model_copy(update={"serial_number": "7", "operator": "Bob", "part_name": "x"})
    assert is_released(replace(released, facts=released.facts.model_copy(update={"identification": stated})))


def test_a_release_needs_a_name(program):
    with pytest.raises(InputError, match="name"):
        release_part_program(program, "  ", AT)


def test_a_project_says_which_release_it_follows_until_its_program_is_changed(program, project):
    assert program_words(project.path) == ""
    store_part_program(project, program)
    assert program_words(project.path) == "Gypsum cross, not released"
    store_part_program(project, release_part_program(program, "Ada", AT))
    assert program_words(project.path) == "Gypsum cross, revision 1, released by Ada on 2026-11-25"
    project.save_program(project.program_text(has_nominal=True) + "\n# another tolerance\n")
    assert program_words(project.path) == "Gypsum cross, changed after the release of revision 1"


def test_a_program_is_released_on_the_command_line(program, tmp_path, capsys):
    path = write_part_program(program, tmp_path / "p.mpart")
    assert main(["program", "show", str(path)]) == 0
    assert "Not released: not offered to operators." in capsys.readouterr().out
    assert main(["program", "release", str(path), "--by", "Ada"]) == 0
    assert "Revision 1, released by Ada" in capsys.readouterr().out
    assert is_released(read_part_program(path))
