"""What moves: the table's axis, hand-eye and the linear guide, from board poses along one kinematic chain."""
