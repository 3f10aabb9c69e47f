"""Checking calibrated cameras, or a projector, with views held back: is what they state about themselves true?"""

from __future__ import annotations

from measureapp.calibrate.cameras.projector import HeadSolution
from measureapp.calibrate.cameras.validation import CrossValidation, cross_validate
from measureapp.errors import CalibrationError
from measureapp.pipeline.collecting.collection import Collection
from measureapp.pipeline.collecting.solving import camera_problem
from measureapp.progress import Progress


def check_held_back(collection: Collection, progress: Progress | None = None) -> CrossValidation | None:
    """Check what the last solution calibrated with views held back, which takes some seconds; None where that is neither cameras nor a projector.

    Raises
    ------
    CalibrationError
        Nothing was solved yet, or there are too few views to hold some back.
    """
    solved = collection.solved
    if solved is None:
        raise CalibrationError("There is no solution yet.", "Solve what was collected first.")
    cameras, head = solved.camera_solution, solved.solution
    if isinstance(head, HeadSolution):
        return cross_validate(head.problem, head.solution, progress=progress)
    if cameras is None:
        return None
    sizes = {name: (camera.pinhole.width_px, camera.pinhole.height_px) for name, camera in cameras.calibration.cameras.items()}
    entered = [one for one in collection.observations if one.id in solved.of]
    return cross_validate(camera_problem(collection.setup, entered, sizes), cameras, progress=progress)
