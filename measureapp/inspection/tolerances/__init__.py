"""Geometrical tolerances (ISO 1101): form, datum systems, zones and run-out, without what noise adds to them."""
