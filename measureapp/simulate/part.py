"""Simulated parts: surface, materials and nominal dimensions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from measureapp.arrays import IntArray, read_only
from measureapp.data.mesh import Mesh


@dataclass(frozen=True, slots=True)
class Material:
    """Reflection model: Lambertian albedo plus a Blinn-Phong lobe [1]_.

    References
    ----------
    .. [1] J. F. Blinn, SIGGRAPH Computer Graphics 11(2), 192-198, 1977.
    """

    name: str
    albedo: float  # 0…1, matt
    gloss: float = 0.0  # height of the lobe relative to a matt white surface
    sharpness: float = 1.0  # exponent of the lobe


MATT_WHITE = Material("matt white", 0.85)
MATT_GREY = Material("matt grey", 0.7)
ALUMINIUM = Material("blasted aluminium", 0.55, gloss=0.35, sharpness=12.0)
STEEL = Material("machined steel", 0.45, gloss=0.5, sharpness=15.0)
POLISHED = Material("polished steel", 0.25, gloss=6.0, sharpness=25.0)


@dataclass(frozen=True, slots=True, eq=False)
class Part:
    """A part manufactured exactly to its nominal: frame `nominal`, z up, origin at the centre of the underside."""

    name: str
    mesh: Mesh
    materials: tuple[Material, ...]
    material: IntArray  # (T,) uint8, index into `materials` of every triangle
    dimensions: Mapping[str, float] = field(default_factory=dict)  # nominal, mm
    watertight: bool = True
    expansion: float = 0.0  # relative, by its temperature above 20 °C

    def __post_init__(self) -> None:
        object.__setattr__(self, "material", read_only(self.material, np.uint8, (len(self.mesh.triangles),)))

    def at_reference(self) -> Mesh:
        """Return its surface at 20 °C."""
        return replace(self.mesh, vertices_mm=self.mesh.vertices_mm / (1.0 + self.expansion)) if self.expansion else self.mesh

    @property
    def radius_mm(self) -> float:
        """Radius of the enclosing cylinder about the z axis."""
        return float(np.linalg.norm(self.mesh.vertices_mm[:, :2], axis=1).max())

    @property
    def height_mm(self) -> float:
        """Height above the table."""
        return float(self.mesh.vertices_mm[:, 2].max())
