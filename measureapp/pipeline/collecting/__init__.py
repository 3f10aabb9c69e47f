"""Collecting observations of a board for one calibration: what a wizard and the command line share.

It stands here and not in `calibrate/` because it keeps images and observations in a folder (`project/`) and solves a whole rig in the
order of the stages, which only the pipeline knows. Nothing in it knows a window or a device: images and read-backs come in,
advice, solutions and verdicts go out.
"""

from measureapp.pipeline.collecting.coaching import Advice, Gauge, Ghost, coach
from measureapp.pipeline.collecting.collection import Collection
from measureapp.pipeline.collecting.comparison import Change, Comparison, compare, compare_axes
from measureapp.pipeline.collecting.estimates import Estimate, estimates_of, result_of
from measureapp.pipeline.collecting.held_back import check_held_back
from measureapp.pipeline.collecting.keeping import accept, keep, read_result
from measureapp.pipeline.collecting.observation import Observation, Readback, Refusal, StoredImage
from measureapp.pipeline.collecting.recorded import ReadbackFiles, add_fringes, add_recorded, add_views
from measureapp.pipeline.collecting.repeating import repeated
from measureapp.pipeline.collecting.setup import KINDS, Kind, Setup
from measureapp.pipeline.collecting.solved import Solved
from measureapp.pipeline.collecting.verdict import LIMITS, Limits, Verdict, judge

__all__ = [
    "KINDS",
    "LIMITS",
    "Advice",
    "Change",
    "Collection",
    "Comparison",
    "Estimate",
    "Gauge",
    "Ghost",
    "Kind",
    "Limits",
    "Observation",
    "Readback",
    "ReadbackFiles",
    "Refusal",
    "Setup",
    "Solved",
    "StoredImage",
    "Verdict",
    "accept",
    "add_fringes",
    "add_recorded",
    "add_views",
    "check_held_back",
    "coach",
    "compare",
    "compare_axes",
    "estimates_of",
    "judge",
    "keep",
    "read_result",
    "repeated",
    "result_of",
]
