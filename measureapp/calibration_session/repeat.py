"""Repeating a session from its stored images: does its result follow from them?"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from measureapp.calibration_session.session import CalibrationSession
from measureapp.errors import StorageError
from measureapp.progress import PartOf, Progress


def repeat_session(session: CalibrationSession, inputs: Mapping[str, str], folder: Path, progress: Progress) -> CalibrationSession:
    """Repeat the detection and solution of a result from the stored images of its session.

    Parameters
    ----------
    inputs : "observation camera" -> checksum of each image the result was made from; other observations of the session are excluded
    folder : for the new session

    Raises
    ------
    StorageError, InputError
        An image is missing, or is not the one the result was made from.
    CalibrationError
        The observations do not determine the result.
    """
    kept = {f"{one.id} {camera}": image for one in session.observations for camera, image in one.images.items()}
    for name, digest in inputs.items():
        if name not in kept or kept[name].checksum != digest:
            state = "is missing" if name not in kept else "has changed"
            raise StorageError(
                f"The image {name!r} of session {session.folder}, from which the calibration was made, {state}.",
                "Restore it from a backup.",
            )
    again = CalibrationSession.create(folder, session.setup)
    count, entered = len(session.observations), {name.partition(" ")[0] for name in inputs}
    for number, one in enumerate(session.observations):
        progress.report(number, 2 * count, f"board in {one.id}")
        again.repeat(one)
        if one.id not in entered:
            again.remove(one.id)
    again.solve_with_parts(PartOf(progress, 0.5, 1.0), afresh=True)
    return again
