"""Manual decisions to use or exclude views regardless of their quality, and to keep what lies around the part."""

from __future__ import annotations

from typing import Literal

from pydantic import model_validator

from measureapp.data.model import Model

ViewChoice = Literal["use", "refuse"]


class ViewChoices(Model):
    """Manual choices, stored with the project and applied when it is recomputed; all other views are accepted by their quality."""

    schema_version: Literal[1] = 1
    used: tuple[str, ...] = ()  # viewpoint ids, used regardless of quality and correction
    refused: tuple[str, ...] = ()  # never used
    keep_surroundings: bool = False  # whether points of table, fixtures and background stay in the clouds

    @model_validator(mode="after")
    def _are_distinct(self) -> ViewChoices:
        if both := set(self.used) & set(self.refused):
            raise ValueError(f"view {sorted(both)[0]!r} is both used and refused")
        return self

    def with_choice(self, viewpoint_id: str, choice: ViewChoice) -> ViewChoices:
        """Return these choices with another choice for one view.

        >>> ViewChoices(used=("a", "b")).with_choice("a", "refuse")
        ViewChoices(schema_version=1, used=('b',), refused=('a',), keep_surroundings=False)
        """
        used, refused = ({name for name in names if name != viewpoint_id} for names in (self.used, self.refused))
        (used if choice == "use" else refused).add(viewpoint_id)
        return self.model_copy(update={"used": tuple(sorted(used)), "refused": tuple(sorted(refused))})
