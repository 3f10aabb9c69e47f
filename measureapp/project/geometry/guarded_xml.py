"""XML from outside: refused in words if it is broken, huge, or declares a document type, where entities could multiply without end."""

from __future__ import annotations

from pathlib import Path
from xml.etree.ElementTree import Element, TreeBuilder
from xml.parsers.expat import ExpatError, ParserCreate

from measureapp.errors import InputError

LARGEST_BYTES = 16 * 2**20
DEEPEST = 100  # nested elements


def read_xml(path: Path, remedy: str) -> Element:
    """Return the root element of a file.

    Parameters
    ----------
    remedy : hint for a file that cannot be read

    Raises
    ------
    InputError
        The file cannot be read, is larger than 16 MB, is not XML (names line and column), or is refused for its document type or depth.
    """
    builder, parser, depth = TreeBuilder(), ParserCreate(), 0

    def start(tag: str, attributes: dict[str, str]) -> None:
        nonlocal depth
        depth += 1
        if depth > DEEPEST:
            raise InputError(f"{path} nests more than {DEEPEST} elements.", remedy)
        builder.start(tag, attributes)

    def end(tag: str) -> None:
        nonlocal depth
        depth -= 1
        builder.end(tag)

    def refuse_document_type(*_: object) -> None:
        raise InputError(f"{path} declares a document type (DOCTYPE), which can hide entities.", "Delete the DOCTYPE from the file.")

    parser.StartElementHandler, parser.EndElementHandler = start, end
    parser.StartDoctypeDeclHandler = refuse_document_type
    try:
        parser.Parse(_content(path, remedy), True)
    except (ExpatError, ValueError, LookupError) as error:  # the latter two: encodings
        raise InputError(f"{path} is not valid XML: {error}.", remedy) from error
    return builder.close()


def _content(path: Path, remedy: str) -> bytes:
    try:
        with path.open("rb") as file:
            content = file.read(LARGEST_BYTES + 1)
    except OSError as error:
        raise InputError(f"{path} cannot be read: {error.strerror or error}.", remedy) from error
    if len(content) > LARGEST_BYTES:
        raise InputError(f"{path} is larger than {LARGEST_BYTES // 2**20} MB.", remedy)
    return content
