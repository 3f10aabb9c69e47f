"""Which views somebody decided to use, or to leave out, whatever their figures say."""

from __future__ import annotations

from typing import Literal

from pydantic import model_validator

from measureapp.data.model import Model

ViewChoice = Literal["use", "refuse"]


class ViewChoices(Model):
    """Choices by hand, kept with the project so that computing again repeats them; every other view is judged by its figures."""

    schema_version: Literal[1] = 1
    used: tuple[str, ...] = ()  # viewpoint ids, used however poor the cloud and however far it has to move
    refused: tuple[str, ...] = ()  # never stitched

    @model_validator(mode="after")
    def _are_distinct(self) -> ViewChoices:
        if both := set(self.used) & set(self.refused):
            raise ValueError(f"view {sorted(both)[0]!r} is both used and refused")
        return self

    def with_choice(self, viewpoint_id: str, choice: ViewChoice) -> ViewChoices:
        """Return these choices with another one for a view.

        >>> ViewChoices(used=("a", "b")).with_choice("a", "refuse")
        ViewChoices(schema_version=1, used=('b',), refused=('a',))
        """
        used, refused = ({name for name in names if name != viewpoint_id} for names in (self.used, self.refused))
        (used if choice == "use" else refused).add(viewpoint_id)
        return ViewChoices(used=tuple(sorted(used)), refused=tuple(sorted(refused)))
