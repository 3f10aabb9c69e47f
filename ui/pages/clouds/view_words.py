"""Views in words: verdicts and properties."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ui.look.wording import counted, millimetres, percent, quantity, sentence
from ui.widgets.properties_panel import Group, Properties

if TYPE_CHECKING:
    from measureapp.data.cloud import ViewPlacement
    from measureapp.data.measurement import ViewResult
    from measureapp.data.view_choices import ViewChoice

USE, LEAVE_OUT = "Use it anyway", "Leave this view out"
BY_HAND, REFUSED = "accepted by hand", "refused by hand"


def view_verdict(view: ViewResult, placement: ViewPlacement | None) -> tuple[str, str, str]:
    """Return the sign of a view's verdict, the word, and the reason."""
    quality = view.quality
    used = placement is not None and placement.used
    if placement is not None and placement.verdict.startswith(REFUSED):
        return "not measured", "Refused", "Refused by hand: it is not used."
    if not quality.accepted:
        why = sentence(quality.reason)
        return ("not proven", "By hand", f"Used by hand. {why}") if used else ("fail", "Poor", why)
    if placement is not None and not used:
        return "fail", "Left out", sentence(placement.verdict.removesuffix(": left out"))
    if placement is not None and placement.verdict.endswith(BY_HAND):
        return "not proven", "By hand", "Used by hand. " + sentence(placement.verdict.removesuffix(f": {BY_HAND}"))
    if placement is not None and placement.verdict != "good":
        return "not proven", "Doubtful", sentence(placement.verdict)
    return "pass", "Good", "Accepted by cloud statistics" + (" and fine stitching." if placement is not None else ".")


def choice_for(placement: ViewPlacement | None) -> tuple[str, ViewChoice]:
    """Return what one can decide about a view, in words, and the choice that means it."""
    return (LEAVE_OUT, "refuse") if placement is not None and placement.used else (USE, "use")


def decoding_group(view: ViewResult) -> Group:
    """Return how much of the images was decoded."""
    rows = [(f"Camera {camera}", percent(figures["decoded_ratio"])) for camera, figures in view.decode.items()]
    conflicts = sum(int(figures["order_conflicts"]) for figures in view.decode.values())
    noise = [float(figures["phase_sigma_median"]) for figures in view.decode.values() if figures["phase_sigma_median"]]
    rows.append(("Order conflicts", counted(conflicts)))
    if noise:
        rows.append(("Phase noise (median)", quantity(max(noise), "rad", 4)))
    return Group("Pixels decoded", tuple(rows))


def view_properties(view: ViewResult, placement: ViewPlacement | None) -> Properties:
    """Return what there is to know about one view."""
    quality = view.quality
    groups = [
        Group(
            "Cloud",
            (
                ("Points", counted(quality.points)),
                ("Density", quantity(quality.density_per_mm2, "per mm²", 2)),
                ("Noise", millimetres(quality.noise_mm)),
                ("Outliers", percent(quality.outlier_ratio)),
                ("Completeness", percent(quality.completeness, 0)),
            ),
        )
    ]
    if placement is not None and not placement.verdict.startswith(REFUSED):
        groups.append(
            Group(
                "Fine stitching",
                (
                    ("Correction", millimetres(placement.correction_mm)),
                    ("Correction, turn", quantity(placement.correction_deg, "°")),
                    ("Neighbours allow", millimetres(placement.bound_mm)),
                    ("To other views ± σ", millimetres(placement.sigma_mm, 4)),
                    ("To other views ± σ, turn", quantity(placement.sigma_deg, "°")),
                    ("Residual (rms)", millimetres(placement.residual_mm)),
                    ("Overlap", percent(placement.overlap, 0)),
                    ("Used", "Yes" if placement.used else "No"),
                ),
            )
        )
        if placement.unconstrained_motions:
            groups.append(Group("Held by the axes alone", tuple(("", sentence(motion)) for motion in placement.unconstrained_motions)))
    if view.decode:
        groups.append(decoding_group(view))
    left_out = sorted(((count, name) for name, count in view.rejected.items() if count), reverse=True)
    if left_out:
        groups.append(Group("Points left out", tuple((sentence(name).rstrip("."), counted(count)) for count, name in left_out)))
    verdict, _, why = view_verdict(view, placement)
    return Properties(view.viewpoint_id, tuple(groups), "" if verdict == "pass" else why)
