"""The still figures of chapter 04, one function each."""

from __future__ import annotations

from course_lib.drawing.sensor.chain import (
    acquisition_chain,
    light_to_number,
)
from course_lib.drawing.sensor.colour import (
    colour_spaces,
    colour_strategies,
    development,
    dimmed_belt,
    gamma_curve,
    spectrum,
)
from course_lib.drawing.sensor.exposure import (
    STOPS,
    apertures_to_scale,
    belt_photographs,
    exposure_chart,
)
from course_lib.drawing.sensor.histograms import (
    corrected_afterwards,
    gain_before_or_after,
    histogram_series,
    street_exposed,
    street_light,
)
from course_lib.drawing.sensor.lighting import (
    BACK_LIT,
    back_lit,
    lamp_drift,
    stripe_geometry,
    three_lights,
)
from course_lib.drawing.sensor.mosaics import computed_raw, label_and_nut, mosaic_and_back
from course_lib.drawing.sensor.noise import (
    photon_patches,
    photon_transfer,
    response_curve,
    snr_curve,
)
from course_lib.drawing.sensor.readout import (
    clock_blur,
    shutters,
    skewed_pole,
    ways_of_reading,
)
from course_lib.drawing.sensor.sampling import (
    aliasing,
    height_field,
    quantisation,
    sampled_wave,
)
from course_lib.drawing.sensor.scan import scanned_profile, stripe_scan
from course_lib.drawing.sensor.shading import (
    colour_fringes,
    flat_field_series,
    vignetting_profile,
)

__all__ = [
    "BACK_LIT",
    "STOPS",
    "acquisition_chain",
    "aliasing",
    "apertures_to_scale",
    "back_lit",
    "belt_photographs",
    "clock_blur",
    "colour_fringes",
    "colour_spaces",
    "colour_strategies",
    "computed_raw",
    "corrected_afterwards",
    "development",
    "dimmed_belt",
    "exposure_chart",
    "flat_field_series",
    "gain_before_or_after",
    "gamma_curve",
    "height_field",
    "histogram_series",
    "label_and_nut",
    "lamp_drift",
    "light_to_number",
    "mosaic_and_back",
    "photon_patches",
    "photon_transfer",
    "quantisation",
    "response_curve",
    "sampled_wave",
    "scanned_profile",
    "shutters",
    "skewed_pole",
    "snr_curve",
    "spectrum",
    "street_exposed",
    "street_light",
    "stripe_geometry",
    "stripe_scan",
    "three_lights",
    "vignetting_profile",
    "ways_of_reading",
]
