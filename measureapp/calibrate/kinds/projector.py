"""The projector as an inverse camera, next to cameras that are calibrated: from fringes on a board."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from typing_extensions import override

from measureapp.calibrate.boards.observation import Observation
from measureapp.calibrate.cameras.array import CameraArrayProblem
from measureapp.calibrate.cameras.projector import HeadSolution, as_camera, pair_with_projector, solve_head
from measureapp.calibrate.cameras.projector_sightings import PROJECTOR
from measureapp.calibrate.cameras.shortfalls import shortfalls
from measureapp.calibrate.cameras.uncertainty import WorkingVolume
from measureapp.calibrate.cameras.validation import CrossValidation, cross_validate
from measureapp.calibrate.draft.advice import Ghost, Notes
from measureapp.calibrate.draft.comparison import Comparison, changes_between, millimetres, sigma_ratio
from measureapp.calibrate.draft.draft import Draft, Effect, Kind, Known, Limits, Setup, Solved, Words
from measureapp.calibrate.draft.estimate import Estimate, projector_estimates
from measureapp.calibrate.guidance.lenses import advise_lenses, ghost_for_lenses
from measureapp.calibrate.kinds.cameras import with_cameras
from measureapp.calibrate.kinds.lenses import lens_problem, mark_warnings, solved_cameras
from measureapp.calibrate.kinds.on_part import fitting_length_mm, length_uncertainty_with_projector, shape_difference_mm, volume_of
from measureapp.calibrate.sightings import Rejection
from measureapp.data.calibration import CameraArrayCalibration, ProjectorCalibration, RigCalibration
from measureapp.data.uncertainty import COVERAGE_FACTOR
from measureapp.errors import InputError
from measureapp.progress import Progress

NO_COVARIANCE = "The uncertainty of the cameras themselves is not known: it comes in addition."


class Projector(Kind):
    """Lens and pose of the projector by bundle adjustment with the cameras held fixed."""

    name = "projector"
    words = Words(
        subject="the projector",
        title="Calibrate the projector",
        action="Projector",
        tip="Lens and pose of the projector, relative to calibrated cameras",
        purpose="Determines lens and pose of the projector from fringes of both directions on the board, with the cameras as calibrated. "
        "The phases around a corner of the board identify the projector pixel that lights it.",
        step="Take the views",
        hints=(
            "Bring the board to the borders of the projector's image, not only of the camera images.",
            "Tilt it by 20° to 45° to all four sides, and show it nearer and farther.",
            "Nothing may move while the fringes of one view are taken. White should be bright, but not clipped.",
        ),
        recorded="Recorded fringes",
        folder="A folder with one folder per position of the board, each with its fringe images of both directions and a MANIFEST.toml.",
    )
    limits = Limits(0.02, 0.05, "points from the projector complement those of two cameras and should be as certain")
    file = "cameras.json"
    uses_fringes = True

    @override
    def lenses(self, setup: Setup) -> tuple[str, ...]:
        return (PROJECTOR,)

    @override
    def check(self, setup: Setup) -> None:
        if PROJECTOR in setup.camera_names:
            raise InputError(f"A camera is called {PROJECTOR!r}.", "Give the camera another name.")
        if setup.projector_px is None:
            raise InputError("The size of the projector's image is not known.", "Give columns and rows of the projector.")

    @override
    def solve(self, draft: Draft, progress: Progress) -> Solved:
        known, setup = draft.setup.cameras, draft.setup
        assert known is not None  # guaranteed by `Setup`
        problem = head_problem(
            CameraArrayProblem(setup.board, setup.reference, {}, (), distortion_count=setup.distortion_count), draft.observations, known
        )
        read = [one.seen[PROJECTOR].of(PROJECTOR, one.id) for one in draft.observations]
        start = None if draft.solved is None else draft.solved.solution
        head = solve_head(problem, read, draft.sizes_px[PROJECTOR], progress, start)
        solved = solved_cameras(draft, head.solution)
        used = tuple(name for name in solved.used if PROJECTOR in solved.residuals_px[name])
        return replace(solved, solution=head, used=used, cameras=head.calibration)

    @override
    def shortfalls(self, draft: Draft) -> tuple[str, ...]:
        return shortfalls(lens_problem(draft, draft.setup.lenses))

    @override
    def advise(self, draft: Draft, notes: Notes) -> Ghost | None:
        advise_lenses(draft, notes)
        return ghost_for_lenses(draft)

    @override
    def result(self, solved: Solved) -> ProjectorCalibration:
        head: HeadSolution = solved.solution
        return head.projector

    @override
    def estimates(self, result: ProjectorCalibration) -> Sequence[Estimate]:
        return projector_estimates(result)

    @override
    def effect(self, draft: Draft, solved: Solved) -> Effect:
        head: HeadSolution = solved.solution
        camera, volume, length_mm = _worst_pair(head, draft.setup)
        found = length_uncertainty_with_projector(head, camera, volume, length_mm)
        own = length_uncertainty_with_projector(head, camera, volume, length_mm, own=True)
        value, worst = COVERAGE_FACTOR * found.length_sigma_mm, COVERAGE_FACTOR * found.worst_length_sigma_mm
        camera_jacobian = COVERAGE_FACTOR * float(np.sqrt(max(found.length_sigma_mm**2 - own.length_sigma_mm**2, 0.0)))
        sentence = (
            f"Adds {millimetres(value)} (k = 2), at worst {millimetres(worst)}, to a length of {found.length_mm:g} mm "
            f"measured by camera {camera} and the projector"
        )
        return Effect(value, sentence, cameras_mm=camera_jacobian)

    @override
    def previous(self, known: Known) -> ProjectorCalibration | None:
        return None if known.cameras is None else known.cameras.projector

    @override
    def compare(self, previous: Any, draft: Draft, solved: Solved) -> Comparison | None:
        before, head = _projector_of(previous), solved.solution
        if before is None:
            return None
        camera = head.calibration.reference
        volume = volume_of(head.solution, draft.setup.standoff_mm)
        found = length_uncertainty_with_projector(head, camera, volume, fitting_length_mm(volume, draft.setup.length_mm))
        with_before = replace(head.calibration, projector=replace(before, name=head.projector.name))
        moved = shape_difference_mm(pair_with_projector(head.calibration, camera), pair_with_projector(with_before, camera), volume)
        named = replace(before, name=head.projector.name)
        alone = [CameraArrayCalibration(one.name, {one.name: as_camera(one)}) for one in (named, head.projector)]
        expanded = float(np.hypot(1.0, sigma_ratio(*alone))) * COVERAGE_FACTOR * found.shape_rms_mm
        changes = changes_between(projector_estimates(before), projector_estimates(head.projector))
        return Comparison(
            tuple(changes), moved, expanded, f"points measured by camera {camera} and the projector, relative to each other (rms)"
        )

    @override
    def merge(self, draft: Draft, solved: Solved, known: Known) -> Known:
        return with_cameras(known, solved.cameras)

    @override
    def cross_validate(self, draft: Draft, solved: Solved, progress: Progress | None) -> CrossValidation | None:
        head: HeadSolution = solved.solution
        return cross_validate(head.problem, head.solution, progress=progress)

    @override
    def warnings(self, solved: Solved) -> Sequence[str]:
        head: HeadSolution = solved.solution
        return (*mark_warnings(head.solution), *(() if solved.cameras.covariance is not None else (NO_COVARIANCE,)))


def head_problem(
    empty: CameraArrayProblem,
    observations: Sequence[Observation],
    known: CameraArrayCalibration | None,
    rejected: Sequence[Rejection] = (),
) -> CameraArrayProblem:
    """Return the problem of the cameras next to the projector: known ones stay fixed, others are calibrated with it.

    Parameters
    ----------
    empty : without sightings; with the sizes of cameras that are not known
    rejected : images without marks, for the list of rejections
    """
    sightings = tuple(marks.of(camera, one.id) for one in observations for camera, marks in one.seen.items() if camera != PROJECTOR)
    problem = replace(empty, sightings=sightings, rejected=tuple(rejected), known=known)
    if known is None:
        return problem
    lenses = {name: known.cameras[name].pinhole for name in known.names}
    return replace(problem, sizes_px={name: (lens.width_px, lens.height_px) for name, lens in lenses.items()})


def _projector_of(previous: Any) -> ProjectorCalibration | None:
    """The projector among what was calibrated before; None where there is none."""
    if isinstance(previous, RigCalibration):
        return previous.cameras.projector
    if isinstance(previous, CameraArrayCalibration):
        return previous.projector
    return previous if isinstance(previous, ProjectorCalibration) else None


def _worst_pair(head: HeadSolution, setup: Setup) -> tuple[str, WorkingVolume, float]:
    """The camera with which the projector measures worst, the volume, and the length for which that is stated."""
    volume = volume_of(head.solution, setup.standoff_mm)
    length_mm = fitting_length_mm(volume, setup.length_mm)
    sigmas = {camera: length_uncertainty_with_projector(head, camera, volume, length_mm).length_sigma_mm for camera in setup.camera_names}
    return max(sigmas, key=lambda camera: sigmas[camera]), volume, length_mm
