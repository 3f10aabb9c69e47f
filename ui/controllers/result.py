"""The result page of a wizard: verdict, values with comparison, and acceptance."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Literal

from measureapp.errors import CalibrationError
from ui.controllers.collected_views import name_of
from ui.controllers.stored_sessions import RESULT, project_on_disk
from ui.look.language.words import tr
from ui.look.wording import millimetres, quantity
from ui.session import Session

if TYPE_CHECKING:
    from measureapp.calibrate.draft.draft import Known, Solved
    from measureapp.calibrate.draft.estimate import Estimate
    from measureapp.calibrate.draft.verdict import Verdict
    from measureapp.calibration_session.snapshot import Snapshot
    from measureapp.data.calibration import CameraCalibration
    from ui.workers.job import Job

Sign = Literal["pass", "fail", "not proven"]
SIGNS: Mapping[str, Sign] = {"good": "pass", "usable": "not proven", "bad": "fail"}
DIGITS = {"px": 2, "mm": 3, "°": 4, "": 6}
DISTORTION_DIGITS = 5


@dataclass(frozen=True)
class ValueRow:
    """A value with its true and its previous one, where they are known."""

    estimate: Estimate
    true: float | None = None
    previous: float | None = None

    @property
    def digits(self) -> int:
        """How many decimals are shown."""
        return DISTORTION_DIGITS if self.estimate.label.startswith("Distortion") else DIGITS[self.estimate.unit]


@dataclass(frozen=True, eq=False)
class Result:
    """One solved calibration with its verdict."""

    snapshot: Snapshot  # solved
    known: Known  # the calibration before
    merged: Known  # the calibration with the result
    verdict: str
    sign: Sign
    reasons: tuple[str, ...]  # of the verdict, the limits first
    rows: tuple[ValueRow, ...]
    facts: tuple[tuple[str, str], ...]
    rejected: tuple[tuple[str, str], ...]  # view -> reason
    comparison: str
    has_truth: bool
    has_previous: bool
    held_back: str = ""  # result of the test with held-back views


def conclude(job: Job, snapshot: Snapshot, known: Known, truth: Known) -> Result:
    """Solve from scratch and evaluate; runs on a job's thread. Raises CalibrationError where there is no solution."""
    from measureapp.calibrate.draft.verdict import evaluate, require_solution

    snapshot = snapshot.solve(job, afresh=True)
    draft, kind = snapshot.draft, snapshot.setup.kind
    solved, verdict = require_solution(draft), evaluate(draft)
    merged = kind.merge(draft, solved, known)
    rows = pair_values(kind.shown(merged, merged), kind.shown(truth, merged), kind.shown(known, merged))
    return Result(
        snapshot,
        known,
        merged,
        verdict.sentence,
        SIGNS[verdict.level],
        reasons_of(verdict),
        rows,
        facts_of(snapshot, solved),
        tuple((name_of(snapshot.observation(view)), reason) for view, reason in solved.rejected.items()),
        _compare(snapshot, solved, known, merged),
        any(row.true is not None for row in rows),
        any(row.previous is not None for row in rows),
    )


def cross_validate(job: Job, found: Result) -> Result:
    """Test the stated uncertainty with held-back views, and evaluate again; runs on a job's thread."""
    from measureapp.calibrate.draft import verdict

    draft = found.snapshot.draft
    try:
        held_back = verdict.cross_validate(draft, job)
    except CalibrationError as error:  # too few views
        return replace(found, held_back=str(error))
    if held_back is None:
        return found
    evaluation = verdict.evaluate(draft, held_back=held_back)
    return replace(found, verdict=evaluation.sentence, sign=SIGNS[evaluation.level], held_back=held_back.verdict)


def reasons_of(verdict: Verdict) -> tuple[str, ...]:
    """Return the reasons of a verdict: limits, remedy and objections."""
    return (verdict.reason, *([verdict.remedy] if verdict.remedy else []), *verdict.reasons)


def facts_of(snapshot: Snapshot, solved: Solved) -> tuple[tuple[str, str], ...]:
    """Return how the result was found, in a few figures."""
    facts = [("Views used", tr("{count} of {total}", count=len(solved.used), total=len(snapshot.observations)))]
    cameras, lenses = solved.camera_solution, snapshot.setup.lenses
    if cameras is not None and not snapshot.setup.calibrates_cameras:
        (lens,) = lenses
        facts += [
            ("Reprojection (rms)", quantity(cameras.calibration.cameras[lens].rms_px, "px", 3)),
            ("Noise of a mark (1 σ)", quantity(cameras.sigmas_px[lens], "px", 3)),
        ]
    elif cameras is not None:
        facts += [
            ("Reprojection (rms)", quantity(cameras.joint_rms_px, "px", 3)),
            ("Noise of a corner (1 σ)", quantity(cameras.sigma_px, "px", 3)),
        ]
        facts += [(tr("Camera {name}", name=name), _camera_words(camera)) for name, camera in solved.cameras.cameras.items()]
    if solved.residuals_mm:
        worst = max(solved.residuals_mm, key=lambda name: solved.residuals_mm[name])
        facts.append(("Largest residual", f"{millimetres(solved.residuals_mm[worst])}, {name_of(snapshot.observation(worst))}"))
    return tuple(facts)


def accept(found: Result, session: Session) -> tuple[str, str]:
    """Make a result the calibration in use, on disk first; returns the message. Raises StorageError."""
    from measureapp.calibration_session.accepting import accept_result

    project, place = project_on_disk(session), found.snapshot.folder / RESULT
    valid_days = None if session.rig is None else session.rig.calibration_rules.valid_days
    now = accept_result(found.snapshot, found.merged, place, project, valid_days=valid_days)
    if now.rig is not None:
        session.set_calibration(now.rig)
    elif session.calibration is None and now.cameras is not None:
        session.set_cameras(now.cameras)
    elif session.calibration is not None and now.cameras is not None:
        rig, own = (", ".join(one.names) for one in (session.calibration.cameras, now.cameras))
        return "The result is saved, but the rig keeps its own cameras.", tr("It is one of {own}; the rig has {rig}.", own=own, rig=rig)
    outdated = found.snapshot.setup.kind.outdates(found.known if now.rig is not None else replace(found.known, rig=None))
    return "The calibration is accepted.", " ".join(outdated) or tr("Saved to {words}.", words=place if project is None else project)


def _compare(snapshot: Snapshot, solved: Solved, known: Known, merged: Known) -> str:
    """Return the comparison with the previous calibration in a sentence; empty where there was none."""
    try:
        found = snapshot.setup.kind.compare_merged(snapshot.draft, solved, known, merged)
    except CalibrationError as error:
        return str(error)
    return "" if found is None else found.sentence


def _camera_words(camera: CameraCalibration) -> str:
    """Return the residual of a camera, and the blur of its images where it was determined."""
    return quantity(camera.rms_px, "px", 3) + (tr(", blur {blur_px}", blur_px=quantity(camera.blur_px, "px", 2)) if camera.blur_px else "")


def pair_values(found: Sequence[Estimate], truth: Sequence[Estimate], previous: Sequence[Estimate]) -> tuple[ValueRow, ...]:
    """Return one row per value found; the others are matched by name."""
    true, before = ({one.name: one.value for one in values} for values in (truth, previous))
    return tuple(ValueRow(one, true.get(one.name), before.get(one.name)) for one in found)
