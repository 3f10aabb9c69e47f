"""All pictures of a report, and what they are drawn from."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any

from measureapp.data.measurement import Measurement
from measureapp.data.mesh import Mesh
from measureapp.inspection.surface.deviation import Deviation
from measureapp.inspection.surface.statistics import DeviationStatistics
from measureapp.progress import NoProgress, Progress
from measureapp.project.documents import inspection_document
from measureapp.project.kept_arrays import hash_of
from measureapp.report.cross_sections import render_sections
from measureapp.report.deviation_pictures import render_deviation
from measureapp.report.model import DeviationSummary, Pictures
from measureapp.report.part_pictures import render_failing, render_part, scene_of


@dataclass(frozen=True, slots=True, eq=False)
class Compared:
    """A cloud compared with its nominal."""

    nominal: Mesh
    deviation: Deviation
    summary: DeviationSummary


@dataclass(frozen=True, slots=True, eq=False)
class Drawing:
    """What the pictures of a report show."""

    measurement: Measurement
    compared: Compared | None = None  # None without a nominal

    def draw(self, progress: Progress = NoProgress()) -> Pictures:  # noqa: B008 - stateless
        """Draw all pictures, which takes seconds; can be cancelled between them."""
        scene, compared = scene_of(self.measurement), self.compared
        progress.check()
        part = render_part(self.measurement, scene)
        progress.check()
        failing = render_failing(self.measurement, scene)
        if compared is None:
            return Pictures(part=part, failing=failing)
        progress.check()
        deviation = render_deviation(compared.nominal, compared.deviation, compared.summary)
        progress.check()
        return Pictures(part, failing, deviation, render_sections(compared.nominal, compared.deviation, compared.summary.scale))

    def made_from(self) -> str:
        """Return a hash of everything that is drawn, the program included."""
        inspection, mesh, compared = self.measurement.inspection, self.measurement.mesh, self.compared
        words = {
            "inspection": None if inspection is None else inspection_document(inspection),
            "scale": None if compared is None else asdict(compared.summary.scale),
            "extremes": None if compared is None else _extremes(compared.summary.statistics),
        }
        surface = (None, None, None) if mesh is None else (mesh.vertices_mm, mesh.triangles, mesh.measured)
        cloud = self.measurement.stitched
        arrays = [*surface, *((cloud.points_mm, cloud.normals) if mesh is None else ())]
        if compared is not None:
            nominal, found = compared.nominal, compared.deviation
            arrays += [nominal.vertices_mm, nominal.triangles, found.points_mm, found.distances_mm, found.nominal_normals]
        return hash_of(words, *arrays)


def _extremes(statistics: DeviationStatistics) -> list[Any]:
    return [None if one is None else [one.value_mm, one.point_mm.tolist()] for one in (statistics.minimum, statistics.maximum)]
