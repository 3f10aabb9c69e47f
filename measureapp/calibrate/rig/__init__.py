"""The whole rig at once, what it leaves uncertain on the part, and how that compares with what is asked."""
