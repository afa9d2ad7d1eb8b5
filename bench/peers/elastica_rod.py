"""PyElastica: a Cosserat rod, let go until it rests.

A Cosserat rod can be stretched and sheared. Here it is so slender (radius 1/100 of its length) that this changes the tip by about 1e-4 only;
a more slender one is stiffer against both, and takes smaller time steps. Its clamp holds the whole first element. Damped so that its slowest
swing dies soonest; at rest is when its tip moves by less than 1e-6 in a time unit. The first call compiles (Numba) and is not counted.
"""

import elastica as ea
import numpy as np

from case import CLAMP, WEIGHT, answer

RADIUS = 0.01
#: Of the time that a stretching wave takes for one element, or for the radius if that is less: beyond 1 it explodes.
STEP = 0.4
#: 1 / s, about critical for the slowest swing of a rod of mass 1.
DAMPING = 8.0
AT_REST = 1e-6
STEPS_BETWEEN_LOOKS = 1000


class Simulator(ea.BaseSystemCollection, ea.Constraints, ea.Forcing, ea.Damping):
    pass


def prepare(n):
    area = np.pi * RADIUS**2
    modulus = 4 / (np.pi * RADIUS**4)
    density = 1 / area
    step = STEP * min(1 / n, RADIUS) / np.sqrt(modulus / density)

    def solve():
        simulator = Simulator()
        rod = ea.CosseratRod.straight_rod(
            n,
            np.zeros(3),
            np.array([np.cos(CLAMP), np.sin(CLAMP), 0]),
            np.array([0.0, 0, 1]),
            1.0,
            RADIUS,
            density,
            youngs_modulus=modulus,
            shear_modulus=modulus / 2,
        )
        simulator.append(rod)
        simulator.constrain(rod).using(ea.OneEndFixedBC, constrained_position_idx=(0,), constrained_director_idx=(0,))
        simulator.add_forcing_to(rod).using(ea.GravityForces, acc_gravity=np.array([0, -WEIGHT, 0]))
        simulator.dampen(rod).using(ea.AnalyticalLinearDamper, uniform_damping_constant=DAMPING, time_step=step)
        simulator.finalize()
        stepper, time, steps, speed = ea.PositionVerlet(), 0.0, 0, np.inf
        while speed > AT_REST:
            for _ in range(STEPS_BETWEEN_LOOKS):
                time = stepper.step(simulator, time, step)
            steps += STEPS_BETWEEN_LOOKS
            speed = float(np.linalg.norm(rod.velocity_collection[:, -1]))
            if not np.isfinite(speed):
                raise RuntimeError("it exploded")
        return {"tip": rod.position_collection[:2, -1].tolist(), "speed": speed, "steps": steps}

    return solve


answer(prepare)
