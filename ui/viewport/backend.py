"""Which of the two backends draws the 3-D view, and whether one can."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING, Literal

from PySide6.QtGui import QGuiApplication

if TYPE_CHECKING:
    from vtkmodules.vtkRenderingCore import vtkRenderWindow

BackendName = Literal["native", "off-screen"]
NATIVE_PLATFORMS = {"xcb", "windows", "cocoa"}
OFF_SCREEN_CLASSES = ("vtkEGLRenderWindow", "vtkOSOpenGLRenderWindow")
CHOICE = "MEASUREAPP_VIEWPORT"
NO_GRAPHICS = "The 3-D view needs a graphics library that this computer does not have. See Help, Scan: “If the 3-D view stays empty”."


def choose_backend() -> BackendName:
    """Return the native interactor where there is a display of this machine, the off-screen one elsewhere.

    The environment variable MEASUREAPP_VIEWPORT (``native`` or ``off-screen``) decides where it is set.
    """
    wanted = os.environ.get(CHOICE)
    if wanted in {"native", "off-screen"}:
        return "native" if wanted == "native" else "off-screen"
    remote = "SSH_CONNECTION" in os.environ or os.environ.get("SESSIONNAME", "").startswith("RDP")
    return "native" if QGuiApplication.platformName() in NATIVE_PLATFORMS and not remote else "off-screen"


def off_screen_window() -> vtkRenderWindow | None:
    """Return a render window without a display, or None where no graphics library offers one."""
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
        if window.SupportsOpenGL():
            return window
    return None


def missing_graphics() -> str:
    """Import VTK and tell in a sentence what keeps the 3-D view from working; empty: nothing. Slow the first time."""
    try:
        import ui.viewport.native
        import ui.viewport.off_screen  # noqa: F401
    except ImportError as error:
        return f"The 3-D view needs a library that is missing ({error}). Run the installation again to repair it."
    if choose_backend() == "off-screen":
        return _try_off_screen()
    return ""


def _try_off_screen() -> str:
    """Draw one empty picture, which loads the graphics driver here and not while the user waits."""
    from vtkmodules.vtkRenderingCore import vtkRenderer

    window = off_screen_window()
    if window is None:
        return NO_GRAPHICS
    window.SetSize(16, 16)
    window.AddRenderer(vtkRenderer())
    window.Render()
    window.Finalize()
    return ""
