"""What of a calibration reconstruction needs before it sees an image: rectified pairs, epipolar lines, viewing rays."""
