"""Blocks that cannot be adjusted say why."""

from dataclasses import replace

import numpy as np
import pytest

from course_lib.bundle import Block, Control, Observations, bundle_adjust, connected_parts
from course_lib.checks import DegenerateConfigurationError
from data_generators.blocks import flight, turntable


def test_bad_input_is_named():
    known = flight(np.random.default_rng(3), strips=2, pictures=3, points=60, oblique=2)
    block, seen = known.truth, known.observations

    def adjust(block=block, seen=seen, **more):
        return bundle_adjust(block, seen, **more)

    strange = Observations(
        np.append(seen.cameras, 0), np.append(seen.points, 999), np.append(seen.pixels, [[1, 2]], 0)
    )
    with pytest.raises(ValueError, match="of point 999, but the block has only"):
        adjust(seen=strange)
    twice = seen.only(np.append(np.arange(len(seen)), 0))
    with pytest.raises(ValueError, match=r"camera \d+ sees point \d+ twice"):
        adjust(seen=twice)
    lonely = seen.only((seen.points != 4) | (np.cumsum(seen.points == 4) == 1))
    with pytest.raises(DegenerateConfigurationError, match="point 4 is seen by 1 cameras"):
        adjust(seen=lonely)
    blind = seen.only((seen.cameras != 2) | (np.cumsum(seen.cameras == 2) <= 2))
    often = np.bincount(blind.points, minlength=len(block.points)) >= 2
    numbers = np.cumsum(often) - 1
    blind = blind.only(often[blind.points])
    blind = Observations(blind.cameras, numbers[blind.points], blind.pixels)
    fewer = block.moved_to(block.points[often])
    with pytest.raises(DegenerateConfigurationError, match="camera 2 sees 2 points"):
        adjust(fewer, blind)
    with pytest.raises(ValueError, match="behind it at the start"):
        adjust(block.moved_to(np.add(block.points, [0, 0, 500])))
    with pytest.raises(ValueError, match="gauge must be"):
        adjust(gauge="free")
    two = Control(np.array([0, 1]), block.points[:2])
    with pytest.raises(DegenerateConfigurationError, match="2 control points that cameras"):
        adjust(control=two)
    unseen = Block(block.K, block.R, block.t, np.append(block.points, block.points[:3], axis=0))
    with pytest.raises(DegenerateConfigurationError, match="0 control points that cameras"):
        adjust(unseen, control=Control(len(block.points) + np.arange(3), block.points[:3]))
    line = Control(np.arange(3), np.outer([1, 2, 3], [1, 1, 0]))
    with pytest.raises(DegenerateConfigurationError, match="collinear"):
        adjust(control=line)
    with pytest.raises(ValueError, match="named twice"):
        Control(np.array([0, 0, 1]), block.points[:3])
    with pytest.raises(TypeError, match="whole numbers"):
        Observations(np.array([0.5]), np.array([1]), np.zeros((1, 2)))


def test_parts_without_a_common_point_are_named():
    known = turntable(np.random.default_rng(1), pictures=4, points=200)
    seen = known.observations
    # The second pair of cameras sees points of its own.
    count = len(known.truth.points)
    points = seen.points + count * (seen.cameras >= 2)
    apart = Observations(seen.cameras, points, seen.pixels)
    X = np.concatenate([known.truth.points, known.truth.points])
    often = np.bincount(points, minlength=2 * count) >= 2
    numbers = np.cumsum(often) - 1
    apart = apart.only(often[points])
    apart = Observations(apart.cameras, numbers[apart.points], apart.pixels)
    assert connected_parts(apart, 4).tolist() == [0, 0, 1, 1]
    with pytest.raises(DegenerateConfigurationError, match="falls into 2 parts"):
        bundle_adjust(known.truth.moved_to(X[often]), apart)
    # Control points place a part only if it sees them.
    one_side = Control(np.arange(5), X[often][:5])
    with pytest.raises(DegenerateConfigurationError, match=r"cameras \[2, 3\] … see do not fix"):
        bundle_adjust(known.truth.moved_to(X[often]), apart, one_side)
    both = Control(np.arange(often.sum()), X[often])
    assert bundle_adjust(known.truth.moved_to(X[often]), apart, both).converged


def test_pictures_from_one_place_leave_depths_open():
    known = flight(np.random.default_rng(2), strips=1, pictures=3, points=80)
    truth = known.truth
    one_place = replace(truth, t=-np.einsum("vij,j->vi", truth.R, truth.centres[1]))
    seen = known.observations
    pixels = one_place.project(seen.cameras, seen.points)
    fit = bundle_adjust(one_place, Observations(seen.cameras, seen.points, pixels))
    with pytest.raises(DegenerateConfigurationError, match="parallel, or all from one place"):
        _ = fit.precision


def test_mirrored_control_points_are_named():
    known = flight(np.random.default_rng(3), strips=2, pictures=3, points=60)
    start = known.roughly(np.random.default_rng(4), 0.002, 0.5)
    survey = known.surveyed(np.random.default_rng(5), 0.02)
    assert bundle_adjust(start, known.observations, survey).converged
    for swapped in (survey.coordinates[:, [1, 0, 2]], survey.coordinates * [1, -1, 1]):
        control = Control(survey.points, swapped, 0.02)
        with pytest.raises(DegenerateConfigurationError, match="are a mirror image"):
            bundle_adjust(start, known.observations, control)


def test_control_points_along_a_road_and_heights_beside_it_will_do():
    known = flight(np.random.default_rng(3), strips=2, pictures=3, points=60)
    points = np.array(known.truth.points)
    points[:4] = points.mean(axis=0) + np.outer([-20, -5, 5, 20], [1, 0.1, 0])
    truth, seen = known.truth.moved_to(points), known.observations
    exact = replace(seen, pixels=truth.project(seen.cameras, seen.points))
    sigma = np.repeat([[0.02] * 3, [1e4, 1e4, 0.02]], 4, axis=0)
    control = Control(np.arange(8), points[:8], sigma)
    assert bundle_adjust(truth, exact, control).converged
