"""The costly parts of a report, deviation and pictures: computed for it, or kept in its project since they were last."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from typing import Any

import numpy as np

from measureapp.data.cloud import StitchedCloud
from measureapp.data.measurement import Alignment
from measureapp.data.mesh import Mesh
from measureapp.inspection.surface.deviation import Deviation, compute_deviation
from measureapp.progress import Progress
from measureapp.project.folder import ProjectFolder
from measureapp.project.kept_arrays import keep, read_kept
from measureapp.project.kept_deviation import deviation_of
from measureapp.project.results import PICTURES
from measureapp.report.drawing import Drawing
from measureapp.report.model import DimensionPicture, Flag, Picture, Pictures

DOCUMENT = "document"


class Afresh:
    """Computes each part for the report."""

    def deviation(self, stitched: StitchedCloud, nominal: Mesh, alignment: Alignment, progress: Progress) -> Deviation:
        """Return the deviation of a cloud from its nominal. Raises InspectionError."""
        return compute_deviation(stitched, nominal, alignment, progress=progress)

    def pictures(self, drawing: Drawing, progress: Progress) -> Pictures:
        """Return the pictures."""
        return drawing.draw(progress)


@dataclass(frozen=True, slots=True)
class KeptIn(Afresh):
    """Takes what is kept in a project where it would come out as it is; the rest is computed and kept."""

    project: ProjectFolder

    def deviation(self, stitched: StitchedCloud, nominal: Mesh, alignment: Alignment, progress: Progress) -> Deviation:
        """Return the deviation of a cloud from its nominal. Raises InspectionError."""
        return deviation_of(self.project, stitched, nominal, alignment, progress=progress)

    def pictures(self, drawing: Drawing, progress: Progress) -> Pictures:
        """Return the pictures."""
        path, made_from = self.project.results / PICTURES, drawing.made_from()
        kept = read_kept(path, self.project.journal, made_from, pictures_from)
        if kept is not None:
            return kept
        made = drawing.draw(progress)
        keep(path, made_from, arrays_of(made))
        return made


def arrays_of(pictures: Pictures) -> dict[str, Any]:
    """Return pictures as arrays: the bytes of each, and a document with their words."""
    arrays: dict[str, Any] = {}

    def words(picture: Picture) -> dict[str, Any]:
        name = f"picture{len(arrays)}"
        arrays[name] = np.frombuffer(picture.png, np.uint8)
        return {**asdict(replace(picture, png=b"")), "png": name}

    document = {
        "part": [words(one) for one in pictures.part],
        "failing": [[one.name, words(one.picture)] for one in pictures.failing],
        "deviation": [words(one) for one in pictures.deviation],
        "cross_sections": [words(one) for one in pictures.cross_sections],
    }
    return {**arrays, DOCUMENT: np.array(json.dumps(document))}


def pictures_from(arrays: Mapping[str, Any]) -> Pictures:
    """Return the pictures of `arrays_of`."""
    document = json.loads(str(arrays[DOCUMENT]))

    def picture(words: Mapping[str, Any]) -> Picture:
        return Picture(words["caption"], arrays[words["png"]].tobytes(), tuple(_flag(flag) for flag in words["flags"]))

    return Pictures(
        tuple(picture(one) for one in document["part"]),
        tuple(DimensionPicture(name, picture(one)) for name, one in document["failing"]),
        tuple(picture(one) for one in document["deviation"]),
        tuple(picture(one) for one in document["cross_sections"]),
    )


def _flag(flag: Mapping[str, Any]) -> Flag:
    x, y = flag["at"]
    return Flag((x, y), tuple(flag["text"]), flag["colour"], tuple((x, y) for x, y in flag["further"]))
