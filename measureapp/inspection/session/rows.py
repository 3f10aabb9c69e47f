"""Status of every entry of a program: what a table of features and dimensions shows beside the numbers."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Literal

from measureapp.data.inspection_program import InspectionProgram, copy_names
from measureapp.inspection.session.graph import Graph, Node

State = Literal["current", "stale", "failed"]
FailureOf = Callable[[Node], str | None]  # reason why an entry has no result; None: it has one


@dataclass(frozen=True, slots=True)
class Row:
    """Status of one feature, dimension or alignment."""

    node: Node
    state: State
    reason: str = ""  # of a failure
    failed_parents: tuple[Node, ...] = ()  # the direct or indirect parents that failed themselves
    parents: tuple[Node, ...] = ()
    children: tuple[Node, ...] = ()


def list_rows(program: InspectionProgram, is_known: Callable[[Node], bool], failure: FailureOf) -> tuple[Row, ...]:
    """Return the status of all entries in the order of the program: alignments, features, dimensions.

    Parameters
    ----------
    is_known : whether a result of an entry exists for its present definition
    failure : reason why a known entry has no result
    """
    graph = Graph.of(program)
    children: dict[Node, list[Node]] = {node: [] for node in graph.parents}
    for node, parents in graph.parents.items():
        for parent in parents:
            children[parent].append(node)
    reasons = {node: failure(node) if is_known(node) else None for node in graph.parents}
    rows = []
    for node, parents in graph.parents.items():
        reason = reasons[node]
        state: State = "stale" if not is_known(node) else "current" if reason is None else "failed"
        causes = () if reason is None else _causes(node, graph, reasons)
        rows.append(Row(node, state, reason or "", causes, parents, tuple(children[node])))
    return tuple(rows)


def _causes(node: Node, graph: Graph, reasons: Mapping[Node, str | None]) -> tuple[Node, ...]:
    """Return the failed ancestors whose own parents did not fail."""
    failed = [one for one in graph.ancestors(node) if reasons[one] is not None]
    return tuple(one for one in failed if not any(reasons[parent] is not None for parent in graph.parents[one]))


def copies_of(program: InspectionProgram) -> Mapping[str, tuple[str, ...]]:
    """Return the names of the copies of every feature entry."""
    return {one.name: copy_names(one.name, one.repeat) for one in program.features}
