"""The camera process: holds one camera through Aravis, answers calls on one pipe, and announces images on another.

It is a process of its own because a crash of the library or of its stream thread must not end a measurement; it imports nothing
but the standard library. It ends, and releases the camera, when its pipe closes: also when the program is killed.
"""

from __future__ import annotations

import ctypes
import mmap
import signal
import socket
import sys
import threading
import time
from contextlib import suppress
from ctypes import byref, c_double, c_int64, c_size_t, c_uint, c_uint32
from multiprocessing.connection import Connection
from typing import Any

from .aravis import Aravis, AravisError, text

TRANSPORTS = ("GigEVision", "USB3Vision")
# GigE Vision: control channel privilege, address of the primary application, heartbeat time-out
CONTROL_REGISTER, OWNER_REGISTER, HEARTBEAT_REGISTER = 0x0A00, 0x0A14, 0x0938
CONTROLLED = 0b11
SOCKET_BYTES, MOST_DESCRIPTORS = 8_000_000, 256
POP_US = 20_000
IMAGE_PAYLOADS = (1, 4, 5)  # image, and images with chunks
NEVER = 0


class CameraProcess:
    """The calls that the other side may make: every public method."""

    def __init__(self, memory: int, frames: Connection) -> None:
        self._arv = Aravis()
        self._memory, self._frames = memory, frames
        self._mapped: mmap.mmap | None = None
        self._address = self._slot_bytes = self._slots = 0
        self._camera = self._device = self._stream = self._parser = None
        self._sequence = 0
        self._streaming = threading.Event()
        self._thread: threading.Thread | None = None
        self._counted: dict[str, int] = {}  # of streams that have ended

    def cameras(self) -> list[dict[str, str]]:
        """Find all cameras: their id, vendor, model, serial number and address."""
        for index in range(self._arv.get_n_interfaces()):
            if text(name := self._arv.get_interface_id(index)) not in TRANSPORTS:
                self._arv.disable_interface(name)
        self._arv.update_device_list()
        fields = {"id": "id", "vendor": "vendor", "model": "model", "serial": "serial_nbr", "address": "address"}
        return [
            {key: text(getattr(self._arv, f"get_device_{name}")(index)) for key, name in fields.items()}
            for index in range(self._arv.get_n_devices())
        ]

    def open(self, device_id: str, wait_s: float) -> str:
        """Open a camera and take control; after ``wait_s`` without it return who holds the camera ("" if unknown), else "me"."""
        end = time.monotonic() + wait_s
        self._camera = self._arv.camera_new(device_id.encode())
        self._device = self._arv.camera_get_device(self._camera)
        while self._is_gige() and not self._arv.gv_device_is_controller(self._device):
            if time.monotonic() > end:
                return self._owner()
            time.sleep(0.1)
            try:
                self._arv.gv_device_take_control(self._device)
            except AravisError:
                continue
        return "me"

    def alive(self) -> None:
        """Read from the camera. Raises AravisError when it does not answer, or when this program does not control it any more."""
        if not self._is_gige():
            self._arv.camera_get_payload(self._camera)
            return
        controlled = self._register(CONTROL_REGISTER) & CONTROLLED and self._arv.gv_device_is_controller(self._device)
        try:  # only the program in control may write, and this writes what is there
            self._arv.device_write_register(self._device, HEARTBEAT_REGISTER, self._register(HEARTBEAT_REGISTER))
        except AravisError as error:
            controlled = controlled and error.lost
            if controlled:
                raise
        if not controlled:
            raise AravisError("it is no longer controlled by this program", lost=True)

    def available(self, feature: str) -> bool:
        """Tell whether the camera has a feature, and whether it is available now."""
        return bool(self._arv.camera_is_feature_available(self._camera, feature.encode()))

    def read(self, feature: str) -> Any:
        """Read a feature."""
        value = self._feature("get", feature)
        return text(value) if isinstance(value, bytes) else value

    def write(self, feature: str, value: Any) -> None:
        """Write a feature; an enumeration is written by name."""
        self._feature("set", feature, value.encode() if isinstance(value, str) else value)

    def bounds(self, feature: str) -> tuple[float, float, float]:
        """Return lowest and highest value of a number, and its step; 0: the camera states none."""
        kind = self._kind(feature)
        low, high = (c_double(), c_double()) if kind == "float" else (c_int64(), c_int64())
        self._feature("get", feature, byref(low), byref(high), suffix="_bounds")
        try:
            step = self._feature("get", feature, suffix="_increment")
        except AravisError as error:
            if error.lost:
                raise
            step = 0
        return low.value, high.value, step

    def entries(self, feature: str) -> list[str]:
        """List the values of an enumeration that are available now."""
        count = c_uint()
        array = self._arv.camera_dup_available_enumerations_as_strings(self._camera, feature.encode(), byref(count))
        return self._arv.strings(array, count.value)

    def execute(self, command: str) -> None:
        """Execute a command."""
        self._arv.camera_execute_command(self._camera, command.encode())

    def packets(self, size_bytes: int | None, delay_ns: int | None) -> tuple[int, int] | None:
        """Set size of packets (None: the largest that arrives) and pause between them; return both read back. None: not GigE Vision."""
        if not self._is_gige():
            return None
        if size_bytes is None:
            self._arv.camera_gv_auto_packet_size(self._camera)
        else:
            self._arv.camera_gv_set_packet_size(self._camera, size_bytes)
        if delay_ns is not None:
            self._arv.camera_gv_set_packet_delay(self._camera, delay_ns)
        self._arv.camera_gv_set_packet_size_adjustment(self._camera, NEVER)
        delay = self._arv.camera_gv_get_packet_delay(self._camera) if delay_ns is not None else 0
        return self._arv.camera_gv_get_packet_size(self._camera), delay

    def payload_bytes(self) -> int:
        """Size of an image with its chunks."""
        return int(self._arv.camera_get_payload(self._camera))

    def share(self, slots: int, slot_bytes: int) -> None:
        """Map the shared memory, which has ``slots`` places for images."""
        self._mapped = mmap.mmap(self._memory, slots * slot_bytes)
        self._address = ctypes.addressof(ctypes.c_char.from_buffer(self._mapped))
        self._slots, self._slot_bytes = slots, slot_bytes

    def start(self, sequence: int, exposure_chunk: str) -> None:
        """Start streaming, with a stream of its own: nothing of an earlier sequence can arrive in it."""
        self.stop()
        self._sequence = sequence
        self._stream = self._arv.camera_create_stream(self._camera, None, None)
        if self._is_gige():
            widen_socket(self._arv.gv_stream_get_port(self._stream), max(SOCKET_BYTES, 4 * self._slot_bytes))
        for slot in range(self._slots):
            self.give_back(slot, sequence)
        if exposure_chunk and self._parser is None:
            self._parser = self._arv.camera_create_chunk_parser(self._camera)
        self._streaming.set()
        self._thread = threading.Thread(target=self._announce, args=(exposure_chunk.encode(),), name="images")
        self._thread.start()
        self._arv.camera_start_acquisition(self._camera)

    def give_back(self, slot: int, sequence: int) -> None:
        """Let the place of an image be filled again."""
        if sequence == self._sequence and self._stream is not None:
            place = self._address + slot * self._slot_bytes
            self._arv.stream_push_buffer(self._stream, self._arv.buffer_new_full(self._slot_bytes, place, slot, None))

    def stop(self) -> None:
        """Stop streaming. Raises AravisError when the camera does not answer; the stream has ended all the same."""
        if self._stream is None:
            return
        try:
            self._arv.camera_stop_acquisition(self._camera)
        finally:
            self._streaming.clear()
            if self._thread is not None:
                self._thread.join()
            self._counted = self.statistics()
            self._arv.unref(self._stream)
            self._stream = None

    def statistics(self) -> dict[str, int]:
        """Read the counters of all streams until now."""
        counted = dict(self._counted)
        for index in range(self._arv.stream_get_n_infos(self._stream) if self._stream else 0):
            name = text(self._arv.stream_get_info_name(self._stream, index))
            counted[name] = counted.get(name, 0) + self._arv.stream_get_info_uint64(self._stream, index)
        return counted

    def close(self) -> None:
        """Stop streaming and release the camera."""
        try:
            self.stop()
            if self._camera is not None and self._is_gige() and self._arv.gv_device_is_controller(self._device):
                self._arv.gv_device_leave_control(self._device)
        finally:
            if self._camera is not None:
                self._arv.unref(self._camera)
                self._camera = None

    def _announce(self, exposure_chunk: bytes) -> None:
        """Pass on what is known of each image that arrives; runs in a thread, so that no call has to wait for an image."""
        with suppress(OSError):  # the program has ended
            while self._streaming.is_set():
                buffer = self._arv.stream_timeout_pop_buffer(self._stream, POP_US)
                if buffer:
                    self._frames.send(self._described(buffer, exposure_chunk))
                    self._arv.unref(buffer)

    def _described(self, buffer: int, exposure_chunk: bytes) -> dict[str, Any]:
        arv, size = self._arv, c_size_t()
        known: dict[str, Any] = {
            "sequence": self._sequence,
            "slot": arv.buffer_get_user_data(buffer),
            "status": arv.buffer_get_status(buffer),
            "block": arv.buffer_get_frame_id(buffer),
            "time_ns": arv.buffer_get_timestamp(buffer),
            "size": 0,
            "exposure_us": None,
        }
        if known["status"] == 0 and arv.buffer_get_payload_type(buffer) in IMAGE_PAYLOADS:
            known["start"] = (arv.buffer_get_image_data(buffer, byref(size)) or 0) - self._address
            known["size"] = size.value
            known["format"] = arv.buffer_get_image_pixel_format(buffer)
            known["width"], known["height"] = arv.buffer_get_image_width(buffer), arv.buffer_get_image_height(buffer)
            if exposure_chunk:
                with suppress(AravisError):  # an image without its chunk is found by the other side
                    known["exposure_us"] = arv.chunk_parser_get_float_value(self._parser, buffer, exposure_chunk)
        return known

    def _is_gige(self) -> bool:
        return bool(self._arv.camera_is_gv_device(self._camera))

    def _register(self, address: int) -> int:
        value = c_uint32()
        self._arv.device_read_register(self._device, address, byref(value))
        return value.value

    def _owner(self) -> str:
        try:
            address = self._register(OWNER_REGISTER)
        except AravisError:
            return ""
        return ".".join(str(byte) for byte in address.to_bytes(4, "big")) if address else ""

    def _kind(self, feature: str) -> str:
        node = self._arv.device_get_feature(self._device, feature.encode())
        if not node:
            raise AravisError(f"it has no feature {feature}")
        kinds = {"enumeration": "string", "string": "string", "boolean": "boolean", "float": "float", "integer": "integer"}
        for kind, access in kinds.items():
            if self._arv.is_a(node, getattr(self._arv, f"gc_{kind}_get_type")()):
                return access
        raise AravisError(f"its feature {feature} is no value")

    def _feature(self, verb: str, feature: str, *values: Any, suffix: str = "") -> Any:
        function = getattr(self._arv, f"camera_{verb}_{self._kind(feature)}{suffix}")
        return function(self._camera, feature.encode(), *values)


