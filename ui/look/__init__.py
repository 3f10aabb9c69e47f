"""Theme, icons and wording: what every view looks and reads like."""
