"""Wrong answers to the exercises of chapter 04 on exposure and electrons."""

from __future__ import annotations

from typing import Any

import numpy as np

# --- exposure_value ---------------------------------------------------------------------------


def f_number_not_squared(N, t, iso=100):
    return np.log2(N / t) - np.log2(iso / 100)


def time_multiplied(N, t, iso=100):
    return np.log2(N**2 * t) - np.log2(iso / 100)


def natural_logarithm(N, t, iso=100):
    return np.log(N**2 / t) - np.log(iso / 100)


def decimal_logarithm(N, t, iso=100):
    return np.log10(N**2 / t) - np.log10(iso / 100)


def logarithm_left_out(N, t, iso=100):
    return N**2 / t / (iso / 100)


def logarithm_left_out_of_both(N, t, iso=100):
    return N**2 / t - iso / 100


def iso_the_other_way(N, t, iso=100):
    return np.log2(N**2 / t) + np.log2(iso / 100)


def iso_left_out(N, t, iso=100):
    return np.log2(N**2 / t)


def not_referred_to_100(N, t, iso=100):
    return np.log2(N**2 / t) - np.log2(iso)


# --- equivalent_exposure ----------------------------------------------------------------------


def aperture_not_squared(t, N, N_new, iso=100, iso_new=100):
    return t * (N_new / N) * (iso / iso_new)


def aperture_upside_down(t, N, N_new, iso=100, iso_new=100):
    return t * (N / N_new) ** 2 * (iso / iso_new)


def speed_upside_down(t, N, N_new, iso=100, iso_new=100):
    return t * (N_new / N) ** 2 * (iso_new / iso)


def speed_squared(t, N, N_new, iso=100, iso_new=100):
    return t * (N_new / N * iso / iso_new) ** 2


def speed_left_out(t, N, N_new, iso=100, iso_new=100):
    return t * (N_new / N) ** 2


def number_of_stops(t, N, N_new, iso=100, iso_new=100):
    return 2 * np.log2(N_new / N) - np.log2(iso_new / iso)


def number_of_stops_backwards(t, N, N_new, iso=100, iso_new=100):
    return np.log2(iso_new / iso) - 2 * np.log2(N_new / N)


def stops_added(t, N, N_new, iso=100, iso_new=100):
    return t + 2 * np.log2(N_new / N) - np.log2(iso_new / iso)


def only_the_factor(t, N, N_new, iso=100, iso_new=100):
    return (N_new / N) ** 2 * (iso / iso_new)


def one_f_number_squared(t, N, N_new, iso=100, iso_new=100):
    return t * N_new / N**2 * (iso / iso_new)


# --- sensor_response --------------------------------------------------------------------------


def every_photon_counts(photons, camera, exposure_time=0.0):
    electrons = np.minimum(photons + camera.dark_current * exposure_time, camera.full_well)
    return np.minimum(camera.gain * electrons + camera.offset, camera.white)


def offset_left_out(photons, camera, exposure_time=0.0):
    electrons = camera.quantum_efficiency * photons + camera.dark_current * exposure_time
    return np.minimum(camera.gain * np.minimum(electrons, camera.full_well), camera.white)


def offset_amplified(photons, camera, exposure_time=0.0):
    electrons = camera.quantum_efficiency * photons + camera.dark_current * exposure_time
    electrons = np.minimum(electrons, camera.full_well)
    return np.minimum(camera.gain * (electrons + camera.offset), camera.white)


def divided_by_gain(photons, camera, exposure_time=0.0):
    electrons = camera.quantum_efficiency * photons + camera.dark_current * exposure_time
    electrons = np.minimum(electrons, camera.full_well)
    return np.minimum(electrons / camera.gain + camera.offset, camera.white)


def numbers_without_end(photons, camera, exposure_time=0.0):
    electrons = camera.quantum_efficiency * photons + camera.dark_current * exposure_time
    return camera.gain * np.minimum(electrons, camera.full_well) + camera.offset


def never_clipped(photons, camera, exposure_time=0.0):
    electrons = camera.quantum_efficiency * photons + camera.dark_current * exposure_time
    return camera.gain * electrons + camera.offset


def never_clipped_without_dark(photons, camera, exposure_time=0.0):
    return camera.gain * camera.quantum_efficiency * photons + camera.offset


def photons_fill_the_well(photons, camera, exposure_time=0.0):
    electrons = camera.quantum_efficiency * np.minimum(photons, camera.full_well)
    electrons = electrons + camera.dark_current * exposure_time
    return np.minimum(camera.gain * electrons + camera.offset, camera.white)


def dark_needs_efficiency(photons, camera, exposure_time=0.0):
    electrons = camera.quantum_efficiency * (photons + camera.dark_current * exposure_time)
    electrons = np.minimum(electrons, camera.full_well)
    return np.minimum(camera.gain * electrons + camera.offset, camera.white)


def always_12_bits(photons, camera, exposure_time=0.0):
    electrons = camera.quantum_efficiency * photons + camera.dark_current * exposure_time
    electrons = np.minimum(electrons, camera.full_well)
    return np.minimum(camera.gain * electrons + camera.offset, 4095)


def clipped_too_early(photons, camera, exposure_time=0.0):
    electrons = camera.quantum_efficiency * photons + camera.dark_current * exposure_time
    electrons = np.minimum(electrons, camera.full_well)
    return np.minimum(camera.gain * electrons, camera.white) + camera.offset


