"""Set-ups of one part, each a project of its own, joined into one measurement in another project.

The joined project has a `setups.json`, which names its set-ups with the checksums of their clouds, a copy of the first one's calibration,
an inspection program and a nominal, and results of its own. `process` joins the set-ups again from their present results.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
from pydantic import ValidationError
from scipy.spatial.transform import Rotation

from measureapp.data.cloud import StitchedCloud
from measureapp.data.measurement import Measurement, ViewResult
from measureapp.data.mesh import Mesh
from measureapp.data.model import first_problem
from measureapp.data.setups import JoinMethod, SetUps, SetUpSource
from measureapp.data.validity import Validity
from measureapp.errors import InputError, StorageError
from measureapp.geometry.transform import RigidTransform
from measureapp.inspection.alignment.best_fit import best_fit
from measureapp.inspection.measured_points import sample_mesh
from measureapp.inspection.settings import AlignmentSettings
from measureapp.language.languages import ENGLISH
from measureapp.pipeline.assemble import inspect_stitched, project_settings
from measureapp.pipeline.events import Event, InspectionReady, StitchReady
from measureapp.pipeline.project_names import unique_names
from measureapp.pipeline.run import Outcome, finish
from measureapp.pipeline.surface import SurfaceBeside
from measureapp.pipeline.watch import Stopwatch
from measureapp.progress import PartOf, Progress
from measureapp.project.atomic import write_text
from measureapp.project.documents import calibration_id
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.geometry.files import read_mesh
from measureapp.project.results import DOCUMENT, STITCHED, cloud_path
from measureapp.register.setups.join import JoinedCloud, JoinRequest, NominalFit, join_setups, view_name
from measureapp.register.setups.setup_cloud import SetUpCloud

OnEvent = Callable[[Event], None]
SETUPS = "setups.json"
NOMINAL_SAMPLES, NOMINAL_SIGMA_MM = 600_000, 1e-3
HASH_BLOCK = 1 << 20


@dataclass(frozen=True, slots=True)
class JoinOptions:
    """How projects are to be joined."""

    method: JoinMethod = "overlap"
    turned_deg: Mapping[str, tuple[float, float, float]] = field(default_factory=dict)  # by the name of the set-up
    sphere_diameter_mm: float | None = None
    program: Path | None = None  # None: that of the first set-up that has one
    nominal: Path | None = None
    one_part: bool = False  # the projects are of one part although they name it differently


@dataclass(frozen=True, slots=True, eq=False)
class _Member:
    """A set-up with its project and results."""

    name: str
    project: ProjectFolder
    measurement: Measurement

    @property
    def files(self) -> tuple[Path, ...]:
        """The files of its clouds."""
        results = self.project.results
        return (results / STITCHED, *(cloud_path(results, view.viewpoint_id) for view in self.measurement.views))


def is_joined(project: ProjectFolder) -> bool:
    """Whether the project is joined from several set-ups."""
    return (project.path / SETUPS).exists()


def join_projects(folders: Sequence[Path], out: Path, options: JoinOptions, on_event: OnEvent, progress: Progress) -> Outcome:
    """Join the measurements of several projects into a new project; if that fails, nothing is written.

    Raises
    ------
    InputError
        A folder is no measured project, the projects are of different parts, or ``out`` is not a new folder.
    RegistrationError
        The set-ups have too little in common, contradict each other, or fit in several positions.
    """
    if out.exists() and (not out.is_dir() or any(out.iterdir())):
        raise InputError(f"{out} is not an empty folder.", "Choose a new or an empty folder for the joined project.")
    if len(folders) < 2:
        raise InputError("Only one set-up is named.", "Name two or more projects of the same part.")
    members = [_load(name, Path(folder)) for name, folder in zip(unique_names(folders, "Name each set-up once."), folders, strict=True)]
    _require_one_part(members, options.one_part)
    unknown = sorted(set(options.turned_deg) - {member.name for member in members})
    if unknown:
        raise InputError(f"There is no set-up {unknown[0]!r}.", f"Name one of: {', '.join(member.name for member in members)}.")
    program = options.program or next((path for one in members if (path := one.project.program) is not None), None)
    nominal = options.nominal or next((path for one in members if (path := one.project.nominal) is not None), None)
    watch = Stopwatch()
    with watch.stage("joining"):
        described = _describe(members, out, options)
        joined = _join(described, members, None if nominal is None else read_mesh(nominal, "nominal"), PartOf(progress, 0.0, 0.5))
    first = members[0]
    settings = ProjectSettings(
        name=f"{first.project.settings.part}: {len(members)} set-ups", part=first.project.settings.part, rig=first.project.rig()
    )
    project = ProjectFolder.create(out, settings)
    with project.lock():
        project.save_calibration(first.measurement.calibration, first.project.rig_uncertainty())
        project.save_inspection(program, nominal)
        write_text(project.path / SETUPS, described.model_dump_json(indent=2))
        return _complete(project, members, joined, on_event, PartOf(progress, 0.5, 1.0), watch)


def process_joined(project: ProjectFolder, on_event: OnEvent, progress: Progress, watch: Stopwatch, language: str = ENGLISH) -> Outcome:
    """Join the set-ups of a project again, from their present results; ``watch`` notes the stages.

    Raises
    ------
    InputError, StorageError
        A set-up is missing, or its clouds were changed since they were computed.
    RegistrationError
        As `join_projects`.
    """
    with project.lock():
        described = read_setups(project)
        folders = [(project.path / source.path).resolve() for source in described.sources]
        for source, folder in zip(described.sources, folders, strict=True):
            _require_undamaged(source, folder)
        members = [_load(source.name, folder) for source, folder in zip(described.sources, folders, strict=True)]
        sources = tuple(_renewed(source, member) for source, member in zip(described.sources, members, strict=True))
        described = described.model_copy(update={"sources": sources})
        with watch.stage("joining"):
            nominal = None if project.nominal is None else read_mesh(project.nominal, "nominal")
            joined = _join(described, members, nominal, PartOf(progress, 0.0, 0.5))
        project.save_calibration(members[0].measurement.calibration, members[0].project.rig_uncertainty())
        write_text(project.path / SETUPS, described.model_dump_json(indent=2))
        return _complete(project, members, joined, on_event, PartOf(progress, 0.5, 1.0), watch, language)


def read_setups(project: ProjectFolder) -> SetUps:
    """Read which set-ups a project is joined from. Raises StorageError when the file is damaged."""
    path = project.path / SETUPS
    project.journal.check(path)
    try:
        return SetUps.model_validate_json(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError) as error:
        raise StorageError(f"{path} cannot be read: {error}.", "Restore it from a backup, or join the set-ups again.") from error
    except ValidationError as error:
        problem = first_problem(error, "the file")
        raise StorageError(f"{path}: {problem}.", "Restore it from a backup, or join the set-ups again.") from error


def _load(name: str, folder: Path) -> _Member:
    project = ProjectFolder.open(folder)
    if is_joined(project):
        raise InputError(f"{folder} is itself joined from several set-ups.", "Name the projects of its set-ups instead.")
    measurement = project.measurement()
    if measurement is None:
        raise InputError(f"{folder} has no results.", f"Measure it first: measureapp process {folder}.")
    return _Member(name, project, measurement)


def _require_one_part(members: Sequence[_Member], one_part: bool) -> None:
    first = members[0]
    for other in members[1:]:
        ours, theirs = first.project.settings.part, other.project.settings.part
        if ours != theirs and not one_part:
            raise InputError(
                f"{first.name} and {other.name} are of different parts: {ours!r} and {theirs!r}.",
                "Name projects of one part; if this is one part under two names, add --one-part.",
            )


def _describe(members: Sequence[_Member], out: Path, options: JoinOptions) -> SetUps:
    """Describe the set-ups with paths relative to the joined project."""
    sources = tuple(
        SetUpSource(
            name=member.name,
            path=_relative(member.project.path, out),
            measured_at=member.measurement.measured_at,
            sha256=_checksums(member),
            turned_deg=options.turned_deg.get(member.name),
        )
        for member in members
    )
    return SetUps(method=options.method, sphere_diameter_mm=options.sphere_diameter_mm, sources=sources)


def _relative(path: Path, out: Path) -> str:
    """Return a path relative to the joined project; absolute on another drive."""
    try:
        return Path(os.path.relpath(path.resolve(), out.resolve())).as_posix()
    except ValueError:
        return path.resolve().as_posix()


def _checksums(member: _Member) -> dict[str, str]:
    return {path.relative_to(member.project.path).as_posix(): _sha256(path) for path in member.files}


def _sha256(path: Path) -> str:
    digest = hashlib.sha256()
    with path.open("rb") as file:
        while block := file.read(HASH_BLOCK):
            digest.update(block)
    return digest.hexdigest()


def _require_undamaged(source: SetUpSource, folder: Path) -> None:
    """Refuse clouds of a set-up that changed although they were not computed again. Raises StorageError that names the file."""
    try:
        measured_at = json.loads((folder / "results" / DOCUMENT).read_text(encoding="utf-8"))["measured_at"]
    except (OSError, ValueError, KeyError, TypeError):
        return  # missing or damaged results are refused where they are loaded
    if measured_at != source.measured_at:
        return
    for name, expected in source.sha256.items():
        if not (folder / name).is_file() or _sha256(folder / name) != expected:
            raise StorageError(
                f"{folder / name} is damaged: it is not the file that was joined.", f"Compute it again: measureapp process {folder}."
            )


def _renewed(source: SetUpSource, member: _Member) -> SetUpSource:
    """Return the description of a set-up's present results."""
    return source.model_copy(update={"measured_at": member.measurement.measured_at, "sha256": _checksums(member)})


