"""Documents of repeated measurements: PDF, CSV and JSON."""
