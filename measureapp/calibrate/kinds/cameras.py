"""The cameras: lens and pose of each, from views of a board anywhere in front of them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from typing_extensions import override

from measureapp.calibrate.cameras.shortfalls import shortfalls
from measureapp.calibrate.cameras.validation import CrossValidation
from measureapp.calibrate.draft.advice import Ghost, Notes
from measureapp.calibrate.draft.comparison import Comparison
from measureapp.calibrate.draft.draft import Draft, Effect, Kind, Known, Limits, Setup, Solved, Words
from measureapp.calibrate.draft.estimate import Estimate, camera_estimates
from measureapp.calibrate.guidance.lenses import advise_lenses, ghost_for_lenses
from measureapp.calibrate.kinds.lenses import (
    compare_cameras,
    cross_validate_cameras,
    effect_of_cameras,
    lens_problem,
    mark_warnings,
    solve_cameras,
)
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.errors import InputError
from measureapp.progress import Progress

GOOD_VIEWS = (
    "Cover the images to their borders and corners: lens distortion is largest there.",
    "Tilt the board by 20° to 45° to all four sides: this separates the focal length from the distance.",
    "Show it nearer and farther, sharp, evenly lit and not so bright that its white is clipped.",
)
REST_STAYS = "Hand–eye, guide and table axis were determined with the earlier cameras: calibrate the rig next."
PROJECTOR_STAYS = "The projector was calibrated with the earlier cameras: calibrate it again."


class Cameras(Kind):
    """Lenses and poses of one to several cameras by bundle adjustment."""

    name = "cameras"
    words = Words(
        subject="several cameras",
        title="Calibrate the cameras",
        action="Cameras",
        tip="Focal length, image centre, distortion and pose of every camera",
        purpose="Determines lens and pose of every camera from images of a board seen from many sides. "
        "Fill the images to their borders, and tilt the board.",
        step="Show the board",
        hints=GOOD_VIEWS,
    )
    limits = Limits(0.02, 0.05, "of a measurement uncertainty of 0.05 mm, 0.02 mm is hardly noticeable and 0.05 mm is all of it")
    needs = ""
    file = "cameras.json"

    @override
    def lenses(self, setup: Setup) -> tuple[str, ...]:
        return setup.camera_names

    @override
    def check(self, setup: Setup) -> None:
        if setup.cameras is not None:
            raise InputError("The cameras are what is to be calibrated.", "Start without calibrated cameras; compare with them later.")

    @override
    def solve(self, draft: Draft, progress: Progress) -> Solved:
        return solve_cameras(draft, progress)

    @override
    def shortfalls(self, draft: Draft) -> tuple[str, ...]:
        return shortfalls(lens_problem(draft, draft.setup.lenses))

    @override
    def advise(self, draft: Draft, notes: Notes) -> Ghost | None:
        advise_lenses(draft, notes)
        return ghost_for_lenses(draft)

    @override
    def result(self, solved: Solved) -> CameraArrayCalibration:
        return solved.cameras

    @override
    def estimates(self, result: CameraArrayCalibration) -> Sequence[Estimate]:
        return camera_estimates(result)

    @override
    def effect(self, draft: Draft, solved: Solved) -> Effect:
        return effect_of_cameras(draft, solved.solution)

    @override
    def previous(self, known: Known) -> CameraArrayCalibration | None:
        return known.cameras

    @override
    def compare(self, previous: Any, draft: Draft, solved: Solved) -> Comparison | None:
        return compare_cameras(previous, draft, solved.solution) if isinstance(previous, CameraArrayCalibration) else None

    @override
    def outdates(self, known: Known) -> Sequence[str]:
        return (*([REST_STAYS] if known.rig is not None else ()), *outdated_projector(known))

    @override
    def merge(self, draft: Draft, solved: Solved, known: Known) -> Known:
        return with_cameras(known, solved.cameras)

    @override
    def cross_validate(self, draft: Draft, solved: Solved, progress: Progress | None) -> CrossValidation | None:
        return cross_validate_cameras(draft, solved, progress)

    @override
    def warnings(self, solved: Solved) -> Sequence[str]:
        return mark_warnings(solved.camera_solution)


def outdated_projector(known: Known) -> Sequence[str]:
    """Return that the projector has to be calibrated again, where it was calibrated with the earlier cameras."""
    return [PROJECTOR_STAYS] if known.cameras is not None and known.cameras.projector is not None else []


def with_cameras(known: Known, cameras: CameraArrayCalibration) -> Known:
    """Replace the calibrated cameras; a rig of other cameras keeps its own."""
    rig = known.rig
    same = rig is not None and set(rig.cameras.cameras) == set(cameras.cameras)
    return Known(cameras, replace(rig, cameras=cameras) if rig is not None and same else None)
