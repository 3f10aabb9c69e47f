"""Filing of a measured project in a series: the run is stored in the project, too, from which a series can be rebuilt."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

from measureapp.data.dimension import Dimension, worst_verdict
from measureapp.data.identification import Identification, one_line
from measureapp.data.measurement import Measurement
from measureapp.data.series import SeriesRun, SeriesValue
from measureapp.errors import InputError, StorageError
from measureapp.project.atomic import write_text
from measureapp.project.folder import ProjectFolder
from measureapp.project.identification_file import read_identification
from measureapp.project.series.store import SeriesStore
from measureapp.project.text_document import read_model

FOLDER = "series"
DEEPEST = 4  # levels of folders that are searched for projects
VERSION_DIGITS = 8


class FiledRun(NamedTuple):
    """A run in a series, and whether it was not there before."""

    run: SeriesRun
    is_new: bool


def file_run(
    project: ProjectFolder,
    measurement: Measurement | None = None,
    *,
    program: str = "",
    version: str = "",
    repeat_reason: str = "",
    root: Path | None = None,
) -> FiledRun:
    """File the measurement of a project in the series of its program; filed once more it is the same run, which changes nothing.

    Parameters
    ----------
    measurement : that of the project, if it is loaded already
    program, version : of the part program; by default the inspection program's name and the beginning of its SHA-256
    repeat_reason : why a part that was measured before is measured again
    root : folder of all series

    Raises
    ------
    InputError
        There is no measurement with an inspection, or the part was measured before and no reason is given.
    StorageError
        Project or series cannot be read or written.
    """
    measurement = measurement or project.measurement()
    if measurement is None or measurement.inspection is None:
        raise InputError(f"{project.path} has no evaluated dimensions.", "Measure the part with an inspection program first.")
    dimensions = measurement.inspection.dimensions
    defaults = Identification(part_name=measurement.part[:200], machine=measurement.rig[:200])
    run = SeriesRun(
        run_id="0" * 32,
        program=program or measurement.inspection.program,
        version=version or _version(project),
        identification=read_identification(project.path).with_defaults(defaults),
        verdict=worst_verdict(dimension.verdict for dimension in dimensions),
        values=tuple(series_value(dimension) for dimension in dimensions),
        project=str(project.path.absolute()),
        measured_at=measurement.measured_at,
    )
    run = run.model_copy(update={"run_id": _run_id(run), "repeat_reason": one_line(repeat_reason)})
    is_new = SeriesStore(run.program, root).add(run)
    write_text(project.path / FOLDER / f"{run.run_id}.json", run.model_dump_json(indent=2))
    return FiledRun(run, is_new)


def _run_id(run: SeriesRun) -> str:
    """Return an id that is the same for the same results of the same measurement."""
    kept = run.model_dump(mode="json", include={"program", "version", "values", "measured_at", "identification"})
    return hashlib.sha256(json.dumps(kept, sort_keys=True).encode()).hexdigest()[:32]


def series_value(dimension: Dimension) -> SeriesValue:
    """Return what a series keeps of a dimension."""
    return SeriesValue(**{name: getattr(dimension, name) for name in SeriesValue.model_fields})


def find_runs(folders: Iterable[Path]) -> tuple[SeriesRun, ...]:
    """Return the runs stored in projects in and below ``folders``; files of runs that cannot be read are passed over.

    Raises
    ------
    InputError
        One of the folders is none.
    """
    found: dict[str, SeriesRun] = {}
    for folder in folders:
        if not Path(folder).is_dir():
            raise InputError(f"{folder} is not a folder.", "Name project folders, or folders with projects in them.")
        for project in _projects(Path(folder), DEEPEST):
            for path in sorted((project / FOLDER).glob("*.json")):
                try:
                    run = read_model(path, SeriesRun)
                except StorageError:
                    continue
                found[run.run_id] = run
    return tuple(found.values())


def _projects(folder: Path, levels: int) -> Iterator[Path]:
    if (folder / "project.json").is_file():
        yield folder
    elif levels and folder.is_dir():
        for inner in sorted(folder.iterdir()):
            if inner.is_dir() and not inner.is_symlink():
                yield from _projects(inner, levels - 1)


def _version(project: ProjectFolder) -> str:
    return "" if project.program is None else hashlib.sha256(project.program.read_bytes()).hexdigest()[:VERSION_DIGITS]
