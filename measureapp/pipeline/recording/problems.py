"""Gathering of the problems of a recording, so that one message names all of them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from measureapp.errors import InputError, MeasureError
from measureapp.project.calibration.recording_file import MOST_NAMED


def list_places(places: Sequence[str]) -> str:
    """Return the first of places with the same problem, and the number of the others."""
    return places[0] + (f" and {len(places) - 1} more" if len(places) > 1 else "")


class Problems:
    """Problems found so far."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._found: list[MeasureError] = []

    def __bool__(self) -> bool:
        """Whether there are any."""
        return bool(self._found)

    def note(self, message: str, hint: str) -> None:
        """Remember a problem that is a sentence without the name of the file."""
        self._found.append(InputError(f"{self._path}: {message}", hint))

    @contextmanager
    def gathered(self) -> Iterator[None]:
        """Remember the error that ends the body, if one does."""
        try:
            yield
        except MeasureError as error:
            self._found.append(error)

    def raise_all(self) -> None:
        """Raise the problems as one InputError; a single one as it is."""
        if len(self._found) == 1:
            raise self._found[0]
        if self._found:
            shown = [error.message.replace(f"{self._path}: ", "") for error in self._found[:MOST_NAMED]]
            more = len(self._found) - MOST_NAMED
            hints = list(dict.fromkeys(error.hint for error in self._found[:MOST_NAMED]))
            raise InputError(
                f"{self._path} has {len(self._found)} problems. {' '.join(shown)}" + (f" There are {more} more." if more > 0 else ""),
                " ".join(hints),
            )
