"""The case of all peers, and how each answers: one line of JSON for each line `<segments> <rounds>`.

A rod of length 1 and EI = 1, clamped at 50 degrees above the horizontal, of weight 10: q = w L^3 / EI = 10. The cut is the second-order
one: half a segment's mass at each of its ends, spring constant 2 EI / l at the clamp and EI / l elsewhere.
"""

import json
import sys
import time

import numpy as np

CLAMP = np.deg2rad(50)
WEIGHT = 10.0
TOLERANCE = 1e-6


def stiffness(n):
    """Spring constant of each joint, from the clamp to the tip."""
    kappa = np.full(n, float(n))
    kappa[0] *= 2
    return kappa


def weights(n):
    """Weight at the end of each segment."""
    weight = np.full(n, WEIGHT / n)
    weight[-1] /= 2
    return weight


def torques(angles):
    """Torque of the weights about the base of each segment."""
    n = len(angles)
    carried = np.cumsum(weights(n)[::-1])[::-1]
    return np.cumsum((-carried * np.cos(angles) / n)[::-1])[::-1]


def residual(angles):
    """Largest torque left over at a joint, relative to the largest torque."""
    deviation = np.diff(angles, prepend=CLAMP)
    torque = torques(angles)
    return np.abs(stiffness(len(angles)) * deviation - torque).max() / np.abs(torque).max()


def tip(angles):
    """Where the rod ends."""
    return [np.cos(angles).mean(), np.sin(angles).mean()]


def answer(prepare):
    """Times `prepare(n)()`, which returns a dict with the tip and the residual, as often as is asked for."""
    made = {}
    for line in sys.stdin:
        n, rounds = (int(word) for word in line.split())
        try:
            if n not in made:
                made[n] = prepare(n)
            start = time.perf_counter()
            for _ in range(rounds):
                result = made[n]()
            seconds = time.perf_counter() - start
            print(json.dumps({"seconds": seconds, **result}), flush=True)
        except Exception as error:  # whatever a peer throws is its result
            print(json.dumps({"failed": f"{type(error).__name__}: {error}"}), flush=True)
