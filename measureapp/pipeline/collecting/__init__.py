"""Collecting observations of a board for one calibration: what a wizard and the command line share.

It stands here and not in `calibrate/` because it keeps images and observations in a folder (`project/`) and solves a whole rig in the
order of the stages, which only the pipeline knows. Nothing in it knows a window or a device: images and read-backs come in,
advice, solutions and verdicts go out.
"""

from measureapp.pipeline.collecting.coaching import Advice, Gauge, Ghost, coach
from measureapp.pipeline.collecting.collection import Collection
from measureapp.pipeline.collecting.observation import Observation, Readback, Refusal, StoredImage
from measureapp.pipeline.collecting.setup import KINDS, Kind, Setup
from measureapp.pipeline.collecting.solved import Solved

__all__ = [
    "KINDS",
    "Advice",
    "Collection",
    "Gauge",
    "Ghost",
    "Kind",
    "Observation",
    "Readback",
    "Refusal",
    "Setup",
    "Solved",
    "StoredImage",
    "coach",
]
