"""Time what other libraries do with the same fringe images; runs in the peers' own environment and prints one JSON document.

Usage: ``python run_peers.py IMAGES.npy WRAPPED.npy`` with images (N, H, W) uint8 of one pitch and a wrapped phase map (H, W) float32.
"""

import json
import sys
import time

import cv2
import numpy as np
from skimage.restoration import unwrap_phase

ROUNDS = 3


def best_of(work):
    """Return the shortest time in seconds."""
    times = []
    for _ in range(ROUNDS):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return min(times)


def main():
    """Time every peer and print the seconds."""
    images = np.load(sys.argv[1])
    wrapped = np.load(sys.argv[2])
    seconds = {}
    parameters = cv2.structured_light_SinusoidalPattern_Params()
    for number, method in enumerate(("FTP", "PSP", "FAPS")):
        parameters.methodId = number
        sinusoidal = cv2.structured_light.SinusoidalPattern_create(parameters)
        seconds[f"OpenCV contrib SinusoidalPattern {method}, 3 images"] = best_of(lambda s=sinusoidal: s.computePhaseMap(list(images[:3])))
    gray = cv2.structured_light.GrayCodePattern_create(1024, 768)
    planes = [images[k % len(images)] for k in range(gray.getNumberOfPatternImages())]
    dark, white = np.zeros_like(images[0]), np.full_like(images[0], 200)
    both = [planes, planes]
    seconds["OpenCV contrib GrayCodePattern, two cameras"] = best_of(lambda: gray.decode(both, None, [dark, dark], [white, white]))
    seconds["scikit-image unwrap_phase, one map"] = best_of(lambda: unwrap_phase(wrapped))
    json.dump({"seconds": seconds, "versions": {"opencv": cv2.__version__}}, sys.stdout)


if __name__ == "__main__":
    main()
