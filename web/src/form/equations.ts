/**
 * The equations that the parameters enter, as MathML that was made beforehand (by Temml, from the TeX above each):
 * browsers draw it, and no library is loaded for it. Loaded when the first help is opened.
 */

import { unsafeHTML } from "lit/directives/unsafe-html.js";
import type { Text } from "../language/english.ts";

/** An equation, and what it says. */
export interface Equation {
  readonly caption: Text;
  readonly mathml: string;
}

// \kappa = \frac{E I}{s}, \quad I = \frac{\pi R^4}{4}
const kappa: Equation = {
  caption: "The spring constant of a joint",
  mathml:
    '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow><mi>κ</mi><mo>=</mo><mfrac><mrow><mi>E</mi><mi>I</mi></mrow><mi>s</mi></mfrac><mo separator="true">,</mo><mspace width="1em"></mspace><mi>I</mi><mo>=</mo><mfrac><mrow><mi>π</mi><msup><mi>R</mi><mn>4</mn></msup></mrow><mn>4</mn></mfrac></mrow></math>',
};

// T_i = x_{i-1} \left(m_{i-1} + \dots + m_0\right) g + T_{i-1}
const moment: Equation = {
  caption: "Torque of all that is beyond joint i",
  mathml:
    '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow><msub><mi>T</mi><mi>i</mi></msub><mo>=</mo><msub><mi>x</mi><mrow><mi>i</mi><mo>−</mo><mn>1</mn></mrow></msub><mrow><mo fence="true" form="prefix" stretchy="true">(</mo><msub><mi>m</mi><mrow><mi>i</mi><mo>−</mo><mn>1</mn></mrow></msub><mo>+</mo><mo>⋯</mo><mo>+</mo><msub><mi>m</mi><mn>0</mn></msub><mo fence="true" form="postfix" stretchy="true">)</mo></mrow><mi>g</mi><mo>+</mo><msub><mi>T</mi><mrow><mi>i</mi><mo>−</mo><mn>1</mn></mrow></msub></mrow></math>',
};

// m = \rho \pi R^2 l
const mass: Equation = {
  caption: "Mass of a segment",
  mathml:
    '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow><mi>m</mi><mo>=</mo><mi>ρ</mi><mi>π</mi><msup><mi>R</mi><mn>2</mn></msup><mi>l</mi></mrow></math>',
};

// \kappa \left(\mu - \varphi\right) = T
const rest: Equation = {
  caption: "A joint at rest",
  mathml:
    '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow><mi>κ</mi><mrow><mo fence="true" form="prefix" stretchy="true">(</mo><mi>μ</mi><mo>−</mo><mi>φ</mi><mo fence="true" form="postfix" stretchy="true">)</mo></mrow><mo>=</mo><mi>T</mi></mrow></math>',
};

// \varphi_1 = 2 \arctan\left(e^{-\lambda} \tan\frac{\varphi_0}{2}\right), \quad \lambda = k\, l
const tropism: Equation = {
  caption: "New wood turns towards the preferred direction",
  mathml:
    '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow><msub><mi>φ</mi><mn>1</mn></msub><mo>=</mo><mn>2</mn><mrow><mspace width="0.1667em"></mspace><mi>arctan</mi><mo>⁡</mo></mrow><mrow><mo fence="true" form="prefix" stretchy="true">(</mo><msup><mi>e</mi><mrow><mo form="prefix" stretchy="false" lspace="0em" rspace="0em">−</mo><mi>λ</mi></mrow></msup><mrow><mi>tan</mi><mo>⁡</mo><mspace width="0.1667em"></mspace></mrow><mfrac><msub><mi>φ</mi><mn>0</mn></msub><mn>2</mn></mfrac><mo fence="true" form="postfix" stretchy="true">)</mo></mrow><mo separator="true">,</mo><mspace width="1em"></mspace><mi>λ</mi><mo>=</mo><mi>k</mi><mspace width="0.1667em"></mspace><mi>l</mi></mrow></math>',
};

