"""Formatting of numbers with unit and reasonable digits, and of labels."""

from __future__ import annotations

import math
from datetime import datetime
from pathlib import PurePath

from measureapp.data.shown_name import shown_name
from measureapp.language.translator import full_stop
from ui.look.language.words import tr, translated

NOTHING = "–"
THIN = "\u2009"
MINUS = "\u2212"
SENTENCE_ENDS = ".!?…。！？"
POINT_REASONS = {  # why a pixel has no point, by the names that documents use
    "point": "Point measured",
    "seen by another": "Measured by another camera",
    "flying": "Flying point",
    "grazing": "Grazing incidence",
    "partner grazing": "Oblique to another camera",
    "grazing for a partner": "Oblique to another camera",
    "island": "Isolated patch",
    "rim": "Depth discontinuity",
    "at a rim": "Depth discontinuity",
}


def _number(value: float, digits: int, signed: bool) -> str:
    text = f"{abs(value):.{digits}f}"
    if float(text) == 0:
        return text
    return (MINUS if value < 0 else "+" if signed else "") + text


def quantity(value: float | None, unit: str, digits: int = 3, *, signed: bool = False) -> str:
    """Format ``value`` with its unit; a dash if there is no value."""
    if value is None or not math.isfinite(value):
        return NOTHING
    gap = "" if unit in {"", "°", "″"} else "\u00a0"
    return f"{_number(value, digits, signed)}{gap}{unit}"


def millimetres(value: float | None, digits: int = 3, *, signed: bool = False) -> str:
    """Format a length: ``0.012 mm``."""
    return quantity(value, "mm", digits, signed=signed)


def with_unit(words: str, unit: str) -> str:
    """Name a quantity with its unit, as axes do: ``Deviation [mm]``."""
    return tr("{words} [{unit}]", words=words, unit=unit) if unit else translated(words)


def percent(value: float | None, digits: int = 1, *, signed: bool = False) -> str:
    """Format a fraction in per cent."""
    return NOTHING if value is None else quantity(100.0 * value, "%", digits, signed=signed)


def keep_units(words: str) -> str:
    """Return ``words`` in the language of the window, with non-breaking spaces between numbers and their units, so that no line ends between them.

    >>> keep_units("adds 0.006 mm to 300 mm") == "adds 0.006\u00a0mm to 300\u00a0mm"
    True
    """
    return tr("{words:kept}", words=words)  # a template, so that the text follows a later change of language


def counted(value: int) -> str:
    """Format a count with thousands separators."""
    return f"{value:,}".replace(",", "\u00a0" if value < 10_000 else THIN)


def several(value: int, one: str, many: str = "") -> str:
    """Format a count with its noun: ``1 view`` or ``8 views``."""
    return tr("{count} {noun}", count=counted(value), noun=one if value == 1 else many or one + "s")


def with_hint(text: str, hint: str) -> str:
    """Return a message with its hint; both follow the language, which a text that was merely joined would not do."""
    return tr("{text} {hint}", text=translated(text), hint=translated(hint)) if text and hint else translated(text or hint)


def duration(seconds: float) -> str:
    """Format a duration: ``45 s``, ``2 min 10 s``, ``1 h 05 min``."""
    whole = max(0, round(seconds))
    if whole < 60:
        return f"{whole} s"
    if whole < 3600:
        return f"{whole // 60} min {whole % 60:02d} s"
    return f"{whole // 3600} h {whole % 3600 // 60:02d} min"


def rough_duration(seconds: float) -> str:
    r"""Format an estimated duration without digits that nobody knows: ``20 s``, ``4 min``, ``1 h 10 min``.

    >>> rough_duration(17.0), rough_duration(200.0), rough_duration(4100.0)
    ('20\xa0s', '4\xa0min', '1\xa0h 10\xa0min')
    """
    if seconds <= 60:
        return f"{max(10, 10 * math.ceil(seconds / 10))}\u00a0s"
    minutes = math.ceil(seconds / 60)
    if minutes < 60:
        return f"{minutes}\u00a0min"
    hours, rest = divmod(10 * math.ceil(minutes / 10), 60)
    return f"{hours}\u00a0h" + (f" {rest}\u00a0min" if rest else "")


def exposure(microseconds: int) -> str:
    """Format an exposure time: ``80 ms``."""
    return f"{microseconds / 1000:g}\u00a0ms" if microseconds >= 1000 else f"{microseconds}\u00a0µs"


def storage(size_bytes: float) -> str:
    """Format a file size: ``12.4 GB``."""
    for unit in ("B", "kB", "MB", "GB"):
        if size_bytes < 1000:
            return quantity(size_bytes, unit, 0 if unit in {"B", "kB"} or size_bytes >= 100 else 1)
        size_bytes /= 1000
    return quantity(size_bytes, "TB", 1)


def when(iso: str, now: datetime | None = None) -> str:
    """Format how long ago an ISO 8601 time was; empty for an invalid time."""
    try:
        then = datetime.fromisoformat(iso)
    except ValueError:
        return ""
    seconds = ((now or datetime.now(then.tzinfo)) - then).total_seconds()
    if seconds < 90:
        return tr("just now")
    if seconds < 5400:
        return tr("{minutes} min ago", minutes=round(seconds / 60))
    if seconds < 129_600:
        return tr("{hours} h ago", hours=round(seconds / 3600))
    return tr("{days} days ago", days=round(seconds / 86_400))


def sentence(text: str) -> str:
    """Return ``text`` as a sentence, with a capital letter and the full stop of its script."""
    text = text.strip()
    if not text:
        return ""
    return text[0].upper() + text[1:] + ("" if text[-1] in SENTENCE_ENDS else full_stop(text))


def part_words(part: str) -> str:
    """Return the display name of a part: the name of a sample, or of a mesh file without folder and extension."""
    return translated(sentence_case(PurePath(part).stem))


def sentence_case(text: str) -> str:
    """Return a label with a capital first letter, underscores as spaces."""
    return shown_name(text)


def dimension_words(name: str) -> str:
    """Return the name of a dimension as words; single letters are unchanged."""
    return name if len(name) == 1 else sentence_case(name)


def point_reason(name: str) -> str:
    """Format the reason why a pixel has no point."""
    return translated(POINT_REASONS.get(name) or sentence_case(name))
