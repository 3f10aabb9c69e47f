"""Project folders and file formats."""
