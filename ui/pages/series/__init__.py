"""Series of parts: trend and capability."""
