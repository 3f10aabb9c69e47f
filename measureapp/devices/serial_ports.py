"""Serial ports by what stays the same: the serial number of their USB adapter."""

from __future__ import annotations

from measureapp.errors import DeviceError


def find_port(usb_serial: str) -> str:
    """Return the port of the USB adapter with this serial number, whatever its name is now.

    Raises
    ------
    DeviceError
        No such adapter, or more than one; names those that are connected.
    """
    from serial.tools.list_ports import comports  # type: ignore[import-untyped]

    here = sorted((str(entry.serial_number), str(entry.device)) for entry in comports() if entry.serial_number)
    fitting = [device for number, device in here if usb_serial and number == usb_serial]
    if len(fitting) == 1:
        return fitting[0]
    listed = ", ".join(f"{device} ({number})" for number, device in here) or "none"
    if fitting:
        raise DeviceError(
            f"{len(fitting)} serial ports have the USB serial number {usb_serial!r} (adapters here: {listed}).",
            "Set port in [links] instead of usb_serial.",
        )
    wanted = f"serial number {usb_serial!r}" if usb_serial else "a port, a host or a USB serial number"
    raise DeviceError(
        f"No serial adapter with {wanted} was found (adapters here: {listed}).", "Plug it in, or set port, host or usb_serial in [links]."
    )
