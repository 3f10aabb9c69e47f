"""What a wizard's last page shows: the verdict, every value beside others, and what accepting it does."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Literal

from measureapp.errors import CalibrationError
from ui.controllers import result_values as values
from ui.controllers.collecting_nouns import Kind
from ui.controllers.kept_sessions import CAMERAS, RESULT, project_on_disk
from ui.controllers.seen_views import name_of
from ui.look.wording import millimetres, quantity
from ui.session import Session

if TYPE_CHECKING:
    from pathlib import Path

    from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration, RigCalibration
    from measureapp.pipeline.collecting.collection import Collection
    from measureapp.pipeline.collecting.solved import Solved
    from measureapp.pipeline.collecting.verdict import Verdict
    from ui.workers.job import Job

Sign = Literal["pass", "fail", "not proven"]
SIGNS: Mapping[str, Sign] = {"good": "pass", "usable": "not proven", "bad": "fail"}
PROJECTOR_GOES = "The projector was calibrated beside the earlier cameras: calibrate it again."
REST_STAYS = "Hand–eye, guide and table axis were found with the earlier cameras: calibrate the rig next."


@dataclass(frozen=True, eq=False)
class Before:
    """What a result is laid beside: the calibration before it, and the truth of a virtual rig."""

    cameras: CameraArrayCalibration | None
    rig: RigCalibration | None
    truth: RigCalibration | None


@dataclass(frozen=True, eq=False)
class Result:
    """One solved calibration, judged."""

    snapshot: Collection  # solved
    verdict: str
    sign: Sign
    reasons: tuple[str, ...]  # why the verdict is what it is, the limits first
    cameras: CameraArrayCalibration
    rig: RigCalibration | None  # None: the cameras alone
    rows: tuple[values.ValueRow, ...]
    facts: tuple[tuple[str, str], ...]
    left_out: tuple[tuple[str, str], ...]  # view -> reason
    comparison: str
    has_truth: bool
    has_previous: bool
    held_back: str = ""  # what the check with views held back gave


def concluded(job: Job, snapshot: Collection, before: Before) -> Result:
    """Solve from nothing and judge; runs on a job's thread. Raises CalibrationError where there is no answer."""
    from measureapp.pipeline.collecting import judge

    solved = snapshot.solve(job, afresh=True)
    verdict = judge(snapshot)
    kind, rig = snapshot.setup.kind, rig_of(snapshot, before.rig)
    cameras = solved.cameras if rig is None else rig.cameras
    shown, true, previous = (
        () if one is None else quantities_of(kind, one, other, rig)
        for one, other in (
            (cameras, rig),
            (None if before.truth is None else before.truth.cameras, before.truth),
            (before.cameras, before.rig),
        )
    )
    rows = values.rows_beside(shown, true, previous)
    return Result(
        snapshot,
        verdict.sentence,
        SIGNS[verdict.level],
        reasons_of(verdict),
        cameras,
        rig,
        rows,
        facts_of(snapshot, solved),
        tuple((name_of(snapshot.observation(view)), reason) for view, reason in solved.rejected.items()),
        compared(snapshot, before, rig),
        bool(true),
        any(row.previous is not None for row in rows),
    )


def checked(job: Job, found: Result) -> Result:
    """Check with views held back, and judge again; runs on a job's thread."""
    from measureapp.pipeline.collecting import check_held_back, judge

    try:
        held_back = check_held_back(found.snapshot, job)
    except CalibrationError as error:  # too few views
        return replace(found, held_back=str(error))
    if held_back is None:
        return found
    verdict = judge(found.snapshot, held_back=held_back)
    return replace(found, verdict=verdict.sentence, sign=SIGNS[verdict.level], held_back=held_back.verdict)


def reasons_of(verdict: Verdict) -> tuple[str, ...]:
    """Return why a verdict is what it is: the limits, what would make it better, what else speaks against it."""
    return (verdict.reason, *([verdict.remedy] if verdict.remedy else []), *verdict.reasons)


def compared(snapshot: Collection, before: Before, found: RigCalibration | None) -> str:
    """Return what changed against the calibration before, in a sentence; empty where there was none to compare with.

    Parameters
    ----------
    found : the rig with what was solved in it; an axis is compared there, since cameras that stood elsewhere saw it elsewhere
    """
    from measureapp.pipeline.collecting import compare, compare_axes

    rig, kind = before.rig, snapshot.setup.kind
    if kind == "axis" and rig is not None and found is not None:
        return compare_axes(rig.axis, found.axis).sentence
    links = {} if rig is None else {"rig": rig, "hand-eye": rig.hand_eye, "guide": rig.guide}
    previous = before.cameras if kind in ("cameras", "projector") else links.get(kind)
    if previous is None or (kind == "projector" and before.cameras is not None and before.cameras.projector is None):
        return ""
    try:
        return compare(previous, snapshot).sentence
    except CalibrationError as error:
        return str(error)


def quantities_of(
    kind: Kind, cameras: CameraArrayCalibration, rig: RigCalibration | None, found: RigCalibration | None
) -> tuple[values.Quantity, ...]:
    """Return what a calibration of this kind tells; an axis is told at the height at which it was ``found``."""
    if kind == "cameras":
        return values.camera_quantities(cameras)
    if kind == "projector":
        return () if cameras.projector is None else values.projector_quantities(cameras.projector)
    if rig is None or found is None:
        return ()
    height = float(found.axis.point_mm[2])
    if kind == "hand-eye":
        return values.hand_eye_quantities(rig.hand_eye)
    if kind == "guide":
        return values.guide_quantities(rig.guide)
    return values.axis_quantities(rig.axis, height) if kind == "axis" else values.rig_quantities(rig, height)


