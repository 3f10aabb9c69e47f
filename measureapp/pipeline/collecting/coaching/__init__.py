"""What to show the cameras next, in words, as gauges and as an outline in the image."""

from measureapp.pipeline.collecting.coaching.advice import Advice, Gauge, Ghost
from measureapp.pipeline.collecting.coaching.coach import coach

__all__ = ["Advice", "Gauge", "Ghost", "coach"]
