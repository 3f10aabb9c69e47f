"""The whole way on the virtual rig: card, serial number, Start, verdict, report filed; and a tightened tolerance that fails."""

from __future__ import annotations

import re
import shutil
from dataclasses import replace

import pytest

from measureapp.project.part_program_file import read_part_program, write_part_program
from measureapp.project.series.store import SeriesStore

MEASURED_MS = 1_800_000


@pytest.mark.slow
def test_one_part_passes_and_one_fails_by_a_tightened_tolerance(application, window, rig, sample_programs, qtbot, tmp_path):
    folder = tmp_path / "MeasureApp" / "programs"
    shutil.copytree(sample_programs, folder)
    sample = read_part_program(folder / "gypsum.mpart")
    text = sample.inspection.decode()
    tight = re.sub(r"(name = \"a\"\n.*\n.*\nnominal = )180", r"\g<1>180.5", text)
    assert tight != text
    facts = sample.facts.model_copy(update={"name": "Gypsum cross, tight", "part_number": "GC-T"})
    write_part_program(replace(sample, facts=facts, inspection=tight.encode()), folder / "tight.mpart")
    application.session.set_rig(rig)
    application.session.set_graphics("ready")
    application.session.set_role("operator")
    operator, screens = application.controllers.operator, window.shell.operator
    qtbot.waitUntil(lambda: operator.shelf is not None, timeout=60_000)
    for name, verdict in (("Gypsum cross", "PASS"), ("Gypsum cross, tight", "FAIL")):
        next(button for button in screens.home.grid.buttons if button.card.name == name).click()
        screens.identify.fields["serial"].setText("GC-7")
        screens.identify.next.click()
        qtbot.waitUntil(lambda: operator.obstacles is not None, timeout=60_000)
        screens.load.confirm.done = True
        screens.load.confirm.held.emit()
        screens.load.start.click()
        qtbot.waitUntil(lambda: operator.step == "verdict" or operator.fault is not None, timeout=MEASURED_MS)
        assert operator.fault is None, operator.fault
        assert screens.verdict.band.word.text() == verdict
        qtbot.waitUntil(lambda: operator.filed is not None, timeout=60_000)
        assert operator.filed.report.is_file() and not operator.filed.problem
        window.grab().save(str(tmp_path / f"{verdict}.png"))
        (run,) = SeriesStore(name).runs(serial_number="GC-7")
        assert str(run.verdict).upper() == verdict
        operator.go_home()
        qtbot.waitUntil(lambda known=name: known in _measured(screens), timeout=60_000)


def _measured(screens):
    """Return the programs whose cards show a last run."""
    return [button.card.name for button in screens.home.grid.buttons if button.card.last is not None]
