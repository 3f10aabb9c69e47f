"""Dialogs that ask one question are in the language of the window as a whole."""

from __future__ import annotations

import re
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from PySide6.QtWidgets import QWidget

from measureapp.data.dimension_program import DimensionProgram
from measureapp.data.length_certificate import LengthCertificate
from measureapp.data.length_unit import LengthUnit
from measureapp.pipeline.closed_loop.causes import CAUSES, Cause
from measureapp.pipeline.closed_loop.next_views import _reason
from tests.ui.look.language.displayed import displayed_texts
from ui.look.language.words import tr
from ui.pages.inspection.certificate_dialog import CertificateDialog
from ui.pages.inspection.distance_dialog import DistanceDialog
from ui.pages.inspection.rename_dialog import RenameDialog
from ui.pages.scan.missing import MissingDialog
from ui.widgets.closing_bar import ClosingBar
from ui.widgets.new_project_dialog import NewProjectDialog
from ui.widgets.unit_dialog import QUESTIONS, UnitDialog

CERTIFIED = DimensionProgram(
    name="4711",
    kind="distance",
    features=("1", "2"),
    nominal=250.0,
    certificate=LengthCertificate(uncertainty_mm=0.001, number="4711"),
)
SPAN = "The points span 7.1, the nominal 180 mm"


def closing(look) -> ClosingBar:
    made = ClosingBar(look)
    made.ask("Stitching again")
    return made


DIALOGS = {
    "distance": lambda look: DistanceDialog(look, "4711", 3.0),
    "rename": lambda look: RenameDialog(look, "4711", lambda _name: ""),
    "certificate": lambda look: CertificateDialog(look, CERTIFIED),
    "new project": lambda look: NewProjectDialog(look, Path("/"), ""),
    "missing": MissingDialog,
    "closing": closing,
    **{f"unit of {what}": lambda look, what=what: UnitDialog(look, what, SPAN, LengthUnit.INCH, 7.1) for what in QUESTIONS},
}


@pytest.mark.parametrize("name", DIALOGS)
def test_a_dialog_is_in_the_language_and_follows_it(application, qtbot, speaking, english_left, name):
    speaking("zh_CN")
    dialog: QWidget = DIALOGS[name](application.look)
    qtbot.addWidget(dialog)
    assert english_left(displayed_texts(dialog)) == []
    speaking("en")
    assert not [text for _, text in displayed_texts(dialog) if "⟦" in text]
    speaking("zh_CN")
    assert english_left(displayed_texts(dialog)) == []


def found(cause: Cause) -> SimpleNamespace:
    """What is missing of a scan for one cause, and what would measure it."""
    explained, samples = SimpleNamespace(cause=np.array([CAUSES.index(cause)])), SimpleNamespace(areas_mm2=np.array([12.0]))
    coverage = SimpleNamespace(samples=samples)
    proposals = [
        SimpleNamespace(
            viewpoint=SimpleNamespace(id="01"), share=0.1, seconds=20.0, reason=_reason(np.array([True]), explained, coverage, kind)
        )
        for kind in ("viewpoint", "exposures")
    ]
    return SimpleNamespace(
        sufficient=0.9, accessible=0.95, median_sigma_mm=0.01, shares=lambda: {str(cause): 0.1}, proposals=proposals, expected=0.95
    )


@pytest.mark.parametrize("cause", Cause)
def test_what_is_missing_is_said_in_chinese(application, qtbot, cause):
    application.settings.set_text("language", "zh_CN")
    dialog = MissingDialog(application.look)
    qtbot.addWidget(dialog)
    dialog.show_found(found(cause))
    assert [text for _, text in displayed_texts(dialog) if re.search(r"[A-Za-z]{3,}", text)] == []
    assert sum("12 mm²" in text.replace("\u00a0", " ") for _, text in displayed_texts(dialog)) >= 2


@pytest.mark.parametrize("unit", LengthUnit)
def test_units_have_names_in_chinese(application, unit):
    application.settings.set_text("language", "zh_CN")
    said = tr("{finding}: probably {words}.", finding=SPAN, words=unit.words)
    assert re.findall(r"[A-Za-z]{3,}", said) == []
