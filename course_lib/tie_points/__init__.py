"""Tie points: the same detail found in two pictures or more, by SIFT.

Use it as ``points1, points2 = tie_points(picture1, picture2)``, or step by step: `find_features`
looks for details that can be recognised, `match_features` pairs those that look alike, and
`join_matches` follows each through all pictures. OpenCV does the finding; what is done with it is
here. How alike two details are says nothing about where they are: some pairs are always wrong.
"""

from course_lib.tie_points.features import Features, find_features
from course_lib.tie_points.matching import match_features, tie_points
from course_lib.tie_points.tracks import agreeing_matches, join_matches, tracks

__all__ = [
    "Features",
    "agreeing_matches",
    "find_features",
    "join_matches",
    "match_features",
    "tie_points",
    "tracks",
]
