"""The alignment that an inspection program asks for."""

from __future__ import annotations

from measureapp.data.alignment_program import AlignmentProgram, BestFit, DatumAlignment, NoAlignment, ThreeTwoOne
from measureapp.data.inspection_program import InspectionProgram
from measureapp.data.measurement import Alignment
from measureapp.errors import InspectionError
from measureapp.inspection.alignment.best_fit import best_fit, no_alignment
from measureapp.inspection.alignment.by_features import datum_alignment, reference_points, three_two_one
from measureapp.inspection.alignment.cyclic_fit import cyclic_fit
from measureapp.inspection.alignment.local_fit import local_fit
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.progress import NoProgress, Progress


def align(
    points: MeasuredPoints,
    program: InspectionProgram,
    surface: NominalSurface | None,
    settings: InspectionSettings,
    frame: str,
    progress: Progress = NoProgress(),  # noqa: B008 - stateless
) -> Alignment:
    """Lay ``points`` onto the nominal as ``program`` says.

    An alignment by features starts from a best fit where there is a nominal mesh, because features are looked for
    around their nominal places; without a mesh it starts from the part as it stands.

    Raises
    ------
    InspectionError
        A best fit has no nominal, the points do not match it, or a feature the alignment rests on was not found.
    """
    asked: AlignmentProgram = program.alignment
    if isinstance(asked, NoAlignment):
        return no_alignment(frame)
    if isinstance(asked, BestFit):
        if surface is None:
            raise InspectionError(
                f"The program {program.name!r} aligns by best fit but there is no nominal mesh.",
                'Name one (nominal = "…") in the program, or set alignment = "none".',
            )
        if asked.fold is not None:
            return cyclic_fit(points, surface, asked, settings, frame)
        if asked.features or asked.regions:
            return local_fit(points, program, asked, surface, settings, frame)
        return best_fit(points, surface, settings.alignment, frame, progress)
    start = no_alignment(frame) if surface is None else best_fit(points, surface, settings.alignment, frame, progress)
    if isinstance(asked, ThreeTwoOne):
        return three_two_one(points, program, asked, start, surface, settings)
    if isinstance(asked, DatumAlignment):
        return datum_alignment(points, program, asked, start, surface, settings)
    return reference_points(points, program, asked, start, surface, settings)
