"""The controller's commands, status bits and limits, as the programmer's guide of the DLPC350 states them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from enum import IntEnum

VENDOR_ID, PRODUCT_ID, INTERFACE = 0x0451, 0x6401, 0
WIDTH_PX, HEIGHT_PX = 912, 1140  # diamond pixels: every second row is offset by half a column


class Command(IntEnum):
    """Code of a command: CMD2 in the high byte, CMD3 in the low one."""

    STANDBY = 0x0200
    VERSION = 0x0205
    LED_CURRENTS = 0x0B01
    LED_ENABLE = 0x1A07
    HARDWARE_STATUS = 0x1A0A
    SYSTEM_STATUS = 0x1A0B
    MAIN_STATUS = 0x1A0C
    VALIDATE = 0x1A1A
    DISPLAY_MODE = 0x1A1B
    TRIGGER_OUT_1 = 0x1A1D
    TRIGGER_OUT_2 = 0x1A1E
    PATTERN_SOURCE = 0x1A22
    TRIGGER_MODE = 0x1A23
    START_STOP = 0x1A24
    TIMES = 0x1A29
    SEQUENCE = 0x1A31
    MAILBOX_ADDRESS = 0x1A32
    MAILBOX = 0x1A33
    MAILBOX_DATA = 0x1A34
    LOAD_TIME = 0x1A3A
    FLASH_IMAGES = 0x1A42


class Mailbox(IntEnum):
    """The tables that are written through the mailbox."""

    CLOSED = 0
    IMAGES = 1
    PATTERNS = 2


PATTERN_MODE = 1  # of DISPLAY_MODE
FROM_VIDEO, FROM_FLASH = 0, 3  # of PATTERN_SOURCE
BY_VSYNC, BY_ITSELF = 0, 1  # of TRIGGER_MODE
STOP, START = 0, 2  # of START_STOP
LEDS_OFF, LEDS_BY_SEQUENCER = 0x00, 0x08  # of LED_ENABLE
LEDS: Mapping[str, int] = {"red": 1, "green": 2, "blue": 4, "white": 7}
INTERNAL_TRIGGER, EXTERNAL_TRIGGER = 0, 1  # of an entry of the pattern table
WHITE_FIELD, WHITE_FIELD_BITS = 24, 1  # pattern number that lights all mirrors, whatever the image

SHORTEST_EXPOSURE_US: Mapping[int, int] = {1: 235, 2: 700, 3: 1570, 4: 1700, 5: 2000, 6: 2500, 7: 4500, 8: 8333}  # by bit depth
DARK_GAP_US = 230  # what the sequencer needs between the end of an exposure and the next pattern
MOST_PATTERNS, MOST_IMAGES = 128, 64
PATTERNS_PER_IMAGE = 3  # of 8 bits, in an image of 24
LOAD_TICKS_PER_MS = 18667
EDGE_STEP_NS, EDGE_ZERO, EDGE_LAST = 107.2, 0xBB, 0xD5  # delay of an edge of a trigger output, in counts

PARKED, SEQUENCER_RUNS, FROZEN = 0x01, 0x02, 0x04  # of MAIN_STATUS
MEMORY_TEST_PASSED = 0x01  # of SYSTEM_STATUS
INITIALISED = 0x01  # of HARDWARE_STATUS
HARDWARE_FAULTS: Mapping[int, str] = {
    0x04: "the controller of the mirrors reports an error",
    0x08: "an image buffer was swapped too late",
    0x40: "the sequencer stopped before the end of the sequence",
    0x80: "the sequencer reports an error",
}
BUSY = 0x80  # of VALIDATE
VALIDATION: Mapping[int, str] = {
    0x01: "the exposure or the period is not valid",
    0x02: "the table has a pattern number that is not valid",
    0x04: "trigger output 1 stays high, or black fields overlap",
    0x08: "a pattern that waits for an external trigger follows without a black field",
    0x10: f"the period exceeds the exposure by less than {DARK_GAP_US} µs",
}


def sentences(bits: int, meanings: Mapping[int, str]) -> str:
    """Return the meanings of all bits that are set, joined to one sentence part; empty if none is."""
    found: Sequence[str] = [text for bit, text in meanings.items() if bits & bit]
    unknown = bits & ~sum(meanings)
    return "; ".join([*found, *([f"unknown bits 0x{unknown:02X}"] if unknown else [])])
