"""Complete measurement on the virtual rig, compared with its hidden ground truth afterwards."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from measureapp.acquire.control import RunControl
from measureapp.arrays import FloatArray
from measureapp.data.calibration import RigCalibration
from measureapp.data.cloud import StitchedCloud
from measureapp.data.length_unit import LengthUnit
from measureapp.data.measurement import Measurement
from measureapp.data.mesh import Mesh
from measureapp.data.pattern_sets import DEFAULT_NAME
from measureapp.data.rig import Resolution
from measureapp.data.sample_worlds import DEFAULT_WORLD
from measureapp.devices.connect import connect_rig
from measureapp.devices.plugin_loader import load_driver
from measureapp.devices.rig import Rig
from measureapp.geometry.transform import RigidTransform, orthonormalise
from measureapp.inspection.alignment.point_to_plane import register
from measureapp.inspection.dimensions import inspect
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.settings import AlignmentSettings
from measureapp.inspection.surface.deviation import signed_distances
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.language.languages import ENGLISH
from measureapp.peers.cell import rig_at, virtual_cell
from measureapp.pipeline.events import Event
from measureapp.pipeline.run import Outcome, scan_into_project
from measureapp.pipeline.sample import SampleScan, sample_request
from measureapp.progress import Progress
from measureapp.project.folder import ProjectFolder
from measureapp.project.geometry.files import read_mesh, write_mesh
from measureapp.project.program_file import read_program
from measureapp.register.settings import StitchSettings
from measureapp.register.stitch import stitch
from measureapp.simulate.parts import make_part
from measureapp.simulate.placing import UPRIGHT_DEG, place_part
from measureapp.simulate.truth import Truth
from measureapp.simulate.world import World
from measureapp.simulate.worlds import read_world

OnEvent = Callable[[Event], None]
PLUGIN = "virtual_rig"
ALIGNMENT_POINTS = 60_000
ALIGNMENT_REACH_MM = 3.0


@dataclass(frozen=True, slots=True)
class DemoRequest:
    """Settings of a demo: part, virtual rig and project folder."""

    folder: Path
    part: str = "gypsum"  # a sample part, or a mesh file
    resolution: Resolution = "half"
    viewpoints: int | None = None  # None: default of the part
    seed: int = 1  # of the rig's hidden errors and all noise
    patterns: str = DEFAULT_NAME
    unit: LengthUnit = LengthUnit.MM  # of a mesh file
    bracket_s: float | None = None  # time budget per viewpoint for exposures chosen by a probe; None: default exposures
    through_drivers: bool = False  # robot, guide and table through their drivers and virtual peers
    part_turn_deg: tuple[float, float, float] = UPRIGHT_DEG  # rotation about x, then y, then z, before it is put on the table
    conditions: str = DEFAULT_WORLD  # how well rig and part are made: a world of `resources/worlds`, or a TOML file
    language: str = ENGLISH  # of the report

    @property
    def sample(self) -> SampleScan:
        """The scan on the virtual rig."""
        return SampleScan(
            self.part,
            self.resolution,
            self.viewpoints,
            self.seed,
            self.patterns,
            self.unit,
            self.bracket_s,
            self.part_turn_deg,
            self.conditions,
        )


def run_demo(request: DemoRequest, on_event: OnEvent, progress: Progress, control: RunControl | None = None) -> Outcome:
    """Calibrate, scan, stitch, measure and report, then compare the results with the ground truth.

    A folder with the same demo is continued: stored images are not taken again. ``control`` is that of the scan, which begins after the
    calibration.

    Raises
    ------
    InputError
        The part cannot be read, or the folder contains something else.
    MeasureError
        From the stages.
    Cancelled
        From ``progress``.
    """
    part = place_part(make_part(request.part, request.unit), request.part_turn_deg)
    scan = replace(sample_request(request.sample, request.folder), language=request.language)
    world = World(scan.rig, part, request.seed, options=read_world(request.conditions))
    with _connected(world, request.through_drivers) as rig:
        outcome = scan_into_project(scan, on_event, progress, control, replace(rig, description=scan.rig))
    assert outcome is not None  # the rig was calibrated
    return _add_truth(outcome, world, ProjectFolder.open(request.folder))


@contextmanager
def _connected(world: World, through_drivers: bool) -> Iterator[Rig]:
    """Connect the virtual rig: all of it in process, or its axes through their drivers and virtual peers."""
    virtual: Rig = load_driver(None, PLUGIN, "rig").module.rig_of(world)
    if not through_drivers:
        yield virtual
        return
    with virtual_cell(world) as addresses:
        rig = connect_rig(rig_at(addresses, world.description), given={"cell": virtual})
        try:
            yield replace(rig, place_on_table=virtual.place_on_table)
        finally:
            rig.close()


def _add_truth(outcome: Outcome, world: World, project: ProjectFolder) -> Outcome:
    measurement = outcome.measurement
    surface, deviation = truth_deviation(measurement, world)
    path = project.results / "truth_mesh.ply"
    write_mesh(path, surface)
    files = {**outcome.files, "truth_mesh": path}
    document = {
        **outcome.document,
        "calibration": {**outcome.document["calibration"], "truth": compare_calibration(measurement.calibration, world.truth())},
        "truth_deviation": deviation,
        "true_dimensions": true_dimensions(measurement, world, project),
        "files": {name: str(file) for name, file in files.items()},
    }
    return replace(outcome, document=document, files=files)


def truth_deviation(measurement: Measurement, world: World) -> tuple[Mesh, dict[str, Any]]:
    """Compare the stitched cloud with the true surface after a rigid best fit.

    Returns
    -------
    surface : the true surface in the stitched cloud's frame
    figures : `rms`, `p95`, `bias` in mm over all stitched points, the same for kinematic positions of the views, and
        `offset_mm`, `offset_deg`: error of the calibrated part frame
    """
    views = [view for view in measurement.views if view.quality.accepted]
    kinematic = stitch([view.cloud for view in views], [view.part_from_camera for view in views], StitchSettings(fine=False))
    surface, figures, offset = _compare(measurement.stitched, world)
    _, kinematic_figures, _ = _compare(kinematic, world)
    shift = float(np.linalg.norm(offset.translation_mm))
    return surface, {**figures, "kinematic_only": kinematic_figures, "offset_mm": shift, "offset_deg": float(np.degrees(offset.angle_rad))}


def true_dimensions(measurement: Measurement, world: World, project: ProjectFolder) -> list[dict[str, Any]]:
    """Compare every dimension with its true value: that of the part as it was made, at 20 °C, by the same inspection program.

    Returns
    -------
    list : `name`, `true`, `measured`, `error`, `uncertainty` (k = 2) and whether it `contains_truth`; without what was not measured
    """
    if measurement.inspection is None or project.program is None:
        return []
    nominal = None if project.nominal is None else read_mesh(project.nominal)
    found = inspect(world.part.at_reference(), read_program(project.program), nominal)
    true = {dimension.name: dimension.measured for dimension in found.dimensions}
    return [
        {
            "name": one.name,
            "true": value,
            "measured": one.measured,
            "error": one.measured - value,
            "uncertainty": one.uncertainty,
            "contains_truth": abs(one.measured - value) <= one.uncertainty,
        }
        for one in measurement.inspection.dimensions
        if one.measured is not None and one.uncertainty is not None and (value := true.get(one.name)) is not None
    ]


def _compare(stitched: StitchedCloud, world: World) -> tuple[Mesh, dict[str, float], RigidTransform]:
    """Return the true surface in the cloud's frame, the statistics of the distances, and the transform of the best fit."""
    truth = world.true_surface(stitched.frame)
    surface = NominalSurface(truth)
    points = MeasuredPoints.of(stitched)
    fitted = register(points.thin(ALIGNMENT_POINTS), surface, np.eye(4), AlignmentSettings(), reach_mm=ALIGNMENT_REACH_MM)
    truth_from_cloud = RigidTransform(orthonormalise(fitted.matrix), stitched.frame, stitched.frame)
    distances = signed_distances(truth_from_cloud.apply(stitched.points_mm), surface)
    figures = {
        "rms": float(np.sqrt(np.mean(distances**2))),
        "p95": float(np.percentile(np.abs(distances), 95.0)),
        "bias": float(np.mean(distances)),
        "points": len(stitched),
    }
    return truth.seen_from(truth_from_cloud.inverse()), figures, truth_from_cloud


