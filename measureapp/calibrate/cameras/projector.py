"""The projector as one more camera of the head, calibrated in the same bundle adjustment."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from measureapp.calibrate.cameras.array import CameraArrayProblem, CameraArraySolution, solve
from measureapp.calibrate.cameras.projector_sightings import PROJECTOR
from measureapp.calibrate.sightings import Rejection, Sighting
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration, ProjectorCalibration, Provenance
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import RigidTransform
from measureapp.progress import Progress


@dataclass(frozen=True, slots=True, eq=False)
class HeadSolution:
    """Cameras and projector of one head."""

    calibration: CameraArrayCalibration  # with its `projector`
    solution: CameraArraySolution  # of the bundle, in which the projector is a camera called `PROJECTOR`
    problem: CameraArrayProblem  # from which it was solved

    @property
    def projector(self) -> ProjectorCalibration:
        """The projector."""
        assert self.calibration.projector is not None  # `solve_head` always gives one
        return self.calibration.projector


def add_projector(problem: CameraArrayProblem, read: Sequence[Sighting | Rejection], size_px: tuple[int, int]) -> CameraArrayProblem:
    """Return the problem with the projector as one more camera.

    Parameters
    ----------
    read : what `projector_sighting` made of the phases in every camera and view; where several cameras have phases of a view, the
        one with most marks speaks for the projector
    size_px : width and height of the projector's image

    Raises
    ------
    CalibrationError
        A camera is called like the projector.
    """
    if PROJECTOR in problem.sizes_px:
        raise CalibrationError(f"A camera is called {PROJECTOR!r}.", "Give the camera another name.")
    seen: dict[str, list[Sighting]] = {}
    for one in read:
        if isinstance(one, Sighting):
            seen.setdefault(one.view, []).append(one)
    missed = {one.view: one for one in read if isinstance(one, Rejection) and one.view not in seen}
    best = [max(found, key=lambda one: len(one.corners_px)) for found in seen.values()]
    return replace(
        problem,
        sizes_px={**problem.sizes_px, PROJECTOR: size_px},
        sightings=(*problem.sightings, *best),
        rejected=(*problem.rejected, *missed.values()),
    )


def solve_head(
    problem: CameraArrayProblem,
    read: Sequence[Sighting | Rejection],
    size_px: tuple[int, int],
    progress: Progress | None = None,
    before: HeadSolution | None = None,
) -> HeadSolution:
    """Calibrate cameras and projector together, or the projector alone where the problem's cameras are known.

    Parameters
    ----------
    read : what `projector_sighting` made of the phases in every camera and view
    before : a solution from fewer or other views, to start from

    Raises
    ------
    CalibrationError
        As `camera_array.solve`; for the projector as for any camera.
    """
    whole = add_projector(problem, read, size_px)
    solution = solve(whole, progress, None if before is None else before.solution)
    return HeadSolution(as_head(solution.calibration), solution, whole)


def as_head(calibration: CameraArrayCalibration, name: str = PROJECTOR) -> CameraArrayCalibration:
    """Return the calibration with its camera ``name`` made the projector."""
    seen = calibration.cameras[name]
    projector = ProjectorCalibration(
        seen.pinhole,
        RigidTransform(seen.reference_from_camera.matrix, "camera", name),
        name,
        seen.standard_deviations,
        Provenance(calibration.provenance.created, "inverse camera in the bundle adjustment of all cameras", calibration.provenance.inputs),
        seen.rms_px,
    )
    cameras = {camera: value for camera, value in calibration.cameras.items() if camera != name}
    pairs = {pair: value for pair, value in calibration.pair_rms_px.items() if not _names(pair, name, cameras)}
    return replace(calibration, cameras=cameras, pair_rms_px=pairs, projector=projector)


def as_camera(projector: ProjectorCalibration) -> CameraCalibration:
    """Return the projector as the inverse camera it is."""
    place = RigidTransform(projector.reference_from_projector.matrix, "camera", projector.name)
    return CameraCalibration(projector.name, projector.pinhole, place, projector.standard_deviations, projector.rms_px)


def pair_with_projector(head: CameraArrayCalibration, camera: str) -> CameraArrayCalibration:
    """Return one camera and the projector as a pair of cameras, in the frame of the head.

    Raises
    ------
    CalibrationError
        The projector of the head is not calibrated.
    """
    if head.projector is None:
        raise CalibrationError("The projector is not calibrated.", "Calibrate it: `measureapp calibrate projector`.")
    pair = {camera: head.cameras[camera], head.projector.name: as_camera(head.projector)}
    return CameraArrayCalibration(camera, pair, covariance=head.covariance)


def _names(pair: str, name: str, cameras: Sequence[str] | Mapping[str, object]) -> bool:
    return any(pair in (f"{camera}-{name}", f"{name}-{camera}") for camera in cameras)
