"""The graphics driver in words, for support."""

from __future__ import annotations

from ui.look.language.words import tr

WANTED = ("OpenGL vendor", "OpenGL renderer", "OpenGL version")


def describe_renderer() -> str:
    """Return vendor, renderer and version of OpenGL off screen; a window of its own is made for it, and ended."""
    from ui.viewport.backend import choose_backend, off_screen_window

    window = off_screen_window()
    if window is None:
        return tr("No graphics library was found. Backend: {choose_backend}.", choose_backend=choose_backend())
    window.SetSize(16, 16)
    window.Render()
    lines = [line.strip() for line in window.ReportCapabilities().splitlines() if line.strip().startswith(WANTED)]
    window.Finalize()
    return "\n".join(
        (
            tr("Backend: {choose_backend}", choose_backend=choose_backend()),
            tr("Class: {getclassname}", getclassname=window.GetClassName()),
            *lines,
        )
    )