// \kappa = \sum_p \kappa_p, \quad \varphi = \frac{1}{\kappa} \sum_p \kappa_p \varphi_p, \quad R_n = R_1 \sqrt{n}
const pipes: Equation = {
  caption: "A bundle of pipes acts as one spring",
  mathml:
    '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow><mi>κ</mi><mo>=</mo><mrow><munder><mo movablelimits="false">∑</mo><mi>p</mi></munder></mrow><msub><mi>κ</mi><mi>p</mi></msub><mo separator="true">,</mo><mspace width="1em"></mspace><mi>φ</mi><mo>=</mo><mfrac><mn>1</mn><mi>κ</mi></mfrac><mrow><munder><mo movablelimits="false">∑</mo><mi>p</mi></munder></mrow><msub><mi>κ</mi><mi>p</mi></msub><msub><mi>φ</mi><mi>p</mi></msub><mo separator="true">,</mo><mspace width="1em"></mspace><msub><mi>R</mi><mi>n</mi></msub><mo>=</mo><msub><mi>R</mi><mn>1</mn></msub><msqrt><mrow><mi>n</mi><mspace width="0pt" height="0.5em"></mspace></mrow></msqrt></mrow></math>',
};

// R(s) = R \left(1 - (1 - t) \frac{s}{L}\right)
const taper: Equation = {
  caption: "Radius along the finished axis",
  mathml:
    '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow><mi>R</mi><mrow><mo fence="true" form="prefix" stretchy="false">(</mo><mi>s</mi><mo fence="true" form="postfix" stretchy="false">)</mo></mrow><mo>=</mo><mi>R</mi><mrow><mo fence="true" form="prefix" stretchy="true">(</mo><mn>1</mn><mo>−</mo><mrow><mo fence="true" form="prefix" stretchy="false">(</mo><mn>1</mn><mo>−</mo><mi>t</mi><mo fence="true" form="postfix" stretchy="false">)</mo></mrow><mfrac><mi>s</mi><mi>L</mi></mfrac><mo fence="true" form="postfix" stretchy="true">)</mo></mrow></mrow></math>',
};

// d_0^\alpha = d_1^\alpha + d_2^\alpha
const murray: Equation = {
  caption: "Widths at a fork",
  mathml:
    '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow><msubsup><mi>d</mi><mn>0</mn><mi>α</mi></msubsup><mo>=</mo><msubsup><mi>d</mi><mn>1</mn><mi>α</mi></msubsup><mo>+</mo><msubsup><mi>d</mi><mn>2</mn><mi>α</mi></msubsup></mrow></math>',
};

// \cos x = \frac{d_0^4 + d_1^4 - d_2^4}{2\, d_0^2 d_1^2}, \quad d_2 = r\, d_1
const girth: Equation = {
  caption: "How far the thicker child turns",
  mathml:
    '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow><mrow><mi>cos</mi><mo>⁡</mo><mspace width="0.1667em"></mspace></mrow><mi>x</mi><mo>=</mo><mfrac><mrow><msubsup><mi>d</mi><mn>0</mn><mn>4</mn></msubsup><mo>+</mo><msubsup><mi>d</mi><mn>1</mn><mn>4</mn></msubsup><mo>−</mo><msubsup><mi>d</mi><mn>2</mn><mn>4</mn></msubsup></mrow><mrow><mn>2</mn><mspace width="0.1667em"></mspace><msubsup><mi>d</mi><mn>0</mn><mn>2</mn></msubsup><msubsup><mi>d</mi><mn>1</mn><mn>2</mn></msubsup></mrow></mfrac><mo separator="true">,</mo><mspace width="1em"></mspace><msub><mi>d</mi><mn>2</mn></msub><mo>=</mo><mi>r</mi><mspace width="0.1667em"></mspace><msub><mi>d</mi><mn>1</mn></msub></mrow></math>',
};

