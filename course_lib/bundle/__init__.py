"""Bundle adjustment: all cameras and all points of a block at once, from all that was measured.

A block is cameras and points; each observation is a pixel where one camera sees one point. The
bundles of rays are turned and moved, and the points with them, until the reprojection error is
smallest. Control points and a gauge say where in the world that is.
"""

from course_lib.bundle.adjustment import BundleAdjustment, bundle_adjust
from course_lib.bundle.block import Block, Observations
from course_lib.bundle.connections import check_block, connected_parts
from course_lib.bundle.control import Control
from course_lib.bundle.covariance import Precision
from course_lib.bundle.derivatives import reprojection_jacobian
from course_lib.bundle.normals import solve_normal_block
from course_lib.bundle.self_calibration import SelfCalibration, self_calibrate
from course_lib.bundle.tables import NormalBlocks, move_block, normal_blocks, squared_error

__all__ = [
    "Block",
    "BundleAdjustment",
    "Control",
    "NormalBlocks",
    "Observations",
    "Precision",
    "SelfCalibration",
    "bundle_adjust",
    "check_block",
    "connected_parts",
    "move_block",
    "normal_blocks",
    "reprojection_jacobian",
    "self_calibrate",
    "solve_normal_block",
    "squared_error",
]
