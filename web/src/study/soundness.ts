/** Whether a plant holds: sentences on its stability and on its strength. */
import { numberText, quantityText } from "../form/quantity.ts";
import { quantity } from "../geometry/quantity.ts";
import type { Params } from "../params/params.ts";
import type { Plant } from "../plant/plant.ts";
import { words } from "./words.ts";

/** Gravity number at which an upright, clamped column of even thickness buckles (Greenhill 1881): the first root of a Bessel function. */
export const criticalGravityNumber = 7.837347;

/** On its stability, and on the load at which an upright axis would buckle. */
export function stabilitySentences({ params, report }: Plant): string[] {
  const { stable, unstableSince, gravityNumber, selfBuckling } = report;
  const sentences: string[] = [];
  if (stable === null) sentences.push(words.why.noEquilibrium);
  else if (!stable) sentences.push(words.why.unstableNow);
  if (stable !== null && unstableSince !== null) sentences.push(words.why.unstableSince(unstableSince));
  else if (stable) sentences.push(words.why.stable);
  if (selfBuckling !== null) {
    const share = `${numberText(100 * selfBuckling, 3)} %`;
    sentences.push((selfBuckling > 1 ? words.why.leans : words.why.stands)(share));
  }
  if (isGreenhillsColumn(params)) {
    const share = `${numberText((100 * gravityNumber) / criticalGravityNumber, 3)} %`;
    const critical = numberText(criticalGravityNumber);
    sentences.push(words.why.buckling(numberText(gravityNumber), critical, words.why.ofCritical(share)));
  }
  return sentences;
}

/** Upright, one axis, of even thickness, under its own weight alone. */
function isGreenhillsColumn({ axis, tropism, growth, branching, loads }: Params): boolean {
  const isEven = axis.taper === 1 && growth.thickening === "none" && branching.pattern === "none";
  const isUpright = axis.elevation === 90 && (tropism.strength === 0 || tropism.elevation === 90);
  return isEven && isUpright && loads.tipMass === 0 && loads.tipForce.every((part) => part === 0);
}

/** On the largest stress, and the safety factor where the wood's modulus of rupture is known. */
export function strengthSentences({ segments, params }: Plant): string[] {
  let most = 0;
  for (let segment = 1; segment < segments.stress.length; segment++) {
    if ((segments.stress[segment] ?? 0) > (segments.stress[most] ?? 0)) most = segment;
  }
  const stress = segments.stress[most] ?? 0;
  let distance = 0;
  for (let segment = 0; segment < most; segment++) {
    if (segments.axis[segment] === segments.axis[most]) distance += segments.length[segment] ?? 0;
  }
  const sentences = [words.why.stressAt(quantity(stress, "Pa"), quantityText(distance, "m"))];
  const { modulusOfRupture } = params.material as { modulusOfRupture?: number };
  if (modulusOfRupture !== undefined && stress > 0) {
    const factor = modulusOfRupture / stress;
    sentences.push((factor >= 1 ? words.why.safety : words.why.breaks)(numberText(factor, 2)));
  }
  return sentences;
}
