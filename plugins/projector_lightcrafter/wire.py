"""HID reports of the DLPC350: messages to reports of 64 bytes, and replies back."""

from __future__ import annotations

from dataclasses import dataclass

from measureapp.errors import DeviceError

REPORT_BYTES = 64
HEADER_BYTES = 4
READ, REPLY_WANTED, ERROR = 0x80, 0x40, 0x20
LONGEST_REPLY = 512  # the whole pattern table is 384 bytes
EXCERPT_BYTES = 16


@dataclass(frozen=True, slots=True)
class Header:
    """First four bytes of a message."""

    flags: int
    sequence: int
    length: int  # of what follows the header, in this and further reports

    @property
    def refused(self) -> bool:
        """Whether the controller refused the command."""
        return bool(self.flags & ERROR)


def message(command: int, data: bytes = b"", *, sequence: int, read: bool = False, reply: bool = True) -> list[bytes]:
    """Return the reports of one message, without the report id; the last is filled with zeros.

    Parameters
    ----------
    command : CMD2 in the high byte, CMD3 in the low one
    data : parameters, integers little-endian
    sequence : number that the reply repeats, 0…255
    read : a question; otherwise a command
    reply : the controller shall answer
    """
    flags = (READ if read else 0) | (REPLY_WANTED if reply else 0)
    length = 2 + len(data)
    header = bytes([flags, sequence]) + length.to_bytes(2, "little")
    whole = header + bytes([command & 0xFF, command >> 8]) + data
    return [whole[start : start + REPORT_BYTES].ljust(REPORT_BYTES, b"\0") for start in range(0, len(whole), REPORT_BYTES)]


def parse_header(report: bytes, name: str) -> Header:
    """Read the header of the first report of a reply.

    Raises
    ------
    DeviceError
        The report is too short, or states a length that no reply has.
    """
    if len(report) < HEADER_BYTES:
        raise _malformed(report, name, f"has {len(report)} bytes, and a reply begins with {HEADER_BYTES}")
    length = int.from_bytes(report[2:4], "little")
    if length > LONGEST_REPLY:
        raise _malformed(report, name, f"states a length of {length} bytes; the longest reply has {LONGEST_REPLY}")
    return Header(report[0], report[1], length)


def missing_bytes(header: Header, reports: bytes) -> int:
    """Return how many bytes of a reply are still to come."""
    return max(0, HEADER_BYTES + header.length - len(reports))


def payload(header: Header, reports: bytes) -> bytes:
    """Return the data of a complete reply."""
    return reports[HEADER_BYTES : HEADER_BYTES + header.length]


def check_length(data: bytes, expected: int, name: str, what: str) -> bytes:
    """Return ``data`` when it has the expected length. Raises DeviceError."""
    if len(data) != expected:
        raise _malformed(data, name, f"to {what} has {len(data)} bytes of data instead of {expected}")
    return data


def excerpt(report: bytes) -> str:
    """Return the first bytes in hexadecimal notation."""
    more = " …" if len(report) > EXCERPT_BYTES else ""
    return (report[:EXCERPT_BYTES].hex(" ") or "nothing") + more


def _malformed(report: bytes, name: str, problem: str) -> DeviceError:
    return DeviceError(
        f"{name}: a reply {problem} ({excerpt(report)}).",
        "Check the USB cable, and close other programs that use the projector.",
    )
