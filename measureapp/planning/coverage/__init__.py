"""What viewpoints see of a part, with which standard deviation, and the choice of viewpoints by it."""
