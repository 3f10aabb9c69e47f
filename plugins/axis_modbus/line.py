"""One Modbus line: transactions one after the other, in words where they fail, and no reply believed after a late one."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

from pydantic import ValidationError

from measureapp.data.model import first_problem
from measureapp.devices.serial_ports import find_port
from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout, InputError

from .drive_map import DriveMap
from .settings import LineSettings
from .turns import Turns

Kind = Literal["holding", "input", "coil", "discrete"]
BUSY, BUSY_TRIES, BUSY_WAIT_S = 6, 5, 0.05
LOST_AFTER = 2  # transactions without a reply
QUIET_S = 0.2  # without a byte, after which a late reply is not expected any more
EXCERPT_BYTES = 24
REFUSALS = {
    1: "does not know this function",
    2: "has no such register",
    3: "refuses this value",
    4: "failed while executing the request",
    6: "is busy",
    11: "is not reached by the gateway",
}


@dataclass(frozen=True, slots=True)
class Target:
    """What a transaction is addressed to: the axis for messages, and its station number."""

    axis: str
    unit_id: int


def _always() -> None:
    """Allow a request to be sent."""


@dataclass(frozen=True, slots=True)
class Urgency:
    """How a request is sent: a stop before those that wait; others only if ``check``, called when nothing else can be sent, does not raise."""

    check: Callable[[], None] = _always
    is_stop: bool = False


class ModbusLine:
    """A serial line or TCP connection that several axes may share. All methods may be called from any thread."""

    def __init__(self, make_client: Callable[[Callable[[bool, bytes], bytes]], Any], place: str, *, serial: bool) -> None:
        self._client = make_client(self._trace)
        self._place, self._serial = place, serial
        self._turns = Turns()
        self._heard = b""
        self._silent: dict[int, int] = {}  # by station: transactions in a row without a reply
        self._lost: dict[int, str] = {}  # by station: why
        self._closed = False
        self.doubtful = False  # a late reply may still arrive: nothing is believed before `trust`
        if not self._client.connect():
            raise DeviceError(f"{place} cannot be opened.", "Check port or address, cable and power, and that no other program uses it.")

    def read(self, target: Target, kind: Kind, address: int, count: int) -> list[int]:
        """Read registers or bits. Raises DeviceTimeout, DeviceLost, DeviceError."""
        functions = {
            "holding": self._client.read_holding_registers,
            "input": self._client.read_input_registers,
            "coil": self._client.read_coils,
            "discrete": self._client.read_discrete_inputs,
        }
        reply = self._transact(target, lambda: functions[kind](address, count=count, device_id=target.unit_id), Urgency())
        values = reply.registers if kind in ("holding", "input") else [int(bit) for bit in reply.bits[:count]]
        if len(values) != count:
            raise DeviceError(
                f"{target.axis} answered {len(values)} instead of {count} registers ({self._excerpt()}).", "Check the map of the drive."
            )
        return list(values)

    def write(self, target: Target, kind: Kind, address: int, values: Sequence[int], urgency: Urgency) -> None:
        """Write registers or one bit; never repeated by itself. Raises DeviceTimeout, DeviceLost, DeviceError, and what the check raises."""
        if kind == "coil":
            self._transact(target, lambda: self._client.write_coil(address, bool(values[0]), device_id=target.unit_id), urgency)
        elif len(values) == 1:
            self._transact(target, lambda: self._client.write_register(address, values[0], device_id=target.unit_id), urgency)
        else:
            self._transact(target, lambda: self._client.write_registers(address, list(values), device_id=target.unit_id), urgency)

    def drain(self) -> None:
        """Discard what arrives late, until the line is silent; a stop may be sent meanwhile."""
        quiet_since = time.monotonic()
        while self._serial and time.monotonic() - quiet_since < QUIET_S:
            with self._turns.turn():
                port = self._client.socket
                try:
                    heard = port is not None and bool(port.read(port.in_waiting))
                except (OSError, TypeError):
                    return  # the next transaction reports it
            if heard:
                quiet_since = time.monotonic()
            time.sleep(0.005)

    def trust(self) -> None:
        """Believe replies again, after one was proven to be the drive's own."""
        self.doubtful = False

    def close(self) -> None:
        """Close the line; harmless when repeated. No call opens it again."""
        with self._turns.turn(urgent=True):
            self._closed = True
            self._client.close()

    def _transact(self, target: Target, request: Callable[[], Any], urgency: Urgency) -> Any:
        for attempt in range(BUSY_TRIES):
            reply = self._once(target, request, urgency)
            if not reply.isError():
                return reply
            if reply.exception_code != BUSY:
                break
            if attempt + 1 < BUSY_TRIES:
                time.sleep(BUSY_WAIT_S)
        code = reply.exception_code
        raise DeviceError(
            f"{target.axis} (station {target.unit_id} at {self._place}) {REFUSALS.get(code, 'refused the request')} (Modbus exception {code}).",
            "Check that the map fits this drive, and the state of the drive.",
        )

    def _once(self, target: Target, request: Callable[[], Any], urgency: Urgency) -> Any:
        from pymodbus.exceptions import ConnectionException, ModbusException

        with self._turns.turn(urgent=urgency.is_stop):
            if self._closed:
                raise self._lose(target, "the line was closed")
            if target.unit_id in self._lost and not urgency.is_stop:
                raise self._lose(target, self._lost[target.unit_id])
            urgency.check()
            self._heard = b""
            try:
                reply = request()
            except (ConnectionException, OSError) as error:
                raise self._lose(target, str(error)) from error
            except ModbusException as error:
                raise self._miss(target) from error
            self._silent[target.unit_id] = 0
            return reply

    def _miss(self, target: Target) -> DeviceError:
        self._silent[target.unit_id] = silent = self._silent.get(target.unit_id, 0) + 1
        self.doubtful = True
        if silent >= LOST_AFTER:
            return self._lose(target, f"no reply ({self._excerpt()})")
        return DeviceTimeout(
            f"{target.axis} (station {target.unit_id} at {self._place}) did not reply ({self._excerpt()}).",
            "Check power, cable, station number and baud rate.",
        )

    def _lose(self, target: Target, reason: str) -> DeviceLost:
        """Return the error, and believe this station no more: what is found at its port later may be another device, or not referenced."""
        self._lost.setdefault(target.unit_id, reason)
        return DeviceLost(
            f"{target.axis} (station {target.unit_id} at {self._place}) does not answer any more: {self._lost[target.unit_id]}.",
            "Check power, cable, station number and baud rate; connect again, and find the reference anew if the drive lost it.",
        )

    def _excerpt(self) -> str:
        heard = self._heard[:EXCERPT_BYTES].hex(" ")
        return f"received {heard}{' …' if len(self._heard) > EXCERPT_BYTES else ''}" if heard else "received nothing"

    def _trace(self, sending: bool, data: bytes) -> bytes:
        if not sending:
            self._heard = data
        return data


