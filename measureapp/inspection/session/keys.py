"""Keys of results: digests of everything a result depends on, within one session of fixed points, nominal and settings."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass

from measureapp.data.alignment_program import AlignmentProgram, alignment_features
from measureapp.data.inspection_program import (
    ConstructedFeature,
    DimensionProgram,
    InspectionProgram,
    copy_names,
    needed_names,
)

OF_THE_VERDICT = frozenset(
    {"name", "nominal", "nominal_linked", "lower_tolerance", "upper_tolerance", "tolerance", "alignment", "group", "certificate"}
)  # entries of a dimension that do not affect its value


@dataclass(frozen=True, slots=True)
class ProgramKeys:
    """Keys of the alignments, features and values of one program."""

    alignments: Mapping[str | None, str]  # by name; None: that of the program
    definitions: Mapping[str, str]  # of features (each copy by name): their entries with all ancestors, without alignment
    entries: Mapping[str, str]  # name of each copy -> name of its entry
    certified: tuple[DimensionProgram, ...]  # lengths that correct others

    @classmethod
    def of(cls, program: InspectionProgram) -> ProgramKeys:
        """Return the keys of a program."""
        definitions: dict[str, str] = {}
        entries: dict[str, str] = {}
        for feature in program.features:
            parents = needed_names(feature) if isinstance(feature, ConstructedFeature) else ()
            key = digest(type(feature).__name__, feature.model_dump_json(), *(definitions[name] for name in parents))
            for name in copy_names(feature.name, feature.repeat):
                definitions[name], entries[name] = key, feature.name
        named: dict[str | None, AlignmentProgram] = {None: program.alignment, **{one.name: one.alignment for one in program.alignments}}
        alignments = {
            name: digest(one.model_dump_json(), *(definitions[needed] for needed in alignment_features(one))) for name, one in named.items()
        }
        return cls(alignments, definitions, entries, tuple(one for one in program.dimensions if one.certificate is not None))

    def feature(self, name: str, alignment: str | None) -> str:
        """Return the key of the entry of a feature, found in an alignment."""
        return digest(self.alignments[alignment], self.definitions[name])

    def value(self, described: DimensionProgram) -> str:
        """Return the key of a dimension's value."""
        names = (name for names in (*described.feature_sets, *described.datum_sets) for name in names)
        bonus = (str(described.upper_tolerance),) if described.size_limits_mm is not None else ()  # stated in words with the value
        own = (described.model_dump_json(exclude=set(OF_THE_VERDICT)), *bonus, *(self.feature(name, described.alignment) for name in names))
        return digest(*own, *(part for one in self.certified for part in self._standard(one, described)))

    def _standard(self, certified: DimensionProgram, described: DimensionProgram) -> tuple[str, ...]:
        """Return what the value of a dimension takes from a certified length, measured in the same alignment; nothing for certified ones."""
        if described.certificate is not None:
            return ()
        return (certified.model_dump_json(), *(self.feature(name, described.alignment) for name in certified.features))


def digest(*parts: str) -> str:
    """Return the SHA-256 digest of texts."""
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()
