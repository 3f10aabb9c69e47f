"""One file for support: log, messages, settings, versions and graphics; nothing that is secret."""

from __future__ import annotations

import platform
import sys
import zipfile
from collections.abc import Iterable
from importlib import metadata
from pathlib import Path
from typing import TYPE_CHECKING

from measureapp.errors import StorageError
from ui.look.language.words import tr
from ui.messages import Message
from ui.settings.settings import Settings
from ui.workers.job import LOG

if TYPE_CHECKING:
    from ui.workers.job import Job

PACKAGES = ("measureapp", "PySide6-Essentials", "vtk", "numpy", "scipy", "numba", "open3d", "trimesh", "opencv-python-headless")


def support_lines(settings: Settings, messages: Iterable[Message]) -> dict[str, str]:
    """Return the texts of the file by their names; must be called on the thread of the window."""
    told = [f"{message.at:%Y-%m-%d %H:%M:%S}  {message.level:8} {message.text} {message.hint}".rstrip() for message in messages]
    return {"messages.txt": "\n".join(told), "settings.txt": "\n".join(settings.lines())}


def save_support_log(file: Path, texts: dict[str, str], log_folder: Path, job: Job) -> Path:
    """Write the file; runs on a job's thread.

    Raises
    ------
    StorageError
        It cannot be written.
    """
    job.report(0, 2, "Reading versions and graphics")
    texts = {**texts, "versions.txt": "\n".join(_versions()), "graphics.txt": _graphics()}
    job.report(1, 2, "Writing the file")
    try:
        with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
            for name, text in texts.items():
                archive.writestr(name, text + "\n")
            for log in sorted(log_folder.glob(f"{LOG}*")):
                archive.write(log, log.name)
    except OSError as error:
        raise StorageError(
            tr("{file} cannot be written: {value}.", file=file, value=error.strerror or error), "Choose another folder."
        ) from error
    return file


def _versions() -> list[str]:
    lines = [tr("Python {split}", split=sys.version.split()[0]), f"{platform.system()} {platform.release()} {platform.machine()}"]
    for name in PACKAGES:
        try:
            lines.append(f"{name} {metadata.version(name)}")
        except metadata.PackageNotFoundError:
            lines.append(tr("{name} is not installed", name=name))
    return lines


def _graphics() -> str:
    from ui.viewport.renderer import describe_renderer

    return describe_renderer()
