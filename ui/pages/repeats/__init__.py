"""Repeated measurements of one part."""
