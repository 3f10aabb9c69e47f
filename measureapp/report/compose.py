"""Composition of the report model from a measurement."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import replace
from datetime import UTC, datetime
from math import degrees, hypot
from typing import Any

from measureapp import __version__
from measureapp.data.calibration import CameraCalibration, RigCalibration
from measureapp.data.consistency import Consistency
from measureapp.data.dimension import SEVERITY, Dimension, Verdict, of_other_versions, worst_verdict
from measureapp.data.measurement import Alignment, Measurement
from measureapp.data.mesh import Mesh
from measureapp.data.setups import JoinedSetUp
from measureapp.data.validity import Validity
from measureapp.errors import InspectionError
from measureapp.inspection.alignment.best_fit import best_fit
from measureapp.inspection.settings import VerdictRule
from measureapp.inspection.surface.deviation import Deviation
from measureapp.inspection.verdict import RULES
from measureapp.progress import NoProgress, Progress
from measureapp.report.deviation_pictures import summarise_deviation
from measureapp.report.drawing import Compared, Drawing
from measureapp.report.header import calibration_age, header, plan_lines
from measureapp.report.kept import Afresh
from measureapp.report.model import Details, Fact, Pictures, ReportModel, Section, ViewLine
from measureapp.report.part_pictures import placed_mesh
from measureapp.report.valid_pixels import valid_pixel_facts, valid_pixels
from measureapp.report.words import format_key, format_name, format_setting, number, percent

KEYS = {
    "plan": "Plan",
    "patterns": "Patterns",
    "exposures_us": "Exposures (µs)",
    "exposure rule": "Exposure rule",
    "noise": "Noise",
    "surroundings": "Surroundings",
    "spacing_mm": "Spacing (mm)",
    "merge_voxel_mm": "Merge voxel (mm)",
    "views_used": "Views used",
    "set-ups": "Set-ups",
}  # of settings and notes of a measurement, as the report names them
COUNTED = {
    Verdict.FAIL: "{count} fail",
    Verdict.NOT_PROVEN: "{count} not proven",
    Verdict.NOT_MEASURED: "{count} not measured",
    Verdict.PASS: "{count} pass",
    Verdict.NO_TOLERANCE: "{count} no tolerance",
}
DEVIATIONS_BY = "Deviations by {name}"
PAIR = "Cameras {name}"
BEST_FIT = "The alignment is a best fit, which belongs to no datum system and spreads defects over the whole part: for comparison only."


def compose(
    measurement: Measurement,
    nominal: Mesh | None = None,
    *,
    details: Details = Details(),  # noqa: B008 - immutable
    verdict_rule: VerdictRule = "iso-14253-1:2017",
    pictures: bool = True,
    parts: Afresh = Afresh(),  # noqa: B008 - stateless
    progress: Progress = NoProgress(),  # noqa: B008 - stateless
) -> ReportModel:
    """Compose the report model of a measurement.

    Parameters
    ----------
    nominal : the nominal mesh, if there is one; the report then shows the deviation of the cloud from it
    details : identification, template, plan and exposures
    pictures : False omits the pictures of the part, which take some seconds
    parts : where deviation and pictures are taken from
    """
    dimensions = () if measurement.inspection is None else measurement.inspection.dimensions
    verdict, summary = summarise_verdicts(dimensions)
    deviation, why_not = (None, "") if nominal is None else _find_deviation(measurement, nominal, parts, progress)
    details = details if details.created_at else replace(details, created_at=datetime.now(UTC).isoformat(timespec="seconds"))
    compared = None
    if deviation is not None and nominal is not None:
        summary_of_it = summarise_deviation(nominal, deviation, placed_mesh(measurement), scale=details.deviation_scale)
        compared = Compared(nominal, deviation, summary_of_it)
    drawn = parts.pictures(Drawing(measurement, compared), progress) if pictures else Pictures()
    return ReportModel(
        measurement=measurement,
        title=details.identification.part_name or measurement.part,
        software=f"MeasureApp {__version__}",
        verdict=verdict,
        summary=summary,
        verdict_rule=RULES[verdict_rule],
        dimensions=tuple(dimensions),
        views=view_lines(measurement),
        header=header(measurement, details),
        sections=_sections(measurement, details, deviation, why_not),
        pictures=drawn.part,
        deviation=None if compared is None else replace(compared.summary, pictures=drawn.deviation),
        details=details,
        failing=drawn.failing,
        cross_sections=drawn.cross_sections,
        plan_lines=plan_lines(measurement, details),
        compared=deviation,
    )


def _sections(measurement: Measurement, details: Details, deviation: Deviation | None, why_not: str) -> tuple[Section, ...]:
    dimensions = () if measurement.inspection is None else measurement.inspection.dimensions
    calibration = (
        *_version_facts(dimensions),
        *_validity_facts(measurement.validity),
        Fact("Calibration age", calibration_age(measurement)),
        *_length_facts(dimensions, () if measurement.inspection is None else measurement.inspection.lengths),
        *_calibration_facts(measurement.calibration),
    )
    return (
        Section("Cloud and alignment", _cloud_facts(measurement, deviation, why_not)),
        Section("Set-ups", _setup_facts(measurement.setups)),
        Section("Checks of the error model", _consistency_facts(measurement.consistency)),
        Section("Valid pixels of the exposures", valid_pixel_facts(valid_pixels(measurement, details.exposures_us))),
        Section("Calibration", calibration),
        Section("Settings", _settings_facts(measurement.settings)),
    )


def _find_deviation(measurement: Measurement, nominal: Mesh, parts: Afresh, progress: Progress) -> tuple[Deviation | None, str]:
    """Return the deviation of the stitched cloud from the nominal, in the inspection's alignment or a best fit; or the reason for none."""
    try:
        alignment = best_fit(measurement.stitched, nominal) if measurement.inspection is None else measurement.inspection.alignment
        return parts.deviation(measurement.stitched, nominal, alignment, progress), ""
    except InspectionError as error:
        return None, error.message


