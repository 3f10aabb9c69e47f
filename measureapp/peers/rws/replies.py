"""Answers of the virtual controller and their envelopes: JSON and XHTML of both versions of Robot Web Services."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from html import escape
from typing import Any

NOT_MASTER = -1073414146
HELD_BY_OTHER = -1073414143
WRONG_STATE = -1073442803
BAD_FORM = -1073442809
NOT_FOUND = -1073442811


@dataclass(frozen=True)
class Answer:
    """One answer before it is wrapped: a list of states, or an error."""

    status: int = 200
    states: tuple[Mapping[str, Any], ...] = ()
    code: int = 0
    message: str = ""
    headers: Mapping[str, str] = field(default_factory=dict)


def state(kind: str, title: str, /, **values: object) -> dict[str, Any]:
    """Return one state; all values are strings, as on a controller."""
    return {"_type": kind, "_title": title, **{name: str(value) for name, value in values.items()}}


def refusal(status: int, code: int, message: str) -> Answer:
    """Return an error."""
    return Answer(status, code=code, message=message)


def json_body(answer: Answer, base: str, second_version: bool) -> bytes:
    """Wrap an answer as JSON."""
    links = {"base": {"href": base}}
    if answer.message:
        status = {"code": answer.code, "msg": answer.message}
        body: dict[str, Any] = {"status": status} if second_version else {"_embedded": {"status": status}}
    elif second_version:
        body = {"status": {"code": 294912}, "state": list(answer.states)}
    else:
        body = {"_embedded": {"_state": list(answer.states)}}
    return json.dumps({"_links": links, **body}).encode()


def xhtml_body(answer: Answer, base: str) -> bytes:
    """Wrap an answer as XHTML."""
    if answer.message:
        inner = f'<div class="status"><span class="code">{answer.code}</span><span class="msg">{escape(answer.message)}</span></div>'
    else:
        inner = f'<div class="state"><a href="" rel="self"/><ul>{"".join(map(_item, answer.states))}</ul></div>'
    head = f'<head><title>rws</title><base href="{escape(base)}/"/></head>'
    page = f'<html xmlns="http://www.w3.org/1999/xhtml">{head}<body>{inner}</body></html>'
    return f'<?xml version="1.0" encoding="UTF-8"?>{page}'.encode()


def _item(values: Mapping[str, Any]) -> str:
    spans = "".join(
        f'<span class="{escape(name)}">{escape(str(value))}</span>' for name, value in values.items() if not name.startswith("_")
    )
    return f'<li class="{escape(values["_type"])}" title="{escape(values["_title"])}">{spans}</li>'