def open_line(table: Mapping[str, object], drive: DriveMap) -> ModbusLine:
    """Open the line that a table ``[links.NAME]`` describes, in the framing of the first drive on it.

    Raises
    ------
    InputError
        A setting is invalid, or the port is not named.
    DeviceError
        It cannot be opened.
    """
    try:
        chosen = LineSettings.model_validate(dict(table))
    except ValidationError as error:
        raise InputError(f"[links]: {first_problem(error, 'the line')}.", "Correct it in the rig description.") from error
    from pymodbus import FramerType
    from pymodbus.client import ModbusSerialClient, ModbusTcpClient

    framing = FramerType(drive.framing if chosen.framing == "map" else chosen.framing)
    if chosen.host:
        framer = framing if chosen.framing != "map" else FramerType.SOCKET

        def over_tcp(trace: Callable[[bool, bytes], bytes]) -> Any:
            return ModbusTcpClient(
                chosen.host, port=chosen.tcp_port, framer=framer, timeout=chosen.reply_timeout_s, retries=0, trace_packet=trace
            )

        return ModbusLine(over_tcp, f"{chosen.host}:{chosen.tcp_port}", serial=False)
    port = chosen.port or find_port(chosen.usb_serial)

    def over_serial(trace: Callable[[bool, bytes], bytes]) -> Any:
        return ModbusSerialClient(
            port,
            framer=framing,
            baudrate=chosen.baudrate or drive.baudrate,
            parity=chosen.parity or drive.parity,
            timeout=chosen.reply_timeout_s,
            retries=0,
            trace_packet=trace,
        )

    return ModbusLine(over_serial, port, serial=True)
