"""Prediction before a scan: what its viewpoints will see, and how uncertain every dimension will be."""