// n_k = n\, b^k
const ratio: Equation = {
  caption: "Segments of an axis of generation k",
  mathml:
    '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow><msub><mi>n</mi><mi>k</mi></msub><mo>=</mo><mi>n</mi><mspace width="0.1667em"></mspace><msup><mi>b</mi><mi>k</mi></msup></mrow></math>',
};

// L = n\, l
const length: Equation = {
  caption: "Length of the axis",
  mathml:
    '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow><mi>L</mi><mo>=</mo><mi>n</mi><mspace width="0.1667em"></mspace><mi>l</mi></mrow></math>',
};

// T = x F_y - y F_x
const force: Equation = {
  caption: "Torque of a force on the axis",
  mathml:
    '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow><mi>T</mi><mo>=</mo><mi>x</mi><msub><mi>F</mi><mi>y</mi></msub><mo>−</mo><mi>y</mi><msub><mi>F</mi><mi>x</mi></msub></mrow></math>',
};

// \mu = \varphi = \frac{1}{\kappa} \sum_p \kappa_p \varphi_p
const springback: Equation = {
  caption: "What stays when every load is off",
  mathml:
    '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow><mi>μ</mi><mo>=</mo><mi>φ</mi><mo>=</mo><mfrac><mn>1</mn><mi>κ</mi></mfrac><mrow><munder><mo movablelimits="false">∑</mo><mi>p</mi></munder></mrow><msub><mi>κ</mi><mi>p</mi></msub><msub><mi>φ</mi><mi>p</mi></msub></mrow></math>',
};

// \omega \leftarrow \omega + \frac{T - \kappa\theta - b\omega}{I}\, \Delta t, \quad \theta \leftarrow \theta + \omega\, \Delta t
const euler: Equation = {
  caption: "The paper's iteration",
  mathml:
    '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow><mi>ω</mi><mo stretchy="false">←</mo><mi>ω</mi><mo>+</mo><mfrac><mrow><mi>T</mi><mo>−</mo><mi>κ</mi><mi>θ</mi><mo>−</mo><mi>b</mi><mi>ω</mi></mrow><mi>I</mi></mfrac><mspace width="0.1667em"></mspace><mrow><mi mathvariant="normal">Δ</mi><mspace></mspace></mrow><mi>t</mi><mo separator="true">,</mo><mspace width="1em"></mspace><mi>θ</mi><mo stretchy="false">←</mo><mi>θ</mi><mo>+</mo><mi>ω</mi><mspace width="0.1667em"></mspace><mrow><mi mathvariant="normal">Δ</mi><mspace></mspace></mrow><mi>t</mi></mrow></math>',
};

// \kappa = 2 \left(\frac{s_1}{E I_1} + \frac{s_2}{E I_2}\right)^{-1}
const second: Equation = {
  caption: "A joint between two segments",
  mathml:
    '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow><mi>κ</mi><mo>=</mo><mn>2</mn><msup><mrow><mo fence="true" form="prefix" stretchy="true">(</mo><mfrac><msub><mi>s</mi><mn>1</mn></msub><mrow><mi>E</mi><msub><mi>I</mi><mn>1</mn></msub></mrow></mfrac><mo>+</mo><mfrac><msub><mi>s</mi><mn>2</mn></msub><mrow><mi>E</mi><msub><mi>I</mi><mn>2</mn></msub></mrow></mfrac><mo fence="true" form="postfix" stretchy="true">)</mo></mrow><mrow><mo form="prefix" stretchy="false" lspace="0em" rspace="0em">−</mo><mn>1</mn></mrow></msup></mrow></math>',
};