def widen_socket(port: int, size_bytes: int) -> None:
    """Enlarge the receive buffer of this process's socket on ``port``, as far as the system allows (net.core.rmem_max).

    The system's default holds a fraction of an image, and Aravis enlarges it only once the first image arrives.
    """
    for descriptor in range(3, MOST_DESCRIPTORS):
        with suppress(OSError), socket.fromfd(descriptor, socket.AF_INET, socket.SOCK_DGRAM) as candidate:
            if candidate.getsockname()[1:2] == (port,):
                candidate.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, size_bytes)


def serve(control: Connection, frames: Connection, memory: int) -> None:
    """Answer calls (number, method, arguments) by (number, result, error) until the pipe closes; error: None or (text, lost)."""
    process = CameraProcess(memory, frames)
    control.send((0, None, None))
    try:
        with suppress(EOFError, OSError):  # the program has closed its end, or has ended
            while True:
                number, method, arguments = control.recv()
                result, problem = None, None
                try:
                    result = getattr(process, method)(*arguments)
                except AravisError as error:
                    problem = (error.text, error.lost)
                control.send((number, result, problem))
    finally:
        process.close()


def main() -> None:
    """Run the camera process; its arguments are the file descriptors of both pipes and of the shared memory."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl+C is for the program, which then closes the pipe
    control, frames, memory = (int(argument) for argument in sys.argv[1:])
    pipe = Connection(control)
    try:
        serve(pipe, Connection(frames), memory)
    except AravisError as error:
        pipe.send((0, None, (error.text, False)))


if __name__ == "__main__":
    main()
