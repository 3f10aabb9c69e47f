"""The simulated world: true rig, true axis positions, and the images of its cameras."""

from __future__ import annotations

import threading
from typing import Literal

import numpy as np

from measureapp.arrays import FloatArray, ImageArray
from measureapp.data.board import BoardDescription, CheckerboardDescription
from measureapp.data.fringe import AxisReadback
from measureapp.data.mesh import Mesh
from measureapp.data.rig import RigDescription
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform, rotation_about
from measureapp.simulate.effects.bit_planes import shown_levels
from measureapp.simulate.effects.bounce import Bounce, Exchange
from measureapp.simulate.effects.effects import draw_effects
from measureapp.simulate.effects.motions import Settling, begin_settling, flange_play, play
from measureapp.simulate.effects.shake import displaced
from measureapp.simulate.effects.sharpness import object_depth
from measureapp.simulate.effects.timing import into_next
from measureapp.simulate.effects.warmth import FULL_PROJECTOR_PX
from measureapp.simulate.kinematics import ARCSEC
from measureapp.simulate.optics import ProjectorLight, SeeingCamera, expose, project_images
from measureapp.simulate.options import WorldOptions
from measureapp.simulate.part import Part
from measureapp.simulate.printed_board import PrintedBoard
from measureapp.simulate.sensor import read_out
from measureapp.simulate.surface import Surface
from measureapp.simulate.truth import Truth, draw_truth, knock_camera

PAPER_BOARD = CheckerboardDescription(columns=14, rows=11, square_mm=15.0)
TableContent = Literal["empty", "board", "part"]
PLAIN_LIGHT = -1
DARK = -2
HOME_MM = (450.0, 0.0, 600.0)
POSE_STEP_MM, GUIDE_STEP_MM, TABLE_STEP_RAD = 1e-4, 1e-4, float(np.deg2rad(1e-5))  # resolution of the displays
QUATERNION_DIGITS = 9
SELF_HEATING_K = 14.0  # of a camera in thermal equilibrium


