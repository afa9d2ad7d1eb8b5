// @ts-nocheck: types need Rapier, which only the bench installs.
// Rapier, in two dimensions: a chain of bodies with revolute joints whose motors are the springs. What its JavaScript offers: motors
// are for impulse joints only (its multibody joints have none), and all is in single precision.

import { init, JointData, MotorModel, RigidBodyDesc, World } from "@dimforge/rapier2d-compat";

const clamp = (50 * Math.PI) / 180;
const weight = 10;
const timestep = 1 / 240;
/** With fewer, long chains rest in a wrong shape. */
const iterationsPerSegment = 5;
const stepsBetweenLooks = 60;
/** Per second; about critical for the slowest swing. */
const damping = 6;

await init();

/**
 * Lets the chain go until its tip moves by less than 1e-6 in a quarter of a second, or the time is up.
 * @param {number} segments
 * @param {number} limit seconds
 * @returns {import("../peers.mjs").Answer}
 */
export function rapier(segments, limit) {
  const length = 1 / segments;
  const world = new World({ x: 0, y: -weight });
  world.timestep = timestep;
  world.numSolverIterations = iterationsPerSegment * segments;
  let below = world.createRigidBody(RigidBodyDesc.fixed());
  for (let i = 0; i < segments; i++) {
    const middle = { x: (i + 0.5) * length * Math.cos(clamp), y: (i + 0.5) * length * Math.sin(clamp) };
    // A thin rod: half of its weight at each end makes the same torques.
    const description = RigidBodyDesc.dynamic()
      .setTranslation(middle.x, middle.y)
      .setRotation(clamp)
      .setLinearDamping(damping)
      .setAngularDamping(damping)
      .setAdditionalMassProperties(length, { x: 0, y: 0 }, length ** 3 / 4)
      .setCanSleep(false);
    const body = world.createRigidBody(description);
    const before = i === 0 ? { x: 0, y: 0 } : { x: length / 2, y: 0 };
    const joint = world.createImpulseJoint(
      JointData.revolute(before, { x: -length / 2, y: 0 }),
      below,
      body,
      true,
    );
    joint.configureMotorModel(MotorModel.ForceBased);
    joint.configureMotorPosition(i === 0 ? clamp : 0, (i === 0 ? 2 : 1) * segments, 0);
    below = body;
  }
  const tip = () => {
    const { x, y } = below.translation();
    const angle = below.rotation();
    return [x + (length / 2) * Math.cos(angle), y + (length / 2) * Math.sin(angle)];
  };
  const start = performance.now();
  const seconds = () => (performance.now() - start) / 1000;
  let last = tip();
  let moved = Number.POSITIVE_INFINITY;
  let steps = 0;
  while (moved > 1e-6 && seconds() < limit) {
    world.step();
    steps += 1;
    if (steps % stepsBetweenLooks !== 0) continue;
    const now = tip();
    moved = Math.hypot(now[0] - last[0], now[1] - last[1]);
    last = now;
  }
  const taken = seconds();
  const end = tip();
  world.free();
  return { seconds: taken, tip: end, steps, rests: moved <= 1e-6 };
}
