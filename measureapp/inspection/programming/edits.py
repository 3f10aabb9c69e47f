"""Edits of an inspection program as pure functions: each returns a new valid program, or raises with the reason and changes nothing.

Undo is the former program. Entries are known by kind ("feature", "dimension" or "alignment") and name.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

from measureapp.data.datum_letters import free_letter
from measureapp.data.inspection_program import InspectionProgram, copy_names
from measureapp.data.length_certificate import LengthCertificate
from measureapp.data.shown_name import shown_name
from measureapp.errors import InputError, InspectionError
from measureapp.inspection.programming.nominals import linked_nominal
from measureapp.inspection.programming.references import LISTS, Document, document_of, program_from, rename_references
from measureapp.inspection.session.graph import Graph, Node

MOST_LISTED = 4


def rename(program: InspectionProgram, node: Node, name: str) -> InspectionProgram:
    """Rename an entry; all references follow. Raises InputError for a name without letters, or one that is shown like another's."""
    new = name.strip()
    if not new:
        raise InputError(f"{node.name!r} needs a name.", "Enter at least one character.")
    if new == node.name:
        return program
    document = document_of(program)
    entry = _entry(document, node)
    if shown_name(new) in {shown_name(one) for one in names_of(program, node.kind) - {node.name}}:
        raise InputError(f"The program has a {node.kind} {new!r} already.", "Enter another name.")
    entry["name"] = new
    if node.kind == "feature":
        rename_references(document, lambda one: _renamed(one, node.name, new, entry.get("repeat") is not None))
    if node.kind == "alignment":
        for dimension in document["dimensions"]:
            if dimension.get("alignment") == node.name:
                dimension["alignment"] = new
    return program_from(document)


def _renamed(reference: str, old: str, new: str, has_copies: bool) -> str:
    if reference == old:
        return new
    if has_copies and re.fullmatch(re.escape(old) + r"\.(\d+|\{k(\+\d+)?\})", reference):
        return new + reference[len(old) :]
    return reference


def change(program: InspectionProgram, node: Node, values: Mapping[str, Any]) -> InspectionProgram:
    """Set values of an entry, None removes one; nominals linked to the features follow. Raises InputError."""
    if "name" in values:
        raise InputError(f"The name of {node.name!r} is not one of its values.", "Rename it, so that references follow.")
    document = document_of(program)
    entry = _entry(document, node)
    for key, value in values.items():
        if value is None:
            entry.pop(key, None)
        else:
            entry[key] = value
    return follow_nominals(program_from(document))


def set_tolerance(program: InspectionProgram, dimension: str, text: str) -> InspectionProgram:
    """Set the tolerance of a dimension as one text, such as ±0.1, H7 or 2768-m; empty: no verdict. Raises InputError."""
    document = document_of(program)
    entry = _entry(document, Node("dimension", dimension))
    for name in ("lower_tolerance", "upper_tolerance"):
        entry.pop(name, None)
    entry["tolerance"] = text.strip()
    return program_from(document)


def set_nominal(program: InspectionProgram, dimension: str, nominal: float) -> InspectionProgram:
    """Type the nominal of a dimension; it no longer follows the nominal features. Raises InputError."""
    return change(program, Node("dimension", dimension), {"nominal": nominal, "nominal_linked": None})


def link_nominal(program: InspectionProgram, dimension: str) -> InspectionProgram:
    """Restore the nominal that follows from the nominal features, and keep it linked.

    Raises
    ------
    InspectionError
        It does not follow from features, or one of them has no nominal position.
    """
    nominal = linked_nominal(program, dimension)
    return change(program, Node("dimension", dimension), {"nominal": nominal, "nominal_linked": True})


def set_certificate(
    program: InspectionProgram, dimension: str, length_mm: float, certificate: LengthCertificate | None
) -> InspectionProgram:
    """State that a length is certified, so that it corrects others; None: it is not, and its nominal stays. Raises InputError."""
    stated = None if certificate is None else certificate.model_dump(mode="json", exclude_defaults=True)
    values = {"certificate": stated} if stated is None else {"certificate": stated, "nominal": length_mm, "nominal_linked": None}
    return change(program, Node("dimension", dimension), values)


def follow_nominals(program: InspectionProgram) -> InspectionProgram:
    """Return the program with all linked nominals brought up to date; one that no longer exists keeps its number, unlinked."""
    linked = [one.name for one in program.dimensions if one.nominal_linked]
    if not linked:
        return program
    document = document_of(program)
    for name in linked:
        entry = _entry(document, Node("dimension", name))
        try:
            entry["nominal"] = linked_nominal(program, name)
        except InspectionError:
            entry["nominal_linked"] = False
    return program_from(document)


def add(program: InspectionProgram, kind: str, *entries: Mapping[str, Any]) -> InspectionProgram:
    """Append entries: features, dimensions or alignments, in one step. Raises InputError where one is not valid."""
    document = document_of(program)
    document[LISTS[kind]] += [dict(one) for one in entries]
    return follow_nominals(program_from(document))


