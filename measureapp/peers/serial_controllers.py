"""Controllers of rotary tables as a client sees them.

The commands are stated here again, not taken from the driver's tables: a mistake that both shared would prove nothing.
"""

from __future__ import annotations

import re
from collections import deque

from measureapp.peers.serial_table import TableAxis


class Esp301:
    """A Newport ESP301 with one rotary stage on axis 1, in degrees. Errors wait in a queue until `TB?` reads them."""

    command_end, reply_end, echo = b"\r", b"\r\n", False

    def __init__(self, axis: TableAxis) -> None:
        self.axis = axis
        self._errors: deque[str] = deque(maxlen=10)
        self._ticks = 451_322

    def answer(self, command: str) -> str | None:
        """Carry a command out; several may be separated by semicolons."""
        answers = [answer for part in command.split(";") if (answer := self._one(part.strip())) is not None]
        return "\r\n".join(answers) if answers else None

    def _one(self, command: str) -> str | None:
        if command == "VE?":
            return "ESP301 Version 3.0.1 6/1/99"
        if command == "TB?":
            return self._errors.popleft() if self._errors else self._error("0", "NO ERROR DETECTED")
        found = re.fullmatch(r"(\d+)([A-Z]{2})(.*)", command.upper())
        if found is None:
            self._note("6", "COMMAND DOES NOT EXIST")
            return None
        number, mnemonic, value = found.groups()
        if number != "1":
            self._note("37", "AXIS NUMBER OUT OF RANGE")
            return None
        if mnemonic == "TP" or value == "?":
            return self._ask(mnemonic)
        self._do(mnemonic, value)
        return None

    def _ask(self, mnemonic: str) -> str | None:
        axis = self.axis
        answers = {
            "TP": f"{axis.told_position():.4f}",
            "DP": f"{axis.position():.4f}",  # where it should be at this moment
            "MD": str(int(not axis.told_moving())),
            "MO": str(int(axis.motor_on)),
        }
        if mnemonic not in answers:
            self._note("6", "COMMAND DOES NOT EXIST")
        return answers.get(mnemonic)

    def _do(self, mnemonic: str, value: str) -> None:
        axis = self.axis
        if mnemonic in ("PA", "OR") and axis.faults.refuse:
            self._note(f"1{axis.faults.refuse}", "REFUSED BY ORDER")
        elif mnemonic in ("PA", "OR") and not axis.motor_on:
            self._note("113", "AXIS-1 MOTOR NOT ENABLED")
        elif mnemonic == "PA":
            axis.start(float(value))
        elif mnemonic == "OR":
            axis.find_reference()
        elif mnemonic == "ST":
            axis.stop()
        elif mnemonic in ("MO", "MF"):
            axis.motor_on = mnemonic == "MO"
        elif mnemonic not in ("VA", "AC", "AG"):
            self._note("6", "COMMAND DOES NOT EXIST")

    def _note(self, code: str, text: str) -> None:
        self._errors.append(self._error(code, text))

    def _error(self, code: str, text: str) -> str:
        self._ticks += 7
        return f"{code}, {self._ticks}, {text}"


