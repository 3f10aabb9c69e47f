"""Summary of a measurement for the terminal."""

from __future__ import annotations

from typing import TYPE_CHECKING

from measureapp.cli.reply import say, triple
from measureapp.data.dimension import Verdict
from measureapp.data.shown_number import shown_number
from measureapp.data.surroundings import SURROUNDINGS
from measureapp.report.words import format_tolerance

if TYPE_CHECKING:
    from measureapp.data.dimension import Dimension
    from measureapp.data.measurement import Alignment, Measurement
    from measureapp.pipeline.events import Event, ExposuresChosen, ValidityKnown

MARK = {Verdict.PASS: "✓", Verdict.FAIL: "✗", Verdict.NOT_PROVEN: "?", Verdict.NOT_MEASURED: "–", Verdict.NO_TOLERANCE: "·"}


def report_event(event: Event) -> None:
    """Print failed views, a missing surface, chosen exposures and warnings to standard error."""
    from measureapp.acquire.events import ViewpointFailed, ViewpointRetaken
    from measureapp.pipeline.events import (
        CalibrationReady,
        CloudsKept,
        ExposuresChosen,
        MemoryShort,
        ResultKept,
        SurfaceFailed,
        ValidityKnown,
        ViewFailed,
    )

    if isinstance(event, ViewpointFailed | ViewFailed):
        say(f"{event.viewpoint_id}: {event.reason}")
    elif isinstance(event, ViewpointRetaken):
        say(f"{event.viewpoint_id}: taken again. {event.reason}")
    elif isinstance(event, CalibrationReady):
        for objection in event.objections:
            say(f"Calibration: {objection}")
    elif isinstance(event, CloudsKept):
        say(f"{event.count} of {event.of} clouds kept, {'placed anew' if event.placed_anew else 'as they were'}.")
    elif isinstance(event, ResultKept):
        say("Calibration kept, as it was." if event.what == "calibration" else "Stitched cloud kept, as it was.")
    elif isinstance(event, MemoryShort):
        say(
            f"{event.threads} thread in place of {event.usual} detects the board: these would need about {event.needed_gib:.1f} GiB of memory, "
            f"and {event.available_gib:.1f} GiB are available."
        )
    elif isinstance(event, SurfaceFailed):
        say(f"No surface: {event.reason} {event.remedy}")
    elif isinstance(event, ExposuresChosen):
        say(exposures_line(event))
    elif isinstance(event, ValidityKnown):
        report_warnings(event)


def report_warnings(event: ValidityKnown) -> None:
    """Print warnings about the calibration before a scan; those found by the scan are part of its results."""
    if event.validity.drift is None:
        for warning in event.validity.warnings:
            say(f"Calibration: {warning}")


def exposures_line(event: ExposuresChosen) -> str:
    """Return the exposures chosen by a probe, with their predicted benefit."""
    times = ", ".join(f"{exposure / 1000:g}" for exposure in event.exposures_us)
    note = f"; {event.note}" if event.note else ""
    place = f"{event.viewpoint_id}: " if event.viewpoint_id else ""
    return (
        f"{place}Exposures chosen: {times} ms, {event.decodable_share:.1%} of the lit pixels decodable "
        f"(exposures of the plan: {event.planned_share:.1%}){note}."
    )


def measurement_lines(measurement: Measurement) -> list[str]:
    """Return the summary of a measurement."""
    used = sum(placement.used for placement in measurement.stitched.placements)
    lines = [f"{measurement.part}: {len(measurement.stitched):,} points from {used} of {len(measurement.views)} views."]
    for placement in measurement.stitched.placements:
        if placement.verdict != "good":
            lines.append(f"  {placement.viewpoint_id}: {placement.verdict}")
    if SURROUNDINGS in measurement.settings:
        lines.append(measurement.settings[SURROUNDINGS])
    lines += [f"Calibration: {sentence}" for sentence in measurement.validity.all_warnings]
    if measurement.consistency.sentence:
        lines.append(f"Checks of the error model: {measurement.consistency.sentence}")
    if measurement.inspection is None:
        return [*lines, "The project has no inspection program."]
    from measureapp.data.verdicts import worst_first

    return lines + [dimension_line(dimension) for dimension in worst_first(measurement.inspection.dimensions)]


def dimension_line(dimension: Dimension) -> str:
    """Return one dimension as a line: mark, name, measured ± uncertainty, nominal, deviation."""
    start = f"  {MARK[dimension.verdict]} {dimension.name:<18}"
    if dimension.measured is None or dimension.deviation is None:
        return f"{start}not measured: {dimension.reason}"
    shown = dimension.round_uncertainty()
    uncertainty = "" if shown is None else f" ± {shown:.3f}"
    limits = dimension.lower_tolerance, dimension.upper_tolerance
    tolerance = dimension.tolerance_source or ("" if None in limits else format_tolerance(*limits))
    source = f", {tolerance}" if tolerance else ""
    warning = f"\n      {dimension.warning}." if dimension.warning else ""
    return (
        f"{start}{shown_number(dimension.measured):>9}{uncertainty} {dimension.unit} (nominal {dimension.nominal:g}, deviation {shown_number(dimension.deviation, signed=True)}"
        f"{source})  {dimension.verdict.value}{warning}"
    )


def alignment_lines(alignment: Alignment) -> str:
    """Return an alignment in lines: name, residuals, undetermined motions, notes."""
    lines = [f"Alignment: {alignment.name}" + (f", rms {alignment.rms_mm:.3f} mm." if alignment.rms_mm > 0 else ".")]
    if alignment.residuals_mm:
        lines.append("Residuals: " + ", ".join(f"{name} {off:.4f} mm" for name, off in alignment.residuals_mm.items()) + ".")
    if alignment.undetermined:
        lines.append("Not determined by the points: " + ", ".join(alignment.undetermined) + ".")
    if alignment.fixed < 6:
        lines.append(f"Fixed by its features: {alignment.fixed} of 6 degrees of freedom.")
    if alignment.weakest_mm is not None:
        lines.append(
            f"Weakest direction {triple(alignment.weakest_direction, 2)}: ± {alignment.weakest_mm:.3f} mm (k = 2) at a corner of the part."
        )
    return "\n".join([*lines, *(f"{note}." for note in alignment.notes)])