class World:
    """Contains the ground truth; the devices of the virtual rig command it and read it back like real controllers.

    Commands and read-backs are nominal; the true positions include the errors drawn from the seed. A command that repeats the last
    one moves nothing, as on real controllers. All methods may be called from any thread.

    Parameters
    ----------
    description : nominal rig
    part : nominal of what is on the table while `table_holds` is "part"
    seed : of the rig's errors and all noise
    board : the calibration board
    options : light, sensor and errors
    """

    def __init__(
        self,
        description: RigDescription,
        part: Part,
        seed: int,
        board: BoardDescription = PAPER_BOARD,
        options: WorldOptions | None = None,
    ) -> None:
        self.description = description
        self.board = board
        self.options = options or WorldOptions()
        self._effects = draw_effects(description, part, self.options, seed)
        self.part = self._effects.part
        self._truth = draw_truth(description, board, self.options.errors, seed)
        for camera, turn_deg in self.options.knocked_deg.items():
            self._truth = knock_camera(self._truth, camera, np.deg2rad(turn_deg))
        self._lock = threading.RLock()
        self._moves = np.random.default_rng([seed, 101])
        self._noise_key = int(np.random.default_rng([seed, 102]).integers(2**31)) << 31
        self._images = 0
        self._levels = np.random.default_rng([seed, 103])
        self._level, self._ambient, self._shake_px = 1.0, self.options.light.ambient, 0.0
        self._shakes = np.random.default_rng([seed, 104])
        self._printed = PrintedBoard(board, self.options.board_bow_mm, self._effects.board_print)
        self._surface: Surface | None = None
        self._table_holds: TableContent = "empty"
        self._loaded: ImageArray | FloatArray = np.zeros((0, 2, 2), np.float32)
        self._patterns: dict[int, FloatArray] = {}  # by exposure where that matters, else by 0
        self._shown = DARK
        self._state = 0
        self._settling: Settling | None = None
        self._creep = np.random.default_rng([seed, 105])
        self._triggers = np.random.default_rng([seed, 106])
        self._light_maps: dict[str, tuple[tuple[int, int], FloatArray]] = {}
        self._second: dict[str, Bounce | None] = {}
        self._exchanges: tuple[int, Exchange | None] = (-1, None)  # with the state that it belongs to; settling does not change it
        self._depths: dict[str, FloatArray] = {}
        self._commanded = AxisReadback(_home(), 0.0, 0.0)
        self._base_from_flange = self._flange_reached(self._commanded.base_from_flange)
        self._guide_from_base = self._slide_reached(0.0)
        self._table_rad = self._angle_reached(0.0)

    @property
    def table_holds(self) -> TableContent:
        """The object on the table."""
        return self._table_holds

    @table_holds.setter
    def table_holds(self, thing: TableContent) -> None:
        with self._lock:
            self._table_holds = thing
            self._state += 1

    # axes

    def readback(self) -> AxisReadback:
        """Return the read-back of the controllers: the commands, rounded to their display resolution."""
        with self._lock:
            goal = self._commanded
            return AxisReadback(
                _round_to_display(goal.base_from_flange),
                round(goal.guide_mm / GUIDE_STEP_MM) * GUIDE_STEP_MM,
                round(goal.table_rad / TABLE_STEP_RAD) * TABLE_STEP_RAD,
            )

    def move_robot(self, base_from_flange: RigidTransform) -> None:
        """Bring the flange to a commanded pose."""
        with self._lock:
            if not np.array_equal(base_from_flange.matrix, self._commanded.base_from_flange.matrix):
                before, backlash = self._commanded.base_from_flange.translation_mm, self.options.motions.robot_backlash_mm
                behind = flange_play(before, base_from_flange.translation_mm, backlash)
                self._base_from_flange = _moved_by(behind, self._flange_reached(base_from_flange))
                self._set_commanded(AxisReadback(base_from_flange, self._commanded.guide_mm, self._commanded.table_rad))

    def move_guide(self, position_mm: float) -> None:
        """Bring the slide to a commanded position."""
        with self._lock:
            if position_mm != self._commanded.guide_mm:
                late = play(self._commanded.guide_mm, position_mm, self.options.motions.guide_backlash_mm)
                self._guide_from_base = self._slide_reached(position_mm + late)
                self._set_commanded(AxisReadback(self._commanded.base_from_flange, position_mm, self._commanded.table_rad))

    def turn_table(self, angle_rad: float) -> None:
        """Bring the table to a commanded angle."""
        with self._lock:
            if angle_rad != self._commanded.table_rad:
                late = play(self._commanded.table_rad, angle_rad, self.options.motions.table_backlash_arcsec * ARCSEC)
                self._table_rad = self._angle_reached(angle_rad) + late
                self._set_commanded(AxisReadback(self._commanded.base_from_flange, self._commanded.guide_mm, angle_rad))

    def _set_commanded(self, commanded: AxisReadback) -> None:
        self._commanded = commanded
        self._settling = begin_settling(self.options.motions, self.elapsed_s, self._creep)
        self._state += 1

    def _flange_reached(self, commanded: RigidTransform) -> RigidTransform:
        reached = self._truth.robot.true_pose(commanded, self._moves) if self._truth.robot else commanded
        warmth = self._effects.warmth
        if warmth is None:
            return reached
        return reached @ RigidTransform.from_parts(np.eye(3), warmth.flange_mm(self.elapsed_s), "flange", "flange")

    def _slide_reached(self, commanded_mm: float) -> RigidTransform:
        motion = self._effects.guide
        if self._truth.guide:
            reached = self._truth.guide.guide_from_base(commanded_mm, self._moves)
        else:
            reached = self._truth.calibration.guide.guide_from_base(commanded_mm)
        return reached if motion is None else reached @ motion.at(commanded_mm)

    def _angle_reached(self, commanded_rad: float) -> float:
        return self._truth.table.true_angle_rad(commanded_rad, self._moves) if self._truth.table else commanded_rad

    # light

    def load_patterns(self, images: ImageArray | FloatArray) -> None:
        """Load the projector's images (n, h, w): uint8, or floats 0…1 for an ideal projector."""
        with self._lock:
            self._loaded, self._patterns = images.copy(), {}
            self._shown = DARK

    def show(self, index: int) -> None:
        """Show pattern ``index``, PLAIN_LIGHT for the head lamp, DARK for neither."""
        with self._lock:
            self._shown = index
            self._level = 1.0 + self.options.projector.level_spread * float(self._levels.standard_normal())
            self._ambient = self.options.light.ambient * (1.0 + self.options.ambient_flicker * float(self._levels.standard_normal()))
            scale = self.description.projector.width_px / FULL_PROJECTOR_PX
            self._shake_px = self.options.projector.shake_px * scale * float(self._shakes.standard_normal())

    @property
    def shown(self) -> int:
        """Index of the pattern shown, PLAIN_LIGHT or DARK."""
        return self._shown

    # warmth

    @property
    def elapsed_s(self) -> float:
        """Time since the world began, as it passes with the images taken."""
        return self._images / len(self.description.cameras) * self.options.warmth.seconds_per_image

    def housing_c(self) -> float:
        """Return the temperature of the camera housings."""
        return self.options.temperature_c + SELF_HEATING_K

    # images

    def image(self, camera: str, exposure_us: int) -> ImageArray:
        """Return the image of ``camera`` now, with noise."""
        with self._lock:
            mean = self.mean_image(camera, exposure_us)
            self._images += 1
            return read_out(mean, self.description.camera(camera).bit_depth, self.options.sensor, self._noise_key + self._images)

    def image_under(self, camera: str, exposure_us: int, pattern: int) -> ImageArray:
        """Show pattern ``pattern`` and return the image of ``camera`` under it, with noise."""
        with self._lock:
            self.show(pattern)
            return self.image(camera, exposure_us)

    def mean_image(self, camera: str, exposure_us: int) -> FloatArray:
        """Return the noise-free image of ``camera`` now, (H, W) float32 relative to full scale, without saturation."""
        with self._lock:
            mean = self._exposed(camera, exposure_us, self._shown)
            share = into_next(self.options.timing, len(mean), exposure_us, self._triggers) if self._shown >= 0 else None
            if share is not None:
                following = self._shown + 1 if self._shown + 1 < len(self._loaded) else DARK
                mean += share * (self._exposed(camera, exposure_us, following) - mean)
            of_board, effects = self._table_holds == "board", self._effects.cameras[camera]
            if effects.sharpness is not None:
                mean = effects.sharpness.blurred(mean, self._depths[camera], of_part=not of_board)
            return mean if effects.pixels is None else effects.pixels.apply(mean)

    def _exposed(self, camera: str, exposure_us: int, shown: int) -> FloatArray:
        """Return the image under what is ``shown``, before the lens's own effects."""
        settings = self.options.light.model_copy(update={"ambient": self._ambient})
        width = (PrintedBoard if self._table_holds == "board" else Surface).width_px
        light = self._light_map(camera)
        return expose(light, self._pattern(shown, exposure_us), exposure_us, settings, width, self._second.get(camera))

    def _projected(self, exposure_us: int) -> FloatArray:
        """Return the light of all loaded images as an exposure of this length averages it."""
        effects = self.options.projector
        beating = effects.bit_planes > 0.0 and self._loaded.dtype == np.uint8
        key = exposure_us if beating else 0
        if key not in self._patterns:
            shown = shown_levels(self._loaded, exposure_us, effects.frame_us, effects.bit_planes) if beating else self._loaded
            self._patterns[key] = project_images(shown, self.options.light, effects.vignetting)
        return self._patterns[key]

    def _pattern(self, shown: int, exposure_us: int) -> FloatArray | None:
        if shown == DARK:
            return np.zeros((2, 2), np.float32)
        if shown == PLAIN_LIGHT:
            return None
        pattern = self._projected(exposure_us)[shown]
        if self._shake_px:
            pattern = displaced(pattern, self._shake_px)
        return pattern if self._level == 1.0 else pattern * np.float32(self._level)

    def _light_map(self, camera: str) -> FloatArray:
        now = (self._state, 0 if self._settling is None else self._settling.step(self.elapsed_s))
        state, light = self._light_maps.get(camera, ((-1, 0), None))
        if light is None:
            described = self.description.camera(camera)
            light = np.empty((described.height_px, described.width_px, 4), np.float32)
        if state != now:
            self._fill(camera, light)
            self._light_maps[camera] = (now, light)
        return light

    def _fill(self, camera: str, light: FloatArray) -> None:
        self._second[camera] = None
        self._depths[camera] = np.array([self.description.standoff_mm, 0.0, 0.0])
        if self._table_holds == "empty":
            light[:] = 0.0
            return
        calibration = self._truth.calibration.cameras.cameras[camera]
        scene_from_reference = self.scene_from_camera()
        scene_from_camera = scene_from_reference @ calibration.reference_from_camera
        seeing = SeeingCamera(self._pinhole(camera), self._effects.cameras[camera].residual_px, self._effects.cameras[camera].coma)
        projector = self._projector(scene_from_reference @ self._truth.camera_from_projector)
        seen: Surface | PrintedBoard = self._printed if self._table_holds == "board" else self._part_surface()
        seen.illuminate(seeing, scene_from_camera, projector, light)
        self._depths[camera] = object_depth(seeing.pinhole, scene_from_camera.inverse().apply(seen.sample_mm()))
        if isinstance(seen, Surface) and self.options.part.bounce:
            if self._exchanges[0] != self._state:
                self._exchanges = (self._state, seen.exchange(projector))
            between = self._exchanges[1]
            if between is not None:
                self._second[camera] = seen.second_light(seeing, scene_from_camera, between, light, self.options.part.bounce)

    def _pinhole(self, camera: str) -> PinholeCamera:
        pinhole = self._truth.calibration.cameras.cameras[camera].pinhole
        warmth = self._effects.warmth
        return pinhole if warmth is None else warmth.camera(camera, pinhole, self.elapsed_s)

    def _projector(self, scene_from_projector: RigidTransform) -> ProjectorLight:
        pinhole, warmth = self._truth.projector, self._effects.warmth
        if warmth is not None:
            pinhole = warmth.projector(pinhole, self.elapsed_s)
        return ProjectorLight(pinhole, scene_from_projector, self.description.standoff_mm)

    def _part_surface(self) -> Surface:
        if self._surface is None:
            self._surface = Surface(self._effects.seen_part, self.options.part.penetration_mm)
        return self._surface

    # ground truth: for demonstrations and tests only

    def truth(self) -> Truth:
        """Return the ground truth."""
        return self._truth

    def true_surface(self, frame: str = "table") -> Mesh:
        """Return the surface of the part as it was made, at table angle 0 in the true table frame, which is then also the part frame."""
        mesh = self.part.mesh.seen_from(self._truth.table_from_nominal)
        return mesh.seen_from(RigidTransform.identity(frame, "table"))

    def true_light(self, camera: str) -> FloatArray:
        """Return the light map of ``camera`` now, (H, W, 4) float32.

        Projector column (far below 0 in shadow) and row, reflected light per unit of irradiance, albedo; zero outside the object.
        """
        with self._lock:
            return self._light_map(camera).copy()

    def true_board_corners_mm(self) -> FloatArray:
        """Return the true corners (N, 3) of the bowed board in frame `board`."""
        return self._printed.corners_mm()

    def guide_from_camera(self) -> RigidTransform:
        """Return the true pose of the reference camera now."""
        flange = self._base_from_flange
        if self._settling is not None:
            left = self._settling.left_mm(self.elapsed_s)
            flange = flange @ RigidTransform.from_parts(np.eye(3), left, "flange", "flange")
        return self._guide_from_base @ flange @ self._truth.calibration.hand_eye.flange_from_camera

    def scene_from_camera(self) -> RigidTransform:
        """Return the true pose of the reference camera in the frame of the object on the table (`nominal` or `board`)."""
        part_from_table = RigidTransform.from_parts(rotation_about([0, 0, 1], -self._table_rad), np.zeros(3), "table", "table")
        if self._effects.table is not None:
            part_from_table = part_from_table @ self._effects.table.at(self._commanded.table_rad).inverse()
        thing = self._truth.table_from_board if self._table_holds == "board" else self._truth.table_from_nominal
        return thing.inverse() @ part_from_table @ self._truth.calibration.table_from_guide @ self.guide_from_camera()


def _home() -> RigidTransform:
    forward, right = np.array([0.8, 0.0, -0.6]), np.array([0.0, -1.0, 0.0])
    return RigidTransform.from_parts(np.column_stack([right, np.cross(forward, right), forward]), HOME_MM, "base", "flange")


def _moved_by(shift_mm: FloatArray, pose: RigidTransform) -> RigidTransform:
    return (
        RigidTransform.from_parts(pose.rotation, pose.translation_mm + shift_mm, pose.to_frame, pose.from_frame) if shift_mm.any() else pose
    )


def _round_to_display(pose: RigidTransform) -> RigidTransform:
    quaternion = np.round(pose.quaternion_wxyz, QUATERNION_DIGITS)
    position = np.round(pose.translation_mm / POSE_STEP_MM) * POSE_STEP_MM
    return RigidTransform.from_quaternion(quaternion, position, pose.to_frame, pose.from_frame)
