"""A calibration in the making: what is known, what was observed, what was solved from it, and what every kind of calibration must offer."""
