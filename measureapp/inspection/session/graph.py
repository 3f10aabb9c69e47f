"""Dependency graph of an inspection program: what each feature and dimension needs, and what depends on it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

from measureapp.data.alignment_program import alignment_features
from measureapp.data.inspection_program import ConstructedFeature, InspectionProgram, copy_names, needed_names

ALIGNMENT = ""  # name of the program's own alignment in the graph


@dataclass(frozen=True, slots=True)
class Node:
    """One entry of a program. Features and dimensions may have the same name, so that a node is known by both."""

    kind: str  # "feature", "dimension" or "alignment"
    name: str


@dataclass(frozen=True, slots=True)
class Graph:
    """Parents of every entry, in the order of the program; copies of a pattern belong to their entry."""

    parents: Mapping[Node, tuple[Node, ...]]

    @classmethod
    def of(cls, program: InspectionProgram) -> Graph:
        """Return the graph of a program."""
        entry = {
            copy: Node("feature", one.name) for one in program.features for copy in copy_names(one.name, one.repeat)
        }  # name of each copy -> its entry
        parents: dict[Node, tuple[Node, ...]] = {}
        for name, alignment in ((ALIGNMENT, program.alignment), *((one.name, one.alignment) for one in program.alignments)):
            parents[Node("alignment", name)] = _distinct(entry[needed] for needed in alignment_features(alignment))
        for feature in program.features:
            needed = needed_names(feature) if isinstance(feature, ConstructedFeature) else ()
            parents[Node("feature", feature.name)] = _distinct(entry[name] for name in needed)
        for dimension in program.dimensions:
            names = (name for names in (*dimension.feature_sets, *dimension.datum_sets) for name in names)
            own = () if dimension.alignment is None else (Node("alignment", dimension.alignment),)
            parents[Node("dimension", dimension.name)] = (*_distinct(entry[name] for name in names), *own)
        return cls(parents)

    def children(self, node: Node) -> tuple[Node, ...]:
        """Return the entries that use ``node`` directly."""
        return tuple(one for one, parents in self.parents.items() if node in parents)

    def descendants(self, node: Node) -> tuple[Node, ...]:
        """Return all entries that depend on ``node``, nearest first."""
        return self._reach(node, self.children)

    def ancestors(self, node: Node) -> tuple[Node, ...]:
        """Return all entries that ``node`` depends on, nearest first."""
        return self._reach(node, lambda one: self.parents.get(one, ()))

    def _reach(self, node: Node, step: Callable[[Node], Iterable[Node]]) -> tuple[Node, ...]:
        reached: dict[Node, None] = {}
        waiting = list(step(node))
        while waiting:
            one = waiting.pop(0)
            if one not in reached:
                reached[one] = None
                waiting.extend(step(one))
        return tuple(reached)


def _distinct(nodes: Iterable[Node]) -> tuple[Node, ...]:
    return tuple(dict.fromkeys(nodes))
