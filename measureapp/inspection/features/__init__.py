"""Features: cut around their nominals or grown, fitted, or constructed from others."""
