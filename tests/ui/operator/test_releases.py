"""Operators are offered released programs only; the engineer releases them, and whatever changes a program needs another release."""

from __future__ import annotations

from dataclasses import replace

import pytest

from measureapp.project.part_program_file import is_released, read_part_program, with_former_revision, write_part_program
from ui.pages.operator.setup_dialog import OperatorSetupDialog


@pytest.fixture
def changed(workshop, tmp_path):
    """The gear's program, packed anew with another remark."""
    path = tmp_path / "MeasureApp" / "programs" / "gear.mpart"
    program = read_part_program(path)
    other = replace(program, facts=program.facts.model_copy(update={"remarks": "Put the gear upside down."}))
    write_part_program(with_former_revision(other, path), path)
    reload(workshop)
    return path


def reload(workshop) -> None:
    before = workshop.operator.shelf
    workshop.operator.stock.reload()
    workshop.wait(lambda: workshop.operator.shelf is not before)


def names(workshop) -> list[str]:
    return [button.card.name for button in workshop.screens.home.grid.buttons]


def test_a_program_that_was_changed_is_not_offered_and_the_screen_says_so(workshop, changed):
    assert names(workshop) == ["Gypsum cross"]
    assert workshop.screens.home.note.isVisible()
    assert workshop.screens.home.note.text().startswith("1 part program not released")
    workshop.operator.scan_code("GW-24|S1")
    assert workshop.operator.step == "home"


def test_the_engineer_releases_a_program_as_its_next_revision(workshop, changed, qtbot):
    controllers = workshop.application.controllers
    dialog = OperatorSetupDialog(workshop.application.look, controllers.operator, controllers.roles, workshop.window)
    qtbot.addWidget(dialog)
    dialog.open()
    releases = dialog.releases
    workshop.wait(lambda: len(releases.cards) == 2)
    assert releases.table.texts()[0] == ["Gear", "1", "Changed since"]
    assert releases.table.texts()[1][2].startswith("Released by MeasureApp")
    releases.table.selectRow(0)
    assert not releases.release.isEnabled()
    releases.by.setText("Ada Lovelace")
    assert releases.release.isEnabled()
    releases.release.click()
    workshop.wait(lambda: is_released(read_part_program(changed)))
    workshop.wait(lambda: len(workshop.operator.shelf.cards) == 2)
    facts = read_part_program(changed).facts
    assert facts.revision == 2 and facts.release.by == "Ada Lovelace"
    assert names(workshop) == ["Gear", "Gypsum cross"]
    releases.table.selectRow(0)
    assert not releases.release.isEnabled()  # it is released as it is


def test_the_set_up_does_not_call_a_folder_empty_that_is_still_being_read(workshop, qtbot, monkeypatch):
    controllers = workshop.application.controllers
    monkeypatch.setattr(workshop.operator.stock, "shelf", None)
    dialog = OperatorSetupDialog(workshop.application.look, controllers.operator, controllers.roles, workshop.window)
    qtbot.addWidget(dialog)
    assert dialog.releases.empty.text() == "Reading the part programs…"
    dialog.open()
    workshop.wait(lambda: dialog.releases.cards)
    assert not dialog.releases.empty.isVisible()
