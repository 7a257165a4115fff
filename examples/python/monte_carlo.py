"""Transmission errors of ten thousand housings with random errors of mounting. Run by the tests."""

import sys

import gearwright as gw
import numpy as np

ARCSEC = 3600 * 180 / np.pi
count = int(sys.argv[1]) if len(sys.argv) > 1 else 10_000

pair = gw.load("examples/misaligned_pair.toml")
spread = [0.02, 2e-4, 2e-4, 0.05, 0.004, 0.004]  # mm, rad: gw.ERRORS
te = pair.transmission_error(np.random.default_rng(7).normal(0, spread, (count, 6)), positions=32)
peak = np.ptp(te, axis=1) * ARCSEC
print(f"{count} housings: median {np.nanmedian(peak):.2f} arcsec, one in twenty above {np.nanquantile(peak, 0.95):.2f}")
