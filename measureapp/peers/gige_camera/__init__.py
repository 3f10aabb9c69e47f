"""A virtual GigE Vision camera on 127.0.0.1, for what the fake cameras of other projects cannot do."""

from measureapp.peers.gige_camera.camera import Faults, GigeCamera, gige_camera, noise

__all__ = ["Faults", "GigeCamera", "gige_camera", "noise"]
