"""Where `calibrate cameras` has its corners from: images of a board, or a file of corners found before."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from measureapp.cli.calibrate.options import BoardChoice, ImagesOption
from measureapp.errors import InputError

if TYPE_CHECKING:
    from measureapp.progress import Progress
    from measureapp.project.calibration.board_images import BoardImages
    from measureapp.project.calibration.camera_inputs import CameraInputs

DISTORTION = 5  # coefficients, if neither an option nor the file of corners states them


@dataclass(frozen=True, slots=True)
class CornerSource:
    """Images and board, or stored corners; and the parameters to be estimated from them."""

    board: BoardChoice
    images: ImagesOption = None
    corners: Annotated[Path | None, typer.Option(help="Corners that --corners-out wrote; stands for images and board.")] = None
    reference: Annotated[str | None, typer.Option(help="Reference camera; default: the first given, or as in --corners.")] = None
    distortion: Annotated[int | None, typer.Option(help="Distortion coefficients: 4, 5 or 8; default: 5, or as in --corners.")] = None
    serial: Annotated[list[str] | None, typer.Option(help="Serial number of a camera: name=number; once per camera.")] = None

    def inputs(self, progress: Progress) -> CameraInputs:
        """Find or read the corners. Raises InputError where the options do not go together, name nothing, or a file cannot be read."""
        if self.corners is None:
            return self._from_images(progress)
        if self.images or self.board != BoardChoice():
            raise InputError("--corners already holds board and corners.", "Omit --images and the options of the board, or --corners.")
        from measureapp.project.calibration.camera_inputs import read_camera_inputs

        stored = read_camera_inputs(self.corners)
        self.serials(tuple(stored.problem.sizes_px))
        problem = replace(
            stored.problem,
            reference=self.reference or stored.problem.reference,
            distortion_count=stored.problem.distortion_count if self.distortion is None else self.distortion,
        )
        return replace(stored, problem=problem)

    def serials(self, cameras: Sequence[str]) -> dict[str, str]:
        """Return camera -> serial number of ``--serial camera=number``; also checked early, so that a wrong one costs no minutes. Raises InputError."""
        numbers = {}
        for option in self.serial or ():
            camera, given, number = option.partition("=")
            if not given or not number or camera not in cameras:
                raise InputError(f"--serial {option!r} names no camera and number.", f"Give it as {cameras[0]}=12345.")
            numbers[camera] = number
        return numbers

    def _from_images(self, progress: Progress) -> CameraInputs:
        from measureapp.calibrate.draft.draft import Setup
        from measureapp.calibrate.kinds.lenses import camera_problem
        from measureapp.calibrate.kinds.table import KINDS
        from measureapp.calibrate.sightings import Rejection
        from measureapp.calibration_session.observing import Position, observe
        from measureapp.project.calibration.board_images import find_board_images
        from measureapp.project.calibration.camera_inputs import CameraInputs

        board, files = self.board.description(), find_board_images(self.images or ())
        self.serials(files.cameras)
        first = self.reference or files.cameras[0]
        if first not in files.cameras:
            raise InputError(f"--reference {first!r} is not among the cameras.", "Name one of: " + ", ".join(files.cameras) + ".")
        names = (first, *(name for name in files.cameras if name != first))
        setup = Setup(KINDS["cameras"], board, names, distortion_count=DISTORTION if self.distortion is None else self.distortion)
        sizes = files.sizes_px()
        positions = [
            Position(_view(number), lambda number=number: files.read(number, sizes))  # type: ignore[misc]
            for number in range(files.positions)
        ]
        observed = observe(positions, board, None, progress)
        rejected = [Rejection(one.camera, one.id, one.reason.rstrip(".")) for one in observed.refused]
        return CameraInputs(camera_problem(observed.draft(setup, {name: sizes[name] for name in names}), rejected), _names(files))


def _names(files: BoardImages) -> dict[tuple[str, str], str]:
    return {(camera, _view(number)): files.path(camera, number).name for camera in files.cameras for number in range(files.positions)}


def _view(position: int) -> str:
    return f"{position + 1:02d}"
