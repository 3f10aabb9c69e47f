"""Simulation of the virtual rig: a world with hidden ground truth, its optics, sensors and axes. Measuring packages never import it."""