def _join(described: SetUps, members: Sequence[_Member], nominal: Mesh | None, progress: Progress) -> JoinedCloud:
    turned = {
        source.name: Rotation.from_euler("xyz", source.turned_deg, degrees=True).as_matrix()
        for source in described.sources
        if source.turned_deg is not None
    }
    fit = None
    if described.method == "nominal":
        if nominal is None:
            raise InputError("The set-ups have no nominal to be joined by.", "Name one: --nominal FILE.")
        fit = _fit_nominal(members, nominal, PartOf(progress, 0.0, 0.3))
    request = JoinRequest(described.method, turned, described.sphere_diameter_mm, fit)
    calibrations = [calibration_id(member.measurement.calibration) for member in members]
    return join_setups([_cloud_of(member) for member in members], calibrations, request, progress=PartOf(progress, 0.3, 1.0))


def _fit_nominal(members: Sequence[_Member], nominal: Mesh, progress: Progress) -> NominalFit:
    """Fit every set-up to the nominal, and sample the nominal as a cloud."""
    sampled = sample_mesh(nominal, NOMINAL_SAMPLES)
    count = len(sampled)
    assert sampled.normals is not None
    surface = StitchedCloud(
        sampled.points_mm, sampled.normals, np.full(count, NOMINAL_SIGMA_MM), np.zeros(count), np.zeros(count, np.int16), (), "nominal"
    )
    settings = AlignmentSettings(upright=False)  # a part on its head may fit the upright nominal fairly well
    fits = {}
    for number, member in enumerate(members):
        part = PartOf(progress, number / len(members), (number + 1) / len(members), f"{member.name}: ")
        fits[member.name] = best_fit(member.measurement.stitched, nominal, settings, progress=part).nominal_from_part
    return NominalFit(surface, fits)