class Smc100:
    """A Newport SMC100 at one address, in degrees. It is not referenced until `OR`, and remembers the last error until `TE` reads it."""

    command_end, reply_end, echo = b"\r\n", b"\r\n", False

    def __init__(self, axis: TableAxis, address: int = 1) -> None:
        self.axis = axis
        self._address = address
        self._error = "@"
        self._disabled = False
        self._homing = False

    def answer(self, command: str) -> str | None:
        """Carry a command out; commands to other addresses are not answered."""
        found = re.fullmatch(r"(\d+)([A-Z]{2})(.*)", command)
        if found is None or int(found[1]) != self._address:
            return None
        mnemonic, value = found[2], found[3]
        told = self._tell(mnemonic, value)
        if told is None:
            self._do(mnemonic, value)
            return None
        return f"{self._address}{mnemonic}{told}"

    def _tell(self, mnemonic: str, value: str) -> str | None:
        axis = self.axis
        if mnemonic == "TP":
            return f"{axis.told_position():.6g}" if abs(axis.told_position()) < 1e-3 else f"{axis.told_position():.4f}"
        if mnemonic == "PA" and value == "?":
            return f"{axis.goal:.4f}"
        if mnemonic == "TS":
            return f"{axis.faults.alarm or '0000'}{self._state()}"
        if mnemonic == "TE":
            told, self._error = self._error, "@"
            return told
        return " SMC_CC_1.0.1" if mnemonic == "VE" else None

    def _state(self) -> str:
        if not self.axis.faults.referenced:
            return "0A"
        if self.axis.told_moving():
            return "1E" if self._homing else "28"
        self._homing = False
        return "3C" if self._disabled else "33"

    def _do(self, mnemonic: str, value: str) -> None:
        axis = self.axis
        if mnemonic in ("PA", "OR") and axis.faults.refuse:
            self._error = axis.faults.refuse
        elif mnemonic == "PA":
            if not axis.faults.referenced:
                self._error = "H"
            elif axis.told_moving():
                self._error = "M"
            else:
                axis.start(float(value))
        elif mnemonic == "OR":
            self._homing = True
            axis.find_reference()
        elif mnemonic == "ST":
            axis.stop()
        elif mnemonic == "MM":
            self._disabled = value == "0"
        elif mnemonic not in ("VA", "AC"):
            self._error = "A"


class Shot:
    """A Sigma-Koki SHOT with a stage on axis 1, in pulses; every command is answered by OK or NG."""

    command_end, reply_end = b"\r\n", b"\r\n"

    def __init__(self, axis: TableAxis, *, echo: bool = False) -> None:
        self.axis, self.echo = axis, echo
        self._prepared: int | None = None
        self._accepted = True

    def answer(self, command: str) -> str | None:
        """Carry a command out."""
        axis = self.axis
        if command == "?:N":
            return "SHOT-302GS"
        if command == "!:":
            return "B" if axis.told_moving() else "R"
        if command == "Q:":
            told = round(axis.told_position())
            sign, flags = "-" if told < 0 else " ", f"{'K' if self._accepted else 'X'},K,{'B' if axis.told_moving() else 'R'}"
            return f"{sign}{abs(told):>9},{0:>10},{flags}"
        self._accepted = not (axis.faults.refuse and command[0] in "AGH") and self._do(command)
        return "OK" if self._accepted else "NG"

    def _do(self, command: str) -> bool:
        found = re.fullmatch(r"A:1([+-])P(\d+)", command)
        if found is not None:
            self._prepared = int(found[1] + found[2])
        elif command == "G:" and self._prepared is not None:
            self.axis.start(self._prepared)
            self._prepared = None
        elif command in ("L:1", "L:E"):
            self.axis.stop()
        elif command == "H:1":
            self.axis.find_reference()
        else:
            return False
        return True


class Ps90:
    """An OWIS PS90 with a stage on axis ``number``, in counts; the axes before it are off."""

    command_end, reply_end, echo = b"\r", b"\r", False

    def __init__(self, axis: TableAxis, number: int = 1) -> None:
        self.axis, self._number = axis, number
        self._goal = 0
        self._error = 0

    def answer(self, command: str) -> str | None:
        """Carry a command out."""
        axis, number = self.axis, self._number
        if command == "?VERSION":
            return "PS90-V5.1"
        if command == "?ERR":
            told, self._error = self._error, 0
            return str(told)
        if command == "?ASTAT":
            state = "I" if not axis.motor_on else "T" if axis.told_moving() else "R"
            return "O" * (number - 1) + (axis.faults.alarm or state) + "O" * (9 - number)
        if command == f"?CNT{number}":
            return str(round(axis.told_position()))
        if command == f"?PSET{number}":
            return str(self._goal)
        self._do(command)
        return None

    def _do(self, command: str) -> None:
        axis, number = self.axis, self._number
        found = re.fullmatch(rf"PSET{number}=(-?\d+)", command)
        if found is not None:
            self._goal = int(found[1])
        elif command == f"INIT{number}":
            axis.motor_on = True
        elif command == f"PGO{number}" and axis.motor_on and not axis.faults.refuse:
            axis.start(self._goal)
        elif command == f"STOP{number}":
            axis.stop()
        elif command == f"REF{number}=4" and axis.motor_on:
            axis.find_reference()
        elif command != f"ABSOL{number}":
            self._error = int(axis.faults.refuse or 33)
