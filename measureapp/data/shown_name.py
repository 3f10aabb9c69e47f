"""Names of entries as tables and reports show them."""

from __future__ import annotations


def shown_name(name: str) -> str:
    """Return a name with a capital first letter, underscores as spaces; entries that are shown alike cannot be told apart.

    >>> shown_name("hub_diameter"), shown_name("Hub diameter ")
    ('Hub diameter', 'Hub diameter')
    """
    text = name.replace("_", " ").strip()
    return text[:1].upper() + text[1:]
