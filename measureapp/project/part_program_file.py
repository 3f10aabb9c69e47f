"""Files of part programs (.mpart): a ZIP archive whose checksums are compared on reading."""

from __future__ import annotations

import hashlib
import io
import zipfile
from dataclasses import replace
from pathlib import Path, PurePosixPath

from pydantic import ValidationError

from measureapp.data.identification import one_line
from measureapp.data.model import first_problem
from measureapp.data.part_program import PartProgram, PartProgramFacts, Release
from measureapp.data.plan import ScanPlan
from measureapp.data.rig import RigDescription
from measureapp.errors import InputError
from measureapp.project.atomic import replacing
from measureapp.project.geometry.files import read_mesh
from measureapp.project.geometry.step_files import STEP_KINDS
from measureapp.project.plan_file import read_plan
from measureapp.project.program_file import parse_program, read_program
from measureapp.project.template_folder import FOLDER as TEMPLATE_FOLDER
from measureapp.project.template_folder import read_folder, unzip_folder, zip_folder

PART_PROGRAM = ".mpart"
FACTS, PLAN, INSPECTION, NOMINAL, PICTURE = "part_program.json", "plan.json", "program.toml", "nominal", "picture.png"
RIG = "rig.json"
REPORT, TEMPLATE = "report.typ", "report.zip"  # a layout of the report alone, or a whole template folder
LARGEST_BYTES = 1_000_000_000  # unpacked, all files together
PNG = b"\x89PNG\r\n\x1a\n"
HINT = "Give a part program that `measureapp program pack` has written."


def is_part_program(path: Path) -> bool:
    """Return whether ``path`` names a part program, by its ending."""
    return path.suffix.lower() == PART_PROGRAM


def pack_part_program(
    facts: PartProgramFacts, plan: Path, inspection: Path | None = None, report_template: Path | None = None, picture: Path | None = None
) -> PartProgram:
    """Collect a part program from files; the nominal is the one that the inspection program names.

    Parameters
    ----------
    report_template : a template folder, or a Typst file

    Raises
    ------
    InputError
        A file cannot be read or is not what it should be; names it.
    """
    program = None if inspection is None else read_program(inspection)
    nominal = None
    if inspection is not None and program is not None and program.nominal is not None:
        path = inspection.parent / program.nominal
        content = _content(path)
        if path.suffix.lower() not in STEP_KINDS:
            read_mesh(path, "nominal", unit=program.nominal_unit)  # refused here rather than on the shop floor
        nominal = (path.suffix.lower(), content)
    if picture is not None and not _content(picture).startswith(PNG):
        raise InputError(f"{picture} is not a PNG image.", "Give the picture of the part as PNG.")
    folder = report_template is not None and report_template.is_dir()
    return PartProgram(
        facts,
        read_plan(plan),
        None if inspection is None else _content(inspection),
        nominal,
        None if report_template is None or folder else _content(report_template),
        None if picture is None else _content(picture),
        zip_folder(read_folder(report_template)) if folder and report_template is not None else None,
    )


