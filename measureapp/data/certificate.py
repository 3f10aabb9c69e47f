"""How well the lengths of a calibration board are known: its class or its certificate, and its temperature during the calibration.

No image shows an error of scale that all marks of a board share, so that it must be known from elsewhere. Standard uncertainties (k = 1)
are relative to a length; expansion as JCGM 100 and ISO/TR 16015 combine it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Literal, get_args

import numpy as np
from pydantic import Field, model_validator

from measureapp.data.model import Model

REFERENCE_C = 20.0  # ISO 1
COLDEST_C, HOTTEST_C = -10.0, 60.0  # between which boards and parts are measured
LARGEST_UNCERTAINTY_K = 20.0
ROOM_K = 2.0  # standard uncertainty of a temperature that nobody measured
EXPANSION_SHARE = 0.1  # standard uncertainty of a coefficient of expansion that is not stated
LARGEST_SCALE_ERROR = 0.02  # of a certificate; beyond, it belongs to another board

BoardClass = Literal["printed", "glass", "ceramic"]
BOARD_CLASSES: tuple[BoardClass, ...] = get_args(BoardClass)
LengthSource = Literal["printed", "glass", "ceramic", "certificate", "exact"]


@dataclass(frozen=True, slots=True)
class ClassOfBoards:
    """What is known of every board of a class."""

    words: str
    relative: float  # standard uncertainty of its lengths
    expansion_per_k: float


# A print on aluminium composite errs by ± 0.1 mm on 180 mm (k = 2), photographic film on glass by up to 50 ppm (rectangular), chrome on
# glass or ceramic by 4 ppm: bounds that makers state for such boards
CLASSES: Mapping[BoardClass, ClassOfBoards] = MappingProxyType(
    {
        "printed": ClassOfBoards("a printed board, ± 0.1 mm on 180 mm", 0.1 / 180.0 / 2.0, 23e-6),
        "glass": ClassOfBoards("a film on glass, up to 50 ppm off", 50e-6 / float(np.sqrt(3.0)), 9e-6),
        "ceramic": ClassOfBoards("chrome on glass or ceramic, ± 8 ppm", 4e-6, 7e-6),
    }
)


class BoardLengths(Model):
    """Scale of a board, its uncertainty, and its expansion."""

    source: LengthSource
    number: str = Field(default="", max_length=100, description="of the certificate")
    scale: float = Field(
        default=1.0, ge=1 - LARGEST_SCALE_ERROR, le=1 + LARGEST_SCALE_ERROR, description="certified over nominal lengths, at the reference"
    )
    relative_sigma: float = Field(ge=0, le=LARGEST_SCALE_ERROR, description="standard uncertainty of its lengths at the reference")
    reference_c: float = Field(default=REFERENCE_C, ge=COLDEST_C, le=HOTTEST_C, description="temperature its lengths are stated for")
    expansion_per_k: float = Field(default=0.0, ge=0, le=2e-4)
    expansion_sigma_per_k: float = Field(default=0.0, ge=0, le=2e-4)
    board_c: float | None = Field(default=None, ge=COLDEST_C, le=HOTTEST_C, description="during the calibration; none: not measured")
    board_sigma_k: float = Field(default=ROOM_K, ge=0, le=LARGEST_UNCERTAINTY_K)

    @model_validator(mode="after")
    def _only_certificates_have_a_number(self) -> BoardLengths:
        if self.source != "certificate" and (self.number or self.scale != 1.0):
            raise ValueError(f"the class {self.source!r} has neither a number nor a certified scale")
        return self

    @property
    def factor(self) -> float:
        """True lengths of the board during the calibration over nominal ones."""
        warmer = 0.0 if self.board_c is None else self.board_c - self.reference_c
        return self.scale * (1.0 + self.expansion_per_k * warmer)

    @property
    def sigma(self) -> float:
        """Relative standard uncertainty of the board's lengths during the calibration."""
        if self.source == "exact":
            return 0.0
        warmer = 0.0 if self.board_c is None else self.board_c - self.reference_c
        heat = np.hypot(self.expansion_per_k * self.board_sigma_k, self.expansion_sigma_per_k * warmer)
        return float(np.hypot(self.relative_sigma, heat))

    @property
    def words(self) -> str:
        """Where the lengths come from, as part of a sentence."""
        if self.source == "exact":
            return "an exact board"
        named = f"certificate {self.number}".strip() if self.source == "certificate" else CLASSES[self.source].words
        if self.board_c is None:
            return f"{named}, board at a temperature that was not measured"
        return f"{named}, board at {self.board_c:g} ± {2 * self.board_sigma_k:g} °C"

    def at(self, board_c: float, expanded_k: float) -> BoardLengths:
        """Return the same board at a temperature with its expanded uncertainty (k = 2)."""
        return BoardLengths.model_validate(self.model_dump() | {"board_c": board_c, "board_sigma_k": expanded_k / 2.0})


EXACT = BoardLengths(source="exact", relative_sigma=0.0)


def lengths_of_class(name: BoardClass) -> BoardLengths:
    """Return what is known of a board of this class, at a temperature that nobody measured."""
    known = CLASSES[name]
    return BoardLengths(
        source=name,
        relative_sigma=known.relative,
        expansion_per_k=known.expansion_per_k,
        expansion_sigma_per_k=EXPANSION_SHARE * known.expansion_per_k,
    )
