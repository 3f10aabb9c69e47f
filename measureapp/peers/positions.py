"""Where the axes of a virtual cell are, told over loopback to a simulated measuring head in another program.

Each line received is answered by one line of JSON.
"""

from __future__ import annotations

import json
import socket
import socketserver
import threading
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import Any

import numpy as np

from measureapp.errors import DeviceLost
from measureapp.geometry.transform import RigidTransform

REPLY_TIMEOUT_S = 2.0


class CellPositions:
    """Where the axes came to rest last, and what lies on the table. All methods may be called from any thread."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._told: dict[str, Any] = {"base_from_flange": np.eye(4).tolist(), "guide_mm": 0.0, "table_rad": 0.0, "table_holds": "empty"}

    def move_robot(self, base_from_flange: RigidTransform) -> None:
        """Note where the flange is."""
        self._note(base_from_flange=base_from_flange.matrix.tolist())

    def move_guide(self, position_mm: float) -> None:
        """Note where the slide is."""
        self._note(guide_mm=position_mm)

    def turn_table(self, angle_rad: float) -> None:
        """Note where the table is."""
        self._note(table_rad=angle_rad)

    def place_on_table(self, thing: str) -> None:
        """Note what lies on the table: "board", "part" or "empty"."""
        self._note(table_holds=thing)

    def told(self) -> Mapping[str, Any]:
        """Return everything, as JSON holds it."""
        with self._lock:
            return dict(self._told)

    def _note(self, **news: Any) -> None:
        with self._lock:
            self._told.update(news)


@contextmanager
def tell_positions(positions: CellPositions) -> Iterator[str]:
    """Answer whoever asks on a free port of 127.0.0.1; yields "host:port"."""

    class Answers(socketserver.StreamRequestHandler):
        def handle(self) -> None:
            while self.rfile.readline():
                self.wfile.write(json.dumps(positions.told()).encode() + b"\n")

    class Server(socketserver.ThreadingTCPServer):
        daemon_threads = True
        block_on_close = False

    with Server(("127.0.0.1", 0), Answers) as server:
        threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.05}, name="positions", daemon=True).start()
        try:
            yield f"127.0.0.1:{server.server_address[1]}"
        finally:
            server.shutdown()


class PositionsAsked:
    """A connection that asks a running cell for its positions.

    Parameters
    ----------
    address : "host:port"

    Raises
    ------
    DeviceLost
        Nothing answers there.
    """

    def __init__(self, address: str) -> None:
        self._address = address
        self._lock = threading.Lock()
        host, _, port = address.rpartition(":")
        try:
            self._socket = socket.create_connection((host, int(port)), timeout=REPLY_TIMEOUT_S)
        except (OSError, ValueError, OverflowError) as error:
            raise self._lost(error) from error
        self._lines = self._socket.makefile("rb")

    def ask(self) -> Mapping[str, Any]:
        """Return what `CellPositions.told` returns there. Raises DeviceLost."""
        with self._lock:
            try:
                self._socket.sendall(b"\n")
                found: Mapping[str, Any] = json.loads(self._lines.readline())
            except (OSError, ValueError) as error:
                raise self._lost(error) from error
            return found

    def close(self) -> None:
        """End the connection. Harmless when repeated."""
        self._lines.close()
        self._socket.close()

    def _lost(self, error: Exception) -> DeviceLost:
        return DeviceLost(
            f"The virtual cell at {self._address} does not answer: {error}.",
            "Start it by `measureapp rig peers`, and use the rig description that it has just written.",
        )