def write_part_program(program: PartProgram, path: Path) -> Path:
    """Write a part program, whole or not at all, and return its path, whose ending is `.mpart`. Raises StorageError."""
    path = path if is_part_program(path) else path.with_name(path.name + PART_PROGRAM)
    files = _files(program)
    facts = program.facts.model_copy(
        update={"schema_version": 3, "sha256": {name: hashlib.sha256(data).hexdigest() for name, data in files.items()}}
    )
    with replacing(path) as temporary, zipfile.ZipFile(temporary, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr(FACTS, facts.model_dump_json(indent=2))
        for name, data in files.items():
            archive.writestr(name, data)
    return path


def read_part_program(path: Path) -> PartProgram:
    """Read a part program.

    Raises
    ------
    InputError
        The file cannot be read, is damaged, contains something else, or was written by a newer version.
    """
    files = _unpack(path)
    try:
        facts = PartProgramFacts.model_validate_json(files.pop(FACTS))
        plan = ScanPlan.model_validate_json(files[PLAN])
        rig = RigDescription.model_validate_json(files[RIG]) if RIG in files else None
    except KeyError as error:
        raise InputError(f"{path} has no {error.args[0]}.", HINT) from error
    except ValidationError as error:
        raise InputError(f"{path}: {first_problem(error, 'the part program')}.", HINT) from error
    for name, data in files.items():
        if facts.sha256.get(name) != hashlib.sha256(data).hexdigest():
            raise InputError(f"{path}: {name} does not match its checksum.", "Copy the file again from where it was written.")
    missing = sorted(set(facts.sha256) - set(files))
    if missing:
        raise InputError(f"{path}: {missing[0]} is missing.", "Copy the file again from where it was written.")
    if INSPECTION in files:
        _check_inspection(path, files[INSPECTION])
    if TEMPLATE in files:
        unzip_folder(files[TEMPLATE], f"{path}: {TEMPLATE}")
    nominal = next(((PurePosixPath(name).suffix, data) for name, data in files.items() if PurePosixPath(name).stem == NOMINAL), None)
    return PartProgram(facts, plan, files.get(INSPECTION), nominal, files.get(REPORT), files.get(PICTURE), files.get(TEMPLATE), rig)


def is_released(program: PartProgram) -> bool:
    """Return whether a part program is released as it is; whatever changed it afterwards made it another one."""
    release = program.facts.release
    return release is not None and release.digest == _digest(program)


def release_part_program(program: PartProgram, by: str, at: str) -> PartProgram:
    """Return the part program released for operators as its next revision; one that is released already is returned as it is.

    Parameters
    ----------
    by : name of who answers for it
    at : ISO 8601

    Raises
    ------
    InputError
        Nobody is named.
    """
    if not by.strip():
        raise InputError("A release needs a name.", "State who releases the part program.")
    if is_released(program):
        return program
    release = Release(by=one_line(by), at=at, digest=_digest(program))
    return replace(program, facts=program.facts.model_copy(update={"revision": program.facts.revision + 1, "release": release}))


def release_file(path: Path, by: str, at: str) -> PartProgram:
    """Release the part program in a file, and return it. Raises InputError, StorageError."""
    program = release_part_program(read_part_program(path), by, at)
    write_part_program(program, path)
    return program


def with_former_revision(program: PartProgram, path: Path) -> PartProgram:
    """Return a changed part program that counts on from the revision of the file it replaces; it is not released."""
    path = path if is_part_program(path) else path.with_name(path.name + PART_PROGRAM)
    try:
        former = read_part_program(path).facts.revision if path.exists() else 0
    except InputError:
        former = 0  # a damaged file is replaced
    return replace(program, facts=program.facts.model_copy(update={"revision": former, "release": None}))


def _digest(program: PartProgram) -> str:
    """Return the checksum of everything that decides how a part is measured and judged, and of what is printed for every part."""
    facts, digest = program.facts, hashlib.sha256()
    own = facts.model_dump_json(exclude={"schema_version", "sha256", "revision", "release", "identification"}, exclude_defaults=True)
    same = "\0".join(getattr(facts.identification, name) for name in ("drawing", "revision", "customer"))
    described = {  # without defaults: an entry that a later version adds changes nothing
        "facts": own,
        "same": same,
        PLAN: program.plan.model_dump_json(exclude_defaults=True),
        RIG: "" if program.rig is None else program.rig.model_dump_json(exclude_defaults=True),
    }
    contents = {**_files(program), **{name: text.encode() for name, text in described.items()}}
    for name, content in sorted(contents.items()):
        digest.update(name.encode() + b"\0" + hashlib.sha256(content).digest())
    return digest.hexdigest()


def unpack_part_program(program: PartProgram, folder: Path) -> dict[str, Path]:
    """Write the files of a part program into a new or empty folder, and return them; the nominal gets the name that its program states.

    Raises
    ------
    InputError
        The folder contains something.
    StorageError
        It cannot be written.
    """
    if folder.exists() and (not folder.is_dir() or any(folder.iterdir())):
        raise InputError(f"{folder} is not an empty folder.", "Choose a new or an empty folder.")
    written = {}
    for name, data in _files(program).items():
        if name == TEMPLATE:
            written["report"] = _unpack_template(data, folder / TEMPLATE_FOLDER)
            continue
        path = folder / (_nominal_name(program, name) if PurePosixPath(name).stem == NOMINAL else name)
        with replacing(path) as temporary:
            temporary.write_bytes(data)
        written[PurePosixPath(name).stem] = path
    return written


def _unpack_template(packed: bytes, folder: Path) -> Path:
    for name, content in unzip_folder(packed, TEMPLATE).items():
        with replacing(folder / name) as temporary:
            temporary.write_bytes(content)
    return folder


def _nominal_name(program: PartProgram, name: str) -> str:
    stated = None if program.inspection is None else parse_program(program.inspection.decode()).nominal
    return name if stated is None else PurePosixPath(stated.replace("\\", "/")).name


def _check_inspection(path: Path, content: bytes) -> None:
    try:
        parse_program(content.decode())
    except UnicodeDecodeError as error:
        raise InputError(f"{path}: {INSPECTION} is not a text.", HINT) from error
    except InputError as error:
        raise InputError(f"{path}: {error.message}", error.hint) from error


def _files(program: PartProgram) -> dict[str, bytes]:
    """Return the files of the archive, besides the facts."""
    nominal = {} if program.nominal is None else {f"{NOMINAL}{program.nominal[0]}": program.nominal[1]}
    rig = None if program.rig is None else program.rig.model_dump_json(indent=2).encode()
    others = {
        RIG: rig,
        INSPECTION: program.inspection,
        REPORT: program.report_template,
        PICTURE: program.picture,
        TEMPLATE: program.template_folder,
    }
    return {PLAN: program.plan.model_dump_json(indent=2).encode(), **nominal} | {
        name: data for name, data in others.items() if data is not None
    }


def _unpack(path: Path) -> dict[str, bytes]:
    """Return the files of the archive by name; refuses folders, strangers and what would fill the memory."""
    try:
        with zipfile.ZipFile(io.BytesIO(_content(path))) as archive:
            members = archive.infolist()
            names = [member.filename for member in members]
            strangers = [name for name in names if not _is_known(name)]
            if strangers or len(set(names)) != len(names):
                raise InputError(f"{path} contains {(strangers or names)[0]!r}, which no part program has.", HINT)
            if sum(member.file_size for member in members) > LARGEST_BYTES:
                raise InputError(f"{path} unpacks to more than {LARGEST_BYTES / 1e9:g} GB.", HINT)
            return {member.filename: archive.read(member) for member in members}
    except (zipfile.BadZipFile, EOFError, ValueError, NotImplementedError, RuntimeError, OSError) as error:
        raise InputError(f"{path} cannot be read as a part program: {error}.", HINT) from error


def _is_known(name: str) -> bool:
    return name in (FACTS, PLAN, RIG, INSPECTION, REPORT, TEMPLATE, PICTURE) or (PurePosixPath(name).stem == NOMINAL and "/" not in name)


def _content(path: Path) -> bytes:
    try:
        return path.read_bytes()
    except OSError as error:
        raise InputError(f"{path} cannot be read: {error.strerror or error}.", "Check the path.") from error