// \left|T - \kappa\theta\right| \le \epsilon\, T_\mathrm{max}
const residual: Equation = {
  caption: "When a joint counts as solved",
  mathml:
    '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow><mrow><mo fence="true" form="prefix" stretchy="true">|</mo><mi>T</mi><mo>−</mo><mi>κ</mi><mi>θ</mi><mo fence="true" form="postfix" stretchy="true">|</mo></mrow><mo>≤</mo><mi>ϵ</mi><mspace width="0.1667em"></mspace><msub><mi>T</mi><mpadded lspace="0"><mi>max</mi></mpadded></msub></mrow></math>',
};

// \delta_k = k\, \delta
const divergence: Equation = {
  caption: "Direction of the k-th axis around the stem",
  mathml:
    '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow><msub><mi>δ</mi><mi>k</mi></msub><mo>=</mo><mi>k</mi><mspace width="0.1667em"></mspace><mi>δ</mi></mrow></math>',
};

// h_k = (k + 1)\, h
const spacing: Equation = {
  caption: "Height of the k-th axis on the stem",
  mathml:
    '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow><msub><mi>h</mi><mi>k</mi></msub><mo>=</mo><mrow><mo fence="true" form="prefix" stretchy="false">(</mo><mi>k</mi><mo>+</mo><mn>1</mn><mo fence="true" form="postfix" stretchy="false">)</mo></mrow><mspace width="0.1667em"></mspace><mi>h</mi></mrow></math>',
};

// n_k = n - k\, \Delta n
const interval: Equation = {
  caption: "Growth steps that the k-th axis has had",
  mathml:
    '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow><msub><mi>n</mi><mi>k</mi></msub><mo>=</mo><mi>n</mi><mo>−</mo><mi>k</mi><mspace width="0.1667em"></mspace><mrow><mi mathvariant="normal">Δ</mi><mi>n</mi></mrow></mrow></math>',
};

// 0 \le k < N
const count: Equation = {
  caption: "The axes on the stem, from the lowest on",
  mathml:
    '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow><mn>0</mn><mo>≤</mo><mi>k</mi><mo>&lt;</mo><mi>N</mi></mrow></math>',
};

// R_i = R_p\, \Phi_i \exp(\hat\theta_i)
const joint: Equation = {
  caption: "Orientation of a segment in space",
  mathml:
    '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow><msub><mi>R</mi><mi>i</mi></msub><mo>=</mo><msub><mi>R</mi><mi>p</mi></msub><msub><mi mathvariant="normal">Φ</mi><mi>i</mi></msub><mi>exp</mi><mo>(</mo><msub><mi>θ</mi><mi>i</mi></msub><mo>)</mo></mrow></math>',
};

// r = \frac{\kappa_0}{\kappa_0^2 + \tau_0^2}, \quad h = \frac{2\pi\tau_0}{\kappa_0^2 + \tau_0^2}
const helix: Equation = {
  caption: "Radius and pitch of the helix that unloaded wood makes",
  mathml:
    '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow><mi>r</mi><mo>=</mo><mfrac><msub><mi>κ</mi><mn>0</mn></msub><mrow><msubsup><mi>κ</mi><mn>0</mn><mn>2</mn></msubsup><mo>+</mo><msubsup><mi>τ</mi><mn>0</mn><mn>2</mn></msubsup></mrow></mfrac><mo separator="true">,</mo><mspace width="1em"></mspace><mi>h</mi><mo>=</mo><mfrac><mrow><mn>2</mn><mi>π</mi><msub><mi>τ</mi><mn>0</mn></msub></mrow><mrow><msubsup><mi>κ</mi><mn>0</mn><mn>2</mn></msubsup><mo>+</mo><msubsup><mi>τ</mi><mn>0</mn><mn>2</mn></msubsup></mrow></mfrac></mrow></math>',
};

// \frac{GJ}{EI} = 2\,\frac{G}{E}
const shear: Equation = {
  caption: "Stiffness against twisting over that against bending",
  mathml:
    '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow><mfrac><mrow><mi>G</mi><mi>J</mi></mrow><mrow><mi>E</mi><mi>I</mi></mrow></mfrac><mo>=</mo><mn>2</mn><mfrac><mi>G</mi><mi>E</mi></mfrac></mrow></math>',
};

