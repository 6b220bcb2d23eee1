"""Common sensors and their names: one table for figures, explorers and lessons."""

from __future__ import annotations

#: Width and height in mm of common sensors. Makers differ by a few tenths of a millimetre.
SENSORS = {
    "full frame (FX)": (36.0, 24.0),
    "APS-C (DX)": (23.5, 15.6),
    "Micro Four Thirds": (17.3, 13.0),
    "1 inch": (13.2, 8.8),
    "1/2.3 inch": (6.17, 4.55),
}
#: The sensor that others are compared with.
FULL_FRAME = "full frame (FX)"
