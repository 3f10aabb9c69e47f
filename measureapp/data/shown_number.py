"""Numbers as texts show them."""

from __future__ import annotations


def shown_number(value: float, digits: int = 3, *, signed: bool = False) -> str:
    """Return a number with fixed digits; zero has no sign, also where it is rounded.

    Only differences are ``signed``: a root mean square or another amount is never negative, so that its sign says nothing.

    >>> shown_number(-0.0004), shown_number(0.0004, signed=True), shown_number(-0.0126, 2, signed=True), shown_number(1.5, 1, signed=True)
    ('0.000', '0.000', '-0.01', '+1.5')
    """
    text = f"{value:+.{digits}f}" if signed else f"{value:.{digits}f}"
    return text.lstrip("+-") if float(text) == 0 else text
