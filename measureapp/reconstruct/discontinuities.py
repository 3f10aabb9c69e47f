"""Exclusion of pixels at depth discontinuities.

At the edge of a surface a pixel also receives light from beyond it, or too little, so that its phase is that of a place further in: by several
micrometres, always to the same side, and by a tenth of a millimetre where a camera sees a wall so obliquely that two pixels cover millimetres of
it. No correction knows what is beyond (decision 15). The width of this edge follows the blur of the camera.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import cv2
import numpy as np

from measureapp.arrays import in_bands, read_only
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.phase import PhaseMap
from measureapp.data.point_state import PointState
from measureapp.reconstruct import kernels

MIN_WIDTH_PX = 2  # what the kernel marks
PX_PER_BLUR = 2.6  # beyond, the blur contributes less than a hundredth of the light across the edge
CROSS = cv2.getStructuringElement(cv2.MORPH_CROSS, (3, 3))


def exclude_discontinuities(
    phase_maps: Mapping[str, PhaseMap], cameras: CameraArrayCalibration, memory: BufferPool | None = None
) -> dict[str, PhaseMap]:
    """Exclude the pixels next to holes: their state becomes `PointState.RIM`, which is no `PixelState`.

    Two pixels wide up to a blur of 0.96 px, 2.6 times the blur beyond. The maps of cameras whose blur is unknown stay as they are.
    """
    memory = memory or BufferPool()
    return {
        name: _exclude(phase_map, _width_px(cameras.cameras[name].blur_px), memory)
        if name in cameras.cameras and cameras.cameras[name].blur_px > 0
        else phase_map
        for name, phase_map in phase_maps.items()
    }


def _width_px(blur_px: float) -> int:
    return max(MIN_WIDTH_PX, round(PX_PER_BLUR * blur_px))


def _exclude(phase_map: PhaseMap, width_px: int, memory: BufferPool) -> PhaseMap:
    state = read_only(phase_map.state, np.uint8)
    marked = memory.empty(state.shape, np.uint8)
    flat, out = state.reshape(-1), marked.reshape(-1)
    in_bands(lambda start, stop: kernels.mark_discontinuities(flat, *state.shape, start, stop, out), len(state))
    if width_px > MIN_WIDTH_PX:
        near = cv2.dilate(np.equal(marked, PointState.RIM).astype(np.uint8), CROSS, iterations=width_px - MIN_WIDTH_PX)
        marked[(near != 0) & (state == 0)] = PointState.RIM
    orthogonal = None if phase_map.orthogonal is None else _exclude(phase_map.orthogonal, width_px, memory)
    return replace(phase_map, state=read_only(marked), orthogonal=orthogonal)
