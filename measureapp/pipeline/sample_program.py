"""Sample part programs for the virtual rig, made of the sample parts; and which part the virtual rig has on its table."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np

from measureapp.data.identification import Identification
from measureapp.data.part_program import PartProgram, PartProgramFacts
from measureapp.data.rig import Resolution, RigDescription
from measureapp.pipeline.sample import VIRTUAL_RIG, SampleScan, sample_request
from measureapp.project.geometry.files import read_mesh
from measureapp.project.part_program_file import release_part_program, write_part_program
from measureapp.report.part_pictures import OBLIQUE
from measureapp.report.picture import surface_picture
from measureapp.resources import resource

VIRTUAL_DRIVER = "virtual_rig"
PICTURE_PX = (640, 400)
RELEASED = ("MeasureApp", "2026-11-25T00:00:00+00:00")  # of the sample programs: by whom and when
WHITE = 250  # grey level of the picture's background, and above


@dataclass(frozen=True, slots=True)
class SampleProgram:
    """A sample part as a part program."""

    part: str
    facts: PartProgramFacts
    viewpoints: int


SAMPLES = (
    SampleProgram(
        "gypsum",
        PartProgramFacts(
            name="Gypsum cross",
            part_number="GC-180",
            version="1",
            identification=Identification(drawing="D-1807", revision="B"),
            remarks="Put the cross on the middle of the table, the raised square up.\nOne arm points to the robot.",
            code_pattern=r"(?P<part>GC-180)[|;](?P<serial>[A-Z0-9-]{2,20})(?:[|;](?P<order>[A-Z0-9-]+))?",
        ),
        6,
    ),
    SampleProgram(
        "gear",
        PartProgramFacts(
            name="Gear",
            part_number="GW-24",
            version="1",
            identification=Identification(drawing="D-2406", revision="A"),
            remarks="Put the gear flat on the middle of the table.\nThe bore must be free.",
            code_pattern=r"(?P<part>GW-24)[|;](?P<serial>[A-Z0-9-]{2,20})(?:[|;](?P<order>[A-Z0-9-]+))?",
        ),
        8,
    ),
)


def write_sample_programs(folder: Path) -> tuple[Path, ...]:
    """Write the sample part programs, released, into a folder and return their files. Raises StorageError."""
    released = (release_part_program(sample_program(sample), *RELEASED) for sample in SAMPLES)
    return tuple(write_part_program(program, folder / sample.part) for program, sample in zip(released, SAMPLES, strict=True))


def sample_program(sample: SampleProgram) -> PartProgram:
    """Return one sample part as a part program: plan, inspection program, nominal and picture."""
    scan = sample_request(SampleScan(sample.part, viewpoints=sample.viewpoints), Path("unused"))
    parts = resource("parts") / sample.part
    nominal = (parts / "nominal.stl").read_bytes()
    return PartProgram(sample.facts, scan.plan, (parts / "program.toml").read_bytes(), (".stl", nominal), None, part_picture(sample.part))


def part_picture(part: str) -> bytes:
    """Return a picture of a sample part as PNG with a transparent background."""
    image = surface_picture(read_mesh(resource(f"parts/{part}/nominal.stl")), OBLIQUE, *PICTURE_PX)
    opaque = np.where((image >= WHITE).all(axis=2), 0, 255).astype(np.uint8)
    encoded = cv2.imencode(".png", np.dstack([image[:, :, ::-1], opaque]))[1]
    return encoded.tobytes()


def rig_for_program(rig: RigDescription, program: PartProgram, resolution: Resolution, folder: Path) -> RigDescription:
    """Return the rig that measures a part: a virtual one gets the part on its table, any other is as described.

    Parameters
    ----------
    resolution : of the cameras of a virtual rig that is described at full resolution
    folder : where a nominal that is no sample part is written for the virtual rig
    """
    if rig.driver != VIRTUAL_DRIVER:
        return rig
    part = _virtual_part(program, folder)
    settings = dict(rig.driver_settings) if part is None else {**rig.driver_settings, "part": part}
    described = rig.model_copy(update={"driver_settings": settings})
    return described.at_resolution(resolution) if rig.cameras == _full_cameras() else described


def _full_cameras() -> object:
    from measureapp.project.rig_file import read_rig

    return read_rig(VIRTUAL_RIG).cameras


def _virtual_part(program: PartProgram, folder: Path) -> str | None:
    """Return the sample part that a nominal is of, or the file it was written to; None without a nominal."""
    if program.nominal is None:
        return None
    ending, content = program.nominal
    for place in sorted(resource("parts").iterdir()):
        if (place / "nominal.stl").is_file() and (place / "nominal.stl").read_bytes() == content:
            return place.name
    from measureapp.project.atomic import replacing

    path = folder / f"part-on-virtual-table{ending}"
    with replacing(path) as temporary:
        temporary.write_bytes(content)
    return str(path)
