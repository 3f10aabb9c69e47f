"""Documents of series of parts: trend and capability as PDF, CSV and JSON."""
