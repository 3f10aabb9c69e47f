"""Choice of the backend of the 3-D view, and a test of its availability."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING, Literal

from PySide6.QtGui import QGuiApplication

from ui.look.language.words import tr

if TYPE_CHECKING:
    from vtkmodules.vtkRenderingCore import vtkRenderWindow

BackendName = Literal["native", "off-screen"]
NATIVE_PLATFORMS = {"xcb", "windows", "cocoa"}
OFF_SCREEN_CLASSES = ("vtkEGLRenderWindow", "vtkOSOpenGLRenderWindow")
CHOICE = "MEASUREAPP_VIEWPORT"
NO_GRAPHICS = "The 3-D view needs a graphics library that is not installed. See Help, Scan: “If the 3-D view stays empty”."


def choose_backend() -> BackendName:
    """Choose the native backend on a local display, the off-screen one otherwise.

    The environment variable MEASUREAPP_VIEWPORT (``native`` or ``off-screen``) takes precedence.
    """
    wanted = os.environ.get(CHOICE)
    if wanted in {"native", "off-screen"}:
        return "native" if wanted == "native" else "off-screen"
    remote = "SSH_CONNECTION" in os.environ or os.environ.get("SESSIONNAME", "").startswith("RDP")
    return "native" if QGuiApplication.platformName() in NATIVE_PLATFORMS and not remote else "off-screen"


def off_screen_window() -> vtkRenderWindow | None:
    """Return a render window without a display; None if no graphics library provides one."""
    from vtkmodules import vtkRenderingOpenGL2
    from vtkmodules.vtkRenderingCore import vtkRenderWindow

    kinds = (
        [getattr(vtkRenderingOpenGL2, name) for name in OFF_SCREEN_CLASSES if hasattr(vtkRenderingOpenGL2, name)]
        if sys.platform == "linux"
        else [vtkRenderWindow]
    )
    for kind in kinds:
        window = kind()
        window.SetOffScreenRendering(True)
        window.SetShowWindow(False)
        window.SetAlphaBitPlanes(True)  # for pictures with a transparent background
        if window.SupportsOpenGL():
            return window
    return None


def missing_graphics() -> str:
    """Import VTK and describe the problem of the 3-D view, if any; empty: none. Slow the first time."""
    try:
        import ui.viewport.native
        import ui.viewport.off_screen
        import ui.viewport.overlay.handles
        import ui.viewport.preparation
        import ui.viewport.print_picture  # noqa: F401  (loaded here, because the window must not wait for them)
    except ImportError as error:
        return tr("The 3-D view needs a library that is missing ({error}). Run the installer again.", error=error)
    if choose_backend() == "off-screen":
        return _try_off_screen()
    return ""


def _try_off_screen() -> str:
    """Render an empty picture, which loads the graphics driver in advance."""
    from vtkmodules.vtkRenderingCore import vtkRenderer

    window = off_screen_window()
    if window is None:
        return NO_GRAPHICS
    window.SetSize(16, 16)
    window.AddRenderer(vtkRenderer())
    window.Render()
    window.Finalize()
    return ""