def duplicate(program: InspectionProgram, node: Node) -> tuple[InspectionProgram, str]:
    """Copy an entry below itself under a free name; return that name, too."""
    document = document_of(program)
    entries = document[LISTS[node.kind]]
    entry, name = _entry(document, node), unique_name(program, node.kind, node.name)
    entries.insert(entries.index(entry) + 1, {**entry, "name": name})
    return program_from(document), name


def remove(program: InspectionProgram, nodes: Sequence[Node], *, with_children: bool = False) -> InspectionProgram:
    """Remove entries.

    Parameters
    ----------
    with_children : remove all that depends on them, too

    Raises
    ------
    InputError
        Others depend on them; names these. An alignment of the program that uses them is never removed with them.
    """
    graph = Graph.of(program)
    gone = dict.fromkeys(nodes)
    below = [child for node in nodes for child in graph.descendants(node) if child not in gone]
    if below and not with_children:
        raise InputError(f"{_listed(nodes)} is used by {_listed(below)}.", "Remove these as well, or give them other features first.")
    gone |= dict.fromkeys(below)
    if Node("alignment", "") in gone:
        raise InputError(f"The alignment of the program uses {_listed(nodes)}.", "Choose another alignment first.")
    document = document_of(program)
    for node in nodes:
        _entry(document, node)  # refuses an unknown one
    for kind, name in LISTS.items():
        document[name] = [one for one in document[name] if Node(kind, one["name"]) not in gone]
    lost = {name for one in program.features if Node("feature", one.name) in gone for name in copy_names(one.name, one.repeat)}
    document["datum_letters"] = {letter: name for letter, name in document["datum_letters"].items() if name not in lost}
    return program_from(document)


def move(program: InspectionProgram, node: Node, places: int) -> InspectionProgram:
    """Move an entry down (up for negative ``places``) in its list. Raises InputError where it would stand before what it is made from."""
    document = document_of(program)
    entries = document[LISTS[node.kind]]
    entry = _entry(document, node)
    at = entries.index(entry)
    to = min(max(at + places, 0), len(entries) - 1)
    entries.insert(to, entries.pop(at))
    return program if at == to else program_from(document)


def set_group(program: InspectionProgram, dimensions: Sequence[str], group: str) -> InspectionProgram:
    """List dimensions under a heading; an empty one removes them from their groups."""
    document = document_of(program)
    for name in dimensions:
        entry = _entry(document, Node("dimension", name))
        entry.pop("group", None)
        if group.strip():
            entry["group"] = group.strip()
    return program_from(document)


def set_alignment(program: InspectionProgram, alignment: str | Mapping[str, Any]) -> InspectionProgram:
    """Set the alignment of the program: a short form such as datums:A,B,C, or its values with `method`. Raises InputError."""
    document = document_of(program)
    document["alignment"] = alignment if isinstance(alignment, str) else dict(alignment)
    return program_from(document)


def set_datum_letter(program: InspectionProgram, feature: str, letter: str) -> InspectionProgram:
    """Name a datum feature by a letter, an empty one removes it; a feature that has the letter already takes that of the first, or a free one.

    Raises
    ------
    InputError
        The feature is not defined, the letter is none, or a dimension or alignment refers to the datum that would lose its letter.
    """
    document = document_of(program)
    features = {name: one for one, name in document["datum_letters"].items()}
    former, wanted = features.pop(feature, ""), letter.strip()
    holder = next((name for name, one in features.items() if one == wanted), "")
    if wanted:
        features[feature] = wanted
    if holder:
        features[holder] = former or free_letter(features.values())
    document["datum_letters"] = {one: name for name, one in features.items()}
    changed = program_from(document)
    if not wanted and feature in changed.datum_letters.values():
        raise InputError(f"{feature!r} is used as a datum, which needs a letter.", "Choose another letter, or remove what refers to it.")
    return changed


def names_of(program: InspectionProgram, kind: str) -> frozenset[str]:
    """Return the names in use; for features those of the copies of patterns, too."""
    if kind == "feature":
        return frozenset(name for one in program.features for name in (one.name, *copy_names(one.name, one.repeat)))
    entries: Sequence[Any] = program.dimensions if kind == "dimension" else program.alignments
    return frozenset(one.name for one in entries)


def unique_name(program: InspectionProgram, kind: str, wanted: str) -> str:
    """Return ``wanted``, or with the first free number, so that no other entry is shown by the same name.

    A number at its end is counted on: "bore 2" becomes "bore 3".
    """
    used = {shown_name(name) for name in names_of(program, kind)}
    if shown_name(wanted) not in used:
        return wanted
    stem = re.sub(r" \d+$", "", wanted)
    return next(name for number in range(2, len(used) + 3) if shown_name(name := f"{stem} {number}") not in used)


def _entry(document: Document, node: Node) -> Document:
    found = next((one for one in document[LISTS[node.kind]] if one["name"] == node.name), None)
    if found is None:
        raise InputError(f"The inspection program has no {node.kind} {node.name!r}.", "Choose one of its entries.")
    return found


def _listed(nodes: Sequence[Node]) -> str:
    words = [node.name or "the alignment" for node in nodes[:MOST_LISTED]]
    more = len(nodes) - MOST_LISTED
    return ", ".join(words) + (f" and {more} more" if more > 0 else "")
