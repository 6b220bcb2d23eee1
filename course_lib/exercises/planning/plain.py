"""Chapter 11 written out plainly: what a camera sees of a box, and the arithmetic of a flight.

The library (`course_lib.planning`) checks what comes in, and takes cameras and boxes that are
turned in any way. The tests hold the two against each other.
"""

from __future__ import annotations

import numpy as np


def box_in_view(size, centre, motion, P, image_size):
    """Return how much room a picture leaves around a box that moves.

    The edges of the box are parallel to the axes of the world. It moves along each axis to both
    sides, so that it needs the room of a larger box with the size ``size + 2 motion``. An edge of
    the picture is the edge of its outermost pixels: ``u = -0.5`` on the left and
    ``u = width - 0.5`` on the right, and likewise for v.

    Parameters
    ----------
    size, centre : ndarray, shape (3,)
        Lengths of the edges of the box, and its middle, m.
    motion : ndarray, shape (3,)
        How far it moves along x, y and z, to each side, m.
    P : ndarray, shape (3, 4)
        Camera matrix.
    image_size : tuple of int
        Width and height of the picture, px.

    Returns
    -------
    ndarray, shape (4,)
        Room between the eight corners and the picture's left, right, top and bottom edge, px;
        negative where the box is cut off. If the third number ``w`` of ``P (X, Y, Z, 1)`` is not
        positive for a corner, it has no image: then four times ``-np.inf``.

    Examples
    --------
    >>> P = np.array([[1000, 0, 319.5, 639], [0, 1000, 239.5, 479], [0, 0, 1, 2]])
    >>> size, centre, motion = np.array([1, 0.5, 0.4]), np.array([0, 0, 0.0]), np.array([0, 0, 0.0])
    >>> box_in_view(size, centre, motion, P, (640, 480)).round(1)
    array([ 42.2,  42.2, 101.1, 101.1])
    """
    half = size / 2 + motion
    signs = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    corners = centre + signs * half
    a, b, w = P @ np.column_stack([corners, np.ones(8)]).T
    if (w <= 0).any():
        return np.full(4, -np.inf)
    u, v = a / w, b / w
    width, height = image_size
    left, top = u.min() + 0.5, v.min() + 0.5
    right, bottom = width - 0.5 - u.max(), height - 0.5 - v.max()
    return np.array([left, right, top, bottom])


def object_resolution(Z, f_mm, pitch_um, tilt):
    """Return what one pixel covers on a surface: in its finest and its coarsest direction.

    A surface that faces the camera shows ``Z pitch / f`` in each pixel. Tilted by an angle, it is
    foreshortened in one direction, in which a pixel covers ``1 / cos(tilt)`` times as much. (This
    is exact in the middle of the picture.)

    Parameters
    ----------
    Z : float
        Distance of the surface along the axis, m.
    f_mm : float
        Focal length, mm.
    pitch_um : float
        Pixel pitch, µm.
    tilt : float
        Angle between the surface and one that faces the camera, rad.

    Returns
    -------
    finest, coarsest : float
        m/px.

    Examples
    --------
    >>> finest, coarsest = object_resolution(2.0, f_mm=50, pitch_um=5, tilt=np.radians(60))
    >>> print(f"{1000 * finest:.3f} mm and {1000 * coarsest:.3f} mm")
    0.200 mm and 0.400 mm
    """
    finest = Z * (pitch_um * 1e-6) / (f_mm * 1e-3)
    return finest, finest / np.cos(tilt)


def aperture_window(f_mm, near, far, spot_um, wavelength_um):
    """Return the smallest and the largest f-number at which a whole depth range is sharp.

    Both ends are equally sharp with the focus at ``s = 2 near far / (near + far)``. Their spots
    measure ``c`` at the f-number ``f² (far - s) / (c far (s - f))``. Diffraction makes a disk of
    the diameter ``2.44 λ N (1 + m)``, with the magnification ``m = f / (s - f)``; it measures c at
    the largest f-number.

    Parameters
    ----------
    f_mm : float
        Focal length f, mm.
    near, far : float
        Distances of the two ends from the lens, m.
    spot_um : float
        Diameter c of the largest spot that counts as sharp, µm.
    wavelength_um : float
        Wavelength λ of the light, µm.

    Returns
    -------
    least, most : float
        f-numbers. Where least > most, no aperture does both.

    Examples
    --------
    >>> least, most = aperture_window(50, near=0.95, far=1.05, spot_um=10, wavelength_um=0.55)
    >>> print(f"f/{least:.1f} to f/{most:.1f}")
    f/13.2 to f/7.1
    """
    f, c, wavelength = f_mm / 1e3, spot_um / 1e6, wavelength_um / 1e6
    s = 2 * near * far / (near + far)
    least = f**2 * (far - s) / (c * far * (s - f))
    m = f / (s - f)
    most = c / (2.44 * wavelength * (1 + m))
    return least, most


