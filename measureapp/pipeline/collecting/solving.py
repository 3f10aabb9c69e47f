"""From the observations of a collection to the solution of its kind."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from measureapp.calibrate.cameras.array import CameraArrayProblem, CameraArraySolution
from measureapp.calibrate.cameras.array import solve as solve_cameras
from measureapp.calibrate.cameras.draft import CameraArrayDraft
from measureapp.calibrate.cameras.projector import HeadSolution, solve_head
from measureapp.calibrate.cameras.projector_sightings import PROJECTOR, called
from measureapp.calibrate.sightings import sighting_of
from measureapp.errors import CalibrationError
from measureapp.pipeline.calibrate import rig_with_cameras, with_devices
from measureapp.pipeline.collecting.axis_solving import axis_shortfalls, solve_axes, with_rig
from measureapp.pipeline.collecting.observation import Observation
from measureapp.pipeline.collecting.setup import Setup
from measureapp.pipeline.collecting.solved import Solved
from measureapp.progress import NoProgress, PartOf, Progress

Sizes = Mapping[str, tuple[int, int]]


def solve(
    setup: Setup, observations: Sequence[Observation], sizes_px: Sizes, before: Solved | None = None, progress: Progress | None = None
) -> Solved:
    """Solve the calibration of ``setup.kind``.

    Parameters
    ----------
    observations : those to use; in each at least one camera saw the board
    sizes_px : camera -> (width, height)
    before : a solution to start from, where there is one

    Raises
    ------
    CalibrationError
        They do not determine the result; says what is missing.
    """
    progress = progress or NoProgress()
    if not observations:
        raise CalibrationError(f"The {setup.board.label} was not seen yet.", "Add observations that show it.")
    if setup.kind == "projector":
        return _projector(setup, observations, sizes_px, before, progress)
    if not setup.calibrates_cameras:
        return solve_axes(setup, observations, progress)
    share = 0.7 if setup.kind == "rig" else 1.0
    problem = camera_problem(setup, observations, sizes_px)
    start = None if before is None else before.camera_solution
    cameras = with_devices(solve_cameras(problem, PartOf(progress, 0.0, share), start), setup.serials)
    solved = _with_cameras(observations, cameras)
    return solved if setup.kind == "cameras" else _rig(setup, observations, solved, cameras, PartOf(progress, share, 1.0))


def camera_problem(setup: Setup, observations: Sequence[Observation], sizes_px: Sizes) -> CameraArrayProblem:
    """Return what the cameras are calibrated from. Raises CalibrationError where one has no images yet."""
    missing = [name for name in setup.camera_names if name not in sizes_px]
    if missing:
        raise CalibrationError(f"Camera {missing[0]!r} has no images yet.", "Give one of every camera with an observation.")
    return camera_draft(setup, observations, sizes_px, setup.camera_names).problem()


def camera_draft(setup: Setup, observations: Sequence[Observation], sizes_px: Sizes, names: Sequence[str]) -> CameraArrayDraft:
    """Return the draft of the cameras of these names, of which the projector may be one, with their sightings in the observations."""
    sizes = {name: size for name, size in sizes_px.items() if name in names}
    draft = CameraArrayDraft(setup.board, setup.reference, sizes, setup.distortion_count)
    for one in observations:
        for camera, found in one.seen.items():
            if camera in names:
                draft.add_sighting(sighting_of(camera, one.id, found))
    return draft


def shortfalls_of(setup: Setup, observations: Sequence[Observation], sizes_px: Sizes) -> tuple[str, ...]:
    """Say what is still missing, as the calibration's own draft puts it."""
    if not observations:
        return (f"No observation shows the {setup.board.label} yet.",)
    missing = camera_draft(setup, observations, sizes_px, setup.lenses).shortfalls() if setup.lenses else ()
    return missing if setup.kind in ("cameras", "projector") else (*missing, *axis_shortfalls(setup, observations))


def _projector(setup: Setup, observations: Sequence[Observation], sizes_px: Sizes, before: Solved | None, progress: Progress) -> Solved:
    """Solve the projector beside its cameras, which stay as they are."""
    known = setup.cameras
    assert known is not None  # `Setup` sees to it
    lenses = {name: known.cameras[name].pinhole for name in known.names}
    sizes = {name: (lens.width_px, lens.height_px) for name, lens in lenses.items()}
    problem = replace(camera_draft(setup, observations, sizes, known.names).problem(), known=known)
    read = [sighting_of(PROJECTOR, one.id, one.seen[PROJECTOR]) for one in observations]
    start = None if before is None or not isinstance(before.solution, HeadSolution) else before.solution
    head = solve_head(problem, read, sizes_px[PROJECTOR], progress, start)
    solved = _with_cameras(observations, head.solution)
    used = tuple(name for name in solved.used if PROJECTOR in solved.residuals_px[name])
    return replace(solved, solution=head, used=used, cameras=head.calibration)


def _with_cameras(observations: Sequence[Observation], solution: CameraArraySolution) -> Solved:
    residuals: dict[str, dict[str, float]] = {}
    for view in solution.views:
        residuals.setdefault(view.view, {})[view.camera] = view.rms_px
    reasons: dict[str, list[str]] = {}
    for rejection in solution.rejected:
        reasons.setdefault(rejection.view, []).append(f"{called(rejection.camera)}: {rejection.reason}.")
    for corner in solution.rejected_corners:
        reasons.setdefault(corner.view, []).append(f"{called(corner.camera)}: corner {corner.corner} left out, it {corner.reason}.")
    return Solved(
        solution=solution,
        of=tuple(one.id for one in observations),
        used=tuple(one.id for one in observations if one.id in residuals),
        board=solution.board,
        cameras=solution.calibration,
        places=dict(solution.boards),
        camera_solution=solution,
        residuals_px=residuals,
        reasons={name: " ".join(lines) for name, lines in reasons.items()},
    )


def _rig(setup: Setup, observations: Sequence[Observation], cameras: Solved, solution: CameraArraySolution, progress: Progress) -> Solved:
    found = {one.id: one.seen for one in observations}
    readbacks = {one.id: one.readback.full() for one in observations}
    approaches = {one.id: one.approach for one in observations if one.approach is not None}
    rig = rig_with_cameras(solution, found, readbacks, setup.noise, progress, approaches or None).rig
    return with_rig(rig, observations, cameras)
