"""Contact ratio over both profile shifts, half a million pairs of 17 and 43 teeth. Run by the tests."""

import gearwright as gw
import numpy as np

x1, x2 = np.linspace(-0.5, 1.0, 751)[:, None], np.linspace(-0.5, 1.0, 751)
table = gw.pair_table(17, 43, x1, x2)
(low1, high1), (low2, high2) = gw.shift_limits(17), gw.shift_limits(43)
allowed = (x1 >= low1) & (x1 <= high1) & (x2 >= low2) & (x2 <= high2)
ratio = np.where(allowed, table["contact_ratio_true"], np.nan)
best = np.unravel_index(np.nanargmax(ratio), ratio.shape)
print(f"greatest contact ratio {ratio[best]:.4f} at x1 = {x1[best[0], 0]:.3f}, x2 = {x2[best[1]]:.3f}")
