"""The controller itself: motors, operating mode, program, mastership and event log; and what a person does at the cell."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.peers.moving_axes import MovingAxes
from measureapp.peers.rws.arm import ACCELERATION_DEG_PER_S2, LIMITS_DEG, SPEED_DEG_PER_S, flange_pose
from measureapp.peers.rws.program import MailboxProgram
from measureapp.peers.rws.symbols import Symbols

START_DEG = (0.0, 0.0, 0.0, 0.0, 30.0, 0.0)
AT_ONCE = 1e-5  # time scale that stands for 0


@dataclass(frozen=True, slots=True)
class LogEntry:
    """One message of the event log."""

    number: int
    kind: int  # 1 information, 2 warning, 3 error
    code: int
    title: str
    stamp: str


class Machine:
    """State of the controller. All methods may be called from any thread; `lock` is held by every request.

    Parameters
    ----------
    module_text : the RAPID module that is loaded
    time_scale : 1: moves last as long as in reality; 0: as short as possible
    on_rest : called with base_from_flange's joint angles (6,) in degrees whenever the arm comes to rest
    start_deg : joint angles (6,) at the start
    """

    def __init__(
        self,
        module_text: str,
        time_scale: float = 1.0,
        on_rest: Callable[[FloatArray], None] = lambda _: None,
        start_deg: tuple[float, ...] = START_DEG,
    ) -> None:
        self.lock = threading.RLock()
        self.ctrlstate, self.opmode = "motoron", "AUTO"
        self.system_id = "{2B9F5D6A-3C1E-4C7B-9F1A-0123456789AB}"
        self.version = "6.15.2018.01"
        self.log: list[LogEntry] = []
        self.read_back_error_deg = np.zeros(6)  # the joints read back differ from the true ones
        self.frozen_deg: FloatArray | None = None  # the joints read back never change
        self.creep_deg, self.creep_s = 0.0, 0.0  # after a move the arm creeps this much for this long
        self.robtarget_offset_mm = 0.0  # along x: the controller calculates another pose from the joints
        self._module_text, self._time_scale, self._on_rest = module_text, time_scale, on_rest
        scale = max(time_scale, AT_ONCE)
        self.rested_at = time.monotonic() - 1e9  # when the arm last came to rest
        self.axes = MovingAxes(start_deg, list(SPEED_DEG_PER_S / scale), list(ACCELERATION_DEG_PER_S2 / scale**2), on_rest=self._rest)
        self.program = self._loaded()

    def joints_deg(self) -> FloatArray:
        """Return the joint angles (6,) as read back."""
        self.program.advance()
        true = self.axes.positions()
        if self.frozen_deg is not None:
            return self.frozen_deg
        left = 1.0 - (time.monotonic() - self.rested_at) / self.creep_s if self.creep_s and not self.axes.is_moving else 0.0
        return true + self.read_back_error_deg + self.creep_deg * max(0.0, left)

    def is_running(self) -> bool:
        """Whether the program runs."""
        self.program.advance()
        return self.program.running

    def press_emergency_stop(self) -> None:
        """Press the emergency stop."""
        self._halt("emergencystop", LogEntry(0, 3, 10013, "Emergency stop state", ""))

    def release_emergency_stop(self) -> None:
        """Release the button; the motors still have to be switched on by hand: `reset_emergency_stop`."""
        with self.lock:
            self.ctrlstate = "emergencystopreset"

    def reset_emergency_stop(self) -> None:
        """Press the motors-on button after an emergency stop."""
        with self.lock:
            self.ctrlstate = "motoroff"

    def open_guard(self) -> None:
        """Open the door of the cell."""
        self._halt("guardstop", LogEntry(0, 3, 10012, "Safety guard stop state", ""))

    def close_guard(self) -> None:
        """Close the door of the cell."""
        with self.lock:
            self.ctrlstate = "motoroff"

    def switch_motors_off(self) -> None:
        """Switch the motors off at the cabinet."""
        self._halt("motoroff", LogEntry(0, 1, 10010, "Motors OFF state", ""))

    def turn_key(self, opmode: str) -> None:
        """Select an operating mode (AUTO, MANR, MANF): the motors go off."""
        with self.lock:
            self.opmode = opmode
            self._halt("motoroff", LogEntry(0, 1, 10015, f"Operating mode {opmode} selected", ""))

    def stop_program(self, title: str) -> None:
        """Stop the program with an error in the event log, as a fault of motion supervision does."""
        with self.lock:
            self.program.stop()
            self.write_log(3, int(title.partition(":")[0]), title.partition(": ")[2])

    def restart(self, *, system_id: str = "", module_text: str = "") -> None:
        """Restart the controller, with another system or program where these are given; the program does not run afterwards."""
        with self.lock:
            self.program.stop()
            self.system_id = system_id or self.system_id
            kept = self.program.symbols
            self._module_text = module_text or self._module_text
            self.program = self._loaded()
            if not module_text:
                self.program.symbols = kept  # PERS data keep their values
            self.ctrlstate = "motoroff"
            self.write_log(1, 10011, "System restart")

    def write_log(self, kind: int, code: int, title: str) -> None:
        """Append a message to the event log."""
        stamp = time.strftime("%Y-%m-%d T %H:%M:%S")
        self.log.append(LogEntry(len(self.log) + 1, kind, code, title, stamp))

    def flange_position_mm(self) -> tuple[FloatArray, FloatArray]:
        """Return the flange's position (3,) and quaternion (w, x, y, z) in the base, as read back."""
        pose = flange_pose(self.joints_deg())
        return pose.translation_mm + np.array([self.robtarget_offset_mm, 0.0, 0.0]), pose.quaternion_wxyz

    def _loaded(self) -> MailboxProgram:
        return MailboxProgram(Symbols(self._module_text), self.axes, LIMITS_DEG, time.monotonic, self._time_scale, self.stop_program)

    def _rest(self, positions: FloatArray) -> None:
        self.rested_at = time.monotonic()
        self._on_rest(positions)

    def _halt(self, ctrlstate: str, entry: LogEntry) -> None:
        with self.lock:
            self.ctrlstate = ctrlstate
            self.program.stop()
            self.write_log(entry.kind, entry.code, entry.title)