def _cloud_of(member: _Member) -> SetUpCloud:
    """Return the clouds of a set-up; views refused by hand, whose placements follow the stitched ones, have none."""
    stitched, clouds = member.measurement.stitched, {view.viewpoint_id: view.cloud for view in member.measurement.views}
    count = len(stitched.placements) if stitched.errors is None else len(stitched.errors.poses)
    placements = stitched.placements[:count]
    return SetUpCloud(member.name, replace(stitched, placements=placements), tuple(clouds[one.viewpoint_id] for one in placements))


def _complete(
    project: ProjectFolder,
    members: Sequence[_Member],
    joined: JoinedCloud,
    on_event: OnEvent,
    progress: Progress,
    watch: Stopwatch,
    language: str = ENGLISH,
) -> Outcome:
    """Compute surface and dimensions of the joined cloud, and store everything."""
    on_event(StitchReady(joined.stitched))
    calibration = members[0].measurement.calibration
    views = tuple(
        _view_of(member.name, view, setup.part_from_setup)
        for member, setup in zip(members, joined.setups, strict=True)
        for view in member.measurement.views
    )
    with SurfaceBeside(joined.stitched) as surface:
        with watch.stage("inspection"):
            settings = project_settings(project, calibration, views)
            inspection = inspect_stitched(project, joined.stitched, settings, PartOf(progress, 0.0, 0.4))
        if inspection is not None:
            on_event(InspectionReady(inspection))
        with watch.stage("surface"):
            mesh = surface.wait(on_event, PartOf(progress, 0.4, 0.8))
    measurement = Measurement(
        project=project.name,
        part=project.settings.part,
        rig=project.rig().name,
        measured_at=datetime.now(UTC).isoformat(timespec="seconds"),
        calibration=calibration,
        views=views,
        stitched=joined.stitched,
        mesh=mesh,
        inspection=inspection,
        settings=dict(members[0].measurement.settings),
        timings_s=dict(watch.seconds),
        validity=_validity(members),
        consistency=max((member.measurement.consistency for member in members), key=lambda one: one.unexplained_mm),
        setups=joined.setups,
    )
    with watch.stage("saving"):
        project.save_measurement(measurement, PartOf(progress, 0.8, 0.95))
    progress.report(0.95, 1.0, "joined")
    return finish(project, measurement, watch, language, PartOf(progress, 0.95, 1.0))


def _view_of(setup: str, view: ViewResult, part_from_setup: RigidTransform) -> ViewResult:
    """Return a view of a set-up in the common part frame, under its name among all set-ups."""
    name = view_name(setup, view.viewpoint_id)
    placed = part_from_setup @ RigidTransform(view.part_from_camera.matrix, part_from_setup.from_frame, "camera")
    return replace(view, viewpoint_id=name, cloud=replace(view.cloud, viewpoint_id=name), part_from_camera=placed)


def _validity(members: Sequence[_Member]) -> Validity:
    """Return the warnings of all calibrations, each with the name of its set-up."""
    return Validity(tuple(f"{one.name}: {warning}" for one in members for warning in one.measurement.validity.all_warnings))
