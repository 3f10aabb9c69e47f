"""Inspection of a part: features, dimensions and verdicts from measured points and an inspection program."""

from __future__ import annotations

from measureapp.data.inspection_program import InspectionProgram
from measureapp.data.measurement import Alignment, Inspection
from measureapp.data.mesh import Mesh
from measureapp.inspection.measured_points import HasPoints, MeasuredPoints
from measureapp.inspection.session.session import InspectionSession
from measureapp.inspection.settings import InspectionSettings
from measureapp.progress import NoProgress, Progress


def inspect(
    measured: MeasuredPoints | HasPoints | Mesh,
    program: InspectionProgram,
    nominal: Mesh | None = None,
    settings: InspectionSettings = InspectionSettings(),  # noqa: B008 - frozen
    progress: Progress = NoProgress(),  # noqa: B008 - stateless
    alignment: Alignment | None = None,
) -> Inspection:
    """Evaluate the features and dimensions of ``program`` on measured points, once; an `InspectionSession` measures repeatedly.

    Parameters
    ----------
    measured : stitched cloud, cloud, plain points or mesh, in the part's frame
    nominal : mesh of the nominal; needed for a best fit, and to exclude points near its edges
    alignment : known alignment; None: the one the program defines

    Raises
    ------
    InspectionError
        There are no points, a best fit has no nominal, or the points do not match it or are in another unit. A single feature or
        dimension without a result does not raise: it is "not measured" with its reason.
    """
    return InspectionSession(measured, nominal, settings, alignment).measure(program, progress).inspection
