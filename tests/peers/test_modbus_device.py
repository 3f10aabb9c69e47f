"""The virtual Modbus device against clients that others wrote."""

from __future__ import annotations

import shutil
import subprocess

import pytest
from pymodbus import FramerType
from pymodbus.client import ModbusSerialClient, ModbusTcpClient

from measureapp.peers.modbus_axis import Drive, SimpleMemory, ToyoMemory
from measureapp.peers.modbus_device import ModbusDevice, on_serial, on_tcp

needs_mbpoll = pytest.mark.skipif(shutil.which("mbpoll") is None, reason="needs mbpoll (libmodbus): apt-get install mbpoll")


@pytest.mark.parametrize("framing", ["rtu", "ascii"])
def test_pymodbus_reads_and_writes_it_over_a_serial_line(framing: str) -> None:
    drive = Drive(counts=-70_000)
    with on_serial(ModbusDevice(ToyoMemory(drive)), framing) as port:  # type: ignore[arg-type]
        client = ModbusSerialClient(port, framer=FramerType(framing), timeout=1, retries=0)
        assert client.connect()
        high, low = client.read_holding_registers(0x100A, count=2).registers
        assert (high << 16 | low) - (1 << 32) == -70_000
        assert not client.write_registers(0x2002, [0, 1500]).isError()
        assert client.write_register(0x201E, 77).exception_code == 3
        assert client.read_holding_registers(0x5000, count=1).exception_code == 2
        assert not client.write_register(0x201E, 1).isError()
        client.close()
    assert drive.moves == [1500]


def test_pymodbus_reads_and_writes_it_over_tcp() -> None:
    drive = Drive()
    with on_tcp(ModbusDevice(SimpleMemory(drive))) as port:
        client = ModbusTcpClient("127.0.0.1", port=port, timeout=1, retries=0)
        assert client.connect()
        assert client.read_holding_registers(0, count=1).registers == [0x4D41]
        assert client.read_input_registers(0x12, count=1).registers == [0b0110]
        client.close()


@needs_mbpoll
def test_mbpoll_reads_and_writes_it_over_tcp() -> None:
    drive = Drive(counts=123_456)
    with on_tcp(ModbusDevice(SimpleMemory(drive))) as port:
        common = ["mbpoll", "-m", "tcp", "-p", str(port), "-a", "1", "-0", "-1"]
        read = subprocess.run(
            [*common, "-t", "3", "-r", "16", "-c", "2", "127.0.0.1"], capture_output=True, text=True, timeout=20, check=False
        )
        assert "[16]: \t1" in read.stdout
        assert "[17]: \t57920" in read.stdout.replace(" (-7616)", "")
        write = subprocess.run(
            [*common, "-t", "4", "-r", "32", "127.0.0.1", "0", "900"], capture_output=True, text=True, timeout=20, check=False
        )
        assert write.returncode == 0, write.stdout
        assert drive.long(0x20) == 900


@needs_mbpoll
def test_mbpoll_reads_it_over_a_serial_line() -> None:
    with on_serial(ModbusDevice(ToyoMemory(Drive(counts=4321))), "rtu") as port:
        command = ["mbpoll", "-m", "rtu", "-b", "19200", "-P", "none", "-a", "1", "-0", "-1", "-t", "4", "-r", str(0x100A), "-c", "2", port]
        found = subprocess.run(command, capture_output=True, text=True, timeout=20, check=False)
        assert "[4107]: \t4321" in found.stdout, found.stdout + found.stderr
