"""What the engine takes at viewpoints: fringes, the board, the board under fringes, a probe of the scene, uniform light."""
