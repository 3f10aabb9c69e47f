"""What can go wrong during set-up, in words."""

from __future__ import annotations


class SetupTrouble(Exception):
    """The set-up cannot go on; ``remedy`` is what the user can do."""

    def __init__(self, message: str, remedy: str) -> None:
        super().__init__(message)
        self.message = message
        self.remedy = remedy
