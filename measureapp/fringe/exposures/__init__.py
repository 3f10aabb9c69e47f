"""Which exposures to take, how much each counts, and what saturated pixels do to their neighbours."""
