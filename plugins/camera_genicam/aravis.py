"""The functions of libaravis that the camera process calls, by ctypes.

Declarations follow the headers of Aravis 0.8, whose interface is stable within 0.8.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from ctypes import POINTER, byref, c_char_p, c_double, c_int, c_int64, c_size_t, c_uint, c_uint16, c_uint32, c_uint64, c_void_p
from typing import Any

LIBRARIES = ("libaravis-0.8.so.0", "libaravis-0.8.0.dylib", "libaravis-0.8-0.dll")
LOST = {"arv-device-error-quark": (2, 5, 10)}  # not connected, time-out, not the controller any more
# name of the function without "arv_": type of its result and of its arguments
PLAIN: dict[str, tuple[Any, ...]] = {
    "update_device_list": (None,),
    "get_n_devices": (c_uint,),
    "disable_interface": (None, c_char_p),
    "get_n_interfaces": (c_uint,),
    "get_interface_id": (c_char_p, c_uint),
    "get_device_id": (c_char_p, c_uint),
    "get_device_vendor": (c_char_p, c_uint),
    "get_device_model": (c_char_p, c_uint),
    "get_device_serial_nbr": (c_char_p, c_uint),
    "get_device_address": (c_char_p, c_uint),
    "shutdown": (None,),
    "camera_get_device": (c_void_p, c_void_p),
    "camera_is_gv_device": (c_int, c_void_p),
    "camera_gv_set_packet_size_adjustment": (None, c_void_p, c_int),
    "camera_create_chunk_parser": (c_void_p, c_void_p),
    "gv_stream_get_port": (c_uint16, c_void_p),
    "gv_device_is_controller": (c_int, c_void_p),
    "device_get_feature": (c_void_p, c_void_p, c_char_p),
    "gc_enumeration_get_type": (c_size_t,),
    "gc_string_get_type": (c_size_t,),
    "gc_boolean_get_type": (c_size_t,),
    "gc_float_get_type": (c_size_t,),
    "gc_integer_get_type": (c_size_t,),
    "buffer_new_full": (c_void_p, c_size_t, c_void_p, c_void_p, c_void_p),
    "buffer_get_user_data": (c_size_t, c_void_p),
    "buffer_get_status": (c_int, c_void_p),
    "buffer_get_payload_type": (c_int, c_void_p),
    "buffer_get_frame_id": (c_uint64, c_void_p),
    "buffer_get_timestamp": (c_uint64, c_void_p),
    "buffer_get_image_data": (c_void_p, c_void_p, POINTER(c_size_t)),
    "buffer_get_image_pixel_format": (c_uint32, c_void_p),
    "buffer_get_image_width": (c_int, c_void_p),
    "buffer_get_image_height": (c_int, c_void_p),
    "stream_push_buffer": (None, c_void_p, c_void_p),
    "stream_timeout_pop_buffer": (c_void_p, c_void_p, c_uint64),
    "stream_get_n_infos": (c_uint, c_void_p),
    "stream_get_info_name": (c_char_p, c_void_p, c_uint),
    "stream_get_info_uint64": (c_uint64, c_void_p, c_uint),
}
FAILING: dict[str, tuple[Any, ...]] = {  # their last argument is a GError **
    "camera_new": (c_void_p, c_char_p),
    "camera_create_stream": (c_void_p, c_void_p, c_void_p, c_void_p),
    "camera_start_acquisition": (None, c_void_p),
    "camera_stop_acquisition": (None, c_void_p),
    "camera_get_payload": (c_uint, c_void_p),
    "camera_is_feature_available": (c_int, c_void_p, c_char_p),
    "camera_execute_command": (None, c_void_p, c_char_p),
    "camera_get_boolean": (c_int, c_void_p, c_char_p),
    "camera_set_boolean": (None, c_void_p, c_char_p, c_int),
    "camera_get_string": (c_char_p, c_void_p, c_char_p),
    "camera_set_string": (None, c_void_p, c_char_p, c_char_p),
    "camera_get_integer": (c_int64, c_void_p, c_char_p),
    "camera_set_integer": (None, c_void_p, c_char_p, c_int64),
    "camera_get_integer_bounds": (None, c_void_p, c_char_p, POINTER(c_int64), POINTER(c_int64)),
    "camera_get_integer_increment": (c_int64, c_void_p, c_char_p),
    "camera_get_float": (c_double, c_void_p, c_char_p),
    "camera_set_float": (None, c_void_p, c_char_p, c_double),
    "camera_get_float_bounds": (None, c_void_p, c_char_p, POINTER(c_double), POINTER(c_double)),
    "camera_get_float_increment": (c_double, c_void_p, c_char_p),
    "camera_dup_available_enumerations_as_strings": (POINTER(c_char_p), c_void_p, c_char_p, POINTER(c_uint)),
    "camera_gv_set_packet_size": (None, c_void_p, c_int),
    "camera_gv_get_packet_size": (c_uint, c_void_p),
    "camera_gv_auto_packet_size": (c_uint, c_void_p),
    "camera_gv_set_packet_delay": (None, c_void_p, c_int64),
    "camera_gv_get_packet_delay": (c_int64, c_void_p),
    "gv_device_take_control": (c_int, c_void_p),
    "gv_device_leave_control": (c_int, c_void_p),
    "device_read_register": (c_int, c_void_p, c_uint64, POINTER(c_uint32)),
    "device_write_register": (c_int, c_void_p, c_uint64, c_uint32),
    "chunk_parser_get_float_value": (c_double, c_void_p, c_void_p, c_char_p),
}


class AravisError(Exception):
    """An error reported by Aravis; ``lost``: the camera does not answer, or is controlled by another program now."""

    def __init__(self, text: str, lost: bool = False) -> None:
        super().__init__(text)
        self.text = text
        self.lost = lost


class _GError(ctypes.Structure):
    _fields_ = (("domain", c_uint32), ("code", c_int), ("message", c_char_p))


class Aravis:
    """The library: each function of `PLAIN` and `FAILING` is a method; those of `FAILING` raise AravisError.

    Raises
    ------
    AravisError
        The library is not installed.
    """

    def __init__(self) -> None:
        self._library = _load()  # it brings the GLib and GObject that it was built with
        self.unref = _declare(self._library, "g_object_unref", None, c_void_p)
        self.is_a = _declare(self._library, "g_type_check_instance_is_a", c_int, c_void_p, c_size_t)
        self._free = _declare(self._library, "g_free", None, c_void_p)
        self._free_error = _declare(self._library, "g_error_free", None, c_void_p)
        self._quark = _declare(self._library, "g_quark_to_string", c_char_p, c_uint32)
        for name, (result, *arguments) in PLAIN.items():
            setattr(self, name, _declare(self._library, f"arv_{name}", result, *arguments))
        for name, (result, *arguments) in FAILING.items():
            function = _declare(self._library, f"arv_{name}", result, *arguments, POINTER(POINTER(_GError)))
            setattr(self, name, self._raising(function))

    def __getattr__(self, name: str) -> Callable[..., Any]:
        raise AttributeError(f"{name} is not declared")  # only reached for a function that is in neither table

    def strings(self, array: Any, count: int) -> list[str]:
        """Return the strings of a list whose memory the caller owns, and free the list."""
        try:
            return [text(array[index]) for index in range(count)]
        finally:
            self._free(array)

    def _raising(self, function: Callable[..., Any]) -> Callable[..., Any]:
        def call(*arguments: Any) -> Any:
            error = POINTER(_GError)()
            result = function(*arguments, byref(error))
            if error:
                reported = error.contents
                lost = reported.code in LOST.get(text(self._quark(reported.domain)), ())
                raised = AravisError(text(reported.message), lost)
                self._free_error(error)
                raise raised
            return result

        return call


def text(value: bytes | None) -> str:
    """Decode a string of the library."""
    return (value or b"").decode("utf-8", "replace")


def _load() -> ctypes.CDLL:
    for name in LIBRARIES:
        try:
            return ctypes.CDLL(name)
        except OSError:
            continue
    raise AravisError("The library Aravis 0.8 is not installed")


def _declare(library: ctypes.CDLL, name: str, result: Any, *arguments: Any) -> Callable[..., Any]:
    function = getattr(library, name)
    function.restype, function.argtypes = result, arguments
    return function
