"""The virtual rig: a world with hidden truth, its optics, sensors and axes. Measuring rooms never import it."""
