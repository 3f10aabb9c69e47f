"""Growing of features from clicked points, and their entries for the inspection program."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np
from PySide6.QtCore import QObject, Signal, Slot

from measureapp.errors import InspectionError
from ui.controllers.jobs import JobRunner
from ui.look.language.words import for_name, tr
from ui.look.wording import sentence
from ui.session import Session

if TYPE_CHECKING:
    from measureapp.data.cloud import StitchedCloud
    from measureapp.data.feature import Feature
    from measureapp.data.measurement import Alignment
    from ui.workers.job import Job

GrownShape = Literal["plane", "cylinder", "sphere", "cone"]


@dataclass(frozen=True, eq=False)
class GrownFeature:
    """A feature grown from a clicked point, in the nominal's frame."""

    feature: Feature
    seed_mm: tuple[float, float, float]

    @property
    def entry(self) -> str:
        """The lines that define it in an inspection program."""
        from measureapp.project.program_text import format_entry

        seed = tuple(round(value, 3) for value in self.seed_mm)
        return format_entry("features", {"name": self.feature.name, "shape": self.feature.shape, "grow": {"seed_mm": seed}})


class GrowingController(QObject):
    """Grows features on the measured points; they stay until they are undone or the clouds change."""

    changed = Signal()

    def __init__(self, session: Session, runner: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._runner = session, runner
        self.grown: list[GrownFeature] = []
        self._of: StitchedCloud | None = None
        session.cloudsChanged.connect(self._forget)
        session.inspectionChanged.connect(self._leave_to_program)

    @Slot(object, str)
    def grow(self, place_mm: np.ndarray, shape: GrownShape) -> None:
        """Grow a feature of this shape from a point in the nominal's frame."""
        stitched, inspection = self._session.stitched, self._session.inspection
        if stitched is None or inspection is None or self._session.refuse_during_job():
            return
        self._of = stitched
        taken = {one.name for one in inspection.features} | {one.feature.name for one in self.grown}
        names = (f"{for_name(shape)} {number}" for number in range(1, len(taken) + 2))
        name = next(one for one in names if one not in taken)
        seed, alignment = (float(place_mm[0]), float(place_mm[1]), float(place_mm[2])), inspection.alignment
        self._runner.run("Growing a feature", lambda job: grow_feature(stitched, alignment, name, shape, seed, job), self._keep)

    @Slot()
    def undo(self) -> None:
        """Remove the last grown feature."""
        if self.grown:
            self.grown.pop()
            self.changed.emit()

    @Slot()
    def _leave_to_program(self) -> None:
        """Remove features that are now part of the program."""
        inspection = self._session.inspection
        known = set() if inspection is None else {feature.name for feature in inspection.features}
        left = [one for one in self.grown if one.feature.name not in known]
        if len(left) < len(self.grown):
            self.grown = left
            self.changed.emit()

    @Slot(object)
    def _keep(self, found: GrownFeature) -> None:
        if self._session.stitched is self._of:
            self.grown.append(found)
            self.changed.emit()

    @Slot()
    def _forget(self) -> None:
        if self.grown and self._session.stitched is not self._of:
            self.grown.clear()
            self.changed.emit()


def grow_feature(
    stitched: StitchedCloud, alignment: Alignment, name: str, shape: GrownShape, seed_mm: tuple[float, float, float], job: Job
) -> GrownFeature:
    """Grow one feature; runs on a job's thread. Raises InspectionError with the reason if none is found."""
    from measureapp.data.inspection_program import InspectionProgram
    from measureapp.inspection.find_features import find_features
    from measureapp.inspection.measured_points import MeasuredPoints
    from measureapp.inspection.settings import InspectionSettings

    entry = {"name": name, "shape": shape, "grow": {"seed_mm": seed_mm}}
    program = InspectionProgram.model_validate({"name": "clicked", "alignment": "none", "features": [entry]})
    points = MeasuredPoints.of(stitched).seen_from(alignment.nominal_from_part)
    found = find_features(points, program, None, InspectionSettings(), job)[name]
    if found.feature is None:
        reason, _, remedy = found.reason.removeprefix(f"{name}: ").rstrip(".").partition(". ")
        raise InspectionError(
            tr("No {shape} found there: {reason}.", shape=shape, reason=reason),
            sentence(remedy) or "Click another point, or choose another shape.",
        )
    return GrownFeature(found.feature, seed_mm)
