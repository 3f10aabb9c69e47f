"""Template folders of reports inside projects and part programs: a flat folder with a `template.toml`."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Mapping
from pathlib import Path

from measureapp.errors import InputError
from measureapp.project.atomic import remove, replacing

FOLDER, FILE, LAYOUT = "report_template", "template.toml", "report.typ"
LARGEST_BYTES, MOST_FILES = 20_000_000, 50
HINT = f"Give a folder with a {FILE}, a logo and texts."


def read_folder(folder: Path) -> dict[str, bytes]:
    """Read the files of a template folder. Raises InputError where it is none, or too large."""
    try:
        files = {path.name: path.read_bytes() for path in sorted(folder.iterdir()) if path.is_file() and not path.name.startswith(".")}
    except OSError as error:
        raise InputError(f"{folder} cannot be read: {error.strerror or error}.", HINT) from error
    return _checked(files, str(folder))


def save_folder(project: Path, files: Mapping[str, bytes]) -> None:
    """Store a template folder in the project in the folder ``project``, in place of a former one. Raises StorageError."""
    folder = project / "inspection" / FOLDER
    for name, content in files.items():
        with replacing(folder / name) as temporary:
            temporary.write_bytes(content)
    remove(*(path for path in folder.glob("*") if path.name not in files))


def choose_template(project: Path, source: Path | None) -> None:
    """Copy a template folder or a Typst file into the project in the folder ``project``; None: it has none of its own any more.

    Raises
    ------
    InputError
        ``source`` is no template.
    StorageError
        The project cannot be written.
    """
    layout, folder = project / "inspection" / LAYOUT, project / "inspection" / FOLDER
    if source is not None and source.is_dir():
        save_folder(project, read_folder(source))
    elif source is not None:
        with replacing(layout) as temporary:
            temporary.write_bytes(source.read_bytes())
    unused = [] if source is not None and source.is_file() else [layout]
    remove(*unused, *(() if source is not None and source.is_dir() else sorted(folder.glob("*"))))


def zip_folder(files: Mapping[str, bytes]) -> bytes:
    """Return the files as a ZIP archive, always the same for the same files."""
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in sorted(files.items()):
            archive.writestr(zipfile.ZipInfo(name), content)
    return packed.getvalue()


def unzip_folder(content: bytes, where: str) -> dict[str, bytes]:
    """Return the files of an archive of `zip_folder`. Raises InputError for any other content, which ``where`` names."""
    try:
        with zipfile.ZipFile(io.BytesIO(content)) as archive:
            members = archive.infolist()
            if sum(member.file_size for member in members) > LARGEST_BYTES:
                raise InputError(f"{where} unpacks to more than {LARGEST_BYTES / 1e6:g} MB.", HINT)
            return _checked({member.filename: archive.read(member) for member in members}, where)
    except (zipfile.BadZipFile, EOFError, ValueError, NotImplementedError, RuntimeError, OSError) as error:
        raise InputError(f"{where} cannot be read as a report template: {error}.", HINT) from error


def _checked(files: dict[str, bytes], where: str) -> dict[str, bytes]:
    if FILE not in files:
        raise InputError(f"{where} has no {FILE}.", HINT)
    strangers = [name for name in files if "/" in name or "\\" in name or ":" in name or name.startswith(".")]
    if strangers or len(files) > MOST_FILES or sum(map(len, files.values())) > LARGEST_BYTES:
        raise InputError(f"{where} holds more than a report template.", HINT)
    return files
