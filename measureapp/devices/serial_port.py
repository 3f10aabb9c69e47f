"""Serial adapters by the serial number of their USB interface, whatever their port is called now."""

from __future__ import annotations

from measureapp.errors import DeviceError


def find_port(usb_serial: str) -> str:
    """Return the port of the USB adapter with this serial number. Raises DeviceError with the adapters that are there."""
    from serial.tools.list_ports import comports  # type: ignore[import-untyped]

    found = {entry.serial_number: entry.device for entry in comports() if entry.serial_number}
    if usb_serial and usb_serial in found:
        return str(found[usb_serial])
    listed = ", ".join(f"{device} ({number})" for number, device in sorted(found.items())) or "none"
    wanted = f"serial number {usb_serial!r}" if usb_serial else "a port, a host or a USB serial number"
    raise DeviceError(
        f"No serial adapter with {wanted} was found (adapters here: {listed}).",
        "Plug it in, or correct port, host or usb_serial in the rig description.",
    )
