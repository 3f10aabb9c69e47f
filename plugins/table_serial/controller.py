"""One axis of a controller in counts: questions, conditions, commands, and moves that are believed only when they are read back."""

from __future__ import annotations

import re
import time
from collections.abc import Callable
from contextlib import suppress

from measureapp.devices.attempt import Attempt, Stops
from measureapp.devices.settling import ELSEWHERE_S, Settling, allowed_s
from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout, MeasureError, MotionError
from measureapp.progress import Cancelled

from .command_table import CommandTable, Condition
from .line import SerialLine
from .settings import TableSettings

IDENTITY_TRIES = 3  # after late replies
ENABLE_S = 2.0
FIND_REFERENCE = "Find its reference before it is moved."


def _always() -> None:
    """Allow a command to be sent."""


class TableController:
    """Moves one axis. `move` and `home` are for one thread, `stop` for any."""

    def __init__(self, name: str, line: SerialLine, commands: CommandTable, settings: TableSettings) -> None:
        self.name = name
        self.counts_per_unit = settings.counts_per_unit or commands.counts_per_unit
        self.sense = settings.sense or commands.sense
        self._line, self._commands, self._settings = line, commands, settings
        self._stops = Stops()
        self._referenced = settings.absolute_encoder
        self._regain()
        self._refuse_alarm(DeviceError)
        self._enable()

    # reading

    @property
    def is_modulo(self) -> bool:
        """Whether the position returns to 0 after one turn."""
        return self._commands.turns == "modulo"

    def counts(self) -> float:
        """Read the position."""
        return self._number("position")

    def difference(self, one: float, other: float) -> float:
        """Return ``one - other``, for controllers that count modulo one turn the shorter way."""
        if not self.is_modulo:
            return one - other
        turn = 360.0 * self.counts_per_unit
        return (one - other + turn / 2) % turn - turn / 2

    def sendable(self, counts: float) -> float:
        """Return a goal as it can be sent: rounded, and within one turn where the controller counts so."""
        rounded = round(counts, self._commands.decimals)
        return (rounded % (360.0 * self.counts_per_unit) if self.is_modulo else rounded) + 0.0

    def is_homed(self) -> bool:
        """Return whether the position is known; a controller that cannot report it must have been referenced since it was connected."""
        return self._holds("homed") if "homed" in self._commands.conditions else self._referenced

    def state_words(self) -> tuple[bool, str, str]:
        """Return whether the axis is ready, its state in words, and the remedy."""
        if self._holds("alarm"):
            return False, f"alarm: {self._words('alarm')}.", "Remove the cause and reset the controller."
        if not self.is_homed():
            return False, "not referenced.", "Find the reference."
        uncertain = self._commands.uncertain
        note = f"; compare with the manual: {', '.join(uncertain)}" if uncertain else ""
        return True, f"{self._commands.name}, axis {self._settings.axis}{note}", ""

    # moving

    def move(self, goal: float, duration_s: float, timeout_s: float) -> None:
        """Move to ``goal`` counts and wait until two reads agree with it and each other.

        Raises
        ------
        MotionError
            Not referenced, an alarm, a command refused, or it came to rest elsewhere.
        DeviceTimeout
            It did not come to rest at the goal in time.
        Cancelled
            `stop` was called.
        """
        attempt = self._stops.begin(f"The move of {self.name}", allowed_s(duration_s, timeout_s))
        if not self.is_homed():
            raise MotionError(f"{self.name} is not referenced.", FIND_REFERENCE)
        self._guarded(attempt, lambda: self._move(goal, attempt))

    def home(self, timeout_s: float) -> None:
        """Find the reference, if the position is not known. Raises as `move`."""
        attempt = self._stops.begin(f"The search of {self.name} for its reference", timeout_s)
        if not self.is_homed():
            self._guarded(attempt, lambda: self._home(attempt))

    def stop(self) -> None:
        """Stop now, from any thread; the command is sent before any reply is waited for."""
        self._stops.stop()
        self._shout_stop()
        self._refuse_refusal("stop")

    def _guarded(self, attempt: Attempt, motion: Callable[[], None]) -> None:
        """Run a motion; whatever ends it early also stops the axis. What fails after a stop has the stop as its cause."""
        try:
            motion()
        except Cancelled:
            raise  # by `stop`, which sends the command itself
        except BaseException:
            with suppress(MeasureError):
                self._shout_stop()
            with suppress(DeviceTimeout):
                attempt.check()
            raise

    def _move(self, goal: float, attempt: Attempt) -> None:
        self._run("speed", goal, attempt.check)
        self._run("move", goal, attempt.check)
        if "goal" in self._commands.queries and abs(self.difference(self._number("goal"), goal)) > 0.6 * 10.0**-self._commands.decimals:
            raise MotionError(
                f"{self.name} has another goal than was sent.", "Check the command table, and that no other program controls the table."
            )
        settling = Settling(goal, self._settings.tolerance * self.counts_per_unit, self._settings.settled_s, self.difference)
        while True:
            here, moving = self.counts(), self._holds("moving")
            self._refuse_alarm(MotionError)
            verdict = settling.observe(time.monotonic(), here, moving)
            if verdict == "arrived":
                return
            if verdict == "elsewhere":
                raise MotionError(
                    f"{self.name} came to rest {settling.distance(here) / self.counts_per_unit:.3f}° away from its goal.",
                    "Check for an obstacle, a limit switch, and the scale of the drive.",
                )
            attempt.wait(self._settings.poll_s)

    def _home(self, attempt: Attempt) -> None:
        self._run("home", 0.0, attempt.check)
        began, seen_moving = time.monotonic(), False
        while True:
            attempt.wait(self._settings.settled_s)
            self._refuse_alarm(MotionError)
            if self._holds("moving"):
                seen_moving = True
            elif "homed" in self._commands.conditions:
                if self._holds("homed"):
                    return
            elif seen_moving or time.monotonic() - began > ELSEWHERE_S:
                self._referenced = True
                return

    def _enable(self) -> None:
        """Switch the motor on where it is off, and confirm it. One that must find its reference first is left as it is."""
        if "enabled" not in self._commands.conditions or self._holds("enabled"):
            return
        self._run("enable", 0.0, _always)
        end = time.monotonic() + ENABLE_S
        while not self._holds("enabled"):
            if time.monotonic() > end:
                raise DeviceError(f"{self.name} does not switch its motor on.", "Check its emergency stop and interlocks.")
            time.sleep(self._settings.poll_s)

    # commands and questions

    def _run(self, sequence: str, goal: float, check: Callable[[], None]) -> None:
        acknowledge = self._commands.acknowledge
        for text in self._texts(sequence, goal):
            answer = self._line.command(self.name, text, check, answered=bool(acknowledge))
            if acknowledge and re.fullmatch(acknowledge, answer.strip()) is None:
                raise MotionError(f"{self.name} refused {text!r} with {answer!r}.", "Check the state of the controller and its limits.")
            self._refuse_refusal(text)

    def _texts(self, sequence: str, goal: float) -> list[str]:
        decimals, settings = self._commands.decimals, self._settings
        places = {
            "axis": settings.axis,
            "before": settings.axis - 1,
            "goal": f"{goal:.{decimals}f}",
            "sign": "-" if goal < 0 else "+",
            "magnitude": f"{abs(goal):.{decimals}f}",
            "speed": f"{settings.speed * self.counts_per_unit:.{decimals}f}",
            "acceleration": f"{settings.acceleration * self.counts_per_unit:.{decimals}f}",
        }
        return [text.format(**places) for text in self._commands.sequences.get(sequence, ())]  # type: ignore[call-overload]

    def _shout_stop(self) -> None:
        if self._commands.echo or self._commands.acknowledge:
            self._line.doubtful = True  # its answer may arrive in place of another
        for text in self._texts("stop", 0.0):
            self._line.shout(self.name, text)

    def _refuse_refusal(self, text: str) -> None:
        condition = self._commands.conditions.get("refused")
        if condition is None:
            return
        groups = self._groups(condition.query)
        if condition.holds(groups):
            raise MotionError(
                f"{self.name} refused {text!r}: {self._meaning(condition, groups)}.", "Check the state of the controller and its limits."
            )

    def _refuse_alarm(self, kind: type[DeviceError]) -> None:
        if self._holds("alarm"):
            raise kind(
                f"{self.name} reports an alarm: {self._words('alarm')}.", "Remove the cause and reset the controller, then try again."
            )

    def _words(self, condition: str) -> str:
        stated = self._commands.conditions[condition]  # type: ignore[index]
        return self._meaning(stated, self._groups(stated.query))

    def _meaning(self, condition: Condition, groups: dict[str, str]) -> str:
        code = groups[condition.group]
        return groups.get("text", "").strip().lower() or self._commands.errors.get(code, f"code {code}")

    def _holds(self, condition: str) -> bool:
        stated = self._commands.conditions.get(condition)  # type: ignore[call-overload]
        return stated is not None and stated.holds(self._groups(stated.query))

    def _number(self, query: str) -> float:
        return float(self._groups(query)["value"].replace(" ", ""))

    def _groups(self, query: str) -> dict[str, str]:
        """Ask; after a late reply the identity is confirmed first, and a question without reply is asked once more."""
        if self._line.doubtful:
            self._regain()
        try:
            return self._once(query)
        except DeviceTimeout:  # asking again does no harm
            self._regain()
            return self._once(query)

    def _once(self, query: str) -> dict[str, str]:
        asked = self._commands.queries[query]
        answer = self._line.ask(self.name, asked.send.format(axis=self._settings.axis, before=self._settings.axis - 1))
        found = asked.pattern(self._settings.axis).fullmatch(answer)
        if found is None:
            self._line.doubtful = True
            raise DeviceError(
                f"{self.name} answered the query {query} with {answer[:40]!r} ({self._line.excerpt(answer.encode('ascii'))}), "
                f"which is no reply of a {self._commands.name}.",
                "Check the controller, its command table, address and baud rate.",
            )
        return {name: value or "" for name, value in found.groupdict().items()}

    def _regain(self) -> None:
        """Drain the line, and believe the controller again when it identifies itself."""
        identity = self._commands.conditions.get("identity")
        for attempt in range(IDENTITY_TRIES):
            self._line.drain(self.name)
            try:
                if identity is None or identity.holds(self._once(identity.query)):
                    self._line.trust()
                    return
            except DeviceLost:
                raise
            except DeviceError:
                if attempt + 1 == IDENTITY_TRIES:
                    raise
        raise DeviceError(
            f"{self.name} does not identify itself as a {self._commands.name}.", "Check port, address, baud rate and command table."
        )
