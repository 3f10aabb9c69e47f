"""Typesetting of a Typst template with its data and pictures."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from measureapp.errors import StorageError

MAIN = "main.typ"


def typeset(template: Path, files: Mapping[str, bytes], **options: Any) -> tuple[bytes, ...]:
    """Typeset ``template`` beside ``files`` in a temporary folder and return the document, or its pages as images.

    Raises
    ------
    StorageError
        The template has an error, which is named.
    """
    import typst

    try:
        with tempfile.TemporaryDirectory(prefix="measureapp-report-") as folder:
            for name, data in {MAIN: template.read_bytes(), **files}.items():
                (Path(folder) / name).write_bytes(data)
            made = typst.compile(str(Path(folder) / MAIN), root=folder, **options)
    except (typst.TypstError, RuntimeError) as error:
        hint = "Correct the template, or use the built-in one."
        raise StorageError(f"{template}: the report template has an error: {error}.", hint) from error
    return tuple(bytes(page) for page in made) if isinstance(made, list) else (bytes(made),)
