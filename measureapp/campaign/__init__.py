"""Many jobs, on this computer or on many: projects that are processed, and virtual measurements whose truth is known."""
