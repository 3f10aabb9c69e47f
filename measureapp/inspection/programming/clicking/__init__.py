"""Features described by clicks: on the nominal where there is one, else on the measured points."""
