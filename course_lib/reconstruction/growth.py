"""A block that grows: cameras are placed, points are added, observations are thrown out."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from course_lib.bundle import Block, BundleAdjustment, Observations, bundle_adjust
from course_lib.bundle.block import Indices
from course_lib.checks import Array
from course_lib.orientation import resect_robustly
from course_lib.reconstruction.result import Step, camera_matrices
from course_lib.reconstruction.start import Pair, angles_between, first_points
from course_lib.triangulation import triangulate_linear

#: A point is added when two of its rays meet at this angle or more.
NARROW = np.deg2rad(2.0)
#: So many points must agree on the pose of a camera, and such a share of those that it sees.
LEAST_AGREED, AGREED_SHARE = 8, 0.25
#: If a ray to a point was thrown out, so many others must agree.
AFTER_DOUBT = 3
#: So many triples of points are tried for the pose of a camera.
SAMPLES = 150
#: From so many standard deviations on an observation counts less.
ROBUST = 2.5
#: So often the worst ray of a point is left out, and an adjustment repeated.
ROUNDS = 3
#: What a step changes.
CHANGING = "R", "t", "X", "trusted", "why", "placed", "steps"


class Growth:
    """A block on its way.

    Parameters
    ----------
    seen : Observations
        Who sees which point where; no camera sees a point twice.
    K : ndarray, shape (3, 3)
        Intrinsics, px.
    rng : numpy.random.Generator
        Draws samples.
    threshold : float
        How far an observation may be from where the block puts it, px.
    """

    def __init__(
        self, seen: Observations, K: Array, rng: np.random.Generator, threshold: float
    ) -> None:
        self.seen, self.K, self.rng, self.threshold = seen, K, rng, threshold
        shape = int(seen.cameras.max()) + 1, int(seen.points.max()) + 1
        self.pixels = np.full((*shape, 2), np.nan)
        self.pixels[seen.cameras, seen.points] = seen.pixels
        self.sigma = np.ones(shape)
        self.sigma[seen.cameras, seen.points] = seen.sigma
        # What may be used: rays that were thrown out are False, with the reason in `why`.
        self.trusted = ~np.isnan(self.pixels[..., 0])
        self.given = self.trusted.copy()
        self.why = np.where(self.trusted, "alone", "").astype("U8")
        self.R, self.t = np.full((shape[0], 3, 3), np.nan), np.full((shape[0], 3), np.nan)
        self.X = np.full((shape[1], 3), np.nan)
        self.placed: list[int] = []
        self.steps: list[Step] = []

    @property
    def known(self) -> NDArray[np.bool_]:
        """Which points have a place, shape (n,)."""
        return np.asarray(~np.isnan(self.X[:, 0]))

    def begin(self, pair: Pair) -> None:
        """Place the first two cameras, and the points that agree."""
        one, other = pair.pictures
        self.R[one], self.t[one] = np.eye(3), 0
        self.R[other], self.t[other] = pair.R, pair.t
        self.placed = [one, other]
        X = first_points(self.pixels, pair, self.K)
        wide = angles_between(X, X + pair.R.T @ pair.t) >= NARROW
        self.X[pair.agreed[wide]] = X[wide]
        before = self.trusted.sum()
        self._throw_out(other, np.setdiff1d(pair.common, pair.agreed), "off")
        self._adjusted((one, other), len(pair.common), len(pair.agreed), before)

    def place(self, picture: int) -> bool:
        """Place one more camera and add its points; return False if no pose can be trusted.

        Raises
        ------
        ValueError
            If the points leave the pose open.
        """
        mine = np.flatnonzero(self.known & self.trusted[picture])
        found = resect_robustly(
            self.X[mine], self.pixels[picture, mine], self.K, self.rng, self.threshold, SAMPLES
        )
        if found.used.sum() < max(LEAST_AGREED, AGREED_SHARE * len(mine)):
            return False
        before = self.trusted.sum()
        saved = {name: getattr(self, name).copy() for name in CHANGING}
        self.R[picture], self.t[picture] = found.R, found.t
        self.placed.append(picture)
        self._throw_out(picture, mine[~found.used], "off")
        try:
            self._add_points(picture)
            self._adjusted((picture,), len(mine), int(found.used.sum()), before)
        except ValueError:
            vars(self).update(saved)
            raise
        return True

    def finish(self) -> BundleAdjustment:
        """Adjust to the end, without doubts about what is left, and return the adjustment."""
        self._settle()
        return self._adjustment(1e-10, None)

    def block(self) -> tuple[Block, Observations, Indices]:
        """Return the block, what it is made from, and the numbers of its points."""
        points = np.flatnonzero(self.known)
        block = Block(self.K, self.R[self.placed], self.t[self.placed], self.X[points])
        camera, point = np.nonzero(self.trusted[self.placed][:, points])
        where = np.array(self.placed)[camera], points[point]
        seen = Observations(camera, point, self.pixels[where], self.sigma[where])
        return block, seen, points

    def fates(self) -> NDArray[np.str_]:
        """Return what became of each observation, as in `Reconstruction`."""
        fates = self.why.copy()
        used = self.trusted & self.known
        fates[used] = "used"
        fates[np.setdiff1d(np.arange(len(fates)), self.placed)] = "left out"
        return np.asarray(fates[self.seen.cameras, self.seen.points])

    def _throw_out(self, picture: int | Indices, points: Indices, why: str) -> None:
        self.trusted[picture, points] = False
        self.why[picture, points] = why

    def _add_points(self, picture: int) -> None:
        """Add the points of a new camera that another one sees, too, at a wide enough angle."""
        placed = np.array(self.placed)
        others = self.trusted[placed[:-1]].any(axis=0)
        new = np.flatnonzero(self.trusted[picture] & ~self.known & others)
        pixels = self.pixels[placed][:, new]
        pixels[~self.trusted[placed][:, new]] = np.nan
        good = self._can_be_placed(pixels, new)
        new, pixels = new[good], pixels[:, good]
        given = ~np.isnan(pixels[..., 0])
        for _ in range(ROUNDS):
            if not len(new):
                return
            X, away = self._triangulated(pixels)
            fits = (np.isnan(pixels[..., 0]) | (away <= self.threshold)).all(axis=0)
            self.X[new[fits]] = X[fits]
            camera, point = np.nonzero(given & np.isnan(pixels[..., 0]) & fits)
            self._throw_out(placed[camera], new[point], "off")
            # The others have another chance without the ray that fits worst.
            worst = np.where(np.isnan(pixels[..., 0]), -1, np.nan_to_num(away, nan=1e9)).argmax(0)
            pixels[worst, np.arange(len(new))] = np.nan
            left = ~fits & (worst < len(placed) - 1) & self._can_be_placed(pixels, new)
            new, pixels, given = new[left], pixels[:, left], given[:, left]

    def _can_be_placed(self, pixels: Array, points: Indices) -> NDArray[np.bool_]:
        """Return which points have rays enough, the last camera's at a wide angle to others."""
        rays = np.insert(pixels, 2, 1.0, axis=2) @ np.linalg.inv(self.K).T @ self.R[self.placed]
        angles = np.nan_to_num(angles_between(rays[:-1], rays[-1])).max(axis=0)
        rays_left = (~np.isnan(pixels[..., 0])).sum(axis=0)
        return np.asarray((angles >= NARROW) & self._enough(rays_left, points))

    def _enough(self, rays: Indices, points: Indices | slice) -> NDArray[np.bool_]:
        """Return whether so many rays determine points, and more if others were thrown out."""
        given = self.given[self.placed][:, points].sum(axis=0)
        return np.asarray(rays >= np.where(rays < given, AFTER_DOUBT, 2))

    def _triangulated(self, pixels: Array) -> tuple[Array, Array]:
        """Return points, and how far their images are off, (v, k); NaN behind a camera."""
        block = Block(self.K, self.R[self.placed], self.t[self.placed], np.zeros((1, 3)))
        P = camera_matrices(block)
        X = triangulate_linear(pixels, P)
        image = np.insert(X, 3, 1.0, axis=1) @ P.swapaxes(1, 2)
        depth = np.where(image[..., 2:] > 0, image[..., 2:], np.nan)
        return X, np.linalg.norm(image[..., :2] / depth - pixels, axis=2)

    def _adjusted(self, pictures: tuple[int, ...], seen: int, agreed: int, before: int) -> None:
        """Adjust, throw out what does not fit, and record the step."""
        known = 0 if not self.steps else len(self.steps[-1].points)
        added = int(self.known.sum()) - known
        self._drop_lonely()
        block, observations, _ = self.block()
        rms_before = _rms(block, observations)
        self._settle()
        block, observations, points = self.block()
        self.steps.append(
            Step(
                pictures,
                seen,
                agreed,
                added,
                int(before - self.trusted.sum()),
                rms_before,
                _rms(block, observations),
                block,
                np.array(self.placed),
                points,
            )
        )

    def _settle(self) -> None:
        """Adjust and throw out in turn, until nothing is off."""
        for _ in range(ROUNDS):
            if not self._judge(self._adjustment(1e-4, ROBUST)):
                break

    def _adjustment(self, tolerance: float, robust: float | None) -> BundleAdjustment:
        """Adjust the block as it is, and take over the result."""
        block, observations, points = self.block()
        result = bundle_adjust(block, observations, robust=robust, tolerance=tolerance)
        self.R[self.placed], self.t[self.placed] = result.block.R, result.block.t
        self.X[points] = result.block.points
        return result

    def _judge(self, result: BundleAdjustment) -> bool:
        """Throw out what is too far off after an adjustment; return whether there was any."""
        _, observations, points = self.block()
        off = np.linalg.norm(result.residuals, axis=1) > self.threshold
        placed = np.array(self.placed)
        self._throw_out(placed[observations.cameras[off]], points[observations.points[off]], "off")
        self._drop_lonely()
        return bool(off.any())

    def _drop_lonely(self) -> None:
        """Throw out rays to points behind their camera, and points with too few rays."""
        placed = np.array(self.placed)
        depth = np.einsum("vj,nj->vn", self.R[placed, 2], self.X) + self.t[placed, 2][:, None]
        camera, point = np.nonzero(self.trusted[placed] & (depth <= 0))
        self._throw_out(placed[camera], point, "behind")
        self.X[~self._enough(self.trusted[placed].sum(axis=0), slice(None))] = np.nan


def _rms(block: Block, seen: Observations) -> float:
    away = block.project(seen.cameras, seen.points) - seen.pixels
    return float(np.sqrt((away**2).sum(axis=1).mean()))
