"""Sample projects that come with the program: measured projects of the virtual rig, thinned so that they are small, which open at once."""

from __future__ import annotations

import shutil
import tempfile
import zipfile
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.cloud import PointCloud, StitchedCloud
from measureapp.data.measurement import Measurement, ViewResult
from measureapp.data.storage_rules import StorageRules
from measureapp.errors import InputError, StorageError
from measureapp.pipeline.events import Event
from measureapp.pipeline.restitch import restitch
from measureapp.progress import NoProgress, Progress
from measureapp.project.atomic import replacing, require_writable, write_text
from measureapp.project.folder import ProjectFolder
from measureapp.project.journal import disk
from measureapp.resources import resource

FOLDER, ENDING = "samples", ".zip"
KEPT = ("plan.json", "identification.json", "calibration/*.json", "calibration/*.npz", "inspection/*", "inspection/report_template/*")
RESULTS = ("project.json", "storage.json", *KEPT, "results/*", "results/clouds/*")
DIGITS = 2**-10  # to which normals and greys are rounded: far below their noise, and it halves the archive
SIGMA_MM = 2**-14
LARGEST_BYTES = 2_500_000  # of an archive
AnyCloud = TypeVar("AnyCloud", PointCloud, StitchedCloud)


def sample_names() -> tuple[str, ...]:
    """Return the names of the sample projects that come with the program. Raises InputError where the installation lacks them."""
    return tuple(sorted(path.stem for path in resource(FOLDER).glob(f"*{ENDING}")))


def unpack_sample(name: str, folder: Path) -> ProjectFolder:
    """Unpack a sample project into ``folder``, or open it where this has been done before.

    Raises
    ------
    InputError
        There is no such sample, or the folder contains something else.
    StorageError
        The folder cannot be written, or the archive is damaged.
    """
    if name not in sample_names():
        raise InputError(f"There is no sample project {name}.", f"Name one of: {', '.join(sample_names())}.")
    if (folder / "project.json").exists():
        return ProjectFolder.open(folder)
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        raise InputError(f"{folder} is not an empty folder.", "Choose a new or an empty folder for the project.")
    part = folder.with_name(f".{folder.name}.sample")
    shutil.rmtree(part, ignore_errors=True)
    try:
        with disk.explained(folder), zipfile.ZipFile(resource(f"{FOLDER}/{name}{ENDING}")) as archive:
            part.mkdir(parents=True)
            archive.extractall(part)
            folder.mkdir(parents=True, exist_ok=True)
            folder.rmdir()
            part.replace(folder)
    except zipfile.BadZipFile as error:
        raise StorageError(f"The sample project {name} is damaged: {error}.", "Install the program again.") from error
    finally:
        shutil.rmtree(part, ignore_errors=True)
    project = ProjectFolder.open(folder)
    with project.lock():  # makes its journal
        return project


def pack_sample(
    source: Path,
    archive: Path,
    *,
    title: str,
    every: int = 2,
    on_event: Callable[[Event], None] = lambda _event: None,
    progress: Progress = NoProgress(),  # noqa: B008 - stateless
) -> Path:
    """Write a measured project as a sample: without images, and with every ``every``-th row and column of its clouds, stitched anew.

    Parameters
    ----------
    title : name of the project in the sample

    Raises
    ------
    InputError
        ``source`` has no measurement.
    StorageError
        A file cannot be read or written, or the sample would be larger than `LARGEST_BYTES`.
    RegistrationError
        The thinned clouds cannot be registered.
    """
    project = ProjectFolder.open(source)
    measurement = project.measurement()
    if measurement is None:
        raise InputError(f"{source} contains no measurement.", "Scan first, or recompute it: measureapp process PROJECT.")
    require_writable(archive)
    with tempfile.TemporaryDirectory() as folder:
        made = Path(folder)
        write_text(made / "project.json", project.settings.model_copy(update={"name": title}).model_dump_json(indent=2))
        for path in _matching(project.path, KEPT):
            (made / path).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(project.path / path, made / path)
        sample = ProjectFolder.open(made)
        sample.save_storage_rules(StorageRules(raw="drop"))
        with sample.lock():
            sample.save_measurement(_thinned(measurement, title, every))
        made_anew = restitch(sample, sample.view_choices(), on_event, progress).measurement
        with sample.lock():
            sample.save_measurement(replace(made_anew, stitched=_rounded(made_anew.stitched)), recomputed=False)
        with replacing(archive) as temporary:
            with zipfile.ZipFile(temporary, "w", zipfile.ZIP_LZMA) as written:
                for path in _matching(made, RESULTS):
                    written.write(made / path, path.as_posix())
            size = temporary.stat().st_size
            if size > LARGEST_BYTES:
                raise StorageError(f"The sample would have {size / 1e6:.1f} MB.", "Keep fewer points: a larger --every.")
    return archive


def _matching(folder: Path, patterns: tuple[str, ...]) -> list[Path]:
    return sorted({path.relative_to(folder) for pattern in patterns for path in folder.glob(pattern) if path.is_file()})


def _thinned(measurement: Measurement, title: str, every: int) -> Measurement:
    views = tuple(_thin_view(view, every) for view in measurement.views)
    return replace(measurement, project=title, views=views, mesh=None)


def _thin_view(view: ViewResult, every: int) -> ViewResult:
    cloud = _thin_cloud(view.cloud, every)
    density = view.quality.density_per_mm2 * len(cloud) / max(len(view.cloud), 1)
    quality = replace(view.quality, points=len(cloud), density_per_mm2=density)
    return replace(view, cloud=cloud, quality=quality, made_from="")  # its images would give another cloud


def _thin_cloud(cloud: PointCloud, every: int) -> PointCloud:
    return _rounded(cloud.where((cloud.pixel % every == 0).all(axis=1)))


def _rounded(cloud: AnyCloud) -> AnyCloud:
    """Round what is far less certain than its digits, which halves the archive."""
    rounded: dict[str, Any] = {name: _to_multiples(getattr(cloud, name), DIGITS) for name in ("normals", "grey")}
    return replace(cloud, **rounded, sigma_mm=np.maximum(_to_multiples(cloud.sigma_mm, SIGMA_MM), SIGMA_MM))


def _to_multiples(values: FloatArray, step: float) -> FloatArray:
    return np.asarray(np.round(values / step) * step)
