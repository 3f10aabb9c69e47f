"""The answer of `calibrate collect`, as JSON and as lines."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from measureapp.calibrate.draft.advice import Advice, Ghost
    from measureapp.calibrate.draft.comparison import Comparison
    from measureapp.calibrate.draft.verdict import Verdict
    from measureapp.calibration_session.observation import CollectedObservation
    from measureapp.calibration_session.snapshot import Snapshot
    from measureapp.data.fringe import Readback

MARKS = {"used": "✓", "new": "·", "rejected": "✗", "removed": "–", "no board": "✗"}


def collect_answer(
    snapshot: Snapshot,
    steps: Mapping[str, Sequence[str]],
    advice: Advice | None,
    verdict: Verdict | None,
    comparison: Comparison | None,
) -> dict[str, Any]:
    """Return the JSON answer: changes, every observation, and the requested results."""
    document: dict[str, Any] = {
        "session": snapshot.folder,
        "kind": snapshot.setup.kind.name,
        **steps,
        "can_undo": snapshot.can_undo,
        "can_redo": snapshot.can_redo,
        "observations": [_observation(one) for one in snapshot.observations],
        "shortfalls": snapshot.draft.shortfalls,
        "coach": None if advice is None else _advice(advice),
        "estimates": [],
        "verdict": None if verdict is None else verdict_answer(verdict),
        "comparison": None if comparison is None else _comparison(comparison),
    }
    if snapshot.solved is not None:
        kind = snapshot.setup.kind
        document["estimates"] = [
            {"name": one.name, "value": one.value, "standard_deviation": one.sigma, "unit": one.unit}
            for one in kind.estimates(kind.result(snapshot.solved))
        ]
    return document


def collect_lines(document: Mapping[str, Any]) -> list[str]:
    """Return the answer for people."""
    lines = [f"Session {document['session']}: {document['kind']}, {len(document['observations'])} observations."]
    for step in ("undone", "redone", "added", "removed"):
        if document[step]:
            lines.append(f"{step.capitalize()}: {', '.join(document[step])}")
    lines += [_observation_line(one) for one in document["observations"]]
    lines += [f"  missing: {sentence}" for sentence in document["shortfalls"]]
    if document["coach"] is not None:
        sentences = document["coach"]["sentences"] or ["Nothing is missing."]
        lines += ["Next:", *(f"  {sentence}" for sentence in sentences)]
    if document["estimates"]:
        lines += ["Estimates ± standard deviation:", *(_estimate_line(one) for one in document["estimates"])]
    if document["verdict"] is not None:
        lines += [document["verdict"]["sentence"], f"  {document['verdict']['reason']}"]
        lines += [f"  {document['verdict']['remedy']}"] if document["verdict"]["remedy"] else []
        lines += [f"  but: {reason}" for reason in document["verdict"]["but"]]
    if document["comparison"] is not None:
        lines += [document["comparison"]["sentence"], *(_change_line(one) for one in document["comparison"]["changes"])]
    return lines + ([f"Saved to {document['accepted']}"] if document["accepted"] is not None else [])


def _observation(one: CollectedObservation) -> dict[str, Any]:
    return {
        "id": one.id,
        "standing": one.status,
        "reason": one.reason,
        "images": {
            camera: {
                "file": image.path,
                "name": image.name,
                "checksum": image.checksum,
                "marks": len(one.seen[camera].ids) if camera in one.seen else 0,
                "refused": one.refused[camera].cause if camera in one.refused else None,
            }
            for camera, image in one.images.items()
        },
        "residuals_px": dict(one.residuals_px),
        "residual_mm": one.residual_mm,
        **_axes(one.readback),
    }


def _axes(at: Readback | Ghost) -> dict[str, Any]:
    """Return the positions of the axes; None for those that are not known."""
    return {
        "base_from_flange": None if at.base_from_flange is None else at.base_from_flange.matrix,
        "guide_mm": at.guide_mm,
        "table_deg": None if at.table_rad is None else math.degrees(at.table_rad),
    }


def _advice(advice: Advice) -> dict[str, Any]:
    gauges = [
        {"name": one.name, "camera": one.camera, "value": one.value, "target": one.target, "unit": one.unit, "share": one.share}
        for one in advice.gauges
    ]
    ghost = None if advice.ghost is None else {"outlines_px": dict(advice.ghost.outlines_px), **_axes(advice.ghost)}
    return {"sentences": advice.sentences, "gauges": gauges, "ghost": ghost}


def verdict_answer(verdict: Verdict) -> dict[str, Any]:
    """Return the JSON answer of a verdict."""
    return {
        "level": verdict.level,
        "sentence": verdict.sentence,
        "reason": verdict.reason,
        "remedy": verdict.remedy,
        "but": verdict.reasons,
        "expanded_mm": verdict.expanded_mm,
        "robot_adds_mm": verdict.robot_adds_mm,
        "good_mm": verdict.limits.good_mm,
        "usable_mm": verdict.limits.usable_mm,
    }


def _comparison(comparison: Comparison) -> dict[str, Any]:
    return {
        "within": comparison.within,
        "sentence": comparison.sentence,
        "on_part_mm": comparison.on_part_mm,
        "promised_mm": comparison.expanded_mm,
        "changes": [
            {
                "name": one.name,
                "previous": one.previous,
                "new": one.new,
                "difference": one.difference,
                "standard_deviation": one.sigma,
                "unit": one.unit,
                "within": one.within,
            }
            for one in comparison.changes
        ],
    }


def _observation_line(one: Mapping[str, Any]) -> str:
    px = ", ".join(f"{camera} {value:.3f} px" for camera, value in one["residuals_px"].items())
    mm = "" if one["residual_mm"] is None else f"{one['residual_mm']:.4f} mm"
    details = "  ".join(part for part in (mm, px, one["reason"]) if part)
    return f"  {MARKS[one['standing']]} {one['id']}  {one['standing']:<9} {details}".rstrip()


def _estimate_line(one: Mapping[str, Any]) -> str:
    return f"  {one['name']:<32} {one['value']:14.6f} ± {one['standard_deviation']:.6f} {one['unit']}".rstrip()


def _change_line(one: Mapping[str, Any]) -> str:
    mark = "" if one["within"] else "  more than expected"
    return f"  {one['name']:<32} {one['difference']:+14.6f} ± {one['standard_deviation']:.6f} {one['unit']}{mark}".rstrip()
