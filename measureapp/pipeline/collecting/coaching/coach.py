"""The coach: advice for a collection of any kind."""

from __future__ import annotations

from measureapp.errors import CalibrationError
from measureapp.pipeline.collecting.axis_solving import board_places
from measureapp.pipeline.collecting.coaching.advice import Advice, Ghost, Notes
from measureapp.pipeline.collecting.coaching.axes import advise_axis, advise_guide, ghost_for_axis, ghost_for_guide
from measureapp.pipeline.collecting.coaching.cameras import advise_cameras, ghost_for_cameras
from measureapp.pipeline.collecting.coaching.turns import advise_turns, ghost_for_turns
from measureapp.pipeline.collecting.collection import Collection


def coach(collection: Collection) -> Advice:
    """Say what is still missing, and where the board should be shown next.

    Cheap enough to be asked after every observation; better once `Collection.solve` has been called, since lenses and axes are
    known then.
    """
    notes = Notes()
    kind = collection.setup.kind
    try:
        if collection.setup.cameras is not None and collection.counted:
            board_places(collection.counted, collection.setup.cameras, collection.setup.board)
        if collection.setup.lenses:
            advise_cameras(collection, notes)
        if kind in ("hand-eye", "rig") and (kind != "rig" or _cameras_known(collection)):
            advise_turns(collection, notes)
        if kind in ("axis", "rig"):
            advise_axis(collection, notes)
        if kind in ("guide", "rig"):
            advise_guide(collection, notes)
        ghost = _ghost(collection)
    except CalibrationError as error:  # images that contradict each other: that comes before all else
        return Advice((str(error),), tuple(notes.gauges))
    return Advice(notes.sentences(collection.setup.lenses), tuple(notes.gauges), ghost)


def _cameras_known(collection: Collection) -> bool:
    return collection.setup.cameras is not None or collection.solved is not None


def _ghost(collection: Collection) -> Ghost | None:
    kind = collection.setup.kind
    if kind == "axis":
        return ghost_for_axis(collection)
    if kind == "guide":
        return ghost_for_guide(collection)
    if kind == "hand-eye" or (kind == "rig" and _cameras_known(collection)):
        return ghost_for_turns(collection)
    return ghost_for_cameras(collection)
