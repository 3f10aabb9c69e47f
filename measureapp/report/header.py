"""Header of a report, and its plan as it was carried out."""

from __future__ import annotations

from datetime import datetime
from math import degrees

from measureapp.data.identification import LABELS, Identification
from measureapp.data.measurement import Measurement
from measureapp.report.model import Details, Fact, PlanLine
from measureapp.report.words import NONE, format_time, number


def header(measurement: Measurement, details: Details) -> tuple[Fact, ...]:
    """Return the fields that the template asks for, where they are filled in, and what is known without being asked."""
    inspection = measurement.inspection
    known = Identification(machine=measurement.rig[:200])
    identification = details.identification.with_defaults(known)
    asked = [Fact(LABELS[name], field_words(identification, name)) for name in details.template.description.fields]
    age = calibration_age(measurement)
    used = {placement.viewpoint_id for placement in measurement.stitched.placements if placement.used}
    return (
        *(fact for fact in asked if fact.value),
        Fact("Measured at", format_time(measurement.measured_at)),
        *((Fact("Part program", details.part_program),) if details.part_program else ()),
        Fact("Inspection program", "none" if inspection is None else inspection.program),
        Fact("Project", measurement.project),
        Fact("Rig calibrated", f"{age} before (see the warning)" if measurement.validity.all_warnings else f"{age} before"),
        Fact("Views", f"{len(used)} of {len(measurement.views)} used"),
    )


def field_words(identification: Identification, name: str) -> str:
    """Return a field of the identification as printed; empty where it is not filled in."""
    value = getattr(identification, name)
    if value is None or value == "":
        return ""
    if name == "temperature_c":
        source = f" ({identification.temperature_source})" if identification.temperature_source else ""
        return f"{number(value, 1)} °C{source}"
    return number(value, 0) if isinstance(value, float) else str(value)


def calibration_age(measurement: Measurement) -> str:
    """Return how long before the measurement the rig was calibrated.

    In minutes up to two hours, in hours up to two days, then in days.
    """
    try:
        calibrated = datetime.fromisoformat(measurement.calibration.provenance.created)
        hours = (datetime.fromisoformat(measurement.measured_at) - calibrated).total_seconds() / 3600
    except (ValueError, TypeError):
        return NONE
    if abs(hours) < 2:
        return f"{number(hours * 60, 0)} min"
    return f"{number(hours, 0)} h" if abs(hours) < 48 else f"{number(hours / 24, 0)} days"


def plan_lines(measurement: Measurement, details: Details) -> tuple[PlanLine, ...]:
    """Return every viewpoint with the pose read back and the exposures that its stored images have."""
    planned = {} if details.plan is None else {one.id: details.plan.exposures_of(one) for one in details.plan}
    made = []
    for view in measurement.views:
        taken = details.exposures_us.get(view.viewpoint_id, ())
        flange = view.readback.base_from_flange.matrix[:3, 3]
        same = taken == tuple(planned[view.viewpoint_id]) if taken and view.viewpoint_id in planned else None
        place = (float(flange[0]), float(flange[1]), float(flange[2]))
        made.append(PlanLine(view.viewpoint_id, degrees(view.readback.table_rad), view.readback.guide_mm, place, taken, same))
    return tuple(made)
