"""Measuring of edited programs on the clouds of one project: only what an edit affects is measured, the rest is kept."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from ui.controllers.program_jobs import MeasuredProgram, ProgramState
from ui.controllers.program_rows import changed_names

if TYPE_CHECKING:
    from measureapp.data.inspection_program import InspectionProgram
    from measureapp.data.measurement import Alignment, Inspection, Measurement
    from measureapp.inspection.session.session import InspectionSession
    from measureapp.progress import Progress

SAME = 1e-9  # mm, and of the elements of the rotation: what rounding in a file may change


@dataclass(frozen=True, eq=False)
class Bench:
    """An inspection session of one stitched cloud and one nominal."""

    session: InspectionSession

    @classmethod
    def of(cls, folder: Path, measurement: Measurement) -> Bench:
        """Prepare a session with the nominal and settings of a project."""
        from measureapp.inspection.session.session import InspectionSession
        from measureapp.pipeline.assemble import project_settings
        from measureapp.pipeline.chosen_views import select_views
        from measureapp.project.folder import ProjectFolder
        from measureapp.project.geometry.files import read_mesh

        project = ProjectFolder.open(folder)
        settings = project_settings(project, measurement.calibration, select_views(measurement.views, project.view_choices()))
        nominal = None if project.nominal is None else read_mesh(project.nominal, "nominal")
        return cls(InspectionSession(measurement.stitched, nominal, settings))

    def measure(self, state: ProgramState, former: MeasuredProgram | None, progress: Progress) -> MeasuredProgram:
        """Measure what ``state`` has and ``former`` has not. Raises InspectionError where the alignment fails."""
        if former is not None:
            changed = changed_names(former.state.program, state.program)
            part = program_of(state.program, changed, known=former.state.program)
            found = self.session.measure(part, progress).inspection
            if is_same_alignment(found.alignment, former.inspection.alignment):
                return MeasuredProgram(state, _join(state, found, former))
        found = self.session.measure(state.program, progress).inspection
        if former is not None and is_same_alignment(found.alignment, former.inspection.alignment):
            found = replace(found, alignment=former.inspection.alignment)
        return MeasuredProgram(state, found)


def program_of(program: InspectionProgram, names: set[str], *, known: InspectionProgram) -> InspectionProgram:
    """Return the part of a program that measures some dimensions, and features that ``known`` does not have."""
    from measureapp.inspection.session.graph import Graph, Node

    graph = Graph.of(program)
    wanted = [Node("dimension", name) for name in names]
    wanted += [Node("feature", one.name) for one in program.features if one not in known.features]
    wanted += [node for node in graph.parents if node.kind == "alignment"]
    needed = {*wanted, *(above for node in wanted for above in graph.ancestors(node))}
    return program.model_copy(
        update={
            "features": tuple(one for one in program.features if Node("feature", one.name) in needed),
            "dimensions": tuple(one for one in program.dimensions if one.name in names),
        }
    )


def is_same_alignment(one: Alignment, other: Alignment) -> bool:
    """Return whether two alignments place the part equally."""
    matrices = one.nominal_from_part.matrix, other.nominal_from_part.matrix
    return one.name == other.name and float(np.abs(matrices[0] - matrices[1]).max()) < SAME


def _join(state: ProgramState, found: Inspection, former: MeasuredProgram) -> Inspection:
    """Return the results of the whole program: those found now, and the former ones of all else, with its datum letters."""
    from measureapp.data.datum_letters import letters_of, relettered
    from measureapp.data.inspection_program import copy_names

    results = former.results()
    dimensions = {state.ids[place]: results.get(state.ids[place]) for place in range(len(state.ids))}
    new = {one.name: one for one in found.dimensions}
    features = {one.name: one for one in former.inspection.features} | {one.name: one for one in found.features}
    letters = letters_of(state.program)
    names = [name for one in state.program.features for name in copy_names(one.name, one.repeat)]
    return replace(
        former.inspection,
        program=state.program.name,
        features=tuple(features[name] for name in names if name in features),
        dimensions=tuple(
            relettered(one, letters)
            for entry, number in zip(state.program.dimensions, state.ids, strict=True)
            if (one := new.get(entry.name) or dimensions[number]) is not None
        ),
        further={**former.inspection.further, **found.further},
    )
