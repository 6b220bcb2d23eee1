"""Blocks of pictures with known truth: an object on a turntable, and terrain flown in strips."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from course_lib.bundle import Block, Control, Observations
from course_lib.bundle.block import Indices
from course_lib.calibration.model import rotations_from_vectors
from course_lib.checks import Array
from course_lib.transforms import look_at, rotation_from_omega_phi_kappa


@dataclass(frozen=True, eq=False)
class KnownBlock:
    """A block whose truth is known, and what was measured of it.

    Attributes
    ----------
    truth : Block
        The true cameras and points.
    observations : Observations
        Measured pixels, with errors.
    wrong : ndarray of bool, shape (m,)
        Which of them belong to another point.
    control, check : ndarray of int
        Points that were surveyed to orient the block, and to judge it.
    image_size : tuple of int
        Width and height of the pictures, px.
    """

    truth: Block
    observations: Observations
    wrong: NDArray[np.bool_]
    control: Indices
    check: Indices
    image_size: tuple[int, int]

    def surveyed(self, rng: np.random.Generator, sigma: float) -> Control:
        """Return the control points as a survey with errors of `sigma` finds them."""
        places = self.truth.points[self.control]
        errors = sigma * rng.standard_normal(places.shape)
        return Control(self.control, places + errors, sigma)

    def roughly(
        self, rng: np.random.Generator, turn: float, move: float, points: float | None = None
    ) -> Block:
        """Return a start for an adjustment: the truth with errors.

        Parameters
        ----------
        rng : numpy.random.Generator
            Source of the errors.
        turn : float
            Standard deviation of the turns of the cameras, rad.
        move : float
            Standard deviation of the moves of their centres, and of the points.
        points : float, optional
            That of the points, if it is another.

        Returns
        -------
        Block
            The start.
        """
        true = self.truth
        turns = rotations_from_vectors(turn * rng.standard_normal((len(true.R), 3)))
        R = turns @ true.R
        centres = true.centres + move * rng.standard_normal(true.t.shape)
        away = (move if points is None else points) * rng.standard_normal(true.points.shape)
        return Block(true.K, R, -np.einsum("vij,vj->vi", R, centres), true.points + away)


def turntable(
    rng: np.random.Generator,
    pictures: int = 36,
    points: int = 600,
    noise: float = 0.5,
    wrong: float = 0.0,
    rings: int = 1,
) -> KnownBlock:
    """Return pictures all around a vase, 0.3 m high, as on a turntable; units are metres.

    Parameters
    ----------
    rng : numpy.random.Generator
        Source of everything random.
    pictures : int
        Pictures to a circle.
    points : int
        Points on the vase.
    noise : float
        Standard deviation of a coordinate, px.
    wrong : float
        Share of observations that belong to another point.
    rings : int
        Circles of pictures, from below to above.

    Returns
    -------
    KnownBlock
        Truth and observations; each point is seen by the cameras that it faces. Eight points are
        control, up to twenty are check points.
    """
    angle, height = rng.uniform(0, 2 * np.pi, points), rng.uniform(0, 0.3, points)
    radius = 0.09 + 0.03 * np.sin(2 * np.pi * height / 0.3)
    slope = 0.03 * 2 * np.pi / 0.3 * np.cos(2 * np.pi * height / 0.3)
    outward = np.stack([np.cos(angle), np.sin(angle), np.zeros(points)], axis=1)
    X = radius[:, None] * outward + height[:, None] * [0, 0, 1]
    normals = outward - slope[:, None] * [0, 0, 1]
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    around = 2 * np.pi * np.arange(pictures) / pictures
    eyes = [[np.cos(a), np.sin(a), z] for z in np.linspace(0.35, 0.9, rings) for a in around]
    poses = [look_at(eye, [0, 0, 0.15]) for eye in eyes]
    K = np.array([[4200.0, 0, 999.5], [0, 4200, 749.5], [0, 0, 1]])
    block = Block(K, np.array([R for R, _ in poses]), np.array([t for _, t in poses]), X)
    towards = block.centres[:, None] - X
    towards /= np.linalg.norm(towards, axis=2, keepdims=True)
    facing = np.einsum("vnk,nk->vn", towards, normals) > 0.35
    return _measured(rng, block, facing, (2000, 1500), noise, wrong)


def flight(
    rng: np.random.Generator,
    strips: int = 3,
    pictures: int = 6,
    points: int = 600,
    overlap: tuple[float, float] = (0.8, 0.6),
    noise: float = 0.5,
    wrong: float = 0.0,
    height: float = 100.0,
    oblique: int = 0,
) -> KnownBlock:
    """Return terrain photographed from above in parallel strips, flown to and fro; in metres.

    Parameters
    ----------
    rng : numpy.random.Generator
        Source of everything random.
    strips, pictures : int
        Strips, and pictures in each.
    points : int
        Tie points on the terrain, which has hills of a tenth of the height.
    overlap : tuple of float
        Along a strip and between strips, as shares of the picture.
    noise : float
        Standard deviation of a coordinate, px.
    wrong : float
        Share of observations that belong to another point.
    height : float
        Height of the flight above the ground.
    oblique : int
        Pictures from around the area that look at its middle, in addition.

    Returns
    -------
    KnownBlock
        Truth and observations. Points in fewer than two pictures are not part of it. Eight points
        are control, up to twenty are check points.
    """
    size, f = (4000, 3000), 3600.0
    sides = np.array(size) * height / f
    step, apart = (1 - np.array(overlap)) * sides
    R, C = nadir_poses(rng, strips, pictures, step, apart, height)
    R, C = with_oblique(R, C, oblique)
    low, high = C[:, :2].min(axis=0) - sides / 2, C[:, :2].max(axis=0) + sides / 2
    plan = rng.uniform(low, high, (points, 2))
    X = np.column_stack([plan, _hills(plan, height)])
    K = np.array([[f, 0, 1999.5], [0, f, 1499.5], [0, 0, 1]])
    block = Block(K, R, -np.einsum("vij,vj->vi", R, C), X)
    return _measured(rng, block, np.ones((len(R), points), bool), size, noise, wrong)


def large_block(rng: np.random.Generator, noise: float = 0.5) -> KnownBlock:
    """Return a flight of the size of a well-known problem: 49 cameras, 7776 points, 31 919 pixels.

    Parameters
    ----------
    rng : numpy.random.Generator
        Source of everything random.
    noise : float
        Standard deviation of a coordinate, px.

    Returns
    -------
    KnownBlock
        Truth and observations.
    """
    known = flight(rng, 7, 7, 9500, (0.75, 0.6), noise)
    truth, seen = known.truth, known.observations
    kept = np.isin(seen.points, np.arange(7776))
    # Two pixels of each point stay; of the others as many as are missing.
    chosen = np.flatnonzero(kept)
    chosen = chosen[np.argsort(rng.random(len(chosen)))]
    order = np.argsort(seen.points[chosen], kind="stable")
    ranks = np.arange(len(chosen)) - np.searchsorted(
        seen.points[chosen[order]], seen.points[chosen[order]]
    )
    needed, spare = chosen[order][ranks < 2], chosen[order][ranks >= 2]
    more = rng.permutation(spare)[: 31_919 - len(needed)]
    seen = seen.only(np.sort(np.concatenate([needed, more])))
    points = np.arange(7776)
    smaller = Block(truth.K, truth.R, truth.t, truth.points[:7776])
    wrong = np.zeros(len(seen), bool)
    return KnownBlock(smaller, seen, wrong, points[:8], points[8:28], known.image_size)


def nadir_poses(
    rng: np.random.Generator, strips: int, pictures: int, step: float, apart: float, height: float
) -> tuple[Array, Array]:
    """Return rotations and centres of cameras that look down, nearly."""
    R, C = [], []
    for strip in range(strips):
        for picture in range(pictures):
            omega, phi, kappa = 0.02 * rng.standard_normal(3)
            R.append(rotation_from_omega_phi_kappa(omega, phi, kappa + np.pi * (strip % 2)))
            place = picture if strip % 2 == 0 else pictures - 1 - picture
            C.append([place * step, strip * apart, height])
    return np.array(R), np.array(C) + 0.01 * height * rng.standard_normal((len(C), 3))


def with_oblique(R: Array, C: Array, oblique: int) -> tuple[Array, Array]:
    """Return cameras with some more, around the area, that look at its middle."""
    middle, height = C.mean(axis=0) * [1, 1, 0], C[:, 2].mean()
    for angle in 2 * np.pi * np.arange(oblique) / max(oblique, 1):
        eye = middle + height * np.array([0.8 * np.cos(angle), 0.8 * np.sin(angle), 1])
        R = np.append(R, look_at(eye, middle)[0][None], axis=0)
        C = np.append(C, eye[None], axis=0)
    return R, C


def _hills(plan: Array, height: float) -> Array:
    """Return the height of the ground at places, shape (N, 2)."""
    x, y = 2 * np.pi * plan.T / height
    return np.asarray(0.05 * height * (np.sin(0.9 * x) * np.cos(0.7 * y) + np.sin(0.4 * x + y)))


def _measured(
    rng: np.random.Generator,
    block: Block,
    facing: NDArray[np.bool_],
    size: tuple[int, int],
    noise: float,
    wrong: float,
) -> KnownBlock:
    """Return what the cameras measure of the points that face them; unseen points are left out."""
    cameras, points = np.nonzero(facing)
    pixels = block.project(cameras, points)
    inside = ((pixels > -0.5) & (pixels < np.array(size) - 0.5)).all(axis=1)
    often = np.bincount(points[inside], minlength=len(block.points)) >= 2
    inside &= often[points]
    cameras, points, pixels = cameras[inside], points[inside], pixels[inside]
    numbers = np.cumsum(often) - 1
    mistaken = rng.random(len(points)) < wrong
    # A wrong match lies somewhere in the neighbourhood.
    away = rng.uniform(20, 200, (len(points), 1)) * _directions(rng, len(points))
    pixels = pixels + noise * rng.standard_normal(pixels.shape) + mistaken[:, None] * away
    seen = Observations(cameras, numbers[points], pixels, noise if noise > 0 else 1.0)
    kept = Block(block.K, block.R, block.t, block.points[often])
    control, check = _surveyed(kept.points)
    return KnownBlock(kept, seen, mistaken, control, check, size)


def _directions(rng: np.random.Generator, count: int) -> Array:
    angle = rng.uniform(0, 2 * np.pi, count)
    return np.stack([np.cos(angle), np.sin(angle)], axis=1)


def _surveyed(points: Array) -> tuple[Indices, Indices]:
    """Return eight control points, as far apart as can be, and twenty check points between."""
    chosen = [int(np.argmax(((points - points.mean(axis=0)) ** 2).sum(axis=1)))]
    nearest = np.full(len(points), np.inf)
    for _ in range(min(27, len(points) - 1)):
        nearest = np.minimum(nearest, ((points - points[chosen[-1]]) ** 2).sum(axis=1))
        chosen.append(int(np.argmax(nearest)))
    return np.array(chosen[:8], np.intp), np.array(chosen[8:], np.intp)
