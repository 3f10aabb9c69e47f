"""Alignment by the method an inspection program defines."""

from __future__ import annotations

from dataclasses import replace

from measureapp.data.alignment_program import AlignmentProgram, BestFit, ByCoordinates, NoAlignment
from measureapp.data.inspection_program import InspectionProgram
from measureapp.data.measurement import Alignment
from measureapp.errors import InspectionError
from measureapp.inspection.alignment.best_fit import best_fit, by_coordinates, no_alignment
from measureapp.inspection.alignment.by_features import align_by_features
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
    first_fit: Alignment | None = None,
) -> Alignment:
    """Align ``points`` to the nominal by the method of ``program``.

    An alignment by features starts from a best fit if there is a nominal mesh, because features are searched around their nominals;
    without a mesh it starts from the part's frame.

    Parameters
    ----------
    first_fit : best fit of all points, where it is known already

    Raises
    ------
    InspectionError
        A best fit has no nominal, the points do not match it, or a feature of the alignment was not found.
    """
    made = _align(points, program, surface, settings, frame, progress, first_fit)
    return replace(made, method=program.alignment.method)


def _align(
    points: MeasuredPoints,
    program: InspectionProgram,
    surface: NominalSurface | None,
    settings: InspectionSettings,
    frame: str,
    progress: Progress,
    first_fit: Alignment | None,
) -> Alignment:
    requested: AlignmentProgram = program.alignment
    if isinstance(requested, ByCoordinates):
        return by_coordinates(requested, frame)
    if isinstance(requested, NoAlignment):
        return no_alignment(frame)
    if isinstance(requested, BestFit):
        if surface is None:
            raise InspectionError(
                f"The program {program.name!r} aligns by best fit, but there is no nominal mesh.",
                'Add one to the program (nominal = "…"), or set alignment = "none".',
            )
        whole = first_fit or best_fit(points, surface, settings.alignment, frame, progress)
        if requested.fold is not None:
            return cyclic_fit(points, surface, requested, whole, settings)
        if requested.features or requested.regions:
            return local_fit(points, program, requested, whole, surface, settings, progress)
        return whole
    start = no_alignment(frame)
    if surface is not None:
        start = first_fit or best_fit(points, surface, settings.alignment, frame, progress)
    return align_by_features(points, program, start, surface, settings)
