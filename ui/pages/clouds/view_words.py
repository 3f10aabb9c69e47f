"""Texts about views: verdicts and properties."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ui.look.language.words import tr
from ui.look.wording import counted, millimetres, percent, point_reason, quantity, sentence
from ui.widgets.properties_panel import Group, Properties

if TYPE_CHECKING:
    from measureapp.data.cloud import ViewPlacement
    from measureapp.data.measurement import ViewResult
    from measureapp.data.view_choices import ViewChoice

USE, EXCLUDE = "Use this view anyway", "Exclude this view"
ACCEPTED_BY_HAND, REFUSED = "accepted by hand", "refused by hand"


def view_verdict(view: ViewResult, placement: ViewPlacement | None) -> tuple[str, str, str]:
    """Return the sign of a view's verdict, the word, and the reason."""
    quality = view.quality
    used = placement is not None and placement.used
    if placement is not None and placement.verdict.startswith(REFUSED):
        return "not measured", "Excluded", "Excluded manually."
    if not quality.accepted:
        why = sentence(quality.reason)
        return ("not proven", "Manual", tr("Used by manual choice. {why}", why=why)) if used else ("fail", "Poor", why)
    if placement is not None and not used:
        return "fail", "Excluded", sentence(placement.verdict.rpartition(": ")[0] or placement.verdict)
    if placement is not None and placement.verdict.endswith(ACCEPTED_BY_HAND):
        return (
            "not proven",
            "Manual",
            tr("Used by manual choice. {why}", why=sentence(placement.verdict.removesuffix(f": {ACCEPTED_BY_HAND}"))),
        )
    if placement is not None and placement.verdict != "good":
        return "not proven", "Doubtful", sentence(placement.verdict)
    return "pass", "Good", "Accepted by cloud quality and registration." if placement is not None else "Accepted by cloud quality."


def choice_for(placement: ViewPlacement | None) -> tuple[str, ViewChoice]:
    """Return the available decision about a view: its text, and the choice."""
    return (EXCLUDE, "refuse") if placement is not None and placement.used else (USE, "use")


def decoding_group(view: ViewResult) -> Group:
    """Return the decoded share of the images."""
    rows = [(tr("Camera {camera}", camera=camera), percent(figures["decoded_ratio"])) for camera, figures in view.decode.items()]
    conflicts = sum(int(figures["order_conflicts"]) for figures in view.decode.values())
    noise = [float(figures["phase_sigma_median"]) for figures in view.decode.values() if figures["phase_sigma_median"]]
    rows.append(("Order conflicts", counted(conflicts)))
    if noise:
        rows.append(("Phase noise (median)", quantity(max(noise), "rad", 4)))
    return Group("Pixels decoded", tuple(rows))


def view_properties(view: ViewResult, placement: ViewPlacement | None) -> Properties:
    """Return the properties of one view."""
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
                "Registration",
                (
                    ("Correction", millimetres(placement.correction_mm)),
                    ("Correction, rotation", quantity(placement.correction_deg, "°")),
                    ("Limit of the correction", millimetres(placement.bound_mm)),
                    ("Position σ", millimetres(placement.sigma_mm, 4)),
                    ("Orientation σ", quantity(placement.sigma_deg, "°")),
                    ("Residual (rms)", millimetres(placement.residual_mm)),
                    ("Overlap", percent(placement.overlap, 0)),
                    ("Used", "Yes" if placement.used else "No"),
                ),
            )
        )
        if placement.unconstrained_motions:
            groups.append(
                Group("Determined by kinematics only", tuple(("", sentence(motion)) for motion in placement.unconstrained_motions))
            )
    if view.decode:
        groups.append(decoding_group(view))
    rejected = sorted(((count, name) for name, count in view.rejected.items() if count), reverse=True)
    if rejected:
        groups.append(Group("Rejected points", tuple((point_reason(name), counted(count)) for count, name in rejected)))
    verdict, _, why = view_verdict(view, placement)
    return Properties(view.viewpoint_id, tuple(groups), "" if verdict == "pass" else why)
