"""Which explorers are measured, by chapter, and which of their sliders move."""

from __future__ import annotations

#: By chapter: name, function, title, and a slider that no other one of the chapter has: the
#: peer moves it. Ours moves the first one, or the one named last, which has more positions.
EXPLORERS: dict[str, tuple[tuple[str, ...], ...]] = {
    "pinhole": (
        ("aperture explorer", "aperture_explorer", "The hole of a pinhole camera", "d"),
        (
            "focal length explorer",
            "focal_length_explorer",
            "Focal length, sensor and field of view",
            "f",
        ),
        ("dolly zoom", "dolly_zoom_explorer", "Dolly zoom", "Z"),
    ),
    "homogeneous": (
        ("join and meet", "join_meet_explorer", "Where two lines meet", "p"),
        ("whole camera", "whole_camera_explorer", "The whole camera", "f"),
    ),
    "lenses": (
        ("depth of field", "depth_of_field_explorer", "Depth of field", "f"),
        ("ray tracer", "ray_tracer_explorer", "Rays through a thin lens", "Z"),
        ("two lenses", "two_lens_explorer", "Rays through two lenses", "d", "d"),
        ("aperture window", "aperture_window_explorer", "The aperture window", "N"),
    ),
    "sensor": (
        ("exposure", "exposure_explorer", "Exposure: time, aperture, ISO, light and motion", "t"),
        ("rolling shutter", "rolling_shutter_explorer", "Rolling shutter", "turns"),
        ("Bayer mosaic", "bayer_explorer", "The Bayer mosaic", "pixels"),
        (
            "structured light",
            "structured_light_explorer",
            "Structured light: height from the shift of a stripe",
            "angle_deg",
        ),
    ),
    "distortion": (
        ("distortion", "distortion_explorer", "Lens distortion", "k1"),
        ("undistort", "undistort_explorer", "Straighten a photograph", "k2"),
    ),
    "estimation": (
        ("least squares by hand", "least_squares_explorer", "Least squares by hand", "m"),
        ("homography", "homography_explorer", "A homography from four corners", "u1"),
        ("DLT under noise", "dlt_noise_explorer", "The camera's DLT under noise", "sigma"),
    ),
    "calibration": (
        ("detection viewer", "detection_explorer", "Finding a corner", "blur"),
        ("poses", "pose_explorer", "Which views tell what", "noise"),
        ("reprojection inspector", "reprojection_inspector", "Inspect the residuals", "du"),
    ),
    "epipolar": (
        ("epipolar line", "epipolar_explorer", "The epipolar line of a point", "Z"),
        ("RANSAC stepper", "ransac_stepper", "RANSAC, draw by draw", "n"),
        ("rectification", "rectification_explorer", "Rectification", "s"),
    ),
    "triangulation": (
        ("triangulation bench", "bench_explorer", "Triangulation bench", "X"),
        ("disparity", "disparity_explorer", "Disparity of a real pair", "v"),
    ),
    "bundle": (
        ("reconstruction stepper", "growing_explorer", "A block grows", "turn", "turn"),
        ("control points", "control_point_game", "Place the control points", "x1", "x1"),
    ),
    "planning": (
        ("set-up planner", "setup_planner", "Plan a set-up", "turn_deg"),
        ("flight planner", "flight_planner", "Plan a flight", "gsd", "x1"),
    ),
}
