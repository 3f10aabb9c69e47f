"""Page Scan."""
