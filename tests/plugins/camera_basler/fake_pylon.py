"""A stand-in for pypylon where its emulation has nothing: chunks, trigger lines, other owners, loss, packets, values that are ignored.

It offers only the calls that the driver makes, under pylon's names. Every write to a camera is noted in order.
"""

# ruff: noqa: N802  (pylon's names)
from __future__ import annotations

import threading
import time
from collections import deque
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from types import SimpleNamespace
from typing import Any

import numpy as np

HELD = "Failed to open. The device is controlled by another application. Err: access denied (0xE1018006)"


class PylonError(Exception):
    """Stands for pylon's GenericException."""


class Node:
    """One node; ``accept`` turns what is written into what the camera keeps."""

    def __init__(
        self, value: Any, words: tuple[str, ...] = (), low: float = 0, high: float = 2**32, step: float | None = 1, is_writable: bool = True
    ) -> None:
        self.value, self.words, self.low, self.high, self.step = value, words, low, high, step
        self.name, self.writes, self.is_writable = "", [], is_writable
        self.accept: Callable[[Any], Any] = lambda value: value

    def IsReadable(self) -> bool:
        return self.value is not None

    def IsWritable(self) -> bool:
        return self.is_writable

    def GetValue(self, *_: bool) -> Any:
        return self.value

    def ToString(self, *_: bool) -> str:
        return str(self.value)

    def SetValue(self, value: Any) -> None:
        if not self.words and not isinstance(value, bool) and not self.low <= value <= self.high:
            raise PylonError(f"Value {value} must be between {self.low} and {self.high}. : OutOfRangeException (file 'FloatT.h')")
        self.writes.append((self.name, value))
        self.value = self.accept(value)

    def Execute(self) -> None:
        self.writes.append((self.name, "execute"))

    def GetSymbolics(self) -> tuple[str, ...]:
        return self.words

    def GetMin(self) -> float:
        return self.low

    def GetMax(self) -> float:
        return self.high

    def HasInc(self) -> bool:
        return self.step is not None

    def GetInc(self) -> float:
        return self.step or 0


class NodeMap:
    """Nodes by name; the writes of all of them in one list."""

    def __init__(self, nodes: Mapping[str, Node]) -> None:
        self.nodes, self.writes = dict(nodes), []
        for name, node in self.nodes.items():
            node.name, node.writes = name, self.writes

    def GetNode(self, name: str) -> Node | None:
        return self.nodes.get(name)

    def __getitem__(self, name: str) -> Any:
        return self.nodes[name].value


def ace_gige(**changed: Node) -> NodeMap:
    """An acA2500-14gm: names of SFNC 1.x."""
    nodes = {
        **_common(("AcquisitionStart", "FrameStart"), ("Mono8", "Mono12", "Mono12Packed")),
        "ExposureTimeAbs": Node(35_000.0, low=35.0, high=9_999_990.0, step=None),
        "ExposureTimeBaseAbs": Node(35.0),
        "GainRaw": Node(50, low=0, high=63),
        "BlackLevelRaw": Node(4, low=0, high=63),
        "ShutterMode": Node("Rolling", ("Rolling", "GlobalResetRelease")),
        "ReadoutTimeAbs": Node(68_530.0, is_writable=False),
        "LineDebouncerTimeAbs": Node(0.0, step=None),
        "TemperatureAbs": Node(41.5, is_writable=False),
        "GevSCPSPacketSize": Node(1500, low=220, high=16_404, step=4),
        "GevSCPD": Node(0),
        "GevTimestampTickFrequency": Node(125_000_000, is_writable=False),
        "ChunkSelector": Node("Image", ("Image", "Timestamp", "ExposureTime", "Frametriggerignoredcounter", "PayloadCRC16")),
        "ChunkModeActive": Node(False),
        "ChunkEnable": Node(False),
        "ActionDeviceKey": Node(0),
        "ActionGroupKey": Node(0),
        "ActionGroupMask": Node(0),
    }
    return NodeMap({**nodes, **changed})


