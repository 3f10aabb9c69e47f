"""Work with inspection programs that runs on a job's thread: read, measure, save."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from measureapp.data.length_unit import LengthUnit
from measureapp.errors import InputError, UnitQuestion
from ui.controllers.program_rows import carry_ids

if TYPE_CHECKING:
    from measureapp.data.dimension import Dimension
    from measureapp.data.inspection_program import InspectionProgram
    from measureapp.data.measurement import Inspection, Measurement
    from measureapp.pipeline.run import Outcome
    from ui.workers.job import Job


@dataclass(frozen=True, eq=False)
class ProgramState:
    """An inspection program as it is edited, and the text that the edits started from."""

    program: InspectionProgram
    ids: tuple[int, ...]  # of the dimensions; they outlive renaming and moving
    base: str

    @classmethod
    def of(cls, text: str, before: ProgramState | None = None) -> ProgramState:
        """Parse a text that replaces ``before``. Raises InputError."""
        from measureapp.project.program_file import parse_program

        program = parse_program(text)
        return cls(program, _ids_of(program, before), text)

    def edited(self, program: InspectionProgram) -> ProgramState:
        """Return the state after an edit."""
        return ProgramState(program, _ids_of(program, self), self.base)

    def text(self) -> str:
        """Return the program as it is saved: the text with the edits, its comments kept."""
        from measureapp.project.program_rewrite import rewrite_program

        return rewrite_program(self.base, self.program)


def _ids_of(program: InspectionProgram, before: ProgramState | None) -> tuple[int, ...]:
    former = () if before is None else tuple(one.name for one in before.program.dimensions)
    return carry_ids(former, () if before is None else before.ids, [one.name for one in program.dimensions])


@dataclass(frozen=True, eq=False)
class MeasuredProgram:
    """A program with its results."""

    state: ProgramState
    inspection: Inspection

    def results(self) -> dict[int, Dimension]:
        """Return the results by the numbers of their dimensions."""
        found = {one.name: one for one in self.inspection.dimensions}
        named = zip(self.state.ids, self.state.program.dimensions, strict=True)
        return {number: found[one.name] for number, one in named if one.name in found}


@dataclass(frozen=True, eq=False)
class ChangedNominal:
    """Result with another nominal, and the former nominal."""

    outcome: Outcome
    state: ProgramState
    path: Path
    former: Path | None  # None: there was none, so that the change cannot be undone


@dataclass(frozen=True, eq=False)
class NominalQuestion:
    """A nominal whose unit is doubtful."""

    path: Path
    question: UnitQuestion


def read_state(folder: Path) -> ProgramState:
    """Read the program of a project; without one, its default program. Raises InputError or StorageError."""
    from measureapp.project.folder import ProjectFolder

    project = ProjectFolder.open(folder)
    return ProgramState.of(project.program_text(has_nominal=project.nominal is not None))


def save_state(folder: Path, measurement: Measurement, state: ProgramState, *, is_measured: bool, job: Job) -> Outcome | None:
    """Store a program, and its results with their report if it was measured."""
    from measureapp.pipeline.measure_again import store_program
    from measureapp.project.folder import ProjectFolder

    project = ProjectFolder.open(folder)
    job.report(0, 1, "Saving the program")
    if is_measured:
        return store_program(project, measurement, state.text(), job.language)
    with project.lock():
        project.save_program(state.text())
    return None


def save_copy(path: Path, state: ProgramState) -> Path:
    """Write a program to a file of its own."""
    from measureapp.project.atomic import replacing

    with replacing(path) as temporary:
        temporary.write_text(state.text(), encoding="utf-8")
    return path


def measure_with_nominal(
    folder: Path, measurement: Measurement, state: ProgramState, path: Path, unit: LengthUnit, job: Job
) -> ChangedNominal | NominalQuestion:
    """Measure with another nominal and store everything, or return the question for its unit."""
    from measureapp.pipeline.measure_again import NominalFile, measure_again
    from measureapp.project.folder import ProjectFolder

    project = ProjectFolder.open(folder)
    had_one = project.nominal is not None
    text = project.program_text(has_nominal=True) if not project.program else state.text()
    try:
        outcome = measure_again(project, measurement, job, program=text, nominal_file=NominalFile(path, unit), language=job.language)
    except UnitQuestion as question:
        if question.what == "nominal" and unit is LengthUnit.MM:
            return NominalQuestion(path, question)
        raise InputError(question.message, "Choose the nominal of this part, or export it in millimetres.") from question
    return ChangedNominal(outcome, ProgramState.of(text, state), path, project.former_nominals()[-1] if had_one else None)
