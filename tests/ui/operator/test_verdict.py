"""What an operator sees of a result: the pages of its report, and the part from a side that was measured."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QLabel

from ui.pages.operator.verdict import WorstCard
from ui.pages.operator.worst import seen_from


def test_the_pages_of_the_report_are_shown(workshop):
    page = QImage(200, 300, QImage.Format.Format_RGB32)
    report = workshop.screens.report
    workshop.screens.screens.setCurrentWidget(report)
    workshop.application.controllers.documents.pagesReady.emit((page, page))
    shown = [one for one in report.findChildren(QLabel) if not one.pixmap().isNull() and one.pixmap().height() > 300]
    assert len(shown) == 2


@pytest.mark.parametrize(
    ("verdicts", "advice"),
    [
        (("pass", "pass"), ""),
        (("pass", "fail"), "Put the part aside."),
        (("pass", "not proven"), "Too close to a limit to decide."),
        (("pass", "not measured"), "Not everything could be measured."),
        (("no tolerance", "no tolerance"), "The program has no tolerances"),
    ],
)
def test_each_verdict_says_what_to_do_next(workshop, verdicts, advice):
    workshop.verdicts = verdicts
    workshop.begin("GC-0020")
    workshop.wait(lambda: workshop.operator.filed is not None)
    shown = workshop.screens.verdict.advice
    assert shown.text().startswith(advice) and shown.isVisible() == bool(advice) == bool(shown.text())
    workshop.screens.verdict.call.click()
    assert f"The verdict is {workshop.screens.verdict.band.word.text()}." in workshop.screens.call.words.text()


def test_long_names_are_shortened_and_nothing_is_cut(workshop, qtbot):
    workshop.window.resize(1280, 720)
    inspection = workshop.measurement.inspection
    long = tuple(
        replace(one, name=f"{one.name} over all of the rib on the far side, from the datums A, B and C") for one in inspection.dimensions
    )
    workshop.measurement = replace(workshop.measurement, inspection=replace(inspection, dimensions=long))
    workshop.verdicts = ("not proven",) * 3
    workshop.begin(f"GC-{'0123456789-' * 8}END")
    workshop.wait(lambda: workshop.operator.filed is not None)
    screen = workshop.screens.verdict
    qtbot.wait(50)
    assert screen.band.part.text().endswith("END") and "…" in screen.band.part.text()
    cards = screen.findChildren(WorstCard)
    assert len(cards) == 3
    for card in cards:
        assert card.name.text().endswith("…") and card.name.toolTip().endswith("A, B and C")
    for one in (*(label for card in cards for label in card.findChildren(QLabel)), screen.band.part, screen.band.summary, screen.filed):
        assert one.height() >= one.heightForWidth(one.width()), one.text()


def test_a_part_is_not_shown_from_below_where_nothing_was_measured(inspection):
    plane, circle = inspection.features
    below = replace(circle, point_mm=np.array([0.0, 0.0, 20.0]), direction=np.array([0.0, 0.0, -1.0]))
    worst = replace(inspection, features=(plane, below), dimensions=(inspection.dimensions[1],))
    assert seen_from(worst)[2] > 0
    assert seen_from(replace(worst, dimensions=(replace(worst.dimensions[0], features=("top",)),)))[2] > 0
