"""An observation as the pages of a wizard show it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtGui import QImage

from ui.controllers.collecting_nouns import CollectedView, ViewVerdict
from ui.look.wording import with_hint

if TYPE_CHECKING:
    from measureapp.calibrate.draft.draft import Solved
    from measureapp.calibration_session.observation import CollectedObservation

VERDICTS: Mapping[str, ViewVerdict] = {
    "new": "not proven",
    "used": "pass",
    "rejected": "fail",
    "removed": "not measured",
    "no board": "fail",
}


def describe_view(observation: CollectedObservation, solved: Solved | None, pictures: Mapping[str, QImage]) -> CollectedView:
    """Return one observation with its status in the last solution."""
    left_out = {} if solved is None else _rejected_corners(observation, solved)
    return CollectedView(
        id=observation.id,
        name=name_of(observation),
        pictures=pictures,
        corners_px={camera: np.asarray(found.corners_px) for camera, found in observation.seen.items()},
        rejected_px=left_out,
        residuals_px=observation.residuals_px,
        verdict=VERDICTS[observation.status],
        reason=observation.reason,
        reasons={camera: with_hint(refusal.message, refusal.hint) for camera, refusal in observation.refused.items()},
        residual_mm=observation.residual_mm,
        removed=observation.status == "removed",
    )


def name_of(observation: CollectedObservation) -> str:
    """Return the name of a view: that of its first image, or its number."""
    return next((image.name for image in observation.images.values() if image.name), observation.id)


def _rejected_corners(observation: CollectedObservation, solved: Solved) -> dict[str, np.ndarray]:
    if solved.camera_solution is None:
        return {}
    chosen: dict[str, list[int]] = {}
    for one in solved.camera_solution.rejected_corners:
        if one.view == observation.id and one.camera in observation.seen:
            chosen.setdefault(one.camera, []).append(one.corner)
    return {
        camera: np.asarray(found.corners_px)[np.isin(found.ids, chosen[camera])]
        for camera, found in observation.seen.items()
        if camera in chosen
    }
