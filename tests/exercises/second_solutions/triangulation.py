import math

import numpy as np


def closest_points_on_rays(origin1, direction1, origin2, direction2):
    """From the condition that the way between both points is perpendicular to both rays."""
    a, b, c = direction1 @ direction1, direction1 @ direction2, direction2 @ direction2
    between = origin2 - origin1
    along1, along2 = np.linalg.solve(
        [[a, -b], [b, -c]], [between @ direction1, between @ direction2]
    )
    return [origin1 + along1 * direction1, origin2 + along2 * direction2]


def triangulate_midpoint(pixel1, pixel2, P1, P2):
    """The point with the smallest sum of squared distances from both rays."""
    N, g = np.zeros((3, 3)), np.zeros(3)
    for (u, v), P in ((pixel1, P1), (pixel2, P2)):
        d = np.linalg.solve(P[:, :3], [u, v, 1])
        d = d / math.hypot(*d)
        across = np.eye(3) - np.outer(d, d)
        N += across
        g -= across @ np.linalg.solve(P[:, :3], P[:, 3])
    return np.linalg.solve(N, g)


def triangulate_linear(pixels, cameras):
    """With the last number of X set to 1: three unknowns, and least squares."""
    rows = np.concatenate([x[:, None] * P[2] - P[:2] for x, P in zip(pixels, cameras, strict=True)])
    return np.linalg.lstsq(rows[:, :3], -rows[:, 3], rcond=None)[0]


def refine_point(guess, pixels, cameras):
    """With derivatives from differences, and the normal equations."""

    def residuals(point):
        seen = cameras[:, :, :3] @ point + cameras[:, :, 3]
        return (seen[:, :2] / seen[:, 2:] - pixels).ravel()

    J = np.array([(residuals(guess + h) - residuals(guess - h)) / 2e-5 for h in 1e-5 * np.eye(3)]).T
    return guess - np.linalg.inv(J.T @ J) @ (J.T @ residuals(guess))


def depth_from_disparity(disparity, f, baseline, offset):
    depths = []
    for d in disparity:
        if not d > -offset:
            raise ValueError("no depth")
        depths.append(baseline / ((d + offset) / f))
    return depths


def depth_uncertainty(Z, f, baseline, sigma):
    """By way of the disparity: |dZ/dd| = f b / d²."""
    d = baseline * f / Z
    return baseline * f / d / d * sigma


def intersect_ray_plane(origin, directions, plane):
    answer = []
    for d in directions:
        slope = plane[0] * d[0] + plane[1] * d[1] + plane[2] * d[2]
        height = np.append(origin, 1) @ plane
        ahead = height / slope < 0
        answer.append(origin - d * (height / slope) if ahead else [math.nan] * 3)
    return answer


def point_covariance(point, cameras, sigma):
    """The sum of what each camera knows, from the product rule."""
    information = np.zeros((3, 3))
    for P in cameras:
        (a, b), c = P[:2] @ [*point, 1], P[2] @ [*point, 1]
        du = P[0, :3] / c - a * P[2, :3] / c**2
        dv = P[1, :3] / c - b * P[2, :3] / c**2
        information += (np.outer(du, du) + np.outer(dv, dv)) / sigma**2
    return np.linalg.pinv(information)
