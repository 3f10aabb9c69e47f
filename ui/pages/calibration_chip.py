"""State of the calibration in the header: age, what it adds to a length, and warnings."""

from __future__ import annotations

from dataclasses import dataclass
from datetime import UTC, datetime
from typing import TYPE_CHECKING

from ui.look.language.words import tr
from ui.look.wording import millimetres, when
from ui.pages.calibration_rows import ADDED_LIMIT_MM, added_to_length_mm, judged_rows

if TYPE_CHECKING:
    from measureapp.data.calibration import RigCalibration
    from measureapp.data.rig import RigDescription
    from measureapp.data.validity import Validity

NONE_TIP = "Calibrate the rig on the Calibrate page"
ADDED_TIP = "Age of the calibration, and what it adds to a length between two views, before registration (k = 2)."


@dataclass(frozen=True)
class ChipState:
    """Text, colour and tip of the chip."""

    words: str
    colour: str
    tip: str


def calibration_state(
    calibration: RigCalibration | None, rig: RigDescription | None, validity: Validity | None, now: datetime | None = None
) -> ChipState:
    """Return the state of the calibration: the most severe warning first."""
    if calibration is None:
        return ChipState("Not calibrated", "verdict_not_proven", NONE_TIP)
    age = when(calibration.provenance.created, now) or "before"
    reasons = _reasons(calibration, rig, validity, now)
    drift = None if validity is None else validity.drift
    if drift is not None and drift.status in ("watch", "drifted"):
        who = " or ".join(drift.cameras)
        colour, mark = ("verdict_fail", "✗") if drift.status == "drifted" else ("verdict_not_proven", "!")
        return ChipState(
            tr("Camera {who} moved · {error_mm} {mark}", who=who, error_mm=millimetres(drift.error_mm), mark=mark),
            colour,
            "\n".join(reasons),
        )
    if reasons:
        return ChipState(tr("Calibrated {age} · check it !", age=age), "verdict_not_proven", "\n".join(reasons))
    poor = [f"{found.name}: {found.residual}. {found.criterion}." for found in judged_rows(calibration, rig) if not found.good]
    if poor:
        return ChipState(tr("Calibrated {age} · poor fit ✗", age=age), "verdict_fail", "\n".join(poor))
    added = added_to_length_mm(calibration, rig)
    good = added <= ADDED_LIMIT_MM
    tip = ADDED_TIP if drift is None else "\n".join(line for line in (ADDED_TIP, drift.sentence, drift.undetectable) if line)
    return ChipState(
        tr("Calibrated {age} · adds {added} (k = 2) {words}", age=age, added=millimetres(added), words="✓" if good else "✗"),
        "verdict_pass" if good else "verdict_fail",
        tip,
    )


def _reasons(calibration: RigCalibration, rig: RigDescription | None, validity: Validity | None, now: datetime | None) -> tuple[str, ...]:
    """Warnings of the last scan, and expiry of the calibration."""
    from measureapp.calibrate.cameras.validity import shortfalls

    stated = () if validity is None else validity.all_warnings
    moment = now or datetime.now(UTC)
    aged = (
        shortfalls(calibration.provenance, moment)
        if rig is None
        else shortfalls(calibration.provenance, moment, None, rig.calibration_rules)
    )
    return tuple(dict.fromkeys((*stated, *aged)))
