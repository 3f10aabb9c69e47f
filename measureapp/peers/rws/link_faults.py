"""Faults of the link between a client and the virtual controller."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

Request = tuple[str, str]  # method and path with query


def _never(_request: Request) -> bool:
    return False


def _at_once(_request: Request) -> float:
    return 0.0


def _unchanged(raw: bytes, _request: Request) -> bytes:
    return raw


@dataclass
class LinkFaults:
    """What goes wrong on the line; each may be changed while the server runs."""

    half_open: bool = False  # connections are accepted and never answered
    refuses: bool = False  # connections are closed at once, as by a controller that restarts
    delay_before_s: Callable[[Request], float] = field(default=_at_once)  # before the request is carried out
    delay_after_s: Callable[[Request], float] = field(default=_at_once)  # after it, before the answer
    drops_request: Callable[[Request], bool] = field(default=_never)  # the connection breaks before anything is done
    drops_answer: Callable[[Request], bool] = field(default=_never)  # the connection breaks after the request was carried out
    changed: Callable[[bytes, Request], bytes] = field(default=_unchanged)  # the whole answer, header included
    slice_s: float | None = None  # pause between single bytes of an answer
    calls_per_connection: int | None = None  # a kept-alive connection is dropped after so many
