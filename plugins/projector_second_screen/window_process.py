"""The process that shows the patterns: started, spoken to by lines of JSON, and ended."""

from __future__ import annotations

import contextlib
import json
import os
import subprocess
import sys
import threading
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, BinaryIO

import measureapp
from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout, InputError

ROOT = Path(measureapp.__file__).resolve().parents[1]
MODULE = "ui.second_screen"
END_S = 3.0  # how long the process may take to end by itself
LOG_CHARACTERS = 200
HINT_LOST = "Connect the rig again."
Message = dict[str, Any]


class WindowProcess:
    """One window in a process of its own. All methods may be called from any thread; replies find the call that waits for them.

    Parameters
    ----------
    arguments : of the command ``serve``
    log : file of the process's standard error
    """

    def __init__(self, name: str, arguments: Sequence[str], log: Path) -> None:
        self.name = name
        self._log = log
        self._changed = threading.Condition()
        self._sending = threading.Lock()
        self._number = 0
        self._waiting: set[int] = set()
        self._replies: dict[int, Message] = {}
        self._greeting: Message | None = None
        self._lost = ""
        with log.open("wb") as errors:
            self._process = subprocess.Popen(
                [sys.executable, "-m", MODULE, "serve", *arguments],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=errors,
                cwd=ROOT,
                env=_environment(),
                creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
            )
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._input, output = self._process.stdin, self._process.stdout
        self._reader = threading.Thread(target=self._read, args=(output,), name=f"replies of {name}", daemon=True)
        self._reader.start()

    def greet(self, timeout_s: float) -> Message:
        """Wait until the window is there, and return what its screen is.

        Raises
        ------
        DeviceError, InputError
            The screen is not there, is not the only one of its name, or has another size.
        """
        with self._changed:
            self._changed.wait_for(lambda: self._greeting is not None or self._lost, timeout_s)
            greeting = self._greeting
        if greeting is None:
            reason = self._lost or f"its window did not appear within {timeout_s:g} s"
            raise DeviceError(
                f"{self.name}: {reason}.", "Check that the program has a display (not over ssh), and that PySide6 is installed."
            )
        if greeting["event"] != "ready":
            kind = InputError if greeting["kind"] == "InputError" else DeviceError
            raise kind(f"{self.name}: {greeting['error']}", greeting["hint"])
        screen: Message = greeting["screen"]
        return screen

    def ask(self, command: Message, timeout_s: float, allowed: Callable[[], None] = lambda: None) -> Message:
        """Send a command and wait for its reply.

        Parameters
        ----------
        allowed : called when nothing else can be sent any more before the command; raises to prevent it

        Raises
        ------
        DeviceError
            The window refused.
        DeviceTimeout
            No reply in time.
        DeviceLost
            The screen is gone, or the process has ended.
        """
        number = self._send(command, allowed)
        with self._changed:
            self._changed.wait_for(lambda: number in self._replies or self._lost, timeout_s)
            self._waiting.discard(number)
            reply = self._replies.pop(number, None)
        if reply is None:
            self._check_alive()
            raise DeviceTimeout(f"{self.name}: the window did not follow the command {command['do']} within {timeout_s:g} s.", HINT_LOST)
        if "error" in reply:
            kind = DeviceLost if reply["lost"] else DeviceError
            raise kind(f"{self.name}: {reply['error']}", reply["hint"])
        return reply

    def close(self) -> None:
        """End the process. Harmless when repeated."""
        self._lose("its window was closed")
        with self._sending, contextlib.suppress(OSError, ValueError):
            self._input.close()  # the process ends with its input
        try:
            self._process.wait(END_S)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        self._reader.join()
        if self._process.stdout is not None:
            self._process.stdout.close()

    def _send(self, command: Message, allowed: Callable[[], None]) -> int:
        """Send a command, and return the number that its reply will have. Raises DeviceLost."""
        self._check_alive()
        with self._sending:
            allowed()
            self._number += 1
            self._waiting.add(self._number)
            line = json.dumps({"id": self._number} | command) + "\n"
            try:
                self._input.write(line.encode())
                self._input.flush()
            except (OSError, ValueError) as error:
                self._lose("the process of its window has ended")
                raise DeviceLost(f"{self.name}: {self._lost}.", HINT_LOST) from error
            return self._number

    def _read(self, output: BinaryIO) -> None:
        for line in output:
            try:
                message: Message = json.loads(line)
            except ValueError:
                continue  # a library that prints to the standard output
            with self._changed:
                if message.get("event") == "lost":
                    self._lost = self._lost or str(message["error"]).rstrip(".")
                elif "event" in message:
                    self._greeting = message
                elif message.get("id") in self._waiting:
                    self._replies[message["id"]] = message
                self._changed.notify_all()
        code = self._process.wait()
        self._lose(f"the process of its window ended with code {code}{self._last_words()}")

    def _lose(self, reason: str) -> None:
        with self._changed:
            self._lost = self._lost or reason
            self._changed.notify_all()

    def _check_alive(self) -> None:
        if self._lost:
            raise DeviceLost(f"{self.name}: {self._lost}.", HINT_LOST)

    def _last_words(self) -> str:
        lines = self._log.read_text(encoding="utf-8", errors="replace").strip().splitlines() if self._log.exists() else []
        return f" ({lines[-1][:LOG_CHARACTERS].strip()})" if lines else ""


def _environment() -> dict[str, str]:
    """Return the environment of the process: without display scaling, so that Qt's pixels are the screen's."""
    path = os.pathsep.join(part for part in (str(ROOT), os.environ.get("PYTHONPATH", "")) if part)
    return {"QT_ENABLE_HIGHDPI_SCALING": "0"} | os.environ | {"PYTHONPATH": path}
