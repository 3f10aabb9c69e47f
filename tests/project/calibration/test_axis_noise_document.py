"""Files keep the names of the fields of the axes' noise, so that stored sessions and calibrations open."""

from measureapp.calibrate.motions.axis_noise import AxisNoise
from measureapp.project.documents import noise_document, noise_from

NOISE = AxisNoise(robot_correlation_mm=300.0, robot_correlation_turn=0.6)


def test_the_correlation_of_the_robot_keeps_its_names_in_files():
    document = noise_document(NOISE)
    assert (document["robot_alike_mm"], document["robot_alike_turn"]) == (300.0, 0.6)
    assert not {"robot_correlation_mm", "robot_correlation_turn"} & set(document)


def test_a_stored_noise_is_read_as_it_was_written():
    assert noise_document(noise_from(noise_document(NOISE))) == noise_document(NOISE)
