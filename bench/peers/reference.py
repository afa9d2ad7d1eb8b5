"""The continuous rod by shooting with an eighth-order integrator: prints the tip for clamp angles, to check bench/reference.json."""

import sys

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

WEIGHT = 10.0


def shoot(curvature, clamp):
    def slope(s, y):
        return [y[1], WEIGHT * (1 - s) * np.cos(y[0]), np.cos(y[0]), np.sin(y[0])]

    return solve_ivp(slope, (0, 1), [clamp, curvature, 0, 0], method="DOP853", rtol=2.3e-14, atol=1e-15).y[:, -1]


for degrees in map(float, sys.argv[1:]):
    clamp = np.deg2rad(degrees)
    base = brentq(lambda curvature: shoot(curvature, clamp)[1], -6, -1, xtol=1e-15, rtol=1e-15)
    _, _, x, y = shoot(base, clamp)
    print(f"{degrees:g} {x:.12f} {y:.12f} {-base:.12f}")