def summarise_verdicts(dimensions: tuple[Dimension, ...]) -> tuple[Verdict | None, str]:
    """Return the verdict on the part, the most severe of its dimensions, and the number of each."""
    if not dimensions:
        return None, "No inspection program: no dimensions evaluated."
    counts = Counter(dimension.verdict for dimension in dimensions)
    verdict = worst_verdict(counts)
    total = len(dimensions)
    if counts[Verdict.NO_TOLERANCE] == total:
        return None, "No dimension has a tolerance: no verdict."
    if verdict is Verdict.PASS and counts[Verdict.NO_TOLERANCE]:
        return verdict, f"All {counts[Verdict.PASS]} dimensions with a tolerance pass; {counts[Verdict.NO_TOLERANCE]} without tolerance."
    if verdict is Verdict.PASS:
        return verdict, "The dimension passes." if total == 1 else f"All {total} dimensions pass."
    listed = ", ".join(COUNTED[kind].format(count=counts[kind]) for kind in SEVERITY if counts[kind])
    return verdict, f"Of 1 dimension: {listed}." if total == 1 else f"Of {total} dimensions: {listed}."


def view_lines(measurement: Measurement) -> tuple[ViewLine, ...]:
    """Return one line per view, in order of measurement."""
    placements = {placement.viewpoint_id: placement for placement in measurement.stitched.placements}
    lines = []
    for view in measurement.views:
        placed, quality = placements.get(view.viewpoint_id), view.quality
        lines.append(
            ViewLine(
                viewpoint_id=view.viewpoint_id,
                points=quality.points,
                noise_mm=quality.noise_mm,
                completeness=quality.completeness,
                outlier_ratio=quality.outlier_ratio,
                distortion_mm=quality.distortion_mm,
                correction_mm=None if placed is None else placed.correction_mm,
                correction_deg=None if placed is None else placed.correction_deg,
                residual_mm=None if placed is None else placed.residual_mm,
                overlap=None if placed is None else placed.overlap,
                bound_mm=None if placed is None else placed.bound_mm,
                sigma_mm=None if placed is None else placed.sigma_mm,
                unconstrained_motions=() if placed is None else placed.unconstrained_motions,
                used=placed is not None and placed.used,
                verdict=quality.reason or "not stitched" if placed is None else placed.verdict,
            )
        )
    return tuple(lines)


