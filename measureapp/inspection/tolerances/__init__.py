"""Geometrical tolerances (ISO 1101): form, datum systems, zones and run-out, corrected for noise."""
