"""Comparison of the stitched cloud with the nominal: deviation of each point."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QObject, Slot

from ui.controllers.jobs import JobRunner
from ui.session import Comparison, Session

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from measureapp.data.cloud import StitchedCloud
    from measureapp.data.inspection_program import InspectionProgram
    from measureapp.data.measurement import Alignment
    from measureapp.data.mesh import Mesh
    from measureapp.inspection.surface.deviation import Deviation
    from measureapp.progress import Progress
    from ui.workers.job import Job

PLACES = 60_000
MAP_TRIANGLES = 250_000  # of the coloured nominal, so that it turns smoothly


class ComparisonController(QObject):
    """Compares on a separate thread, without blocking the window."""

    def __init__(self, session: Session, runner: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._runner = runner
        self._asked: object = None

    @Slot()
    def compare(self) -> None:
        """Compare the stitched cloud with the nominal of the open project, once per cloud and nominal."""
        session = self._session
        stitched, inspection, folder = session.stitched, session.inspection, session.folder
        if stitched is None or inspection is None or folder is None or self._asked is inspection.alignment:
            return
        alignment = self._asked = inspection.alignment  # of one cloud and one nominal
        mesh = None if session.measurement is None else session.measurement.mesh
        self._runner.run(
            "Comparing with the nominal",
            lambda job: compare_cloud(stitched, alignment, folder, job, mesh),
            self._show,
            quiet=True,
        )

    @Slot(object)
    def _show(self, found: Comparison | None) -> None:
        if found is not None and found.stitched is self._session.stitched and found.deviation.alignment is self._asked:
            self._session.set_comparison(found)


def compare_cloud(stitched: StitchedCloud, alignment: Alignment, folder: Path, job: Job, mesh: Mesh | None = None) -> Comparison | None:
    """Compare a cloud with the nominal of a project; None if it has none. Runs on a job's thread.

    ``mesh``: the measured surface in the part frame, which tells what was filled.
    """
    from measureapp.project.folder import ProjectFolder
    from measureapp.project.geometry.files import read_mesh
    from measureapp.project.kept_deviation import deviation_of
    from measureapp.project.program_file import read_program

    project = ProjectFolder.open(folder) if (folder / "project.json").exists() else None
    if project is None or project.nominal is None:
        return None
    program = None if project.program is None else read_program(project.program)
    nominal = read_mesh(project.nominal, "nominal")
    return compute_comparison(stitched, nominal, alignment, program, job, mesh, partial(deviation_of, project))


def compute_comparison(
    stitched: StitchedCloud,
    nominal: Mesh,
    alignment: Alignment,
    program: InspectionProgram | None,
    progress: Progress,
    mesh: Mesh | None = None,
    compare: Callable[..., Deviation] | None = None,
) -> Comparison:
    """Return the deviations of a cloud, the unmeasured parts of the nominal, and the sections of the program; for a job's thread.

    ``compare``: where the deviations are taken from, called as `compute_deviation`, which it is by default.
    """
    from measureapp.data.deviation_scale import DeviationScale
    from measureapp.inspection.measured_points import sample_mesh
    from measureapp.inspection.section_curves import find_section_curves
    from measureapp.inspection.surface.deviation import NEAR_MM, compute_deviation
    from measureapp.inspection.surface.deviation_index import DeviationIndex
    from measureapp.inspection.surface.deviation_map import map_deviation
    from measureapp.inspection.surface.nominal import NominalSurface
    from measureapp.inspection.surface.smoothing import smooth_for_eye
    from measureapp.inspection.surface.statistics import compute_statistics

    found = (compare or compute_deviation)(stitched, nominal, alignment, progress=progress)
    places = sample_mesh(nominal, PLACES)
    distance, _ = found.tree.query(places.points_mm, distance_upper_bound=NEAR_MM)
    missing = ~np.isfinite(distance)
    normals = np.zeros_like(places.points_mm) if places.normals is None else places.normals
    surface = NominalSurface(nominal)
    sections = None if program is None else find_section_curves(found, surface, program, progress=progress)
    progress.report(0, 1, "statistics of the deviations")
    index = DeviationIndex(found)
    scale = DeviationScale() if program is None else program.deviation_scale
    statistics = compute_statistics(
        found,
        nominal,
        tolerance_mm=scale.tolerance_mm,
        range_mm=scale.range_mm,
        search_mm=NEAR_MM,
        surface=None if mesh is None else mesh.seen_from(alignment.nominal_from_part),
        index=index,
    )
    return Comparison(
        stitched,
        found,
        places.points_mm[missing],
        normals[missing],
        surface,
        sections,
        index,
        statistics,
        smooth_for_eye(index),
        map_deviation(found, nominal, NEAR_MM, MAP_TRIANGLES),
        scale,
    )