def _cloud_facts(measurement: Measurement, deviation: Deviation | None, why_not: str) -> tuple[Fact, ...]:
    mesh, inspection, loop_closure = measurement.mesh, measurement.inspection, measurement.stitched.loop_closure
    facts = [Fact("Stitched points", f"{len(measurement.stitched):,}".replace(",", " "))]
    if loop_closure is not None:
        gap = f"{loop_closure.gap_mm:.3f} mm and {loop_closure.gap_deg:.4f}° (expected: {loop_closure.sigma_mm:.3f} mm)"
        facts.append(Fact("Loop closure", f"over {len(loop_closure.viewpoints)} views around the part: {gap}"))
    if mesh is not None:
        filled = 0.0 if mesh.measured is None or len(mesh.measured) == 0 else 1.0 - float(mesh.measured.mean())
        count = f"{len(mesh.triangles):,}".replace(",", " ")
        facts.append(Fact("Surface", f"{count} triangles, {percent(filled)} filled" if filled else f"{count} triangles"))
    alignment = inspection.alignment if inspection is not None else None if deviation is None else deviation.alignment
    if alignment is not None:
        facts += _alignment_facts(alignment)
    if why_not:
        facts.append(Fact("No deviation from the nominal", why_not))
    facts += [Fact(fact_name(name), f"{value:.4g}") for name, value in measurement.stitched.notes.items()]
    return tuple(facts)


def _alignment_facts(alignment: Alignment) -> list[Fact]:
    facts = [Fact("Alignment to the nominal", alignment.name)]
    if alignment.for_comparison_only:
        facts.append(Fact("Warning", BEST_FIT))
    if alignment.residuals_mm:
        stays = ", ".join(f"{name} {number(residual)} mm" for name, residual in alignment.residuals_mm.items())
        facts.append(Fact("Residuals of the alignment", stays))
    elif alignment.rms_mm > 0:
        facts.append(
            Fact("Residual of the alignment", f"{number(alignment.rms_mm)} mm rms over {percent(alignment.overlap)} of the points")
        )
    if alignment.undetermined:
        facts.append(Fact("Not determined by the points", ", ".join(alignment.undetermined)))
    return facts + [Fact("About the alignment", note) for note in alignment.notes]


def _setup_facts(setups: Sequence[JoinedSetUp]) -> tuple[Fact, ...]:
    """Return the set-ups of a joined measurement: how each was joined, and the uncertainty of its joint."""
    words = {
        "overlap": "joined by common surface",
        "spheres": "joined by reference spheres",
        "nominal": "joined by common surface and nominal",
    }
    return tuple(
        Fact(
            setup.name,
            "defines the part frame"
            if setup.method == "reference"
            else f"{words[setup.method]}, {percent(setup.overlap)} common; joint σ {number(setup.sigma_mm, 4)} mm and "
            f"{number(setup.sigma_deg, 4)}°, residual {number(setup.residual_mm)} mm",
        )
        for setup in setups
    )


def _consistency_facts(consistency: Consistency) -> tuple[Fact, ...]:
    """Return the checks of the error model: the result in one sentence, then each check."""
    if not consistency.checks:
        return ()
    facts = [Fact("Result", consistency.sentence)]
    return (*facts, *(Fact(DEVIATIONS_BY.format(name=check.name), check.sentence) for check in consistency.checks))


def _version_facts(dimensions: Sequence[Dimension]) -> tuple[Fact, ...]:
    """Return a warning where rows of one table were evaluated by different versions: their U may follow different error models."""
    others = of_other_versions(dimensions, __version__)
    if not others:
        return ()
    listed = ", ".join(f"{one.name} ({one.version})" if one.version else f"{one.name} (an earlier one)" for one in others)
    return (
        Fact("Warning", f"Evaluated by another version of MeasureApp than the rest: {listed}. Their U may follow another error model."),
    )


def _validity_facts(validity: Validity) -> tuple[Fact, ...]:
    facts = [Fact("Warning", warning) for warning in (*validity.warnings, *([validity.axes] if validity.axes else []))]
    if validity.drift is not None:
        alarmed = validity.drift.status in ("watch", "drifted")
        facts.append(Fact("Warning" if alarmed else "Camera drift check", validity.drift.sentence))
        if validity.drift.undetectable:
            facts.append(Fact("Limits of the drift check", validity.drift.undetectable))
    temperature = "not reported by the rig" if validity.temperature_c is None else f"{number(validity.temperature_c, 1)} °C"
    return (*facts, Fact("Head temperature during scan", temperature))


