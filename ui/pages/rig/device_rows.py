"""Rows and properties of the devices: nominal values, and what their drivers read when they are connected."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ui.look.language.words import tr
from ui.look.wording import exposure, millimetres, quantity, sentence_case
from ui.widgets.data_table import Cell, verdict_cell
from ui.widgets.properties_panel import Group, Properties

if TYPE_CHECKING:
    from collections.abc import Sequence

    from measureapp.acquire.states import DeviceState
    from measureapp.data.rig import RigDescription
    from ui.session import CellState, DriverRow

HEADERS = ("Device", "Model", "State", "Driver")


def device_rows(rig: RigDescription, cell: CellState, drivers: Sequence[DriverRow]) -> list[list[Cell]]:
    """Return one row for each device; without a connection the state tells nominal values."""
    states = {state.name: state for state in cell.devices}
    plugins = rig.drivers
    return [
        [
            Cell(tr("Camera {name}", name=name) if kind == "camera" else kind, bold=True),
            Cell(model),
            _state_cell(states.get(name), nominal),
            _driver_cell(plugins[name], drivers),
        ]
        for name, kind, model, nominal in _described(rig)
    ]


def _described(rig: RigDescription) -> list[tuple[str, str, str, str]]:
    """Return name, kind, model and nominal values of every device."""
    low, high = rig.guide.limits_mm
    stroke = tr(
        "{low} … {high} mm · repeatability {repeatability_mm}",
        low=quantity(low, "", 0),
        high=quantity(high, "", 0),
        repeatability_mm=millimetres(rig.guide.repeatability_mm),
    )
    reach = tr(
        "Reach {max_reach_mm:.0f} mm · repeatability {repeatability_mm}",
        max_reach_mm=rig.robot.max_reach_mm,
        repeatability_mm=millimetres(rig.robot.repeatability_mm),
    )
    cameras = [
        (
            camera.name,
            "camera",
            camera.model,
            tr(
                "{width_px} × {height_px} px · {focal_mm:g} mm lens · {bit_depth} bit",
                width_px=camera.width_px,
                height_px=camera.height_px,
                focal_mm=camera.focal_mm,
                bit_depth=camera.bit_depth,
            ),
        )
        for camera in rig.cameras
    ]
    return [
        *cameras,
        ("projector", "Projector", rig.projector.model, f"{rig.projector.width_px} × {rig.projector.height_px} px"),
        ("robot", "Robot", rig.robot.model, reach),
        ("guide", "Linear guide", rig.guide.model, stroke),
        (
            "table",
            "Rotary table",
            rig.table.model,
            tr(
                "⌀ {diameter_mm:.0f} mm · accuracy {accuracy_arcsec:g}″",
                diameter_mm=rig.table.diameter_mm,
                accuracy_arcsec=rig.table.accuracy_arcsec,
            ),
        ),
    ]


def _state_cell(state: DeviceState | None, nominal: str) -> Cell:
    if state is None:
        return Cell(nominal)
    status = state.status
    words = f"{status.text} {status.remedy}".strip()
    tip = f"{words}\n{status.identity}".strip()
    return verdict_cell("pass" if status.ready else "fail", words, tip)


def _driver_cell(plugin: str, drivers: Sequence[DriverRow]) -> Cell:
    found = next((driver for driver in drivers if driver.name == plugin), None)
    if found is None:
        return Cell(sentence_case(plugin))
    if found.problem:
        return verdict_cell("fail", sentence_case(found.name), found.problem)
    return verdict_cell("pass", sentence_case(found.name), tr("Version {version}", version=found.version))


def rig_properties(rig: RigDescription, drivers: Sequence[DriverRow]) -> Properties:
    """Return the nominal values of the rig, and the drivers that are there."""
    listed = tuple((sentence_case(driver.name), driver.problem or driver.version) for driver in drivers)
    return Properties(
        rig.name,
        (
            Group(
                "Measuring head",
                (
                    ("Reference camera", rig.reference),
                    ("Standoff", millimetres(rig.standoff_mm, 0)),
                    ("Exposures", ", ".join(exposure(value) for value in rig.exposures_us)),
                    ("Synchronisation", "by the projector" if rig.head.sequence == "hardware" else "by the program"),
                ),
            ),
            Group(
                "Robot",
                (
                    ("Absolute accuracy", millimetres(rig.robot.absolute_accuracy_mm)),
                    ("Repeatability", millimetres(rig.robot.repeatability_mm)),
                    ("Reach", f"{rig.robot.min_reach_mm:.0f} … {rig.robot.max_reach_mm:.0f} mm"),
                ),
            ),
            *([Group("Drivers", listed)] if listed else []),
        ),
        "Nominal values from data sheets. Calibration determines the true values.",
    )
