"""Region growing on the measured surface."""
