"""All explorers, as the browser's tests find them."""

#: Chapter, function, title, and the label of the slider that is moved.
EXPLORERS = {
    "aperture": ("pinhole", "aperture_explorer", "The hole of a pinhole camera", "Hole diameter d"),
    "focal": (
        "pinhole",
        "focal_length_explorer",
        "Focal length, sensor and field of view",
        "Focal length f",
    ),
    "dolly": ("pinhole", "dolly_zoom_explorer", "Dolly zoom", "Distance Z"),
    "lines": ("homogeneous", "join_meet_explorer", "Where two lines meet", "Slope of line m"),
    "camera": ("homogeneous", "whole_camera_explorer", "The whole camera", "Pan to the left"),
    "depth": ("lenses", "depth_of_field_explorer", "Depth of field", "f-number N"),
    "rays": (
        "lenses",
        "ray_tracer_explorer",
        "Rays through a thin lens",
        "Object distance Z",
    ),
    "lenses": (
        "lenses",
        "two_lens_explorer",
        "Rays through two lenses",
        "Focal length 1",
    ),
    "window": ("lenses", "aperture_window_explorer", "The aperture window", "f-number N"),
    "exposure": (
        "sensor",
        "exposure_explorer",
        "Exposure: time, aperture, ISO, light and motion",
        "Exposure time t",
    ),
    "shutter": ("sensor", "rolling_shutter_explorer", "Rolling shutter", "Turns a second"),
    "mosaic": ("sensor", "bayer_explorer", "The Bayer mosaic", "Across"),
    "stripes": (
        "sensor",
        "structured_light_explorer",
        "Structured light: height from the shift of a stripe",
        "Its height",
    ),
    "lens": ("distortion", "distortion_explorer", "Lens distortion", "Radial k₁"),
    "straight": (
        "distortion",
        "undistort_explorer",
        "Straighten a photograph",
        "Radial k₁",
    ),
    "line": ("estimation", "least_squares_explorer", "Least squares by hand", "Slope"),
    "corners": (
        "estimation",
        "homography_explorer",
        "A homography from four corners",
        "Bottom left u₁",
    ),
    "noise": (
        "estimation",
        "dlt_noise_explorer",
        "The camera's DLT under noise",
        "Tallest pin",
    ),
    "detection": ("calibration", "detection_explorer", "Finding a corner", "Blur σ"),
    "views": ("calibration", "pose_explorer", "Which views tell what", "Error of a corner σ"),
    "residuals": (
        "calibration",
        "reprojection_inspector",
        "Inspect the residuals",
        "Look at du",
    ),
    "epipolar": (
        "epipolar",
        "epipolar_explorer",
        "The epipolar line of a point",
        "Point on the left u",
    ),
    "ransac": ("epipolar", "ransac_stepper", "RANSAC, draw by draw", "Draw"),
    "rectification": (
        "epipolar",
        "rectification_explorer",
        "Rectification",
        "As taken (0) to rectified (1)",
    ),
    "bench": ("triangulation", "bench_explorer", "Triangulation bench", "Baseline b"),
    "disparity": ("triangulation", "disparity_explorer", "Disparity of a real pair", "Row v"),
    "growing": ("bundle", "growing_explorer", "A block grows", "Newest picture"),
    "control": ("bundle", "control_point_game", "Place the control points", "Point 1 east"),
    "setup": ("planning", "setup_planner", "Plan a set-up", "Distance Z"),
    "flight": ("planning", "flight_planner", "Plan a flight", "Ground sampling distance GSD"),
}
#: Those with a photograph that the pointer reads; everything is tried on them.
READABLE = ("aperture", "focal", "dolly", "depth", "corners")
