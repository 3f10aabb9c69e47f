"""Detection of mistakes that decode smoothly, and of cameras that have turned."""
