"""What calibration keeps and reads: boards and their images, cameras, rigs and what they leave uncertain."""
