"""A sharp photograph in a few milliseconds, for pictures that follow a slider.

Every patch is drawn with the forward model of the pinhole camera: its outline is filled into a map
of who is seen where, on a grid finer than the pixels, and its texture is warped by a homography.
`data_generators.render` makes the same picture from rays; a test compares the two.
"""

from __future__ import annotations

import numpy as np

from course_lib.camera import Camera
from course_lib.checks import Array
from course_lib.transforms import camera_centre
from data_generators import paint
from data_generators.clipping import clip, pixels, slabs, view_planes
from data_generators.order import back_to_front, side_table
from data_generators.paint import Picture
from data_generators.pyramid import TexturePyramid, levels_for
from data_generators.scene import Scene

Pieces = list[tuple[int, Array]]  # index of the patch, corners in the camera frame (M, 3), m


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
        counts = np.array([len(p.outline) for p in patches], int)
        self._corners = np.concatenate([np.zeros((0, 3)), *(p.corners for p in patches)])
        self._ends = np.cumsum(counts)
        self._starts = self._ends - counts
        # Columns edge_u, edge_v, origin: a world point from (a, b, 1).
        frames = np.array([[p.edge_u, p.edge_v, p.origin] for p in patches]).reshape(-1, 3, 3)
        self._frames, self._origins = frames.transpose(0, 2, 1), frames[:, 2]
        self._normals = np.array([p.normal for p in patches]).reshape(-1, 3)
        self._one_sided = np.array([p.one_sided for p in patches], bool)
        pyramids: dict[int, TexturePyramid] = {}
        for patch in patches:
            pyramids.setdefault(id(patch.texture), TexturePyramid(patch.texture))
        self._pyramids = [pyramids[id(p.texture)] for p in patches]
        self._texels = np.array([p.size for p in self._pyramids], float).reshape(-1, 2)
        self._repeat = np.array([p.repeat for p in patches], float).reshape(-1, 2)
        self._highest = np.array([p.highest for p in self._pyramids], int).reshape(-1, 2)
        self._sides = side_table(self._corners, self._starts, self._origins, self._normals)

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
        pieces = self._pieces(camera)
        polygons = [pixels(corners, camera.K) for _, corners in pieces]
        owners = paint.fill_owners(polygons, camera.image_size, self.subpixels)
        boxes = [paint.bounding_box(polygon, camera.image_size) for polygon in polygons]
        shares = [
            paint.share_of(owners, number, box, self.subpixels)
            for number, box in enumerate(boxes, 1)
        ]
        width, height = camera.image_size
        picture = np.zeros((height, width, 3), np.uint8)
        everywhere = (0, 0, width, height)
        nobody = paint.share_of(owners, 0, everywhere, self.subpixels)
        if nobody is not None:
            paint.add_colour(picture, nobody, everywhere, self.scene.background)
        patches = np.array([patch for patch, _ in pieces], int)
        maps, levels = self._texture_maps(patches, polygons, camera)
        for patch, share, box, homography, level in zip(
            patches.tolist(), shares, boxes, maps, levels.tolist(), strict=True
        ):
            if share is not None:
                self._add(picture, patch, share, box, homography, level)
        return picture

    def _add(
        self,
        picture: Picture,
        patch: int,
        share: Picture,
        box: paint.Box,
        homography: Array,
        level: tuple[int, int],
    ) -> None:
        """Add one piece to the picture."""
        texture = self._pyramids[patch].level(*level)
        if texture.shape[:2] == (1, 1):
            red, green, blue = texture[0, 0].tolist()
            paint.add_colour(picture, share, box, (red, green, blue))
            return
        wrap = bool((self._repeat[patch] != 1).any())
        rows, columns = texture.shape[:2]
        repeat_u, repeat_v = self._repeat[patch]
        # Texel from (a, b): the first texel's centre is half a texel from the edge.
        texel_from_patch = np.array(
            [[columns * repeat_u, 0, -0.5], [0, rows * repeat_v, -0.5], [0, 0, 1]]
        )
        paint.add_texture(picture, share, box, texture, texel_from_patch @ homography, wrap)

    def _pieces(self, camera: Camera) -> Pieces:
        """Return the visible parts of the patches, in the order of painting."""
        patches, polygons = self._visible(camera)
        pieces: Pieces = []
        for i in self._order(patches, polygons, camera):
            solid = not self._highest[patches[i]].any()
            parts = [polygons[i]] if solid else slabs(polygons[i])
            pieces += [(patches[i], part) for part in parts]
        return pieces

    def _visible(self, camera: Camera) -> tuple[list[int], list[Array]]:
        """Return the patches that face the camera and are in view, clipped, camera frame."""
        if not self.scene.patches:
            return [], []
        eye = camera_centre(camera.R, camera.t)
        facing = np.sum(self._normals * (eye - self._origins), axis=1) > 0
        corners = self._corners @ camera.R.T + camera.t
        planes, offsets = view_planes(camera.K, camera.image_size)
        inside = corners @ planes.T >= offsets
        some = np.asarray(np.logical_or.reduceat(inside, self._starts), bool).all(axis=1)
        every = np.asarray(np.logical_and.reduceat(inside, self._starts), bool).all(axis=1)
        to_clip: list[bool] = np.logical_not(every).tolist()
        patches, polygons = [], []
        for index in np.flatnonzero(some & (facing | ~self._one_sided)).tolist():
            polygon = corners[self._starts[index] : self._ends[index]]
            if to_clip[index]:
                for plane, offset in zip(planes, offsets, strict=True):
                    polygon = clip(polygon, plane, offset) if len(polygon) else polygon
            if len(polygon):
                patches.append(index)
                polygons.append(polygon)
        return patches, polygons

    def _order(self, patches: list[int], polygons: list[Array], camera: Camera) -> list[int]:
        """Return positions in `patches` from back to front."""
        if len(patches) < 2:
            return list(range(len(patches)))
        eye = camera_centre(camera.R, camera.t)
        height: Array = (self._normals[patches] * (eye - self._origins[patches])).sum(axis=1)
        front, behind = (table[np.ix_(patches, patches)] for table in self._sides)
        eye_in_front = (height > 0)[:, None]
        boxes = [pixels(p, camera.K) for p in polygons]
        return back_to_front(
            np.where(eye_in_front, front, behind),
            np.where(eye_in_front, behind, front),
            np.array([[*box.min(axis=0), *box.max(axis=0)] for box in boxes]),
            np.array([polygon[:, 2].max() for polygon in polygons]),
        )

    def _texture_maps(
        self, patches: np.ndarray, polygons: list[Array], camera: Camera
    ) -> tuple[Array, np.ndarray]:
        """Return for each piece the homography (a, b) from pixel, and the texture's level."""
        frames = camera.R @ self._frames[patches]
        frames[:, :, 2] += camera.t
        maps = np.linalg.inv(camera.K @ frames)
        middle = np.array([[*p.mean(axis=0), 1.0] for p in polygons]).reshape(-1, 3)
        a, b, w = (maps @ middle[:, :, None])[:, :, 0].T
        # Derivative of (a / w, b / w) by the pixel, largest of the two directions.
        jacobian = maps[:, :2, :2] - np.stack([a / w, b / w], 1)[:, :, None] * maps[:, 2:, :2]
        footprint = np.abs(jacobian / w[:, None, None]).max(axis=2)
        scale = self._texels[patches] * self._repeat[patches]
        return maps, levels_for(footprint * scale, self._highest[patches])