// \sigma = \max_p \frac{E R_p \left|\mu - \varphi_p\right|}{s} < \sigma_r
const strength: Equation = {
  caption: "Fibre stress, below which the wood holds",
  mathml:
    '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow><mi>σ</mi><mo>=</mo><mrow><munder><mi>max</mi><mi>p</mi></munder></mrow><mfrac><mrow><mi>E</mi><msub><mi>R</mi><mi>p</mi></msub><mrow><mo fence="true" form="prefix" stretchy="true">|</mo><mi>μ</mi><mo>−</mo><msub><mi>φ</mi><mi>p</mi></msub><mo fence="true" form="postfix" stretchy="true">|</mo></mrow></mrow><mi>s</mi></mfrac><mo>&lt;</mo><msub><mi>σ</mi><mi>r</mi></msub></mrow></math>',
};

// F = \frac{1}{2} \rho_a C_d\, 2 R l\, v_n^2
const drag: Equation = {
  caption: "Drag on a segment across the wind, with v_n its speed at right angles",
  mathml:
    '<math xmlns="http://www.w3.org/1998/Math/MathML" display="block"><mrow><mi>F</mi><mo>=</mo><mfrac><mn>1</mn><mn>2</mn></mfrac><msub><mi>ρ</mi><mi>a</mi></msub><msub><mi>C</mi><mi>d</mi></msub><mspace width="0.1667em"></mspace><mn>2</mn><mi>R</mi><mi>l</mi><mspace width="0.1667em"></mspace><msubsup><mi>v</mi><mi>n</mi><mn>2</mn></msubsup></mrow></math>',
};

/** By the path of the parameter. */
export const equations: Readonly<Record<string, Equation>> = {
  "axis.segments": length,
  "axis.segmentLength": kappa,
  "axis.lengthProfile": kappa,
  "axis.radius": kappa,
  "axis.taper": taper,
  "axis.elevation": rest,
  "axis.azimuth": joint,
  "axis.restCurvature": helix,
  "axis.restCurvatureRoll": helix,
  "axis.restTwist": helix,
  "material.youngsModulus": kappa,
  "material.density": mass,
  "material.shearModulusRatio": shear,
  "material.modulusOfRupture": strength,
  "tropism.elevation": tropism,
  "tropism.strength": tropism,
  "tropism.azimuth": tropism,
  "growth.thickening": pipes,
  "branching.exponent": murray,
  "branching.girthRatio": girth,
  "branching.lengthRatio": ratio,
  "arrangement.divergence": divergence,
  "loads.gravity": moment,
  "loads.tipMass": moment,
  "loads.foliage": moment,
  "loads.foliageAge": moment,
  "loads.foliageArea": drag,
  "loads.snow": moment,
  "loads.wind": drag,
  "loads.windAzimuth": drag,
  "loads.dragCoefficient": drag,
  "loads.foliageDrag": drag,
  "loads.tipForce": force,
  "loads.picked": springback,
  "loads.removed": springback,
  "solver.method": euler,
  "solver.discretization": second,
  "solver.tolerance": residual,
  "solver.stepping": rest,
  "solver.space": joint,
  "branching.generations": ratio,
  "branching.pattern": murray,
  "branching.roll": girth,
  "arrangement.pattern": divergence,
  "arrangement.count": count,
  "arrangement.spacing": spacing,
  "arrangement.trunk": spacing,
  "arrangement.interval": interval,
  "arrangement.stemRadius": kappa,
  "arrangement.stemElevation": joint,
};

/** The equation as part of a template. It is text of ours, so that nothing unsafe is in it: the tests hold that. */
export function drawn({ mathml }: Equation): unknown {
  return unsafeHTML(mathml);
}
