"""Lengths at the reference temperature of ISO 1, 20 °C."""

from __future__ import annotations

from dataclasses import replace

from measureapp.data.part_temperature import PartTemperature
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.settings import InspectionSettings

NOT_STATED = "The part's temperature is not stated: its lengths are those at the temperature of the scan."


def at_reference(points: MeasuredPoints, temperature: PartTemperature | None) -> MeasuredPoints:
    """Return the points as they would be at 20 °C, L₂₀ = L / (1 + α (T − 20 °C)) (ISO/TR 16015); as they are where α or T is not known.

    All points move away from the origin of their frame alike: where that is moves the part, and changes no length.
    """
    if temperature is None or temperature.factor == 1.0:
        return points
    return replace(points, points_mm=points.points_mm * temperature.factor)


def length_statements(settings: InspectionSettings) -> tuple[str, ...]:
    """Return what an inspection used for its lengths: where their scale comes from, and at which temperature they hold."""
    chosen = settings.uncertainty
    scale = f"± {2 * chosen.scale_ppm:.3g} ppm (k = 2)" if chosen.scale_ppm > 0 else "taken as exact"
    temperature = NOT_STATED if settings.temperature is None else f"Temperature of the lengths: {settings.temperature.words}."
    return f"Scale of lengths {scale}: {chosen.scale_source}.", temperature
