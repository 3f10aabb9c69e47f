"""The other side of the camera process: starts it, calls it with a deadline, and reads images from the shared memory."""

from __future__ import annotations

import mmap
import os
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable
from multiprocessing import Pipe
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any, NoReturn

import numpy as np

from measureapp.child_process import describe_exit
from measureapp.errors import DeviceError, DeviceLost, PluginError
from measureapp.progress import Cancelled

from .pixels import Bytes

START_S = 10.0
ANSWER_S = 2.8  # a camera that is silent for 5 × 0.5 s does not answer; the deadline covers the case that Aravis does not return
LOOK_S = 0.02  # how often a waiting call looks whether it was stopped
END_S = 3.0
INSTALL = "On Debian and Ubuntu: apt-get install libaravis-0.8-0; on macOS: brew install aravis."


class CameraLink:
    """A camera process. Its methods may be called from any thread.

    Raises
    ------
    PluginError
        Aravis is not installed, or not on this operating system.
    """

    def __init__(self, name: str) -> None:
        if os.name != "posix":
            raise PluginError(f"Camera {name}: Aravis is only used on Linux and macOS.", "Use the driver of the camera's manufacturer.")
        self._name = name
        self._lock, self._reading = threading.Lock(), threading.Lock()
        self._number, self._lost = 0, ""
        self._pixels: mmap.mmap | None = None
        self._memory = _anonymous_memory()
        self._log = Path(tempfile.mkstemp(prefix="measureapp-camera-", suffix=".log")[1])
        self._control, control = Pipe()
        frames, sending = Pipe(duplex=False)
        self._frames = frames
        self._process = _start((control, sending), self._memory, self._log)
        try:
            self._answer(0, time.monotonic() + START_S, None)
        except DeviceError as error:
            self.close()
            raise PluginError(error.message, INSTALL) from error

    def call(self, method: str, *arguments: Any, timeout_s: float = ANSWER_S, stopped: Callable[[], bool] | None = None) -> Any:
        """Call a method of the camera process.

        Raises
        ------
        DeviceLost
            The camera or the process does not answer; no later call is answered either.
        DeviceError
            The camera refused.
        Cancelled
            ``stopped()`` became true; the call may still be executed.
        """
        end = time.monotonic() + timeout_s
        while not self._lock.acquire(timeout=LOOK_S):
            self._check_waiting(end, stopped)
        try:
            if self._lost:
                raise DeviceLost(self._lost, "Check cable, power and network, then connect the camera again.")
            self._number += 1
            try:
                self._control.send((self._number, method, arguments))
            except OSError:
                self._lose(self._ending())
            return self._answer(self._number, end, stopped)
        finally:
            self._lock.release()

    def share(self, slots: int, slot_bytes: int) -> None:
        """Provide the memory for ``slots`` images."""
        os.ftruncate(self._memory, slots * slot_bytes)
        self._pixels = mmap.mmap(self._memory, slots * slot_bytes)
        self.call("share", slots, slot_bytes)

    def frame(self, timeout_s: float) -> dict[str, Any] | None:
        """Wait for the description of the next image; None when there is none in time. Raises DeviceLost."""
        with self._reading:
            try:
                return self._frames.recv() if self._frames.poll(timeout_s) else None
            except (EOFError, OSError):
                self._lose(self._ending())

    def raw(self, start: int, size: int) -> Bytes:
        """Return the bytes of an image in the shared memory, which are overwritten once its place is given back."""
        assert self._pixels is not None
        return np.frombuffer(self._pixels, np.uint8, size, start)

    def close(self) -> None:
        """Release the camera and end the process. Harmless when repeated."""
        self._lost = self._lost or f"Camera {self._name} is closed."
        with self._lock:  # a call that waits ends by its deadline
            self._control.close()  # the process then stops streaming, releases the camera and ends
        try:
            self._process.wait(END_S)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        with self._reading:
            self._frames.close()
        if self._memory >= 0:
            os.close(self._memory)
            self._memory = -1
        self._log.unlink(missing_ok=True)

    def _answer(self, number: int, end: float, stopped: Callable[[], bool] | None) -> Any:
        """Wait for the answer to a call; answers to calls that were stopped are skipped."""
        while True:
            try:
                if not self._control.poll(LOOK_S):
                    self._check_waiting(end, stopped)
                    continue
                answered, result, error = self._control.recv()
            except (EOFError, OSError):
                self._lose(self._ending())
            if answered != number:
                continue
            if error is None:
                return result
            reason, lost = error
            if lost:
                self._lose(reason)
            raise DeviceError(f"Camera {self._name}: {reason}.", "Check the setting named, and what this camera supports.")

    def _check_waiting(self, end: float, stopped: Callable[[], bool] | None) -> None:
        if stopped is not None and stopped():
            raise Cancelled
        if time.monotonic() > end:
            self._lose("its process does not answer in time")

    def _lose(self, reason: str) -> NoReturn:
        self._lost = f"Camera {self._name} does not answer any more: {reason}."
        raise DeviceLost(self._lost, "Check cable, power and network, then connect the camera again.")

    def _ending(self) -> str:
        """Describe how the process ended."""
        try:
            return describe_exit(self._process.wait(END_S), self._log)
        except subprocess.TimeoutExpired:
            return "its process has closed the connection"


def _anonymous_memory() -> int:
    """Return the descriptor of a file without a name that lives in memory where the system can do that."""
    if sys.platform == "linux":
        return os.memfd_create("measureapp-camera")
    with tempfile.TemporaryFile() as file:
        return os.dup(file.fileno())


def _start(pipes: tuple[Connection, Connection], memory: int, log: Path) -> subprocess.Popen[bytes]:
    """Start the camera process with its ends of the pipes, which are closed here."""
    folder = Path(__file__).resolve().parent
    descriptors = (*(pipe.fileno() for pipe in pipes), memory)
    command = [sys.executable, "-m", f"{folder.name}.child", *map(str, descriptors)]
    with log.open("wb") as errors:
        process = subprocess.Popen(command, cwd=folder.parent, pass_fds=descriptors, stdin=subprocess.DEVNULL, stdout=errors, stderr=errors)
    for pipe in pipes:
        pipe.close()
    return process
