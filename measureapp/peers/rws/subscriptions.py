"""Subscriptions of the virtual controller: resources that are watched, and their events on a websocket (RFC 6455)."""

from __future__ import annotations

import base64
import hashlib
import re
import socket
import struct
import threading
from collections.abc import Mapping
from dataclasses import dataclass, field
from html import escape

from measureapp.peers.rws.machine import Machine
from measureapp.peers.rws.symbols import write

GUID = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11"
PROTOCOL = "robapi2_subscription"
WATCH_S = 0.02
SYMBOL = re.compile(r"/rw/rapid/symbol/data/RAPID/(T_ROB1/(?:\w+/)?(\w+));value")
TEXT, CLOSE = 0x1, 0x8


@dataclass
class Subscriptions:
    """All subscriptions, by number."""

    watched: dict[int, tuple[str, ...]] = field(default_factory=dict)
    made: int = 0

    def add(self, form: Mapping[str, str]) -> int | None:
        """Subscribe to the resources of a form; None if one of them cannot be watched."""
        resources = tuple(value for name, value in form.items() if name.isdecimal())
        if not resources or not all(_is_known(resource) for resource in resources):
            return None
        self.made += 1
        self.watched[self.made] = resources
        return self.made


def page(url: str) -> bytes:
    """Return the body of the answer to a new subscription: XHTML even where JSON was requested."""
    link = f'<a href="{url}" rel="self"></a>'
    return f'<?xml version="1.0" encoding="UTF-8"?><html xmlns="http://www.w3.org/1999/xhtml"><body>{link}</body></html>'.encode()


def accept_key(key: str) -> str:
    """Return the answer to the key of a websocket handshake."""
    return base64.b64encode(hashlib.sha1((key + GUID).encode(), usedforsecurity=False).digest()).decode()


def send_events(connection: socket.socket, machine: Machine, resources: tuple[str, ...], closing: threading.Event) -> None:
    """Send an event for every change, until the client leaves or the controller is closed."""
    connection.settimeout(WATCH_S)
    before = {resource: _value(machine, resource) for resource in resources}
    while not closing.is_set():
        for resource in resources:
            value = _value(machine, resource)
            if value != before[resource]:
                before[resource] = value
                connection.sendall(_frame(TEXT, _event(resource, value)))
        try:
            received = connection.recv(4096)
        except TimeoutError:
            continue
        if not received or received[0] & 0x0F == CLOSE:
            connection.sendall(_frame(CLOSE, b""))
            return


def _is_known(resource: str) -> bool:
    return resource in ("/rw/panel/ctrlstate", "/rw/panel/opmode", "/rw/rapid/execution;ctrlexecstate", "/rw/elog/0") or bool(
        SYMBOL.fullmatch(resource)
    )


def _value(machine: Machine, resource: str) -> str:
    with machine.lock:
        if resource == "/rw/panel/ctrlstate":
            return machine.ctrlstate
        if resource == "/rw/panel/opmode":
            return machine.opmode
        if resource == "/rw/elog/0":
            return str(len(machine.log))
        if resource == "/rw/rapid/execution;ctrlexecstate":
            return "running" if machine.is_running() else "stopped"
        machine.program.advance()
        match = SYMBOL.fullmatch(resource)
        found = machine.program.symbols.find(match.group(2)) if match else None
        return write(found.value) if found else ""


def _event(resource: str, value: str) -> bytes:
    """Return one event, on one line."""
    kinds = {
        "/rw/panel/ctrlstate": ("pnl-ctrlstate-ev", "ctrlstate", resource),
        "/rw/panel/opmode": ("pnl-opmode-ev", "opmode", resource),
        "/rw/rapid/execution;ctrlexecstate": ("rap-ctrlexecstate-ev", "ctrlexecstate", resource),
        "/rw/elog/0": ("elog-message-ev", "seqnum", f"/rw/elog/0/{value}"),
    }
    kind, name, link = kinds.get(resource, ("rap-data", "value", resource))
    item = f'<li class="{kind}" title="{name}"><a href="{link}" rel="self"/><span class="{name}">{escape(value)}</span></li>'
    return f'<?xml version="1.0" encoding="utf-8"?><html><body><div class="state"><ul>{item}</ul></div></body></html>'.encode()


def _frame(kind: int, payload: bytes) -> bytes:
    length = len(payload)
    head = struct.pack("!BB", 0x80 | kind, length) if length < 126 else struct.pack("!BBH", 0x80 | kind, 126, length)
    return head + payload
