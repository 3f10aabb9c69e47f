"""What is drawn over the part: outlines of features, sections, distances, and flags that can be dragged."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QObject, QTimer, Slot

from ui.look.look import Look
from ui.pages.inspection.clicking import ClickingTools
from ui.pages.inspection.cutting import Cutting
from ui.pages.inspection.deviation_display import DeviationDisplay
from ui.pages.inspection.dimension_side import DimensionSide
from ui.pages.inspection.feature_lines import OUTLINE, feature_lines, verdict_rgb
from ui.pages.inspection.flags import DIMENSION, dimension_flags, extreme_flags
from ui.pages.inspection.outlines import preview_lines
from ui.pages.inspection.probing import Probing
from ui.pages.layers import rgb
from ui.session import Session
from ui.viewport.cloud_view import CloudView
from ui.viewport.layers import Label, LineLayer

if TYPE_CHECKING:
    from measureapp.data.feature import Feature
    from measureapp.inspection.section_curves import SectionCurves

OUTDATED = "Before the change"  # in place of a verdict that no longer holds
WORST = {"fail": 0, "not proven": 1, "not measured": 2}


class PictureContent(QObject):
    """Composes lines, labels and flags; flags that were dragged stay where they are."""

    def __init__(self, look: Look, session: Session, view: CloudView, side: DimensionSide, display: DeviationDisplay) -> None:
        super().__init__(view)
        self._look, self._session, self._view, self._side, self._display = look, session, view, side, display
        self._pins: dict[str, tuple[float, float]] = {}
        self.point: Label | None = None  # of the last clicked point
        self.all_flags = False
        self.is_deviation = False
        self._preview: Feature | None = None  # construction that is not confirmed yet
        self._soon = QTimer(self)
        self._soon.setSingleShot(True)
        self._soon.timeout.connect(self._draw)
        side.create.previewed.connect(self._show_preview)
        view.flagMoved.connect(self._pin)
        view.flagChosen.connect(self._choose)
        session.projectChanged.connect(self._pins.clear)

    def use(self, cutting: Cutting, clicking: ClickingTools, probing: Probing) -> None:
        """Draw what these tools show."""
        self._cutting, self._clicking, self._probing = cutting, clicking, probing

    @Slot()
    def show(self) -> None:
        """Draw with the next event, once for everything that changed: one choice changes several of the things that are drawn."""
        self._soon.start(0)

    @Slot()
    def _draw(self) -> None:
        """Outline all features in grey and those of the selected row in colour; a dimension has a flag with its value."""
        inspection, chosen = self._session.inspection, self._side.selection
        if inspection is None:
            return
        dimension, theme = chosen.dimension, self._look.theme
        accent = rgb(theme, "accent")
        outdated = {row.found.name for row in self._side.rows if row.found is not None and row.is_outdated}
        colour = accent if dimension is None or dimension.name in outdated else verdict_rgb(theme, dimension)
        lines = feature_lines(inspection.features, chosen.features, dimension, self._sections(), colour)
        shown = inspection.dimensions if self.all_flags else () if dimension is None else (dimension,)
        worst_first = sorted(shown, key=lambda one: (one is not dimension, WORST.get(str(one.verdict), 3)))
        frames = {row.found.name: row.frame for row in self._side.rows if row.found is not None}
        flags = dimension_flags(worst_first, inspection.features, self._sections(), self._pins, frames)
        renewed = {f"{DIMENSION}{name}" for name in outdated}
        flags = [replace(flag, verdict="", more=(*flag.more, OUTDATED)) if flag.key in renewed else flag for flag in flags]
        if self.is_deviation:
            comparison = self._session.comparison
            flags += self._probing.flags(self._pins)
            flags += extreme_flags(None if comparison is None else comparison.statistics, self._pins)
        if self._preview is not None:
            lines.append(LineLayer(tuple(preview_lines(self._preview)), accent, 2.0))
        self._view.set_lines([*lines, *self._cutting.lines, *self._clicking.lines(accent)])
        self._view.set_labels([*self._clicking.labels(theme), *([self.point] if self.point is not None else [])])
        self._view.set_flags(flags, "" if dimension is None else f"{DIMENSION}{dimension.name}")
        self._view.set_legend(self._display.legend if self.is_deviation else None)

    def look_closer(self) -> None:
        """Zoom to the features of the selected row."""
        chosen = self._side.selection
        if chosen.features:
            layers = feature_lines(chosen.features, chosen.features, chosen.dimension, self._sections(), OUTLINE)
            self._view.look_at(np.vstack([line for layer in layers for line in layer.lines]))

    def _sections(self) -> SectionCurves | None:
        return None if self._session.comparison is None else self._session.comparison.sections

    @Slot(object)
    def _show_preview(self, feature: Feature | None) -> None:
        if feature is not self._preview:
            self._preview = feature
            self.show()

    def _pin(self, key: str, middle: tuple[float, float]) -> None:
        self._pins[key] = middle
        self.show()

    def _choose(self, key: str) -> None:
        name = key.removeprefix(DIMENSION)
        row = next((row for row in self._side.rows if row.found is not None and row.found.name == name), None)
        if key.startswith(DIMENSION) and row is not None:
            self._side.list.setValue("dimensions")
            self._side.table.select(row.id)
