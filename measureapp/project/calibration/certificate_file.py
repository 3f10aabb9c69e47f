"""Certificates of calibration boards: a table of the marks, or a TOML file with uncertainty, temperature, and marks or scale."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import numpy as np
from pydantic import Field, ValidationError, model_validator

from measureapp.calibrate.motions.axis_motion import rigid_motion
from measureapp.data.board import AnyBoard
from measureapp.data.certificate import COLDEST_C, EXPANSION_SHARE, HOTTEST_C, BoardClass, BoardLengths, lengths_of_class
from measureapp.data.model import Model, first_problem
from measureapp.data.part_temperature import read_temperature
from measureapp.errors import InputError
from measureapp.project.tables import read_corners
from measureapp.project.text_document import read_toml

LARGEST_MARK_ERROR = 0.05  # of the distance between neighbouring marks; a certificate that is further off belongs to another board
HINT = "Write it as `calibration` of the help describes: number, temperature_c, uncertainty_mm, over_mm, and corners or scale."


class CertifiedBoard(Model):
    """The board that a certificate names: marks in a row, rows, and distance of neighbouring marks."""

    marks: tuple[int, int]
    spacing_mm: float = Field(gt=0)


class Certificate(Model):
    """A certificate as written in a TOML file; uncertainties are expanded by `coverage_factor`."""

    schema_version: Literal[1] = 1
    number: str = Field(min_length=1, max_length=100)
    board: CertifiedBoard | None = Field(default=None, description="none: not checked")
    corners: str | None = Field(default=None, description="table of the certified marks, beside the file")
    scale: float | None = Field(default=None, gt=0, description="certified over nominal lengths, where no marks are certified")
    uncertainty_mm: float = Field(gt=0, description="of a length of `over_mm`")
    over_mm: float = Field(gt=0)
    coverage_factor: float = Field(default=2.0, gt=0, le=5)
    temperature_c: float = Field(ge=COLDEST_C, le=HOTTEST_C, description="for which its lengths are stated")
    expansion_ppm_per_k: float = Field(default=0.0, ge=0, le=200)
    expansion_uncertainty_ppm_per_k: float | None = Field(default=None, ge=0, le=200)

    @model_validator(mode="after")
    def _has_one_source(self) -> Certificate:
        if self.corners is not None and self.scale is not None:
            raise ValueError("it has both corners and a scale, of which one would be ignored")
        return self

    def lengths(self) -> BoardLengths:
        """Return scale, uncertainty and expansion. Raises ValueError where they are absurd."""
        expansion = self.expansion_ppm_per_k * 1e-6
        stated = self.expansion_uncertainty_ppm_per_k
        return BoardLengths(
            source="certificate",
            number=self.number,
            scale=1.0 if self.scale is None else self.scale,
            relative_sigma=self.uncertainty_mm / self.over_mm / self.coverage_factor,
            reference_c=self.temperature_c,
            expansion_per_k=expansion,
            expansion_sigma_per_k=EXPANSION_SHARE * expansion if stated is None else stated * 1e-6 / self.coverage_factor,
        )


def with_lengths(board: AnyBoard, certificate: Path | None, board_class: BoardClass | None, temperature: str | None) -> AnyBoard:
    """Return a board with what is stated about its lengths.

    Parameters
    ----------
    certificate : table of marks (CSV), or certificate (TOML); a table alone states no uncertainty and may have a class beside it
    temperature : of the board during the calibration, such as "23±0.5"

    Raises
    ------
    InputError
        The certificate belongs to another board or cannot be read, or the statements contradict each other.
    """
    if certificate is not None:
        board = certify(board, certificate)
    if board_class is not None:
        if board.lengths is not None:
            raise InputError(f"{certificate} and the class {board_class!r} both state the lengths of the board.", "State one of them.")
        board = board.model_copy(update={"lengths": lengths_of_class(board_class)})
    if temperature is None:
        return board
    if board.lengths is None:
        raise InputError(
            "A temperature of the board says nothing without its class or certificate.", "State --board-class or --certificate."
        )
    try:
        lengths = board.lengths.at(*read_temperature(temperature))
    except ValueError as error:
        raise InputError(f"Temperature of the board: {error}.", "Give it in °C with its uncertainty (k = 2), such as 21.5±0.5.") from error
    return board.model_copy(update={"lengths": lengths})


def certify(board: AnyBoard, path: Path) -> AnyBoard:
    """Return the board with its certified marks, moved rigidly onto the nominal grid, and with what a TOML file states of its lengths.

    Raises
    ------
    InputError
        The certificate cannot be read, has other marks than the board, or differs from its grid by more than the printing could.
    """
    if path.suffix.lower() != ".toml":
        return _with_marks(board, path)
    document = read_toml(path, HINT)
    try:
        certificate = Certificate.model_validate(document)
        lengths = certificate.lengths()
    except ValidationError as error:
        raise InputError(f"{path}: {first_problem(error, 'the certificate')}.", HINT) from error
    named = certificate.board
    if named is not None and (named.marks != (board.columns, board.rows) or abs(named.spacing_mm / board.neighbour_mm - 1) > 1e-3):
        raise InputError(
            f"{path} is the certificate of a board of {named.marks[0]} × {named.marks[1]} marks, {named.spacing_mm:g} mm apart; "
            f"this is a {board.label}, {board.neighbour_mm:g} mm apart.",
            "Choose the certificate of this board, or correct the board.",
        )
    marked = board if certificate.corners is None else _with_marks(board, path.parent / certificate.corners)
    return marked.model_copy(update={"lengths": lengths})


def _with_marks(board: AnyBoard, path: Path) -> AnyBoard:
    table = read_corners(path)
    positions, count = table.corners_mm.shape[:2]
    if positions != 1 or count != board.count:
        found = f"{count} marks" if positions == 1 else f"{positions} positions"
        raise InputError(
            f"{path} has {found}; a certificate of the {board.label} has one position with {board.count} marks.",
            "Number the marks from 0 row by row, all with the same position.",
        )
    nominal = board.nominal_corners_mm
    motion = rigid_motion(table.corners_mm[0], nominal)
    placed = table.corners_mm[0] @ motion[:3, :3].T + motion[:3, 3]
    off = float(np.linalg.norm(placed - nominal, axis=1).max())
    if off > LARGEST_MARK_ERROR * board.neighbour_mm:
        raise InputError(
            f"{path} is not a certificate of the {board.label} with {board.neighbour_mm:g} mm from mark to mark: "
            f"a mark is {off:.3g} mm from its place in the grid.",
            "Check the size given in [board], the unit of the certificate (mm), and that it numbers the marks row by row from 0.",
        )
    return board.model_copy(update={"certified_mm": tuple(tuple(mark) for mark in placed.tolist())})
