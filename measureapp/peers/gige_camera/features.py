"""Features of the virtual camera, and their description as GenICam XML (GenApi 1.0)."""

from __future__ import annotations

import struct
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

FIRST_ADDRESS, SLOT_BYTES = 0x8000, 8
INTEGER, FLOAT = ">I", ">d"
CHUNK_EXPOSURE_ID = 0x1A
PIXEL_FORMATS = {
    "Mono8": 0x01080001,
    "Mono10": 0x01100003,
    "Mono12": 0x01100005,
    "Mono12Packed": 0x010C0006,
    "Mono12p": 0x010C0047,
    "Mono16": 0x01100007,
}
HEAD = """<?xml version="1.0" encoding="utf-8"?>
<RegisterDescription ModelName="Virtual" VendorName="MeasureApp" StandardNameSpace="None" SchemaMajorVersion="1" SchemaMinorVersion="1"
 SchemaSubMinorVersion="0" MajorVersion="1" MinorVersion="0" SubMinorVersion="0" ToolTip="" ProductGuid="0" VersionGuid="0"
 xmlns="http://www.genicam.org/GenApi/Version_1_1">
<Port Name="Device"/>
"""


@dataclass(frozen=True, slots=True)
class Feature:
    """A feature in a register of its own."""

    kind: str  # Integer, Float, Enumeration, Boolean, Command
    start: float = 0
    low: float = 0
    high: float = 2**31 - 1
    entries: Mapping[str, int] = field(default_factory=dict)


def choice(*names: str) -> Feature:
    """Return an enumeration of these names; it starts with the first one."""
    return Feature("Enumeration", entries={name: value for value, name in enumerate(names)})


def features(width_px: int, height_px: int) -> dict[str, Feature]:
    """Return the features of a camera with this sensor."""
    return {
        "Width": Feature("Integer", width_px, 4, width_px),
        "Height": Feature("Integer", height_px, 4, height_px),
        "OffsetX": Feature("Integer", 0, 0, width_px),
        "OffsetY": Feature("Integer", 0, 0, height_px),
        "PixelFormat": Feature("Enumeration", PIXEL_FORMATS["Mono8"], entries=PIXEL_FORMATS),
        "PayloadSize": Feature("Integer"),
        "AcquisitionMode": choice("Continuous", "SingleFrame"),
        "AcquisitionStart": Feature("Command"),
        "AcquisitionStop": Feature("Command"),
        "AcquisitionStatusSelector": choice("FrameTriggerWait", "FrameActive"),
        "AcquisitionStatus": Feature("Boolean"),
        "TriggerSelector": choice("FrameStart"),
        "TriggerMode": choice("Off", "On"),
        "TriggerSource": choice("Line1", "Software"),
        "TriggerActivation": choice("RisingEdge", "FallingEdge"),
        "TriggerSoftware": Feature("Command"),
        "LineDebouncerTime": Feature("Float", 0, 0, 1000),
        "ExposureMode": choice("Timed"),
        "ExposureAuto": choice("Continuous", "Off"),
        "ExposureTime": Feature("Float", 5000, 20, 1_000_000),
        "SensorReadoutTime": Feature("Float", 2000),
        "SensorShutterMode": choice("Rolling"),
        "Gain": Feature("Float", 0, 0, 24),
        "GainAuto": choice("Continuous", "Off"),
        "DeviceTemperature": Feature("Float", 41.5),
        "UserSetSelector": choice("Default"),
        "UserSetLoad": Feature("Command"),
        "ChunkModeActive": Feature("Boolean"),
        "ChunkSelector": choice("ExposureTime"),
        "ChunkEnable": Feature("Boolean"),
    }


def addresses(names: Iterable[str]) -> dict[str, int]:
    """Return the address of each feature's register."""
    return {name: FIRST_ADDRESS + SLOT_BYTES * index for index, name in enumerate(names)}


def encoded(feature: Feature, value: float) -> bytes:
    """Return a value as its register holds it."""
    return struct.pack(FLOAT, value) if feature.kind == "Float" else struct.pack(INTEGER, int(value))


def decoded(feature: Feature, register: bytes) -> float:
    """Return the value that a register holds."""
    size = struct.calcsize(FLOAT if feature.kind == "Float" else INTEGER)
    return float(struct.unpack(FLOAT if feature.kind == "Float" else INTEGER, register[:size])[0])


def described(table: Mapping[str, Feature]) -> bytes:
    """Return the XML file that describes the features to any GenICam client."""
    where = addresses(table)
    nodes = "".join(_node(name, feature) + _register(name, feature, where[name]) for name, feature in table.items())
    chunk = (
        f'<Port Name="ExposureChunk"><ChunkID>{CHUNK_EXPOSURE_ID:x}</ChunkID></Port>\n'
        '<FloatReg Name="ChunkExposureTime"><Address>0</Address><Length>8</Length><AccessMode>RO</AccessMode>'
        "<pPort>ExposureChunk</pPort><Endianess>BigEndian</Endianess></FloatReg>\n"
    )
    category = "".join(f"<pFeature>{name}</pFeature>" for name in (*table, "ChunkExposureTime"))
    return f'{HEAD}<Category Name="Root">{category}</Category>\n{nodes}{chunk}</RegisterDescription>\n'.encode()


def _node(name: str, feature: Feature) -> str:
    value = f"<pValue>{name}Reg</pValue>"
    inner = {
        "Enumeration": "".join(f'<EnumEntry Name="{one}"><Value>{code}</Value></EnumEntry>' for one, code in feature.entries.items())
        + value,
        "Boolean": value + "<OnValue>1</OnValue><OffValue>0</OffValue>",
        "Command": value + "<CommandValue>1</CommandValue>",
    }.get(feature.kind, value + f"<Min>{feature.low}</Min><Max>{feature.high}</Max>")
    return f'<{feature.kind} Name="{name}">{inner}</{feature.kind}>\n'


def _register(name: str, feature: Feature, address: int) -> str:
    tag, length = ("FloatReg", 8) if feature.kind == "Float" else ("IntReg", 4)
    sign = "" if tag == "FloatReg" else "<Sign>Unsigned</Sign>"
    return (
        f'<{tag} Name="{name}Reg"><Address>{address}</Address><Length>{length}</Length><AccessMode>RW</AccessMode>'
        f"<pPort>Device</pPort><Cachable>NoCache</Cachable>{sign}<Endianess>BigEndian</Endianess></{tag}>\n"
    )
