"""Planning of viewpoints for scans and calibrations."""
