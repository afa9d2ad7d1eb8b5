//! The heavy elastica: a uniform rod under its own weight, against shooting on the continuous rod.

#![allow(clippy::disallowed_methods, reason = "expected values may come from any arithmetic")]
#![allow(
    clippy::unwrap_used,
    clippy::needless_range_loop,
    reason = "a test may stop, and reads like the formula"
)]

mod support;

use bough::grow;
use bough::params::Discretization;
use support::{distance, fitted_order, heavy_rod};

/// Tip of the continuous rod of length 1: clamp angle (degrees), q, x, y.
const CONTINUUM: &[(f64, f64, f64, f64)] = &[
    (0.0, 0.5, 0.997779000281, -0.0623057681503),
    (0.0, 1.0, 0.991246395347, -0.123471401983),
    (0.0, 2.0, 0.966892946896, -0.238506582873),
    (0.0, 3.0, 0.931511207065, -0.339648392296),
    (0.0, 4.0, 0.890110746685, -0.425159284202),
    (0.0, 5.0, 0.846657179954, -0.495905044622),
    (0.0, 6.0, 0.803725299226, -0.553923868832),
    (0.0, 7.0, 0.762754182655, -0.601480929896),
    (0.0, 8.0, 0.724424734138, -0.640630717422),
    (0.0, 9.0, 0.688965105053, -0.673081980053),
    (0.0, 10.0, 0.656353761239, -0.700199715514),
    (0.0, 12.0, 0.599026959828, -0.742482755975),
    (0.0, 15.0, 0.529565891664, -0.786042891672),
    (0.0, 20.0, 0.44523205224, -0.829881443439),
    (0.0, 30.0, 0.342763680656, -0.873092423223),
    (0.0, 50.0, 0.245014756321, -0.907917123477),
    (45.0, 0.5, 0.738923232922, 0.673561178518),
    (45.0, 1.0, 0.771546506286, 0.635107480584),
    (45.0, 2.0, 0.836393070384, 0.542209367611),
    (45.0, 3.0, 0.894121805238, 0.428760239532),
    (45.0, 4.0, 0.936350264708, 0.301191765166),
    (45.0, 5.0, 0.958215138913, 0.170536858575),
    (45.0, 6.0, 0.960533599825, 0.0472157728002),
    (45.0, 7.0, 0.947845501962, -0.062700759328),
    (45.0, 8.0, 0.925372857793, -0.157447389178),
    (45.0, 9.0, 0.897366314965, -0.237811512738),
    (45.0, 10.0, 0.866776712588, -0.30561451314),
    (45.0, 12.0, 0.804609187165, -0.411423604951),
    (45.0, 15.0, 0.719506888861, -0.519178885879),
    (45.0, 20.0, 0.607807700041, -0.624964158077),
    (45.0, 30.0, 0.466264934626, -0.725460941476),
    (45.0, 50.0, 0.329777353262, -0.803194650068),
];

const CUTS: [u32; 5] = [20, 40, 80, 160, 320];

#[test]
fn the_tip_converges_to_the_continuous_rod() {
    for &(elevation, q, x, y) in CONTINUUM {
        for (discretization, least, most) in
            [(Discretization::SecondOrder, 1.9, 2.1), (Discretization::Paper, 0.9, 1.1)]
        {
            let errors = CUTS.map(|segments| {
                let mut params = heavy_rod(elevation, q, segments);
                params.solver.discretization = discretization;
                let plant = grow(&params).unwrap();
                assert!(plant.report.residual <= 1e-10, "{elevation} deg, q {q}: {:?}", plant.report);
                assert_eq!(plant.report.stable, Some(true));
                distance(plant.tip(0), [x, y, 0.0])
            });
            let order = fitted_order(&CUTS, &errors);
            let name = if discretization == Discretization::Paper { "paper" } else { "secondOrder" };
            println!("{name:11} {elevation:2} deg q {q:4}: order {order:.3}, errors {errors:?}");
            assert!((least..=most).contains(&order), "{name}: {elevation} deg, q {q}: order {order}");
            if discretization == Discretization::SecondOrder && q <= 10.0 {
                assert!(errors[2] < 2e-4, "80 segments, {elevation} deg, q {q}: {:e}", errors[2]);
            }
        }
    }
}

/// Tip sag of the cut rod over `w L^4 / 8 EI`, in the linear range.
#[test]
fn the_linear_sag_is_that_of_the_discretization() {
    let q = 1e-3;
    for segments in [10, 20, 50] {
        let n = f64::from(segments);
        let paper = (1.0 + 1.0 / n) * (1.0 + 1.0 / n) + 2.0 / 3.0 * (1.0 + 1.0 / n) * (2.0 + 1.0 / n) / n;
        let second_order = 1.0 + 1.0 / (n * n);
        let both = [(Discretization::Paper, paper), (Discretization::SecondOrder, second_order)];
        for (discretization, expected) in both {
            let mut params = heavy_rod(0.0, q, segments);
            params.solver.discretization = discretization;
            let ratio = -grow(&params).unwrap().tip(0)[1] / (q / 8.0);
            println!("{discretization:?}, {segments} segments: sag ratio {ratio:.9}, exact {expected:.9}");
            // The sag's first nonlinear term is relative q^2, so 1e-6 at q = 1e-3.
            assert!((ratio - expected).abs() < 1e-6 * expected);
        }
    }
}
