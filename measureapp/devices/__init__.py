"""What the program expects of devices, and what is connected."""
