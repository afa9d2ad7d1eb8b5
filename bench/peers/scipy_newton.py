"""Newton's method on the same discrete system, as one would write it with NumPy and SciPy's banded solver.

Its first step turns the rod over, and it takes up to 18 iterations to come back. With "tuned" no step turns a segment by more than 1.5 rad:
then it takes four, and no other limit takes fewer.
"""

import sys

import numpy as np
from scipy.linalg import solve_banded

from case import CLAMP, TOLERANCE, answer, residual, stiffness, tip, weights

LIMIT = 1.5 if "tuned" in sys.argv else np.inf


def prepare(n):
    kappa = stiffness(n)
    lifted = np.cumsum(weights(n)[::-1])[::-1] / n
    bands = np.zeros((3, n))
    bands[0, 1:] = bands[2, :-1] = -kappa[1:]
    springs = kappa.copy()
    springs[:-1] += kappa[1:]

    def solve():
        angles = np.full(n, CLAMP)
        for iterations in range(50):
            cosine = np.cos(angles)
            left = kappa * np.diff(angles, prepend=CLAMP)
            torque = -np.cumsum((lifted * cosine)[::-1])[::-1]
            left -= torque
            if np.abs(left).max() <= TOLERANCE * np.abs(torque).max():
                break
            bands[1] = springs - lifted * np.sin(angles)
            gradient = left.copy()
            gradient[:-1] -= left[1:]
            step = solve_banded((1, 1), bands, gradient, check_finite=False)
            angles -= step * min(1, LIMIT / np.abs(step).max())
        return {"tip": tip(angles), "residual": residual(angles), "steps": iterations}

    return solve


answer(prepare)
