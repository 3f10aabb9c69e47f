"""Template folders of reports: `template.toml`, the logo, and optionally a layout of their own."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import tomli_w
from pydantic import ValidationError

from measureapp.data.model import first_problem, toml_values
from measureapp.data.report_template import ReportTemplate
from measureapp.errors import InputError
from measureapp.project.atomic import replacing, write_text
from measureapp.project.text_document import read_toml
from measureapp.resources import resource

FILE = "template.toml"
LAYOUT = "report/report.typ"
LARGEST_LOGO_BYTES = 5_000_000
KINDS = {".png": b"\x89PNG\r\n\x1a\n", ".jpg": b"\xff\xd8\xff", ".jpeg": b"\xff\xd8\xff", ".svg": b""}
REMEDY = "Give a folder with a template.toml, or a Typst file."


@dataclass(frozen=True, slots=True)
class Template:
    """A template that was read: its description, and the contents of its files."""

    description: ReportTemplate = field(default_factory=ReportTemplate)
    logo: tuple[str, bytes] | None = None  # ending such as ".png", and the file
    layout: Path | None = None  # Typst; None: the built-in one

    @property
    def layout_file(self) -> Path:
        """The Typst file that lays out the report."""
        return self.layout or resource(LAYOUT)


def own_template_folder() -> Path:
    """Return the folder of this user's template, with company and logo; it need not exist."""
    return Path.home() / "MeasureApp" / "report_template"


def default_template() -> Template:
    """Return this user's template, or the built-in one. Raises InputError where the user's is not valid."""
    folder = own_template_folder()
    return read_template(folder) if (folder / FILE).is_file() else Template()


def read_template(path: Path) -> Template:
    """Read a template folder, or take a Typst file as the layout of the built-in template.

    Raises
    ------
    InputError
        The folder has no valid `template.toml`, or a file it names is missing or not what it should be.
    """
    if path.is_file():
        return Template(layout=path)
    try:
        description = ReportTemplate.model_validate(read_toml(path / FILE, REMEDY))
    except ValidationError as error:
        raise InputError(f"{path / FILE}: {first_problem(error, 'the template')}.", "Correct this entry of the template.") from error
    layout = path / description.layout if description.layout else None
    if layout is not None and not layout.is_file():
        raise InputError(f"{layout} does not exist.", f"Correct `layout` in {path / FILE}.")
    return Template(description, read_logo(path / description.logo) if description.logo else None, layout)


def save_own_template(company: str, logo: Path | None) -> None:
    """Store company and logo in this user's template; the rest of it stays as it is.

    Raises
    ------
    InputError
        The logo is none, or the template so far is not valid.
    StorageError
        The folder cannot be written.
    """
    folder = own_template_folder()
    former = default_template().description
    content = None if logo is None else read_logo(logo)
    name = "" if content is None else f"logo{content[0]}"
    if content is not None:
        with replacing(folder / name) as temporary:
            temporary.write_bytes(content[1])
    changed = former.model_copy(update={"name": "own" if former.name == "built-in" else former.name, "company": company, "logo": name})
    write_text(folder / FILE, tomli_w.dumps({"schema_version": 1, **toml_values(changed)}))


def own_logo() -> Path | None:
    """Return the logo of this user's template. Raises InputError where the template is not valid."""
    name = default_template().description.logo
    return own_template_folder() / name if name else None


def read_logo(path: Path) -> tuple[str, bytes]:
    """Read a logo. Raises InputError where it is no PNG, JPEG or SVG, or too large."""
    ending = path.suffix.lower()
    try:
        content = path.read_bytes()
    except OSError as error:
        raise InputError(f"{path} cannot be read: {error.strerror or error}.", "Check the path of the logo.") from error
    drawn = ending in KINDS and content.startswith(KINDS[ending]) and (ending != ".svg" or b"<svg" in content)
    if not drawn or len(content) > LARGEST_LOGO_BYTES:
        raise InputError(f"{path} is not a logo that a report can show.", "Give a PNG, JPEG or SVG file of at most 5 MB.")
    return ending, content
