"""Files of calibrations: boards and their images, cameras, rigs and their uncertainties."""
