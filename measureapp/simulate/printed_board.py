"""A calibration board under the projector's light."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray, ImageArray
from measureapp.data.board import BoardDescription, CharucoDescription, CheckerboardDescription, CirclesDescription
from measureapp.geometry.marker_cells import marker_cells
from measureapp.geometry.transform import RigidTransform
from measureapp.simulate.board_kernel import light_board
from measureapp.simulate.effects.board_print import PrintErrors
from measureapp.simulate.kernels import in_bands
from measureapp.simulate.optics import NO_RESIDUAL, OUTLINE_SAMPLES, ProjectorLight, SeeingCamera, image_box, lens_parameters

WHITE, BLACK = 0.85, 0.06  # albedo of the board's print


class PrintedBoard:
    """A board on a slightly bowed plate; its scene is the board frame. The printed pattern is averaged over the pixels already."""

    width_px = 0.0

    def __init__(self, board: BoardDescription, bow_mm: float, print_errors: PrintErrors | None = None) -> None:
        board = board.model_copy(update={"lengths": None})  # what users state about a board changes nothing of it
        self._board = board
        self._layout, self._cells = _print_layout(board)
        self._errors = print_errors
        margin = 2 * self._layout[1]
        right, bottom = board.flat_corners_mm[:, :2].max(axis=0)
        self._shift = NO_RESIDUAL if print_errors is None else print_errors.on_grid(right + 2 * margin, bottom + 2 * margin, -margin)
        middle = board.middle_mm[:2]
        self._bow = np.array([-bow_mm, *middle, float(np.linalg.norm(middle))])  # the printed side faces -z

    def corners_mm(self) -> FloatArray:
        """The true marks (N, 3) of the bowed board."""
        corners = self._board.corners_mm.copy()
        if self._errors is not None:
            corners[:, :2] += self._errors.at(corners[:, :2])
        height, x, y, radius = self._bow
        corners[:, 2] = height * (1.0 - ((corners[:, 0] - x) ** 2 + (corners[:, 1] - y) ** 2) / radius**2)
        return corners

    def sample_mm(self) -> FloatArray:
        """Some points of the board, (N, 3)."""
        return self.corners_mm()

    def illuminate(self, camera: SeeingCamera, scene_from_camera: RigidTransform, light: ProjectorLight, out: FloatArray) -> None:
        """Compute the light map ``out`` as `Surface.illuminate` does; the board casts no shadows."""
        out[:] = 0.0
        margin, (right, bottom) = 2 * self._layout[1], self._board.flat_corners_mm[:, :2].max(axis=0)
        x = np.linspace(-margin, right + margin, OUTLINE_SAMPLES)
        y = np.linspace(-margin, bottom + margin, OUTLINE_SAMPLES)
        outline = np.stack(np.meshgrid(x, y, [0.0]), axis=-1).reshape(-1, 3)
        box = image_box(camera.pinhole, scene_from_camera.inverse(), outline)
        if box is None or scene_from_camera.translation_mm[2] >= 0.0:
            return
        in_bands(
            light_board,
            box[0],
            box[1],
            box,
            *camera.parameters,
            np.array(scene_from_camera.matrix),
            light.position,
            light.from_scene,
            *lens_parameters(light.pinhole),
            light.standoff_mm,
            self._layout,
            self._cells,
            np.array([WHITE, BLACK]),
            self._shift,
            self._bow,
            out,
        )


def _print_layout(board: BoardDescription) -> tuple[FloatArray, ImageArray]:
    """Return layout and marker cells of the printed pattern for `light_board`."""
    none = np.zeros((1, 1, 1, 1), np.uint8)
    if isinstance(board, CirclesDescription):
        return _layout(board.diameter_mm, board.spacing_mm, board.columns, board.rows, 0.0), none
    if isinstance(board, CharucoDescription):
        cells = marker_cells(board.columns, board.rows, board.dictionary, board.legacy_pattern)
        return _layout(0.0, board.square_mm, board.columns, board.rows, board.marker_mm), cells
    assert isinstance(board, CheckerboardDescription)
    return _layout(0.0, board.square_mm, board.columns, board.rows, 0.0), none


def _layout(diameter_mm: float, unit_mm: float, columns: int, rows: int, marker_mm: float) -> FloatArray:
    """Layout as `board_kernel` has it; print errors begin at the margin."""
    return np.array([diameter_mm, unit_mm, columns, rows, marker_mm, -2.0 * unit_mm, -2.0 * unit_mm], float)
