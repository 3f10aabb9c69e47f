"""Deviations read by clicking: each becomes a flag with its number of points and uncertainty."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QObject, Signal, Slot

from ui.controllers.jobs import JobRunner
from ui.look.wording import counted, millimetres
from ui.pages.inspection.flags import Pins, probe_flag
from ui.session import Comparison, Session
from ui.viewport.overlay.flag import Flag
from ui.widgets.properties_panel import Group, Properties

if TYPE_CHECKING:
    from measureapp.inspection.surface.probe import ProbeValue

PROBE = "probe:"
MOST = 24  # flags; more would hide the part


class Probing(QObject):
    """Holds the probes of the present comparison."""

    changed = Signal()
    probed = Signal(object)  # Properties of the last probe

    def __init__(self, session: Session, runner: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._runner = session, runner
        self.probes: list[ProbeValue] = []
        session.comparisonChanged.connect(self.clear)

    def probe(self, place_mm: np.ndarray) -> None:
        """Read the deviation around a place in the nominal's frame."""
        comparison, scale_ppm = self._session.comparison, self._session.scale_ppm
        if comparison is not None and comparison.index is not None:
            self._runner.run("Reading a deviation", lambda _job: read(comparison, place_mm, scale_ppm), self._keep, quiet=True)

    def flags(self, pins: Pins) -> list[Flag]:
        """Return a flag for each probe."""
        return [probe_flag(f"{PROBE}{number}", one, pins) for number, one in enumerate(self.probes)]

    def undo(self) -> None:
        """Remove the last probe."""
        if self.probes:
            self.probes.pop()
            self.changed.emit()

    @Slot()
    def clear(self) -> None:
        """Remove all probes."""
        if self.probes:
            self.probes.clear()
            self.changed.emit()

    @Slot(object)
    def _keep(self, found: ProbeValue) -> None:
        self.probes = [*self.probes, found][-MOST:]
        self.changed.emit()
        self.probed.emit(probe_properties(found))


def read(comparison: Comparison, place_mm: np.ndarray, scale_ppm: float) -> ProbeValue:
    """Fit the deviations around a place; runs on a job's thread. Raises InspectionError where too little was measured."""
    from measureapp.inspection.measured_points import MeasuredPoints
    from measureapp.inspection.surface.probe import probe_deviation

    assert comparison.index is not None
    points = MeasuredPoints.of(comparison.stitched).seen_from(comparison.deviation.alignment.nominal_from_part)
    return probe_deviation(comparison.index, place_mm, measured=points.with_scale_uncertainty(scale_ppm))


def probe_properties(found: ProbeValue) -> Properties:
    """Return the properties of a probe."""
    rows = [
        ("Deviation", millimetres(found.value_mm, signed=True)),
        ("Uncertainty (k = 2)", millimetres(found.uncertainty_mm)),
        ("Points", counted(found.points)),
        ("Radius", millimetres(found.radius_mm, 2)),
    ]
    place = Group("Coordinates", tuple((axis, millimetres(float(value))) for axis, value in zip("xyz", found.point_mm, strict=True)))
    how = (("", f"{found.assumed[:1].upper()}{found.assumed[1:]}."),) if found.assumed else ()
    return Properties("Deviation", (Group("Plane fit around the clicked place", (*rows, *how)), place))