def rig_of(snapshot: Collection, before: RigCalibration | None) -> RigCalibration | None:
    """Return the rig with what was solved in it; None where only the cameras are known."""
    from measureapp.calibrate.motions.hand_eye import HandEyeSolution
    from measureapp.calibrate.motions.linear_guide import GuideSolution
    from measureapp.calibrate.motions.rotation_axis import AxisSolution
    from measureapp.calibrate.rig.joint_solution import RigSolution
    from measureapp.calibrate.rig.stages import carry_axis
    from measureapp.pipeline.collecting.carried import axis_carried

    solved = snapshot.solved
    assert solved is not None
    solution = solved.solution
    if isinstance(solution, RigSolution):
        return solution.calibration
    if snapshot.setup.kind in ("cameras", "projector"):
        same = before is not None and set(before.cameras.cameras) == set(solved.cameras.cameras)
        return replace(before, cameras=solved.cameras) if before is not None and same else None
    if before is None:
        raise CalibrationError("The rest of the rig is not calibrated yet.", "Calibrate the whole rig first.")
    if isinstance(solution, HandEyeSolution):
        return replace(before, hand_eye=solution.hand_eye)
    if isinstance(solution, GuideSolution):
        return replace(before, guide=solution.guide)
    assert isinstance(solution, AxisSolution)
    seen = solution.best.axis
    axis = carry_axis(seen, before.guide_from_camera(snapshot.observation(solved.used[0]).readback.full()))
    return replace(before, axis=axis_carried(axis, seen, before.hand_eye, snapshot.setup.noise))


def facts_of(snapshot: Collection, solved: Solved) -> tuple[tuple[str, str], ...]:
    """Return how the result was found, in a few figures."""
    from measureapp.calibrate.cameras.projector import HeadSolution
    from measureapp.calibrate.cameras.projector_sightings import PROJECTOR

    facts = [("Views used", f"{len(solved.used)} of {len(snapshot.observations)}")]
    cameras, head = solved.camera_solution, solved.solution
    if isinstance(head, HeadSolution):
        facts += [
            ("Reprojection (rms)", quantity(head.projector.rms_px, "px", 3)),
            ("Noise of a mark (1 σ)", quantity(head.solution.sigmas_px[PROJECTOR], "px", 3)),
        ]
    elif cameras is not None:
        facts += [
            ("Reprojection (rms)", quantity(cameras.joint_rms_px, "px", 3)),
            ("Noise of a corner (1 σ)", quantity(cameras.sigma_px, "px", 3)),
        ]
        facts += [(f"Camera {name}", _camera_words(camera)) for name, camera in solved.cameras.cameras.items()]
    if solved.residuals_mm:
        worst = max(solved.residuals_mm, key=lambda name: solved.residuals_mm[name])
        facts.append(("Largest residual", f"{millimetres(solved.residuals_mm[worst])}, {name_of(snapshot.observation(worst))}"))
    return tuple(facts)


def _camera_words(camera: CameraCalibration) -> str:
    """Return the residual of a camera, and the blur of its images where the board told it."""
    return quantity(camera.rms_px, "px", 3) + (f", blur {quantity(camera.blur_px, 'px', 2)}" if camera.blur_px else "")


def accepted(found: Result, session: Session) -> tuple[str, str]:
    """Make a result the calibration in use, on disk first; returns what to tell. Raises StorageError."""
    from measureapp.data.calibration import CameraArrayCalibration, ProjectorCalibration, RigCalibration
    from measureapp.pipeline.collecting import keep

    project = project_on_disk(session)
    had_projector = session.cameras is not None and session.cameras.projector is not None
    kind, place = found.snapshot.setup.kind, found.snapshot.folder / RESULT
    cameras, rig = found.cameras, found.rig
    valid_days = None if session.rig is None else session.rig.calibration_rules.valid_days
    if kind == "rig":
        kept = keep(found.snapshot, place if project is None else project, valid_days=valid_days)
        rig = kept if isinstance(kept, RigCalibration) else rig
    else:
        kept = keep(found.snapshot, place / (CAMERAS if kind == "projector" else f"{kind}.json"), valid_days=valid_days)
        cameras = kept if isinstance(kept, CameraArrayCalibration) else cameras
        cameras = replace(cameras, projector=kept) if isinstance(kept, ProjectorCalibration) else cameras
        rig = rig if rig is None else replace(rig, cameras=cameras)
        if rig is not None:
            _save_rig(rig, place, project)
    if rig is not None:
        session.set_calibration(rig)
    elif session.calibration is None:
        session.set_cameras(cameras)
    else:
        known, found_names = (", ".join(one.names) for one in (session.calibration.cameras, cameras))
        return "The result is kept, but the rig goes on with its own cameras.", f"It is one of {found_names}; the rig has {known}."
    return "The calibration is accepted.", _what_next(found, rig is not None, had_projector, place if project is None else project)


def _what_next(found: Result, has_rig: bool, had_projector: bool, place: Path) -> str:
    """What was found with earlier cameras and has to be found again; else where the result lies."""
    kind = found.snapshot.setup.kind
    again = [REST_STAYS] if kind == "cameras" and has_rig else []
    again += [PROJECTOR_GOES] if had_projector and kind in ("cameras", "rig") else []
    return " ".join(again) or f"It lies in {place}."


def _save_rig(rig: RigCalibration, place: Path, project: Path | None) -> None:
    """Keep the rig with its new link: in the project, or whole beside the session, to be taken up at the next start."""
    from measureapp.pipeline.collecting.keeping import write_rig
    from measureapp.project.folder import ProjectFolder

    if project is None:
        write_rig(rig, place)
    else:
        opened = ProjectFolder.open(project)
        with opened.lock():
            opened.save_calibration(rig)
