"""The two versions of Robot Web Services: paths, headers and envelopes. Nothing else of the driver knows which one is spoken."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any
from urllib.parse import quote

Row = Mapping[str, Any]

FIRST = {
    "system": "/rw/system",
    "ctrlstate": "/rw/panel/ctrlstate",
    "set ctrlstate": "/rw/panel/ctrlstate?action=setctrlstate",
    "opmode": "/rw/panel/opmode",
    "speedratio": "/rw/panel/speedratio",
    "mastership": "/rw/mastership/rapid",
    "request mastership": "/rw/mastership/rapid?action=request",
    "release mastership": "/rw/mastership/rapid?action=release",
    "execution": "/rw/rapid/execution",
    "start": "/rw/rapid/execution?action=start",
    "stop": "/rw/rapid/execution?action=stop",
    "resetpp": "/rw/rapid/execution?action=resetpp",
    "symbol": "/rw/rapid/symbol/data/RAPID/{task}/{module}/{name}",
    "set symbol": "/rw/rapid/symbol/data/RAPID/{task}/{module}/{name}?action=set",
    "joints": "/rw/motionsystem/mechunits/{unit}/jointtarget",
    "pose": "/rw/motionsystem/mechunits/{unit}/robtarget?tool=tool0&wobj=wobj0&coordinate=Base",
    "log": "/rw/elog/0?lang=en&order=lifo",
    "logout": "/logout",
}
SECOND = {
    **FIRST,
    "ctrlstate": "/rw/panel/ctrl-state",
    "set ctrlstate": "/rw/panel/ctrl-state",
    "mastership": "/rw/mastership/edit",
    "request mastership": "/rw/mastership/edit/request",
    "release mastership": "/rw/mastership/edit/release",
    "start": "/rw/rapid/execution/start",
    "stop": "/rw/rapid/execution/stop",
    "resetpp": "/rw/rapid/execution/resetpp",
    "symbol": "/rw/rapid/symbol/RAPID/{task}/{module}/{name}/data",
    "set symbol": "/rw/rapid/symbol/RAPID/{task}/{module}/{name}/data",
}


@dataclass(frozen=True)
class Dialect:
    """One version of Robot Web Services."""

    version: str
    paths: Mapping[str, str]
    headers: Mapping[str, str]
    form_headers: Mapping[str, str]
    digest: bool  # authentication by digest, otherwise basic
    json_in_query: bool

    def path(self, what: str, names: Mapping[str, str]) -> str:
        """Return path and query of the resource ``what``."""
        path = self.paths[what].format(**{key: quote(value, safe="") for key, value in names.items()})
        if not self.json_in_query:
            return path
        return f"{path}{'&' if '?' in path else '?'}json=1"


VERSIONS = {
    "1.0": Dialect("1.0", FIRST, {"Accept": "application/json"}, {}, digest=True, json_in_query=True),
    "2.0": Dialect(
        "2.0",
        SECOND,
        {"Accept": "application/hal+json;v=2.0"},
        {"Content-Type": "application/x-www-form-urlencoded;v=2.0"},
        digest=False,
        json_in_query=False,
    ),
}


def states(document: Any) -> list[Row]:
    """Return the states of an answer in either envelope.

    Raises
    ------
    ValueError
        It is no such envelope.
    """
    if not isinstance(document, dict):
        raise ValueError("no JSON object")
    embedded = document.get("_embedded")
    found = embedded if isinstance(embedded, dict) else {}
    rows = next((part for part in (found.get("_state"), document.get("state"), found.get("resources")) if isinstance(part, list)), None)
    if rows is None or not all(isinstance(row, dict) for row in rows):
        raise ValueError("no list of states")
    return rows


def refusal(document: Any) -> tuple[int, str]:
    """Return code and message of an error in either envelope; 0 and nothing where it has none."""
    outer = document if isinstance(document, dict) else {}
    embedded = outer.get("_embedded")
    status = (embedded if isinstance(embedded, dict) else outer).get("status")
    if not isinstance(status, dict):
        return 0, ""
    try:
        return int(status.get("code", 0)), str(status.get("msg", ""))
    except (TypeError, ValueError):
        return 0, str(status.get("msg", ""))