def ace_2_usb(**changed: Node) -> NodeMap:
    """An ace 2 with USB: names of SFNC 2.x, no chunks in this fake, a global shutter."""
    nodes = {
        **_common(("FrameBurstStart", "FrameStart"), ("Mono8", "Mono10", "Mono10p", "Mono12", "Mono12p")),
        "ExposureTime": Node(5000.0, low=19.0, high=10_000_000.0, step=1.0),
        "Gain": Node(3.0, low=0.0, high=48.0, step=None),
        "BlackLevel": Node(0.0, low=0.0, high=31.0, step=None),
        "SensorShutterMode": Node("Global", ("Global",)),
        "SensorReadoutTime": Node(14_200.0, is_writable=False),
        "LineDebouncerTime": Node(0.0, step=None),
        "DeviceTemperature": Node(38.25, is_writable=False),
        "DeviceTemperatureSelector": Node("Sensor", ("Sensor", "Coreboard")),
    }
    return NodeMap({**nodes, **changed})


def _common(triggers: tuple[str, ...], formats: tuple[str, ...]) -> dict[str, Node]:
    switch = ("Off", "On")
    return {
        "UserSetSelector": Node("UserSet1", ("Default", "UserSet1")),
        "UserSetLoad": Node(0),
        "ExposureAuto": Node("Continuous", ("Off", "Once", "Continuous")),
        "GainAuto": Node("Continuous", ("Off", "Once", "Continuous")),
        "AcquisitionMode": Node("SingleFrame", ("SingleFrame", "Continuous")),
        "TriggerSelector": Node(triggers[0], triggers),
        "TriggerMode": Node("Off", switch),
        "TriggerSource": Node("Line1", ("Software", "Line1", "Action1")),
        "TriggerActivation": Node("RisingEdge", ("RisingEdge", "FallingEdge")),
        "ExposureMode": Node("Timed", ("Timed", "TriggerWidth")),
        "LineSelector": Node("Line1", ("Line1", "Line2")),
        "PixelFormat": Node("Mono8", formats),
        "OffsetX": Node(0, high=2592),
        "OffsetY": Node(0, high=1944),
        "Width": Node(2592, low=16, high=2592),
        "Height": Node(1944, low=1, high=1944),
        "DeviceFirmwareVersion": Node("105656-13", is_writable=False),
    }


@dataclass
class Result:
    """A grab result. A damaged one has error code 0 and its full shape, as pylon's have."""

    pixels: np.ndarray
    block: int
    exposure_us: float
    ignored: int = 0
    succeeded: bool = True
    payload: int | None = None
    ticks: int = 0
    context: int = 0
    has_chunks: bool = True
    crc_ok: bool = True
    released: list[int] = field(default_factory=list)

    def IsValid(self) -> bool:
        return True

    def GrabSucceeded(self) -> bool:
        return self.succeeded

    def GetErrorCode(self) -> int:
        return 0

    def GetErrorDescription(self) -> str:
        return ""

    def GetBlockID(self) -> int:
        return self.block

    def GetPayloadSize(self) -> int:
        return self.pixels.nbytes if self.payload is None else self.payload

    def GetArray(self) -> np.ndarray:
        return self.pixels.copy()

    def GetTimeStamp(self) -> int:
        return self.ticks

    def GetCameraContext(self) -> int:
        return self.context

    def HasCRC(self) -> bool:
        return self.has_chunks

    def CheckCRC(self) -> bool:
        return self.crc_ok

    def IsChunkDataAvailable(self) -> bool:
        return self.has_chunks

    def GetChunkDataNodeMap(self) -> NodeMap:
        return NodeMap({"ChunkExposureTime": Node(self.exposure_us), "ChunkFrameTriggerIgnoredCounter": Node(self.ignored)})

    def Release(self) -> None:
        self.released.append(self.block)


