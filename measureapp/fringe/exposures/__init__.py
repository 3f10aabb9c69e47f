"""Choice of exposures, their weights, and the effect of saturated pixels on their neighbours."""
