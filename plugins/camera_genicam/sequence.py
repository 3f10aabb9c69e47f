"""Numbers of images, counted from the identifiers that the camera gives its images."""

from __future__ import annotations

from contextlib import suppress

from measureapp.errors import SequenceError

WRAP = 65535  # identifiers of GigE Vision 1.x run from 1 to 65535, then begin again
STALE = 0x8000  # a distance this large is a step back
UNKNOWN = 0  # identifier of an image whose first packet was lost


class FrameNumbers:
    """Counts the images of one sequence after another.

    Some cameras begin again with each sequence, others count on; both are recognised from the second sequence on.
    """

    def __init__(self) -> None:
        self._first: int | None = None  # identifier with which the first sequence began
        self._expected: tuple[int, ...] = ()  # identifiers of which one comes next; none: any may come
        self._number = -1

    def begin(self, triggers: int) -> None:
        """Begin a sequence: its first image has number 0.

        Parameters
        ----------
        triggers : of the sequence before. If it lacks images, the camera may have counted those that never came: any identifier may be next
        """
        if self._number + 1 != triggers:
            self._expected = ()
        elif self._first is not None:
            self._expected += (self._first,)
        self._number = -1

    def number(self, identifier: int, triggers: int) -> int:
        """Return the number of an image; images lost before it count.

        Raises
        ------
        SequenceError
            The image was delivered before, or no trigger belongs to it; the count stays as it was.
        """
        missing = min((distance(one, identifier) for one in self._expected), default=0)
        if missing >= STALE:
            raise SequenceError(f"An image with identifier {identifier} arrived twice or late.", "Take the whole sequence again.")
        number = self._number + 1 + missing
        if number >= triggers:
            raise SequenceError(f"Image {number + 1} arrived after {triggers} triggers.", "Take the whole sequence again.")
        self._first = identifier - number if self._first is None else self._first
        self._expected, self._number = (identifier + 1,), number
        return number

    def damaged(self, identifier: int, triggers: int) -> None:
        """Count an image that arrived damaged; its identifier may be unknown."""
        if identifier == UNKNOWN:
            self._number += 1
            self._expected = tuple(one + 1 for one in self._expected)
        else:
            with suppress(SequenceError):
                self.number(identifier, triggers)


def distance(expected: int, identifier: int) -> int:
    """Return how many images lie between the one expected and this one, over a wrap of 16-bit identifiers."""
    ahead = identifier - expected
    return ahead if ahead >= 0 else max(0, ahead + WRAP)
