"""What an operator sees of a result: the pages of its report, and the part from a side that was measured."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QLabel

from ui.pages.operator.worst import seen_from


def test_the_pages_of_the_report_are_shown(workshop):
    page = QImage(200, 300, QImage.Format.Format_RGB32)
    report = workshop.screens.report
    workshop.screens.screens.setCurrentWidget(report)
    workshop.application.controllers.documents.pagesReady.emit((page, page))
    shown = [one for one in report.findChildren(QLabel) if not one.pixmap().isNull() and one.pixmap().height() > 300]
    assert len(shown) == 2


def test_a_part_is_not_shown_from_below_where_nothing_was_measured(inspection):
    plane, circle = inspection.features
    below = replace(circle, point_mm=np.array([0.0, 0.0, 20.0]), direction=np.array([0.0, 0.0, -1.0]))
    worst = replace(inspection, features=(plane, below), dimensions=(inspection.dimensions[1],))
    assert seen_from(worst)[2] > 0
    assert seen_from(replace(worst, dimensions=(replace(worst.dimensions[0], features=("top",)),)))[2] > 0
