"""SciPy's boundary value solver on the continuous rod; the number of segments is that of its first mesh."""

import numpy as np
from scipy.integrate import solve_bvp

from case import CLAMP, WEIGHT, answer


def slope(s, y):
    """Angle, curvature and place: the bending moment loses the weight beyond times its lever."""
    angle, curvature, _, _ = y
    return np.vstack((curvature, WEIGHT * (1 - s) * np.cos(angle), np.cos(angle), np.sin(angle)))


def ends(base, tip):
    return np.array([base[0] - CLAMP, tip[1], base[2], base[3]])


def prepare(n):
    s = np.linspace(0, 1, n + 1)

    def solve():
        straight = np.vstack((np.full_like(s, CLAMP), np.zeros_like(s), s * np.cos(CLAMP), s * np.sin(CLAMP)))
        found = solve_bvp(slope, ends, s, straight, tol=1e-6)
        if not found.success:
            raise RuntimeError(found.message)
        return {"tip": found.y[2:, -1].tolist(), "residual": float(found.rms_residuals.max()), "steps": found.niter}

    return solve


answer(prepare)
