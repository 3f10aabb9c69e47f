"""Robot Web Services 2.0: verbs in the path, media types with a version."""

from __future__ import annotations

ACCEPTED = ("application/hal+json;v=2.0", "application/xhtml+xml;v=2.0")
FORM_TYPE = "application/x-www-form-urlencoded;v=2.0"
MASTERSHIP = {"edit": "rapid", "motion": "motion"}


def translate(method: str, path: str) -> tuple[str, str]:
    """Return path and action in the words of version 1.0."""
    parts = path.strip("/").split("/")
    if parts[:3] == ["rw", "panel", "ctrl-state"]:
        return "/rw/panel/ctrlstate", "setctrlstate" if method == "POST" else ""
    if parts[:3] == ["rw", "panel", "speedratio"]:
        return path, "setspeedratio" if method == "POST" else ""
    if parts[:2] == ["rw", "mastership"]:
        action = parts.pop() if parts[-1] in ("request", "release") else ""
        return "/".join([*parts[:2], *(MASTERSHIP.get(part, part) for part in parts[2:])]), action
    if parts[:3] == ["rw", "rapid", "execution"] or parts[:3] == ["rw", "rapid", "tasks"]:
        action = parts.pop() if parts[-1] in ("start", "stop", "resetpp", "activate", "deactivate") else ""
        return "/".join(parts), action
    if parts[:3] == ["rw", "rapid", "symbol"] and parts[-1] in ("data", "properties"):
        kind = parts.pop()
        return "/".join([*parts[:3], kind, *parts[3:]]), "set" if method == "POST" else ""
    return path, ""
