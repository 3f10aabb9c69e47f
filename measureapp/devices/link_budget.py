"""Bandwidth of an Ethernet link that several GigE Vision cameras share.

An image is sent in ``n = ceil(B / (P - 36))`` packets of P bytes, 36 of which are the headers of IP, UDP and GVSP. On the wire a packet
takes 38 bytes more: Ethernet header and check sequence, preamble and gap. A camera pauses between two packets for its inter-packet delay
(GevSCPD), which leaves the link to the others.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil
from typing import Protocol, runtime_checkable

HEADER_BYTES = 36  # IP 20, UDP 8, GVSP 8
FRAMING_BYTES = 38  # Ethernet header 14, check sequence 4, preamble and gap 20
GIGABIT = 1e9  # bit/s
TICK_HZ = 125e6  # of the inter-packet delay, where a camera does not report it
RESEND_RESERVE = 0.10  # of the time between two images, for packets that are sent again


@dataclass(frozen=True, slots=True)
class LinkCamera:
    """What one camera sends over its link."""

    name: str
    image_bytes: int
    packet_bytes: int = 1500  # GevSCPSPacketSize: headers of IP, UDP and GVSP included
    delay_ticks: int = 0  # GevSCPD
    tick_hz: float = TICK_HZ
    link: str = "ethernet"  # cameras of the same link share its bandwidth


@runtime_checkable
class OnLink(Protocol):
    """A connected camera that reports what it sends over its link."""

    link: LinkCamera


def packets(image_bytes: int, packet_bytes: int) -> int:
    """Return the number of packets of one image."""
    return ceil(image_bytes / (packet_bytes - HEADER_BYTES))


def packet_s(packet_bytes: int, bit_per_s: float = GIGABIT) -> float:
    """Return how long one packet occupies the link."""
    return (packet_bytes + FRAMING_BYTES) * 8.0 / bit_per_s


def frame_s(camera: LinkCamera, bit_per_s: float = GIGABIT) -> float:
    """Return how long the camera sends one image, its inter-packet delays included."""
    step_s = packet_s(camera.packet_bytes, bit_per_s) + camera.delay_ticks / camera.tick_hz
    return packets(camera.image_bytes, camera.packet_bytes) * step_s


def delay_ticks(packet_bytes: int, cameras: int, tick_hz: float = TICK_HZ, bit_per_s: float = GIGABIT) -> int:
    """Return the least inter-packet delay (GevSCPD) with which ``cameras`` equal cameras fill their link when all send at once."""
    return ceil((cameras - 1) * packet_s(packet_bytes, bit_per_s) * tick_hz - 1e-6)


def check_link(cameras: Sequence[LinkCamera], period_s: float | None = None, bit_per_s: float = GIGABIT) -> tuple[str, ...]:
    """Return what does not fit the links, one sentence for each problem.

    Parameters
    ----------
    cameras : of one or several links
    period_s : shortest time between two images of a camera, exposure and read-out included; None: one image now and then

    Returns
    -------
    tuple[str, ...] : empty if every link carries its cameras
    """
    links: dict[str, list[LinkCamera]] = {}
    for camera in cameras:
        links.setdefault(camera.link, []).append(camera)
    problems: list[str] = []
    for name, members in links.items():
        problems += _check_share(name, members, bit_per_s)
        problems += _check_period(name, members, period_s, bit_per_s)
    return tuple(problems)


def _check_share(link: str, cameras: Sequence[LinkCamera], bit_per_s: float) -> list[str]:
    """Find cameras that together send more than the link carries, which loses packets."""
    share = 0.0
    for camera in cameras:
        wire_s = packet_s(camera.packet_bytes, bit_per_s)
        share += wire_s / (wire_s + camera.delay_ticks / camera.tick_hz)
    if share <= 1.0 + 1e-4:
        return []
    needed = max(delay_ticks(camera.packet_bytes, len(cameras), camera.tick_hz, bit_per_s) for camera in cameras)
    return [
        f"Cameras {_names(cameras)} together send at {100 * share:.0f} % of link {link} ({bit_per_s / 1e9:g} Gbit/s) and lose packets: "
        f"set an inter-packet delay of {needed} ticks in each."
    ]


def _check_period(link: str, cameras: Sequence[LinkCamera], period_s: float | None, bit_per_s: float) -> list[str]:
    """Find images that come faster than the link carries them."""
    longest_s = max(frame_s(camera, bit_per_s) for camera in cameras)
    if period_s is None or longest_s * (1.0 + RESEND_RESERVE) <= period_s:
        return []
    if longest_s <= period_s:
        return [
            f"On link {link} an image is transferred in {longest_s * 1e3:.1f} ms of the {period_s * 1e3:.1f} ms between two images, "
            f"which leaves less than {100 * RESEND_RESERVE:.0f} % for packets that are sent again: use larger packets or a longer exposure."
        ]
    return [
        f"On link {link} an image is transferred in {longest_s * 1e3:.1f} ms, but the next one may be exposed after {period_s * 1e3:.1f} ms: "
        f"the sequence slows down to {longest_s * 1e3:.1f} ms an image; use larger packets, fewer bits or a second link."
    ]


def _names(cameras: Sequence[LinkCamera]) -> str:
    names = [camera.name for camera in cameras]
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"
