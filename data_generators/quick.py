"""A sharp photograph in a few milliseconds, for pictures that follow a slider.

Every patch is drawn with the forward model of the pinhole camera: its outline is filled into a map
of who is seen where, on a grid finer than the pixels, and its texture is warped by a homography.
`data_generators.render` makes the same picture from rays; a test compares the two.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from course_lib.camera import Camera
from course_lib.checks import Array
from data_generators import paint
from data_generators.clipping import SLAB, Polygons, clip, slabs, view_planes
from data_generators.order import back_to_front, side_table
from data_generators.paint import Picture
from data_generators.pyramid import TexturePyramid, levels_for
from data_generators.scene import Colour, Scene, Texture

#: m: a patch whose plane is this near to the camera is seen from the edge, as nothing.
EDGE_ON = 1e-9


class QuickRenderer:
    """Draws one scene again and again, through cameras that change.

    Parameters
    ----------
    scene : Scene
        What to draw. Textures are reduced on first use, so the first picture takes longer.
    subpixels : int
        Outlines are smoothed on a grid of this many subpixels a pixel, both ways: 1, 2, 4 or 8.

    Examples
    --------
    >>> from data_generators.places import street, street_camera
    >>> QuickRenderer(street()).picture(street_camera((160, 120))).shape
    (120, 160, 3)
    """

    def __init__(self, scene: Scene, subpixels: int = 4) -> None:
        if subpixels not in (1, 2, 4, 8):
            raise ValueError(f"subpixels must be 1, 2, 4 or 8, got {subpixels!r}")
        self.scene, self.subpixels = scene, subpixels
        patches = scene.patches
        self._outlines = Polygons.of([p.corners for p in patches])
        # Columns edge_u, edge_v, origin: a world point from (a, b, 1).
        frames = np.array([[p.edge_u, p.edge_v, p.origin] for p in patches]).reshape(-1, 3, 3)
        self._frames, self.origins = frames.transpose(0, 2, 1), frames[:, 2]
        self.normals = np.array([p.normal for p in patches]).reshape(-1, 3)
        self._one_sided = np.array([p.one_sided for p in patches], bool)
        pyramids: dict[int, TexturePyramid] = {}
        for patch in patches:
            pyramids.setdefault(id(patch.texture), TexturePyramid(patch.texture))
        self._pyramids = [pyramids[id(p.texture)] for p in patches]
        self._repeat = np.array([p.repeat for p in patches], float).reshape(-1, 2)
        self._wraps: list[bool] = (self._repeat != 1).any(axis=1).tolist()
        self._texels = np.array([p.size for p in self._pyramids]).reshape(-1, 2) * self._repeat
        self._highest = np.array([p.highest for p in self._pyramids], int).reshape(-1, 2)
        self._textured: NDArray[np.bool_] = np.asarray(self._highest.any(axis=1))
        self._plain = np.array([p.texture[0, 0] for p in patches], np.uint8).reshape(-1, 3)
        self._sides = side_table(
            self._outlines.corners, self._outlines.starts, self.origins, self.normals
        )

    def picture(self, camera: Camera) -> Picture:
        """Return what a sharp pinhole camera sees.

        Parameters
        ----------
        camera : Camera
            The camera, in the scene's world.

        Returns
        -------
        ndarray, shape (height, width, 3), uint8
            RGB, linear in light.
        """
        patches, parts = self.pieces(camera)
        return self.painted(patches, parts, camera, self.scene.background)[0]

    def painted(
        self, patches: list[int], parts: list[Array], camera: Camera, background: Colour
    ) -> tuple[Picture, NDArray[Any]]:
        """Return the picture of pieces, and who is seen where in it.

        Parameters
        ----------
        patches : list of int
            The patch that each piece is part of.
        parts : list of ndarray, shape (M, 3)
            Corners in the camera frame, m; from back to front, in view.
        camera : Camera
            The camera.
        background : tuple of int
            RGB where there is no piece.

        Returns
        -------
        picture : ndarray, shape (height, width, 3), uint8
            RGB, linear in light.
        owners : ndarray, shape (height subpixels, width subpixels)
            Number of the piece plus 1, or 0 for none.
        """
        width, height = camera.image_size
        if not patches:
            nobody = np.zeros((height * self.subpixels, width * self.subpixels), np.uint8)
            return np.full((height, width, 3), background, np.uint8), nobody
        polygons = Polygons.of(parts).seen_through(camera.K)
        owners = paint.fill_owners(polygons, camera.image_size, self.subpixels)
        colours = np.concatenate([np.array([background], np.uint8), self._plain[patches]])
        textured = np.flatnonzero(self._textured[patches])
        colours[textured + 1] = 0
        picture = paint.coloured(owners, colours, self.subpixels)
        boxes = paint.bounding_boxes(polygons, camera.image_size)
        which = [patches[k] for k in textured.tolist()]
        maps, textures = self._texture_maps(which, polygons.middle()[textured], camera)
        for k, patch, homography, texture in zip(
            textured.tolist(), which, maps, textures, strict=True
        ):
            share, box = paint.share_of(owners, k + 1, boxes[k], self.subpixels)
            if share is not None and box is not None:
                paint.add_texture(picture, share, box, texture, homography, self._wraps[patch])
        return picture, owners

    def pieces(self, camera: Camera) -> tuple[list[int], list[Array]]:
        """Return the visible parts of the patches, in the order of painting.

        Parameters
        ----------
        camera : Camera
            The camera, in the scene's world.

        Returns
        -------
        patches : list of int
            The patch that each part belongs to.
        parts : list of ndarray, shape (M, 3)
            Corners in the camera frame, m.
        """
        patches, polygons = self._visible(camera)
        if not patches:
            return [], []
        together = Polygons.of(polygons)
        depths = np.stack([together.low()[:, 2], together.high()[:, 2]], axis=1)
        whole = (depths[:, 1] < SLAB * depths[:, 0]) | ~self._textured[patches]
        owners, parts = [], []
        for i in self._order(patches, together, camera):
            slices = [polygons[i]] if whole[i] else slabs(polygons[i])
            parts += slices
            owners += [patches[i]] * len(slices)
        return owners, parts

    def _visible(self, camera: Camera) -> tuple[list[int], list[Array]]:
        """Return the patches that face the camera and are in view, clipped, camera frame."""
        if not self.scene.patches:
            return [], []
        eye = camera.centre
        height = np.sum(self.normals * (eye - self.origins), axis=1)
        facing = np.where(self._one_sided, height, np.abs(height)) > EDGE_ON
        world = self._outlines
        corners = world.corners @ camera.R.T + camera.t
        planes, offsets = view_planes(camera.K, camera.image_size)
        inside = corners @ planes.T >= offsets
        some = np.asarray(np.logical_or.reduceat(inside, world.starts), bool).all(axis=1)
        every = np.asarray(np.logical_and.reduceat(inside, world.starts), bool)
        crossing: list[list[bool]] = np.logical_not(every).tolist()
        starts, ends = world.starts.tolist(), world.ends.tolist()
        patches, polygons = [], []
        for index in np.flatnonzero(some & facing).tolist():
            polygon = corners[starts[index] : ends[index]]
            if any(crossing[index]):
                for plane, offset, cut in zip(planes, offsets, crossing[index], strict=True):
                    polygon = clip(polygon, plane, offset) if cut else polygon
            if len(polygon):
                patches.append(index)
                polygons.append(polygon)
        return patches, polygons

    def _order(self, patches: list[int], polygons: Polygons, camera: Camera) -> list[int]:
        """Return positions in `patches` from back to front."""
        eye = camera.centre
        height: Array = (self.normals[patches] * (eye - self.origins[patches])).sum(axis=1)
        # Rows, then columns: six times as fast as both at once.
        front, behind = (table.take(patches, 0).take(patches, 1) for table in self._sides)
        eye_in_front = (height > 0)[:, None]
        seen = polygons.seen_through(camera.K)
        return back_to_front(
            np.where(eye_in_front, front, behind),
            np.where(eye_in_front, behind, front),
            np.concatenate([seen.low(), seen.high()], axis=1),
            polygons.high()[:, 2],
        )

    def _texture_maps(
        self, patches: list[int], middle: Array, camera: Camera
    ) -> tuple[Array, list[Texture]]:
        """Return for pieces of patches the homography texel from pixel, and the texture."""
        frames = camera.R @ self._frames[patches]
        frames[:, :, 2] += camera.t
        maps = np.linalg.inv(camera.K @ frames)
        a, b, w = np.einsum("nij,nj->in", maps, np.insert(middle, 2, 1.0, axis=1))
        # Derivative of (a / w, b / w) by the pixel, in texels.
        jacobian = maps[:, :2, :2] - np.stack([a / w, b / w], 1)[:, :, None] * maps[:, 2:, :2]
        jacobian *= self._texels[patches][:, :, None] / w[:, None, None]
        footprint = np.abs(jacobian).max(axis=2)
        # A slanted footprint is narrower than the rectangle around it: a compromise between both.
        area = np.abs(np.linalg.det(jacobian))
        slant = np.maximum(1, footprint.prod(axis=1) / np.maximum(3 * area, 1e-12))
        footprint /= np.sqrt(slant)[:, None]
        levels = levels_for(footprint, self._highest[patches]).tolist()
        textures = [self._pyramids[p].in_fours(*ij) for p, ij in zip(patches, levels, strict=True)]
        sizes = np.array([texture.shape[1::-1] for texture in textures]).reshape(-1, 2)
        # The first texel's centre is half a texel from the edge.
        maps[:, :2] = maps[:, :2] * (sizes * self._repeat[patches])[:, :, None] - 0.5 * maps[:, 2:]
        return np.asarray(maps), textures
