"""Theme, icons and number formats of the user interface."""
