"""The journal of a project: what was stored when, with the checksum of every file."""