def compare_calibration(found: RigCalibration, truth: Truth) -> dict[str, Any]:
    """Return the true values of a calibration and its errors."""
    true = truth.calibration
    cameras = {}
    for name, camera in found.cameras.cameras.items():
        real = true.cameras.cameras[name]
        off = camera.reference_from_camera.inverse() @ real.reference_from_camera
        cameras[name] = {
            "true_focal_px": float(real.pinhole.matrix[0, 0]),
            "focal_error_px": float(camera.pinhole.matrix[0, 0] - real.pinhole.matrix[0, 0]),
            "centre_error_px": (camera.pinhole.matrix[:2, 2] - real.pinhole.matrix[:2, 2]).tolist(),
            "position_error_mm": float(np.linalg.norm(off.translation_mm)),
            "direction_error_deg": float(np.degrees(off.angle_rad)),
        }
    hand_eye = found.hand_eye.flange_from_camera.inverse() @ true.hand_eye.flange_from_camera
    axis_gap = found.axis.point_mm - true.axis.point_mm
    return {
        "cameras": cameras,
        "hand_eye": {
            "true_flange_from_camera": true.hand_eye.flange_from_camera.matrix.tolist(),
            "position_error_mm": float(np.linalg.norm(hand_eye.translation_mm)),
            "direction_error_deg": float(np.degrees(hand_eye.angle_rad)),
        },
        "guide": {
            "true_direction": true.guide.direction.tolist(),
            "true_scale": true.guide.scale,
            "direction_error_deg": _angle_deg(found.guide.direction, true.guide.direction),
            "scale_error": found.guide.scale - true.guide.scale,
        },
        "axis": {
            "true_direction": true.axis.direction.tolist(),
            "true_point_mm": true.axis.point_mm.tolist(),
            "direction_error_deg": _angle_deg(found.axis.direction, true.axis.direction),
            "position_error_mm": float(np.linalg.norm(np.cross(axis_gap, true.axis.direction))),
        },
    }


def _angle_deg(one: FloatArray, other: FloatArray) -> float:
    return float(np.degrees(np.arctan2(np.linalg.norm(np.cross(one, other)), one @ other)))
