"""Predicted clouds: the points that a viewpoint will give of the nominal, with their noise."""

from __future__ import annotations

from dataclasses import asdict, dataclass, replace
from zlib import crc32

import numpy as np

from measureapp.data.fringe import AxisReadback, PatternSet
from measureapp.data.measurement import ViewResult
from measureapp.data.part_pose import PartPose
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.data.plan import Viewpoint
from measureapp.errors import ReconstructError
from measureapp.geometry.transform import RigidTransform
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.pipeline.prediction.light import PartLight
from measureapp.pipeline.prediction.phase_maps import Taking, predict_phase_map
from measureapp.pipeline.prediction.rig_model import RigModel
from measureapp.pipeline.prediction.seen import Lens, SeenPixels, projector_of, see
from measureapp.reconstruct.projector.with_projector import reconstruct_view_with_projector
from measureapp.reconstruct.reconstruct import Reconstruction, reconstruct
from measureapp.reconstruct.rectification.rectifier import Rectifier
from measureapp.register.clouds.quality import assess_cloud

UNLIT = (PixelState.SHADOW, PixelState.WEAK_MODULATION)


@dataclass(frozen=True, slots=True)
class Exposing:
    """Patterns and exposures of a viewpoint, and the exposure that the part's light refers to."""

    patterns: PatternSet
    exposures_us: tuple[int, ...]  # long to short
    longest_us: int


@dataclass(frozen=True, slots=True, eq=False)
class PredictedScene:
    """The part on the table before a rig: everything that a view of it follows from."""

    rig: RigModel
    surface: NominalSurface
    part_from_nominal: RigidTransform  # where the part stands on the table; frame `part` is the table's at 0°
    light: PartLight
    rectifier: Rectifier
    seed: int = 1  # of the noise

    @classmethod
    def of(
        cls, rig: RigModel, surface: NominalSurface, part_from_nominal: RigidTransform | None = None, light: PartLight | None = None
    ) -> PredictedScene:
        """Prepare a scene; without ``part_from_nominal`` the part stands in the middle of the table as its nominal is oriented."""
        place = part_from_nominal or standing_on_table(surface, rig)
        return cls(rig, surface, place, light or PartLight(), Rectifier(rig.calibration.cameras))

    def with_brightness(self, factor: float) -> PredictedScene:
        """Return the same scene in ``factor`` times the light."""
        light = PartLight(white=self.light.white * factor, contrast=self.light.contrast, ambient=min(1.0, self.light.ambient * factor))
        return replace(self, light=light)

    def look(self, viewpoint: Viewpoint) -> dict[str, SeenPixels]:
        """Return what each camera sees of the nominal, and what of it is lit."""
        calibration = self.rig.calibration
        nominal_from_camera = self.part_from_nominal.inverse() @ calibration.part_from_camera(readback_of(viewpoint))
        source = projector_of(calibration.cameras, self.rig.description)
        projector = Lens(source.pinhole, nominal_from_camera @ source.reference_from_projector)
        standoff_mm = self.rig.description.standoff_mm
        cameras = {name: calibration.cameras.cameras[name] for name in calibration.cameras.names}
        return {
            name: see(self.surface, Lens(one.pinhole, nominal_from_camera @ one.reference_from_camera), projector, standoff_mm)
            for name, one in cameras.items()
        }

    def predict(self, viewpoint: Viewpoint, exposing: Exposing, seen: dict[str, SeenPixels] | None = None) -> ViewResult | None:
        """Return the predicted view of a viewpoint, or None where the cameras share no point of the part.

        Noise depends on the viewpoint's id alone: the same plan gives the same prediction, and a repeated viewpoint other noise.
        """
        calibration, settings = self.rig.calibration, self.rig.decode_settings
        maps: dict[str, PhaseMap] = {}
        for number, (name, pixels) in enumerate((seen or self.look(viewpoint)).items()):
            camera = calibration.cameras.cameras[name]
            shape = camera.pinhole.height_px, camera.pinhole.width_px
            saturation = float(self.rig.description.camera(name).saturation)
            taking = Taking(
                name, viewpoint.id, shape, exposing.patterns, exposing.exposures_us, exposing.longest_us, saturation, camera.blur_px
            )
            rng = np.random.default_rng([self.seed, number, crc32(viewpoint.id.encode())])
            maps[name] = predict_phase_map(pixels, self.light, taking, settings, rng)
        try:
            made = self._reconstruct(maps)
        except ReconstructError:
            return None
        return self._view(viewpoint, maps, made) if len(made.cloud) else None

    def _reconstruct(self, maps: dict[str, PhaseMap]) -> Reconstruction:
        cameras = self.rig.calibration.cameras
        if len(maps) == 1:
            return reconstruct_view_with_projector(maps, cameras, rectifier=self.rectifier).reconstruction
        return reconstruct(maps, cameras, rectifier=self.rectifier)

    def _view(self, viewpoint: Viewpoint, maps: dict[str, PhaseMap], made: Reconstruction) -> ViewResult:
        states = next(iter(maps.values())).state
        lit = int(np.count_nonzero(~np.isin(states, UNLIT)))
        readback = readback_of(viewpoint)
        return ViewResult(
            viewpoint_id=viewpoint.id,
            cloud=made.cloud,
            quality=assess_cloud(made.cloud, completeness=min(1.0, len(made.cloud) / lit) if lit else 0.0),
            part_from_camera=self.rig.calibration.part_from_camera(readback),
            decode={},
            pairs=tuple(asdict(pair) for pair in made.pairs),
            rejected=dict(made.rejected),
            readback=readback,
        )


def standing_on_table(surface: NominalSurface, rig: RigModel, pose: PartPose | None = None) -> RigidTransform:
    """Return part_from_nominal of a part on the table's top; without a pose in its middle, as its nominal is oriented."""
    placed = (pose or PartPose()).transform(surface.vertices_mm[np.unique(surface.triangles)])
    return RigidTransform.from_parts(placed.rotation, placed.translation_mm + np.array([0.0, 0.0, table_top_mm(rig)]), "part", "nominal")


def table_top_mm(rig: RigModel) -> float:
    """Return the height of the table's top in the frame `part` of the calibration."""
    return float(rig.calibration.table_from_guide.apply(np.array(rig.description.table.centre_in_guide_mm))[2])


def readback_of(viewpoint: Viewpoint) -> AxisReadback:
    """Return the axis positions that a viewpoint asks for."""
    return AxisReadback(viewpoint.flange.transform(), viewpoint.guide_mm, float(np.deg2rad(viewpoint.table_deg)))