def ground_sample_distance(H, f_mm, pitch_um):
    """Return what one pixel covers on the ground: ``GSD = H pitch / f``.

    Parameters
    ----------
    H : float or ndarray
        Height above the ground, m; one, or one for each place.
    f_mm : float
        Focal length, mm.
    pitch_um : float
        Pixel pitch, µm.

    Returns
    -------
    float or ndarray
        Ground sampling distance, m.

    Examples
    --------
    >>> round(ground_sample_distance(100, f_mm=8.8, pitch_um=2.41), 4)
    0.0274
    """
    return H * (pitch_um * 1e-6) / (f_mm * 1e-3)


def overlap(base, footprint):
    """Return which share of a picture the next one shows too, on flat ground.

    Parameters
    ----------
    base : float or ndarray
        From one picture to the next, m; one, or one for each pair.
    footprint : float
        Length of the ground in a picture, in the direction of the flight, m.

    Returns
    -------
    float or ndarray
        Overlap: 0.8 stands for 80 %. A negative one is a gap.

    Examples
    --------
    >>> overlap(20, 80)
    0.75
    """
    return 1 - base / footprint


def base_for_overlap(share, footprint):
    """Return how far apart pictures are taken so that neighbours overlap by a share.

    Parameters
    ----------
    share : float or ndarray
        Overlap, from 0 to below 1; one, or one for each flight.
    footprint : float
        Length of the ground in a picture, in the direction of the flight, m.

    Returns
    -------
    float or ndarray
        Base, m.

    Examples
    --------
    >>> round(base_for_overlap(0.8, 90), 6)
    18.0
    """
    return (1 - share) * footprint


def max_speed(base, interval, gsd, exposure_time, blur):
    """Return how fast a camera may fly: in time for the next picture, and without a smear.

    From one picture to the next it may fly one base. While a picture is exposed it may fly as far
    as `blur` pixels cover on the ground.

    Parameters
    ----------
    base : float or ndarray
        From one picture to the next, m; one, or one for each flight.
    interval : float
        Shortest time from one picture to the next, s.
    gsd : float or ndarray
        Ground sampling distance, m.
    exposure_time : float
        s.
    blur : float
        Longest smear accepted, px.

    Returns
    -------
    float or ndarray
        Speed that meets both demands, m/s.

    Examples
    --------
    >>> round(float(max_speed(18, 2, gsd=0.02, exposure_time=1 / 1000, blur=0.5)), 6)
    9.0
    >>> round(float(max_speed(18, 2, gsd=0.02, exposure_time=1 / 500, blur=0.5)), 6)
    5.0
    """
    return np.minimum(base / interval, blur * gsd / exposure_time)


def photo_count(length, width, base, distance, footprint_width):
    """Return how many pictures a rectangle on flat ground takes: in a strip, and strips.

    The first picture of a strip is taken above one end of the rectangle, the last one above the
    other end or beyond. The strips together must be as wide as the rectangle or wider: one strip
    is as wide as a footprint, and each further one adds a distance.

    Parameters
    ----------
    length, width : float
        Of the rectangle, along and across the strips, m.
    base : float
        From one picture to the next in a strip, m.
    distance : float
        From one strip to the next, m.
    footprint_width : float
        Of what a picture covers across the strip, m.

    Returns
    -------
    pictures, strips : int
        Pictures in each strip, and strips: at least one.

    Examples
    --------
    >>> photo_count(length=500, width=300, base=18, distance=36, footprint_width=110)
    (29, 7)
    """
    pictures = int(np.ceil(length / base)) + 1
    strips = int(np.ceil((width - footprint_width) / distance)) + 1
    return pictures, max(strips, 1)
