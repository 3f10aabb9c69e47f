"""What geometry says about mistakes that decode smoothly, and about cameras that have turned."""
