"""Virtual robot controller with Robot Web Services 1.0 and 2.0: what the robot driver talks to where there is no robot."""

from __future__ import annotations

import ssl
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Literal

from measureapp.arrays import FloatArray
from measureapp.peers.rws.link_faults import LinkFaults
from measureapp.peers.rws.machine import START_DEG, Machine
from measureapp.peers.rws.resources import Cell
from measureapp.peers.rws.server import RwsServer
from measureapp.peers.rws.sessions import Sessions
from measureapp.resources import resource

__all__ = ["LinkFaults", "VirtualController", "virtual_controller"]


@dataclass(frozen=True)
class VirtualController:
    """A running virtual controller: its address, what a person can do at it, its logins, and the faults of its link."""

    url: str
    machine: Machine
    sessions: Sessions
    faults: LinkFaults
    cell: Cell
    server: RwsServer

    def reboot(self, *, system_id: str = "", module_text: str = "") -> None:
        """Restart: logins and connections are lost, the program does not run; optionally with another system or program."""
        with self.machine.lock:
            self.machine.restart(system_id=system_id, module_text=module_text)
            self.sessions.end_all()
        self.server.break_connections()


@contextmanager
def virtual_controller(
    *,
    version: Literal[1, 2] = 1,
    time_scale: float = 0.0,
    start_deg: tuple[float, ...] = START_DEG,
    on_rest: Callable[[FloatArray], None] = lambda _: None,
    session_limit: int = 70,
    tls: ssl.SSLContext | None = None,
) -> Iterator[VirtualController]:
    """Run a virtual controller on a free port of the loopback interface, with the shipped RAPID module loaded.

    Parameters
    ----------
    version : of Robot Web Services
    time_scale : 1: moves last as long as in reality; 0: as short as possible
    start_deg : joint angles at the start
    on_rest : called with the joint angles (6,) in degrees whenever the arm comes to rest
    session_limit : logins beyond this one are refused with 503
    tls : serve https with this context; None: plain http
    """
    module_text = resource("rapid/MeasureApp.mod").read_text(encoding="ascii")
    machine = Machine(module_text, time_scale, on_rest, start_deg)
    sessions, faults = Sessions(limit=session_limit), LinkFaults()
    cell = Cell(machine, sessions)
    with RwsServer(cell, faults, version == 2, tls) as server:
        scheme = "http" if tls is None else "https"
        yield VirtualController(f"{scheme}://127.0.0.1:{server.server_address[1]}", machine, sessions, faults, cell, server)
