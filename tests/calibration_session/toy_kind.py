"""A toy kind of calibration, as a newcomer would add one: the distance of the board, as if that were worth calibrating."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.calibrate.draft.comparison import Comparison, changes_between
from measureapp.calibrate.draft.draft import Effect, Kind, Known, Limits, Solved, Words
from measureapp.calibrate.draft.estimate import Estimate
from measureapp.calibrate.draft.locate import locate_board
from measureapp.calibrate.kinds import table
from measureapp.calibrate.kinds.fit import solved_axes
from measureapp.calibration_session import accepting


@dataclass(frozen=True)
class Standoff:
    distance_mm: float
    sigma_mm: float
    warnings: tuple[str, ...] = ()


class StandoffKind(Kind):
    name = "standoff"
    words = Words(
        "the standoff", "Calibrate the standoff", "Standoff", "Distance of the board", "Determines a distance.", "Show it", ("Once.",)
    )
    limits = Limits(0.05, 0.2, "a toy needs no more")
    file = "standoff.json"

    def solve(self, draft, progress):
        seen = locate_board(draft)
        away = np.array([one.pose.camera_from_board.apply(draft.setup.board.middle_mm)[2] for one in seen.observations])
        predicted = {one.id: one.pose.camera_from_board for one in seen.observations}
        return solved_axes(draft, seen, Standoff(float(away.mean()), float(away.std() / np.sqrt(len(away)))), predicted, {})

    def shortfalls(self, draft):
        return () if len(draft.observations) > 1 else ("One more view is needed.",)

    def advise(self, draft, notes):
        for sentence in self.shortfalls(draft):
            notes.wish(sentence)

    def result(self, solved: Solved):
        return solved.solution

    def estimates(self, result):
        return [Estimate("standoff", result.distance_mm, result.sigma_mm, "mm", "Standoff", "Distance")]

    def effect(self, draft, solved):
        return Effect(2 * solved.solution.sigma_mm, f"Places the board to {2 * solved.solution.sigma_mm:.3f} mm")

    def previous(self, known: Known):
        return None

    def compare(self, previous, draft, solved):
        changes = tuple(changes_between(self.estimates(previous), self.estimates(solved.solution)))
        return Comparison(changes, abs(changes[0].difference), 2 * changes[0].sigma, "the board")

    def method(self, result):
        return "mean"

    def merge(self, draft, solved, known: Known):
        return known


def register(monkeypatch) -> Kind:
    """Do what adding it takes besides its own file: a line in the table of kinds, and one in the table of stored results."""
    kind = StandoffKind()
    monkeypatch.setattr(table, "KINDS", {**table.KINDS, kind.name: kind})
    monkeypatch.setattr(accepting, "LINKS", {**accepting.LINKS, "standoff": (Standoff, lambda document: Standoff(**document))})
    return kind
