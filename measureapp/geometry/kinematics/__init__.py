"""Kinematics of six-axis arms: forward and inverse, branches and their singularities, Jacobian, configuration data."""
