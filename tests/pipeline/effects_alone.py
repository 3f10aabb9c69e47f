"""One effect of the virtual rig alone: the cross measured from images in a world that is ideal but for it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import tomli_w

from measureapp.data.dimension import Verdict
from measureapp.demo import true_dimensions
from measureapp.devices.plugin_loader import load_driver
from measureapp.errors import MeasureError
from measureapp.pipeline.run import scan_into_project
from measureapp.pipeline.sample import SampleScan, sample_request
from measureapp.progress import NoProgress
from measureapp.project.folder import ProjectFolder
from measureapp.simulate.parts import make_part
from measureapp.simulate.world import World
from measureapp.simulate.worlds import read_world

Magnitudes = Mapping[str, Any]


@dataclass(frozen=True)
class Found:
    """What came of a measurement: dimensions beside the true ones, or the sentence with which it was refused."""

    dimensions: tuple[dict[str, Any], ...] = ()
    verdicts: tuple[Verdict, ...] = ()
    views: int = 0
    used: int = 0
    words: tuple[str, ...] = ()  # warnings, and what axes and checks are doubted for
    refusal: str = ""

    @property
    def worst(self) -> tuple[float, float]:
        """Error and U of the dimension whose error is the largest beside its U."""
        if not self.dimensions:
            return 0.0, 0.0
        one = max(self.dimensions, key=lambda one: abs(one["error"]) / one["uncertainty"])
        return one["error"], one["uncertainty"]

    @property
    def silent_lies(self) -> list[str]:
        """Dimensions outside U whose verdict says that they are proven."""
        proven = (Verdict.PASS, Verdict.FAIL)
        return [one["name"] for one in self.dimensions if not one["contains_truth"] and one["verdict"] in proven]

    def line(self, name: str) -> str:
        """Return a row of the table of effects."""
        error, allowed = self.worst
        verdicts = ", ".join(f"{sum(v is kind for v in self.verdicts)} {kind.value}" for kind in Verdict if kind in self.verdicts)
        told = "; ".join(filter(None, (self.refusal, *self.words))) or "–"
        return f"| {name} | {1000 * error:+.1f} | {1000 * allowed:.1f} | {self.used} of {self.views} | {verdicts} | {told} |"


def measure_in(
    world_of: Magnitudes, folder: Path, *, calibrated: Path | None = None, part: str = "gypsum", seed: int = 1, viewpoints: int = 8
) -> Found:
    """Measure at a quarter of the resolution in the world of these magnitudes; ``calibrated`` is a project whose calibration is used."""
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / "world.toml"
    file.write_text(tomli_w.dumps(dict(world_of)), encoding="utf-8")
    project = folder / "project"
    chosen = SampleScan(part, "quarter", viewpoints, seed, conditions=str(file))
    request = replace(sample_request(chosen, project), calibrated=calibrated)
    world = World(request.rig, make_part(part), seed, request.created.board if request.created else None, read_world(str(file)))
    rig = load_driver(None, "virtual_rig", "rig").module.rig_of(world)
    try:
        outcome = scan_into_project(request, lambda _: None, NoProgress(), held=replace(rig, description=request.rig))
    except MeasureError as error:
        return Found(refusal=str(error))
    assert outcome is not None
    measurement, inspection = outcome.measurement, outcome.measurement.inspection
    assert inspection is not None
    verdicts = {one.name: one.verdict for one in inspection.dimensions}
    placements, document = measurement.stitched.placements, outcome.document
    validity, checks = document["validity"], document["consistency"]["checks"]
    causes = [f"{1000 * one['unexplained_mm']:.1f} µm unexplained: {one['cause']}" for one in checks if one["unexplained_mm"] > 0.0]
    drift = validity["drift"] or {"standing": "good"}
    moved = [] if drift["standing"] == "good" else [drift["sentence"]]
    return Found(
        tuple({**one, "verdict": verdicts[one["name"]]} for one in true_dimensions(measurement, world, ProjectFolder.open(project))),
        tuple(verdicts.values()),
        len(measurement.views),
        sum(placement.used for placement in placements),
        tuple(filter(None, (*validity["warnings"], *moved, validity["axes"], *causes))),
    )