def well_without_brim(photons, camera, exposure_time=0.0):
    electrons = camera.quantum_efficiency * photons + camera.dark_current * exposure_time
    return np.minimum(camera.gain * electrons + camera.offset, camera.white)


def dark_left_out(photons, camera, exposure_time=0.0):
    electrons = np.minimum(camera.quantum_efficiency * photons, camera.full_well)
    return np.minimum(camera.gain * electrons + camera.offset, camera.white)


def dark_added_to_full_wells(photons, camera, exposure_time=0.0):
    electrons = np.minimum(camera.quantum_efficiency * photons, camera.full_well)
    electrons = electrons + camera.dark_current * exposure_time
    return np.minimum(camera.gain * electrons + camera.offset, camera.white)


def dark_without_time(photons, camera, exposure_time=0.0):
    electrons = camera.quantum_efficiency * photons + camera.dark_current
    electrons = np.minimum(electrons, camera.full_well)
    return np.minimum(camera.gain * electrons + camera.offset, camera.white)


def larger_of_two(photons, camera, exposure_time=0.0):
    electrons = camera.quantum_efficiency * photons + camera.dark_current * exposure_time
    electrons = np.maximum(electrons, camera.full_well)
    return np.maximum(camera.gain * electrons + camera.offset, camera.white)


# --- signal_to_noise --------------------------------------------------------------------------


def deviations_added(photons, camera, exposure_time=0.0):
    signal = camera.quantum_efficiency * photons
    shot = np.sqrt(signal + camera.dark_current * exposure_time)
    return signal / (shot + camera.read_noise + camera.quantisation_noise)


def variance_for_deviation(photons, camera, exposure_time=0.0):
    signal = camera.quantum_efficiency * photons
    dark = camera.dark_current * exposure_time
    return signal / (signal + dark + camera.read_noise**2 + camera.quantisation_noise**2)


def noise_like_signal(photons, camera, exposure_time=0.0):
    signal = camera.quantum_efficiency * photons
    dark = camera.dark_current * exposure_time
    added = signal**2 + dark**2 + camera.read_noise**2 + camera.quantisation_noise**2
    return signal / np.sqrt(added)


def readout_not_squared(photons, camera, exposure_time=0.0):
    signal = camera.quantum_efficiency * photons
    dark = camera.dark_current * exposure_time
    return signal / np.sqrt(signal + dark + camera.read_noise + camera.quantisation_noise)


def photons_for_electrons(photons, camera, exposure_time=0.0):
    dark = camera.dark_current * exposure_time
    noise = photons + dark + camera.read_noise**2 + camera.quantisation_noise**2
    return photons / np.sqrt(noise)


def dark_as_signal(photons, camera, exposure_time=0.0):
    signal = camera.quantum_efficiency * photons + camera.dark_current * exposure_time
    return signal / np.sqrt(signal + camera.read_noise**2 + camera.quantisation_noise**2)


def dark_squared(photons, camera, exposure_time=0.0):
    signal = camera.quantum_efficiency * photons
    dark = camera.dark_current * exposure_time
    return signal / np.sqrt(signal + dark**2 + camera.read_noise**2 + camera.quantisation_noise**2)


def shot_noise_only(photons, camera, exposure_time=0.0):
    return np.sqrt(camera.quantum_efficiency * photons)


def dark_noise_left_out(photons, camera, exposure_time=0.0):
    signal = camera.quantum_efficiency * photons
    return signal / np.sqrt(signal + camera.read_noise**2 + camera.quantisation_noise**2)


def noise_alone(photons, camera, exposure_time=0.0):
    dark = camera.dark_current * exposure_time
    noise = camera.quantum_efficiency * photons + dark + camera.read_noise**2
    return np.sqrt(noise + camera.quantisation_noise**2)


def root_of_the_first_only(photons, camera, exposure_time=0.0):
    signal = camera.quantum_efficiency * photons
    fixed = camera.read_noise**2 + camera.quantisation_noise**2
    return signal / np.sqrt(signal) + camera.dark_current * exposure_time + fixed


def rounding_left_out(photons, camera, exposure_time=0.0):
    signal = camera.quantum_efficiency * photons
    return signal / np.sqrt(signal + camera.dark_current * exposure_time + camera.read_noise**2)


def dark_current_for_dark_electrons(photons, camera, exposure_time=0.0):
    signal = camera.quantum_efficiency * photons
    noise = signal + camera.dark_current + camera.read_noise**2 + camera.quantisation_noise**2
    return signal / np.sqrt(noise)


def rounding_in_numbers(photons, camera, exposure_time=0.0):
    return with_rounding(photons, camera, exposure_time, 1 / np.sqrt(12))


def with_rounding(photons: Any, camera: Any, exposure_time: float, step: float) -> Any:
    """Return the ratio with another noise of rounding."""
    signal = camera.quantum_efficiency * photons
    dark = camera.dark_current * exposure_time
    return signal / np.sqrt(signal + dark + camera.read_noise**2 + step**2)


def rounding_of_0_29(photons, camera, exposure_time=0.0):
    return with_rounding(photons, camera, exposure_time, 0.29)


def in_decibels(photons, camera, exposure_time=0.0):
    signal = camera.quantum_efficiency * photons
    dark = camera.dark_current * exposure_time
    noise = signal + dark + camera.read_noise**2 + camera.quantisation_noise**2
    return 20 * np.log10(signal / np.sqrt(noise))
