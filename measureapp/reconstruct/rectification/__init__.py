"""What reconstruction derives from a calibration alone: viewing rays, rectified pairs, epipolar lines."""
