"""Joint calibration of the whole rig, its uncertainty on the part, and its comparison with required limits."""
