"""A ready-made scan on the virtual rig: rig description, plan and project for a sample part or a mesh file."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

from measureapp.data.board import AnyBoard
from measureapp.data.certificate import BoardClass, lengths_of_class
from measureapp.data.identification import Identification
from measureapp.data.length_unit import LengthUnit
from measureapp.data.pattern_sets import DEFAULT_NAME
from measureapp.data.project_settings import DEFAULT_BOARD
from measureapp.data.rig import Resolution, RigDescription
from measureapp.data.sample_worlds import DEFAULT_WORLD, IDEAL, world_file
from measureapp.errors import InputError
from measureapp.pipeline.run import NewProject, ScanRequest
from measureapp.planning.viewpoints import plan_around_part
from measureapp.project.geometry.files import read_mesh
from measureapp.project.geometry.robot_file import arm_of
from measureapp.project.rig_file import read_rig
from measureapp.project.text_document import read_toml
from measureapp.resources import resource

VIRTUAL_RIG = "paper"  # description in resources/rigs
DEFAULT_VIEWPOINTS = {"impeller": 26}
OTHER_VIEWPOINTS = 8
EXTENT_DIGITS = 3
UPRIGHT_DEG = (0.0, 0.0, 0.0)
# what an owner of a rig may know: class of the board, and by how much board and part may be off 20 °C (k = 2)
KNOWN_OF_RIGS: dict[str, tuple[BoardClass, float, float]] = {
    "good": ("ceramic", 0.4, 0.4),
    "usual": ("glass", 1.0, 1.0),
    "bad": ("printed", 6.0, 4.0),
}


@dataclass(frozen=True, slots=True)
class SampleScan:
    """Settings of a ready-made scan: part, virtual rig, viewpoints."""

    part: str = "gypsum"  # a sample part, or a mesh file
    resolution: Resolution = "half"
    viewpoints: int | None = None  # None: default of the part
    seed: int = 1  # of the rig's hidden errors and all noise
    patterns: str = DEFAULT_NAME
    unit: LengthUnit = LengthUnit.MM  # of a mesh file
    bracket_s: float | None = None  # time budget per viewpoint for exposures chosen by a probe; None: default exposures
    part_turn_deg: tuple[float, float, float] = UPRIGHT_DEG  # rotation about x, then y, then z, before it is put on the table
    conditions: str = DEFAULT_WORLD  # how well rig and part are made: a world of `resources/worlds`, or a TOML file


def sample_request(chosen: SampleScan, folder: Path) -> ScanRequest:
    """Return the scan of a sample part in ``folder``; a folder with the same scan is continued.

    Raises
    ------
    InputError
        The part is neither a sample part nor a readable mesh file, or there is no such world.
    PlanError
        The virtual rig cannot reach a viewpoint of this part.
    """
    rig, radius_mm, height_mm = virtual_rig(chosen), *_extent(chosen)
    name = Path(chosen.part).stem
    plan = plan_around_part(
        rig,
        name,
        radius_mm=radius_mm,
        height_mm=height_mm,
        count=chosen.viewpoints if chosen.viewpoints is not None else DEFAULT_VIEWPOINTS.get(chosen.part, OTHER_VIEWPOINTS),
        patterns=chosen.patterns,
        arm=arm_of(rig),
    )
    turned = "" if chosen.part_turn_deg == UPRIGHT_DEG else f", turned by {'/'.join(f'{angle:g}' for angle in chosen.part_turn_deg)}°"
    conditions = "" if chosen.conditions == IDEAL else f", {Path(chosen.conditions).stem} rig"
    title = f"Demo: {name}{turned}, {chosen.resolution} resolution, {len(plan)} views, seed {chosen.seed}{conditions}"
    return ScanRequest(
        plan,
        rig,
        folder,
        resume=True,
        bracket_s=chosen.bracket_s,
        created=NewProject(title, name, *_documents(chosen.part), board=board_of(chosen.conditions)),
        stated=part_of(chosen.conditions),
        calibrate=True,
    )


def board_of(conditions: str) -> AnyBoard:
    """Return the board of the virtual rig with what is known of its lengths."""
    known = known_of(conditions)
    if known == IDEAL:
        return DEFAULT_BOARD
    board_class, board_k, _ = KNOWN_OF_RIGS[known]
    return DEFAULT_BOARD.model_copy(update={"lengths": lengths_of_class(board_class).at(20.0, board_k)})


def part_of(conditions: str) -> Identification | None:
    """Return what is known of the part on the virtual rig: it is of steel, and about as warm as the room."""
    known = known_of(conditions)
    if known == IDEAL:
        return None
    return Identification(part_temperature=f"20±{KNOWN_OF_RIGS[known][2]:g}", material="steel")


def known_of(conditions: str) -> str:
    """Return what the owner of a rig knows of board and part, a key of `KNOWN_OF_RIGS` or IDEAL: `known` in the file of the world.

    Raises
    ------
    InputError
        There is no such world, or its file cannot be read or names something else.
    """
    path = world_file(conditions)
    known = str(read_toml(path, "Give a TOML file such as those in resources/worlds.").get("known", IDEAL))
    if known not in (IDEAL, *KNOWN_OF_RIGS):
        raise InputError(f"{path} states known = {known!r}.", f"Name one of {', '.join((IDEAL, *KNOWN_OF_RIGS))}.")
    return known


def virtual_rig(chosen: SampleScan) -> RigDescription:
    """Return the description of the virtual rig with the part on its table."""
    unit = {} if chosen.unit is LengthUnit.MM else {"unit": str(chosen.unit)}
    turn = {} if chosen.part_turn_deg == UPRIGHT_DEG else {"part_turn_deg": chosen.part_turn_deg}
    world = chosen.conditions if not Path(chosen.conditions).suffix else str(Path(chosen.conditions).resolve())
    conditions = {} if world == IDEAL else {"conditions": world}
    description = read_rig(VIRTUAL_RIG).at_resolution(chosen.resolution)
    return description.model_copy(update={"driver_settings": {"part": chosen.part, "seed": chosen.seed, **unit, **turn, **conditions}})


def is_sample(part: str) -> bool:
    """Whether ``part`` is the name of a sample part."""
    return not Path(part).suffix and (resource("parts") / part / "nominal.stl").is_file()


def _documents(part: str) -> tuple[Path | None, Path | None]:
    """Return inspection program and nominal of a sample part; a mesh file has neither."""
    if not is_sample(part):
        return None, None
    return resource(f"parts/{part}/program.toml"), resource(f"parts/{part}/nominal.stl")


def _extent(chosen: SampleScan) -> tuple[float, float]:
    """Return radius and height of the enclosing cylinder of the part in mm, as it stands in the centre of the table."""
    if is_sample(chosen.part):
        vertices_mm = read_mesh(resource(f"parts/{chosen.part}/nominal.stl")).vertices_mm
    else:
        vertices_mm = read_mesh(Path(chosen.part), unit=chosen.unit).vertices_mm
    if not is_sample(chosen.part) or chosen.part_turn_deg != UPRIGHT_DEG:  # as the virtual rig puts it down
        vertices_mm = vertices_mm @ Rotation.from_euler("xyz", chosen.part_turn_deg, degrees=True).as_matrix().T
        low, high = vertices_mm.min(axis=0), vertices_mm.max(axis=0)
        vertices_mm = vertices_mm - [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]]
    radius_mm = float(np.linalg.norm(vertices_mm[:, :2], axis=1).max())
    return round(radius_mm, EXTENT_DIGITS), round(float(vertices_mm[:, 2].max()), EXTENT_DIGITS)
