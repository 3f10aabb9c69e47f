"""Points excluded from the clouds of a measurement because they are not of the part, in numbers and words."""

from __future__ import annotations

from dataclasses import dataclass

SURROUNDINGS = "surroundings"  # key of the settings of a measurement, under which the sentence is kept
SURROUNDINGS_KEPT = "Points of table, fixtures and background were kept, by choice."
PART_ELSEWHERE = "No points were found where the part should stand on the table: none were excluded as its surroundings."
ABOVE_TABLE_MM = 1.0  # excluded with the table
KINDS = {  # in the order in which points are looked at, with how each is told
    "background": "{share} background",
    "table": "{share} the table's top, and all within {above} mm above it",
    "fixtures": "{share} fixtures of the rig description",
    "far": "{share} others far from the nominal, such as clamps",
}


@dataclass(frozen=True, slots=True)
class Surroundings:
    """Numbers of points that were excluded, and of all points."""

    points: int = 0
    found: tuple[tuple[str, int], ...] = ()  # by the keys of `KINDS`
    nothing_of_part: bool = False  # all points would have been excluded, so that none were

    @property
    def sentence(self) -> str:
        """What was excluded, in words; empty where nothing was."""
        if self.nothing_of_part:
            return PART_ELSEWHERE
        told = [KINDS[kind].format(share=f"{count / self.points:.1%}", above=f"{ABOVE_TABLE_MM:g}") for kind, count in self.found if count]
        return f"Excluded as surroundings of the part, of all points: {'; '.join(told)}." if told else ""