def _calibration_facts(calibration: RigCalibration) -> tuple[Fact, ...]:
    cameras = calibration.cameras
    facts = [Fact(f"Camera {name}", _camera_words(cameras.cameras[name])) for name in cameras.names]
    facts += [Fact(PAIR.format(name=name), f"rms {number(rms)} px") for name, rms in cameras.pair_rms_px.items()]
    if cameras.marks_rms_mm:
        facts.append(Fact("Marks of the board", f"displaced by {number(cameras.marks_rms_mm)} mm (rms), estimated with the cameras"))
    axis, hand_eye, guide = calibration.axis, calibration.hand_eye, calibration.guide
    facts += [
        Fact("Rotation axis", _residual_words(axis.point_sigma_mm, axis.direction_sigma_rad, axis.residual_mm)),
        Fact(
            "Hand–eye",
            _residual_words(hand_eye.translation_sigma_mm, hand_eye.rotation_sigma_rad, hand_eye.residual_mm, hand_eye.method),
        ),
        Fact(
            "Linear guide",
            f"scale {guide.scale:.6f} ± {guide.scale_sigma:.6f}, σ {number(degrees(guide.direction_sigma_rad), 4)}°, "
            f"straightness {number(guide.straightness_mm)} mm",
        ),
    ]
    if calibration.motions is not None:
        motions = calibration.motions
        stated = [f"table: {motions.table_words}", *([f"guide: {motions.guide_words}"] if motions.guide_words else [])]
        facts += [Fact("Error motions", "; ".join(stated)), Fact("Effect of error motions", motions.sentences[-1])]
    provenance = calibration.provenance
    if provenance.temperature_c is not None:
        facts.append(Fact("Head temperature during calibration", f"{number(provenance.temperature_c, 1)} °C"))
    if provenance.valid_days is not None:
        facts.append(Fact("Valid for", f"{provenance.valid_days:g} days"))
    if provenance.method:
        facts.append(Fact("Method", provenance.method))
    return tuple(facts)


def _length_facts(dimensions: Sequence[Dimension], lengths: Sequence[str]) -> tuple[Fact, ...]:
    """Return what calibration and length reference add to the lengths of this report, and the temperature at which they hold."""
    if not dimensions:
        return ()
    added = added_to_lengths(dimensions)
    titles = ("Length reference", "Temperature of the part")
    stated = [Fact(title, sentence) for title, sentence in zip(titles, lengths or _lengths_before(dimensions), strict=False)]
    return (*((Fact("Share of calibration and length scale in U", added),) if added else ()), *stated)


def _lengths_before(dimensions: Sequence[Dimension]) -> tuple[str]:
    """Return the length reference of an inspection from before inspections stated theirs."""
    stated = any(one.budget.get("scale") for one in dimensions)
    known = 'in the contribution "scale"' if stated else "not included (taken as exact)"
    return (f"calibration board; uncertainty of its lengths and of the part temperature {known}",)


def added_to_lengths(dimensions: Sequence[Dimension]) -> str:
    """Return what the calibration contributes to the uncertainty of the lengths that were measured; empty where no budget states it."""
    lengths = [one for one in dimensions if one.unit == "mm" and one.measured is not None and "calibration" in one.budget]
    added = [(hypot(one.budget["calibration"], one.budget.get("scale", 0.0)), one) for one in lengths]
    if not added:
        return ""
    size, worst = max(added, key=lambda pair: pair[0])
    return f"at most {number(size, 4)} mm ({format_name(worst.name)})"


def _camera_words(camera: CameraCalibration) -> str:
    stated = [f"rms {number(camera.rms_px)} px"]
    if camera.blur_px:
        stated.append(f"blur {number(camera.blur_px, 2)} px")
    if camera.serial:
        stated.append(f"serial {camera.serial}")
    return ", ".join(stated)


def _residual_words(sigma_mm: float, sigma_rad: float, residual_mm: float, method: str = "") -> str:
    sigma, turned, residual = number(sigma_mm), number(degrees(sigma_rad), 4), number(residual_mm)
    if method:
        return f"σ {sigma} mm and {turned}°, residual {residual} mm ({method})"
    return f"σ {sigma} mm and {turned}°, residual {residual} mm"


def _settings_facts(settings: Mapping[str, Any]) -> tuple[Fact, ...]:
    facts: list[Fact] = []
    for name, value in settings.items():
        if isinstance(value, Mapping):
            facts += [Fact(f"{fact_name(name)}: {format_key(key)}", format_setting(item)) for key, item in value.items()]
        else:
            facts.append(Fact(fact_name(name), format_setting(value)))
    return tuple(facts)


def fact_name(key: str) -> str:
    """Return a key of a document, such as that of a setting, as the name of a fact."""
    return KEYS.get(key) or format_key(key).capitalize()