class FakeCamera:
    """The camera and its InstantCamera in one.

    ``spoil`` changes what arrives for one trigger: it gets the result and returns what is sent in its place, in order.
    """

    def __init__(self, serial: str, nodes: NodeMap | None = None, first_block: int = 1) -> None:
        self.serial, self.nodes, self.first_block = serial, nodes or ace_gige(), first_block
        self.spoil: Callable[[Result], list[Result]] = lambda result: [result]
        self.held_for_s = 0.0  # by another program, from the first attempt to open it on
        self.is_removed = False
        self.retrieve_blocks = threading.Event()  # calls never return while it is set
        self.control_blocks = threading.Event()
        self.attempts = self.closed = self.ignored = 0
        self.released: list[int] = []
        self.stream = NodeMap({name: Node(0) for name in PACKET_COUNTERS})
        self.instant = NodeMap({"MaxNumBuffer": Node(10)})
        self._held_until: float | None = None
        self._arrived = threading.Condition()
        self._results: deque[Result] = deque()
        self._is_grabbing, self._block, self._context = False, 0, 0

    def fire(self) -> None:
        """One trigger pulse, or one software trigger: the image arrives at once."""
        exposure = self.nodes.nodes.get("ExposureTimeAbs") or self.nodes.nodes["ExposureTime"]
        pixels = np.full((self.nodes["Height"], self.nodes["Width"]), 7, np.uint8)
        made = Result(pixels, self._block, exposure.value, self.ignored, ticks=self._block * 125_000, context=self._context)
        made.has_chunks, made.released = "ChunkSelector" in self.nodes.nodes, self.released
        self._block += 1
        self.stream.nodes["Statistic_Total_Packet_Count"].value += 1000
        with self._arrived:
            self._results.extend(self.spoil(made))
            self._arrived.notify_all()

    def Open(self) -> None:
        self.attempts += 1
        if self._held_until is None:
            self._held_until = time.monotonic() + self.held_for_s
        if time.monotonic() < self._held_until:
            raise PylonError(HELD)

    def Close(self) -> None:
        self._wait_while(self.control_blocks)
        self.closed += 1

    def IsGigE(self) -> bool:
        return "GevSCPD" in self.nodes.nodes

    def SetCameraContext(self, context: int) -> None:
        self._context = context

    def GetNodeMap(self) -> NodeMap:
        return self.nodes

    def GetInstantCameraNodeMap(self) -> NodeMap:
        return self.instant

    def GetStreamGrabberNodeMap(self) -> NodeMap:
        return self.stream

    def StartGrabbing(self, _: object) -> None:
        self._is_grabbing, self._block = True, self.first_block
        self._results.clear()
        for node in self.stream.nodes.values():
            node.value = 0

    def StopGrabbing(self) -> None:
        self._is_grabbing = False

    def IsGrabbing(self) -> bool:
        return self._is_grabbing

    def IsCameraDeviceRemoved(self) -> bool:
        self._wait_while(self.control_blocks)
        return self.is_removed

    def CanWaitForFrameTriggerReady(self) -> bool:
        return True

    def WaitForFrameTriggerReady(self, timeout_ms: int, _: object) -> bool:
        self._wait_while(self.control_blocks)
        return True

    def ExecuteSoftwareTrigger(self) -> None:
        self._wait_while(self.control_blocks)
        self.fire()

    def RetrieveResult(self, timeout_ms: int, _: object) -> Any:
        self._wait_while(self.retrieve_blocks)
        with self._arrived:
            self._arrived.wait_for(lambda: bool(self._results), timeout_ms / 1000)
            return self._results.popleft() if self._results else SimpleNamespace(IsValid=lambda: False)

    def _wait_while(self, blocks: threading.Event) -> None:
        while blocks.is_set():
            time.sleep(0.005)


PACKET_COUNTERS = (
    "Statistic_Total_Packet_Count",
    "Statistic_Failed_Packet_Count",
    "Statistic_Resend_Packet_Count",
    "Statistic_Buffer_Underrun_Count",
)


@dataclass(frozen=True)
class Info:
    """Device information."""

    camera: FakeCamera
    address: str

    def GetSerialNumber(self) -> str:
        return self.camera.serial

    def GetModelName(self) -> str:
        return "acA2500-14gm"

    def GetPropertyValue(self, name: str) -> tuple[bool, str]:
        return bool(self.address), self.address


class FakePylon:
    """The module, with the cameras that are there."""

    GrabStrategy_OneByOne = "one by one"
    TimeoutHandling_Return = "return"

    def __init__(self, *cameras: FakeCamera) -> None:
        infos = [Info(camera, f"192.168.0.{number}") for number, camera in enumerate(cameras, 11)]
        factory = SimpleNamespace(EnumerateDevices=lambda: infos, CreateDevice=lambda info: info.camera)
        self.TlFactory = SimpleNamespace(GetInstance=lambda: factory)

    def InstantCamera(self, camera: FakeCamera) -> FakeCamera:
        return camera


def damaged(result: Result) -> Result:
    """A buffer whose packets did not all arrive."""
    return replace(result, succeeded=False, payload=result.pixels.nbytes // 10)
