"""A person's own photographs of a board become a calibrated camera and a report in plain words."""

from course_lib.calibrating.command import add_calibrate_command, add_target_command

__all__ = ["add_calibrate_command", "add_target_command"]
