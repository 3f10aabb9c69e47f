"""Inspection programs: measured features, constructed features and toleranced dimensions."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Literal

from pydantic import Field, field_validator, model_validator

from measureapp.data.alignment_program import AlignmentProgram, BestFit, alignment_entry, alignment_features
from measureapp.data.blade_section import BLADE_KINDS, BladeSection
from measureapp.data.datum_letters import features_of_commons, is_datum_letter
from measureapp.data.deviation_scale import DeviationScale
from measureapp.data.dimension_program import FORMS, PAIRS, PROFILES, ZONES, Criterion, DimensionKind, DimensionProgram, Section
from measureapp.data.feature_program import (
    ConstructedFeature,
    ConstructedShape,
    MeasuredFeature,
    MeasuredShape,
    PatternIndex,
    copy_names,
    needed_names,
    substitute_index,
)
from measureapp.data.free_form import FreeForm
from measureapp.data.length_unit import LengthUnit
from measureapp.data.model import Model

__all__ = [
    "FORMS",
    "PAIRS",
    "PROFILES",
    "ZONES",
    "ConstructedFeature",
    "ConstructedShape",
    "Criterion",
    "DimensionKind",
    "DimensionProgram",
    "FeatureProgram",
    "InspectionProgram",
    "MeasuredFeature",
    "MeasuredShape",
    "NamedAlignment",
    "PatternIndex",
    "Section",
    "copy_names",
    "needed_names",
    "substitute_index",
]
FeatureProgram = MeasuredFeature | ConstructedFeature | FreeForm | BladeSection


class NamedAlignment(Model):
    """A further alignment, which dimensions name in their `alignment`."""

    name: str = Field(min_length=1)
    alignment: AlignmentProgram = Field(description="a short form such as datums:A,B,C, or a table with `method`")

    @field_validator("alignment", mode="before")
    @classmethod
    def _alignment_in_one_word(cls, given: object) -> object:
        return alignment_entry(given) if isinstance(given, str) else given


class InspectionProgram(Model):
    """All features and dimensions of a part, in the nominal frame: z up as on the table."""

    schema_version: Literal[1] = 1
    name: str = Field(min_length=1)
    nominal: str | None = Field(default=None, description="mesh file of the nominal, relative to the program's file")
    nominal_unit: LengthUnit = Field(default=LengthUnit.MM, description="unit of the nominal file; the program itself is in mm")
    alignment: AlignmentProgram = Field(default=BestFit(), description="a short form such as best-fit, or a table with `method`")
    alignments: tuple[NamedAlignment, ...] = Field(default=(), description="further alignments, for single dimensions")
    datum_letters: Mapping[str, str] = Field(
        default={}, description="letter of each datum (ISO 5459) and its feature; datums without one get the next free letter"
    )
    deviation_scale: DeviationScale = Field(default=DeviationScale(), description="colours of the deviations from the nominal")
    features: tuple[Annotated[FeatureProgram, Field(discriminator="shape")], ...] = ()
    dimensions: tuple[DimensionProgram, ...] = ()

    @field_validator("alignment", mode="before")
    @classmethod
    def _alignment_in_one_word(cls, given: object) -> object:
        return alignment_entry(given) if isinstance(given, str) else given

    @model_validator(mode="after")
    def _names_meet(self) -> InspectionProgram:
        known: set[str] = set()
        for feature in self.features:
            if isinstance(feature, ConstructedFeature):
                for needed in needed_names(feature):
                    if needed not in known:
                        raise ValueError(f"feature {feature.name!r} is constructed from {needed!r}, which is not defined before it")
            names = copy_names(feature.name, feature.repeat)
            if twice := known.intersection(names):
                raise ValueError(f"two features have the name {sorted(twice)[0]!r}")
            known.update(names)
        for words, alignment in self._all_alignments():
            for needed in alignment_features(alignment):
                if needed not in known:
                    raise ValueError(f"{words} needs feature {needed!r}, which is not defined")
        self._require_letters_for(known)
        for dimension in self.dimensions:
            for needed in (name for names in (*dimension.feature_sets, *dimension.datum_sets) for name in names):
                if needed not in known:
                    raise ValueError(f"dimension {dimension.name!r} needs feature {needed!r}, which is not defined")
        if len({dimension.name for dimension in self.dimensions}) != len(self.dimensions):
            raise ValueError("two dimensions have the same name")
        return self

    def _require_letters_for(self, known: set[str]) -> None:
        """Require that each letter names one feature of those known, and no feature has two."""
        letters: dict[str, str] = {}
        commons = features_of_commons(self)
        for letter, feature in self.datum_letters.items():
            if not is_datum_letter(letter):
                raise ValueError(f"`datum_letters`: {letter!r} is not a datum letter: use a capital such as A, or one twice, such as AA")
            if feature not in known:
                raise ValueError(f"datum {letter} names feature {feature!r}, which is not defined")
            if feature in commons:
                raise ValueError(f"feature {feature!r} is a common datum, which has the letters of its features, not {letter}")
            if feature in letters:
                raise ValueError(f"feature {feature!r} has two datum letters, {letters[feature]} and {letter}: remove one of them")
            letters[feature] = letter

    @model_validator(mode="after")
    def _alignments_are_known(self) -> InspectionProgram:
        known = {one.name for one in self.alignments}
        if len(known) != len(self.alignments):
            raise ValueError("two alignments have the same name")
        for dimension in self.dimensions:
            if dimension.alignment is not None and dimension.alignment not in known:
                raise ValueError(f"dimension {dimension.name!r} names the alignment {dimension.alignment!r}, which is not defined")
        for one in self.features:
            measured = isinstance(one, MeasuredFeature) and one.grow is None
            if one.repeat is not None and not one.repeat.is_about_z and not measured and not isinstance(one, ConstructedFeature):
                raise ValueError(f"feature {one.name!r}: its pattern must be about the z axis; other patterns apply to measured shapes")
        return self

    def _all_alignments(self) -> list[tuple[str, AlignmentProgram]]:
        further = [(f"the alignment {one.name!r}", one.alignment) for one in self.alignments]
        return [("the alignment", self.alignment), *further]

    @model_validator(mode="after")
    def _features_suit_their_dimensions(self) -> InspectionProgram:
        blades, free = self._names_of(BladeSection), self._names_of(FreeForm)
        for dimension in self.dimensions:
            features = {name for names in dimension.feature_sets for name in names}
            datums = {name for names in dimension.datum_sets for name in names}
            for needed in sorted(features | datums):
                if (needed in blades) != (dimension.kind in BLADE_KINDS):
                    what = "is not a blade_section" if needed not in blades else "is a blade_section"
                    raise ValueError(f"dimension {dimension.name!r}: {needed!r} {what}; a {dimension.kind} cannot be evaluated on it")
            if (dimension.kind not in PROFILES and features & free) or datums & free:
                needed = sorted((features | datums) & free)[0]
                raise ValueError(
                    f"dimension {dimension.name!r}: {needed!r} is a free_form, which allows only a surface_profile or line_profile"
                )
        for one in self.features:
            if isinstance(one, ConstructedFeature) and (unfit := free.intersection(needed_names(one))):
                raise ValueError(f"feature {one.name!r} is constructed from {min(unfit)!r}, a free_form: use a plane, an axis or a centre")
        for words, alignment in self._all_alignments():
            if unfit := free.intersection(alignment_features(alignment)):
                raise ValueError(f"{words} uses {min(unfit)!r}, a free_form: use another feature, or a region of the best fit")
        return self

    def _names_of(self, kind: type[BladeSection] | type[FreeForm]) -> set[str]:
        return {name for one in self.features if isinstance(one, kind) for name in copy_names(one.name, one.repeat)}
