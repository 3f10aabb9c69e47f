"""One file per kind of calibration, and the table of all of them."""
