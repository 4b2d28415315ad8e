# SPDX-License-Identifier: GPL-3.0-or-later
"""Self-affine surface as a sum of waves, so that every grid samples the same surface.

`samcontact.surfaces.rough_self_affine` filters noise on the given grid, so another grid gives
another surface.
"""

from __future__ import annotations

import numpy as np


def wave_amplitudes(highest: int, hurst: float, seed: int, lowest: int = 1) -> np.ndarray:
    """Return the complex amplitudes of waves with kx and ky periods over the side.

    The indices of the array are [kx, ky], with kx = -highest .. highest and ky = 0 .. highest. The
    waves are isotropic: the power decreases as k^(-2 (1 + hurst)) for lowest <= k <= highest, where
    k is the magnitude of (kx, ky), and is zero elsewhere.
    """
    rng = np.random.default_rng(seed)
    kx, ky = np.arange(-highest, highest + 1)[:, None], np.arange(highest + 1)[None, :]
    k = np.hypot(kx, ky)
    inside = (k >= lowest) & (k <= highest)
    phase = np.exp(2j * np.pi * rng.random(k.shape))
    return np.where(inside, np.maximum(k, 1.0) ** -(1.0 + hurst), 0.0) * phase


def heights(n: int, amplitudes: np.ndarray, rms: float) -> np.ndarray:
    """Return heights of zero mean and given rms at the centres of n x n cells.

    n must be more than twice the highest number of periods.
    """
    highest = amplitudes.shape[1] - 1
    if n <= 2 * highest:
        raise ValueError(f"n must be > {2 * highest}, got {n}")
    kx, ky = np.arange(-highest, highest + 1), np.arange(highest + 1)
    # Cell centres lie half a cell away from the points of the inverse transform.
    shift = np.exp(1j * np.pi / n * (kx[:, None] + ky[None, :]))
    spectrum = np.zeros((n, n), complex)
    spectrum[kx[:, None], ky[None, :]] = amplitudes * shift
    # The real part has half the mean square, except that opposite waves interfere on ky = 0.
    surface = n * n * np.fft.ifft2(spectrum).real
    return rms / surface_rms(amplitudes) * surface


def surface_rms(amplitudes: np.ndarray) -> float:
    """Return the rms of the real part of the sum of waves over the whole surface."""
    on_axis = 0.5 * (amplitudes[:, 0] + np.conj(amplitudes[::-1, 0]))
    return float(
        np.sqrt(np.sum(np.abs(on_axis) ** 2) + 0.5 * np.sum(np.abs(amplitudes[:, 1:]) ** 2))
    )


def block_means(field: np.ndarray, n: int) -> np.ndarray:
    """Return the means over the n x n blocks of a square field."""
    m = field.shape[0] // n
    return field.reshape(n, m, n, m).mean(axis=(1, 3))
