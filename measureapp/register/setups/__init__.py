"""Set-ups of one part, joined into one measurement."""
