"""Nominal surface: distances, deviation maps and sections."""
