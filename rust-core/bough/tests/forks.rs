//! Bifurcations: widths, angles, statics, and limits that are known.

#![allow(clippy::disallowed_methods, reason = "expected values may come from any arithmetic")]
#![allow(
    clippy::unwrap_used,
    clippy::needless_range_loop,
    reason = "a test may stop, and reads like the formula"
)]

mod support;

use bough::angle::Degrees;
use bough::growth::Fork;
use bough::mechanics::{GROUND, Linkage, Loads, Settings, hang};
use bough::params::{BranchingPattern, Discretization, Params, Thickening};
use bough::{History, Plant, grow};
use proptest::prelude::*;
use support::{distance, fitted_order, heavy_rod};

/// alpha, r, d1, d2, x, y (degrees), y as the paper prints equation 49.
const MURRAY: &[[f64; 7]] = &[
    [2.49, 1.0, 0.757014885699, 0.757014885699, 29.250537718, 29.250537718, 29.250537718],
    [2.49, 0.8, 0.833515215364, 0.666812172291, 22.3655025192, 36.4807422114, 59.029524064],
    [3.0, 1.0, 0.793700525984, 0.793700525984, 37.4673112109, 37.4673112109, 37.4673112109],
    [3.0, 0.8, 0.871263264291, 0.697010611433, 28.0227331319, 47.2309385943, 64.2408683027],
    [2.2, 1.0, 0.729740052841, 0.729740052841, 20.1272150195, 20.1272150195, 20.1272150195],
    [2.2, 0.8, 0.804887405016, 0.643909924013, 15.6272569693, 24.8916176525, 54.5109339107],
];

#[test]
fn widths_and_angles_as_listed() {
    for &[exponent, ratio, d1, d2, x, y, printed] in MURRAY {
        let fork = Fork::new(exponent, ratio);
        let (found_x, found_y) = (fork.thicker_turn.to_degrees(), fork.thinner_turn.to_degrees());
        println!(
            "alpha {exponent}, r {ratio}: d1 {:.12}, d2 {:.12}, x {found_x:.10}, y {found_y:.10}",
            fork.thicker, fork.thinner
        );
        assert!((fork.thicker - d1).abs() < 1e-12 && (fork.thinner - d2).abs() < 1e-12);
        assert!((found_x - x).abs() < 1e-9 && (found_y - y).abs() < 1e-9);
        // Equation 50 checks the sum.
        let sum = (1.0 - d1.powi(4) - d2.powi(4)) / (2.0 * d1 * d1 * d2 * d2);
        assert!(((x + y).to_radians().cos() - sum).abs() < 1e-9);
        // Equation 49 as printed, with d1 in the denominator, is another angle unless the children are equal.
        let wrong = ((1.0 - d1.powi(4) + d2.powi(4)) / (2.0 * d1 * d1)).acos().to_degrees();
        assert!((wrong - printed).abs() < 1e-8);
        assert_eq!((wrong - found_y).abs() > 1.0, ratio < 1.0);
    }
}

#[test]
fn da_vincis_children_go_straight_on() {
    for ratio in [1.0, 0.8, 0.3, 1e-9] {
        let fork = Fork::new(2.0, ratio);
        assert_eq!((fork.thicker_turn, fork.thinner_turn), (0.0, 0.0));
        assert!((fork.thicker * fork.thicker + fork.thinner * fork.thinner - 1.0).abs() < 1e-15);
    }
}

/// A tree of length about 1 m whose axes have `segments` segments each.
fn tree(segments: u32, generations: u32) -> Params {
    let mut params = heavy_rod(40.0, 2.0, segments);
    params.axis.segment_length = 1.0 / f64::from(segments * (generations + 1));
    params.branching.pattern = BranchingPattern::Bifurcation;
    params.branching.generations = generations;
    params
}

fn tips(plant: &Plant) -> Vec<[f64; 3]> {
    (0..plant.polylines.offsets.len() - 1).map(|axis| plant.tip(axis)).collect()
}

#[test]
fn a_vanishing_child_leaves_a_single_axis() {
    let ratios = [0.2, 0.1, 0.05];
    let single = {
        let mut params = tree(20, 1);
        params.branching.pattern = BranchingPattern::None;
        params.axis.segments = 40;
        grow(&params).unwrap().tip(0)
    };
    let apart = ratios.map(|ratio| {
        let mut params = tree(20, 1);
        params.branching.girth_ratio = ratio;
        // Axis 1 is the thicker child.
        distance(grow(&params).unwrap().tip(1), single)
    });
    let order = fitted_order(&[5, 10, 20], &apart);
    println!("girth ratio {ratios:?}: {apart:?} L from the single axis, order {order:.3}");
    assert!((1.5..2.5).contains(&order));
}

#[test]
fn the_rolled_tree_is_the_mirror_image() {
    for discretization in [Discretization::Paper, Discretization::SecondOrder] {
        let mut params = tree(10, 3);
        params.branching.girth_ratio = 0.7;
        params.tropism.elevation = Degrees(80.0);
        params.tropism.strength = 2.0;
        params.growth.thickening = Thickening::Pipes;
        params.solver.discretization = discretization;
        let plant = grow(&params).unwrap();
        params.axis.elevation = Degrees(180.0 - params.axis.elevation.0);
        params.tropism.elevation = Degrees(180.0 - params.tropism.elevation.0);
        params.branching.roll = Degrees(180.0);
        let mirror = grow(&params).unwrap();
        for (here, there) in tips(&plant).into_iter().zip(tips(&mirror)) {
            assert!(distance(here, [-there[0], there[1], 0.0]) < 1e-12, "{here:?} {there:?}");
        }
    }
}

/// Children that weigh nothing do not bend their parent, however stiff the fork is.
#[test]
fn weightless_children_leave_the_parent_alone() {
    let mut bare = Linkage::default();
    for segment in 0..10 {
        bare.push(if segment == 0 { GROUND } else { segment - 1 }, 0.1, 5.0, 0.05);
    }
    let mut loads = Loads::none(10);
    loads.y.fill(-1.0);
    let mut forked = bare.clone();
    let mut forked_loads = loads.clone();
    forked.push(9, 0.0, 7.0, 0.0);
    for turn in [0.5, -0.7] {
        forked.push(10, 0.1, 3.0, turn);
        let first = forked.len() as u32 - 1;
        forked.push(first, 0.1, 3.0, 0.0);
    }
    forked_loads.x.resize(15, 0.0);
    forked_loads.y.resize(15, 0.0);
    loads.gather(&bare);
    forked_loads.gather(&forked);
    let settings = Settings { tolerance: 1e-12 };
    hang(&mut bare, &loads, settings);
    hang(&mut forked, &forked_loads, settings);
    for (bare, forked) in bare.deviation.iter().zip(&forked.deviation) {
        assert!((bare - forked).abs() < 1e-13);
    }
    assert!(forked.deviation[10..].iter().all(|deviation| deviation.abs() < 1e-13));
}

#[test]
fn a_tree_cut_finer_converges_with_second_order() {
    let cuts = [4, 8, 16, 32, 64];
    for strength in [0.0, 2.0] {
        let shapes = cuts.map(|segments| {
            let mut params = tree(segments, 3);
            params.branching.length_ratio = 0.5;
            params.tropism.elevation = Degrees(80.0);
            params.tropism.strength = strength;
            // The last generation has half a segment at the coarsest cut; take finer ones.
            params.axis.segments *= 2;
            params.axis.segment_length *= 0.5;
            tips(&grow(&params).unwrap())
        });
        let apart = |coarse: &[[f64; 3]], fine: &[[f64; 3]]| {
            coarse.iter().zip(fine).map(|(coarse, fine)| distance(*coarse, *fine)).fold(0.0, f64::max)
        };
        let steps: Vec<f64> = shapes.windows(2).map(|pair| apart(&pair[0], &pair[1])).collect();
        let order = fitted_order(&cuts[..4], &steps);
        println!(
            "tropism {strength}/m: largest change of a tip at each halving {steps:?} L, order {order:.3}"
        );
        assert!((1.8..2.2).contains(&order), "order {order}");
    }
}

/// Area is pipe count times birth area, mass density times area times length, and a child is born as thick as
/// Murray has it of its parent's birth.
#[test]
fn mass_and_area_go_through_forks() {
    let mut params = tree(6, 3);
    params.growth.thickening = Thickening::Pipes;
    params.branching.length_ratio = 0.7;
    let fork = Fork::new(params.branching.exponent, params.branching.girth_ratio);
    let mut history = History::new(&params).unwrap();
    for step in [1, 7, 11, history.steps()] {
        let plant = history.at(step);
        let segments = &plant.segments;
        // Axes alternate thicker, thinner, from axis 1 on; their parent is the axis of the bearing segment.
        let mut birth_radius = vec![params.axis.radius];
        for segment in 0..segments.parent.len() {
            let axis = segments.axis[segment] as usize;
            if axis == birth_radius.len() {
                let bearer = segments.axis[segments.parent[segment] as usize] as usize;
                let width = if axis % 2 == 1 { fork.thicker } else { fork.thinner };
                birth_radius.push(width * birth_radius[bearer]);
            }
            let pipes = f64::from(step - segments.birth[segment] + 1);
            let area = pipes * std::f64::consts::PI * birth_radius[axis] * birth_radius[axis];
            let found = std::f64::consts::PI * segments.radius[segment] * segments.radius[segment];
            assert!((found - area).abs() < 1e-12 * area);
            let mass = params.material.density * area * params.axis.segment_length;
            assert!((segments.mass[segment] - mass).abs() < 1e-12 * mass);
        }
    }
}

/// A twig a thousandth as thick as the main axis, limp under its own weight, snaps over as its bearer sags. Its stiffness is
/// 1e-12 of the base's, and it must come to rest all the same (once ended in `maxIterations`, 1e-6 off).
#[test]
fn a_limp_twig_on_a_stiff_branch_comes_to_rest() {
    let mut params = tree(4, 4);
    params.axis.segment_length = 0.05;
    params.axis.elevation = Degrees(139.85097182927373);
    params.material.youngs_modulus = 14518626.104131227;
    params.tropism.elevation = Degrees(164.23149858158624);
    params.tropism.strength = 1.3193279707778067;
    params.branching.length_ratio = 0.6237790378937619;
    params.branching.exponent = 2.92032903410304;
    params.branching.girth_ratio = 0.16689405693121187;
    params.solver.tolerance = 1e-12;
    let report = grow(&params).unwrap().report;
    assert_eq!((report.status, report.stable), (bough::mechanics::Status::Converged, Some(true)));
    assert!(report.worst_step_residual <= 1e-12);
}

fn random_tree() -> impl Strategy<Value = Params> {
    let shape = (1_u32..8, 0_u32..5, 0.4..1.2, 2.0..4.0, 0.1..1.0);
    let forces = (-180.0..180.0, 0.01..30.0, 0.0..5.0, -180.0..180.0, any::<bool>(), any::<bool>());
    (shape, forces).prop_map(|(shape, forces)| {
        let (segments, generations, length_ratio, exponent, girth_ratio) = shape;
        let (elevation, q, strength, sought, pipes, paper) = forces;
        let mut params = tree(segments, generations);
        params.axis.elevation = Degrees(elevation);
        params.material.youngs_modulus *= 2.0 / q;
        params.branching.length_ratio = length_ratio;
        params.branching.exponent = exponent;
        params.branching.girth_ratio = girth_ratio;
        params.tropism.strength = strength;
        params.tropism.elevation = Degrees(sought);
        params.growth.thickening = if pipes { Thickening::Pipes } else { Thickening::None };
        params.solver.discretization =
            if paper { Discretization::Paper } else { Discretization::SecondOrder };
        // So that 1e-9 relative is asked of the statics and not of the stopping rule.
        params.solver.tolerance = 1e-12;
        params
    })
}

proptest! {
    #![proptest_config(support::cases(200))]

    /// The clamp bears the moment of every weight about it, computed from nothing but the result.
    #[test]
    fn the_base_bears_all_weights(params in random_tree()) {
        let plant = grow(&params).unwrap();
        let (points, segments) = (&plant.polylines.points, &plant.segments);
        let mut moment = 0.0;
        let mut size = 0.0;
        for segment in 0..segments.parent.len() {
            let end = segments.point[segment] as usize;
            let middle = 0.5 * (points[3 * end] + points[3 * end - 3]);
            let paper = params.solver.discretization == Discretization::Paper;
            let arm = if paper { points[3 * end] } else { middle };
            let weight = segments.mass[segment] * params.loads.gravity;
            moment -= weight * arm;
            size += weight * arm.abs();
        }
        prop_assert!((segments.moment[0] - moment).abs() <= 1e-9 * size, "{} {}", segments.moment[0], moment);
        prop_assert!(plant.report.residual <= 1e-10);
    }

    /// Every segment's direction is its quaternion's, and every axis starts where it is attached.
    #[test]
    fn the_arrays_fit_together(params in random_tree()) {
        let plant = grow(&params).unwrap();
        let (lines, segments) = (&plant.polylines, &plant.segments);
        let length = params.axis.segment_length;
        for segment in 0..segments.parent.len() {
            let end = segments.point[segment] as usize;
            let turn = &segments.rotation[4 * segment..4 * segment + 4];
            let (z, w) = (turn[2], turn[3]);
            let direction = [1.0 - 2.0 * z * z, 2.0 * z * w];
            for axis in 0..2 {
                let step = lines.points[3 * end + axis] - lines.points[3 * end - 3 + axis];
                prop_assert!((step - length * direction[axis]).abs() < 1e-12);
            }
            let axis = segments.axis[segment] as usize;
            let first = lines.offsets[axis] as usize;
            if end == first + 1 {
                let start = &lines.points[3 * first..3 * first + 3];
                match segments.parent[segment] {
                    -1 => prop_assert_eq!(start, &[0.0; 3][..]),
                    parent => {
                        let bearing = segments.point[parent as usize] as usize;
                        prop_assert_eq!(start, &lines.points[3 * bearing..3 * bearing + 3]);
                        prop_assert!(parent < segment as i32);
                    }
                }
            } else {
                prop_assert_eq!(segments.point[segments.parent[segment] as usize] as usize, end - 1);
            }
        }
    }
}

/// Turned about the vertical, a planar plant's quaternions have four numbers; each is of length 1 and turns x to its segment.
#[test]
fn quaternions_of_a_turned_plant_point_along_its_segments() {
    let mut params = Params::default();
    params.axis.segments = 12;
    params.axis.azimuth = Degrees(40.0);
    params.branching.pattern = BranchingPattern::Bifurcation;
    params.branching.generations = 1;
    let plant = grow(&params).unwrap();
    let (lines, segments) = (&plant.polylines, &plant.segments);
    for (segment, turn) in segments.rotation.chunks_exact(4).enumerate() {
        let [x, y, z, w] = turn else { unreachable!() };
        let direction = [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w), 2.0 * (x * z - y * w)];
        let end = 3 * segments.point[segment] as usize;
        for (axis, along) in direction.into_iter().enumerate() {
            let step = lines.points[end + axis] - lines.points[end - 3 + axis];
            // Places are sums of two dozen steps, each rounded.
            assert!((step - segments.length[segment] * along).abs() < 1e-14, "segment {segment}");
        }
        assert!((x * x + y * y + z * z + w * w - 1.0).abs() < 4.0 * f64::EPSILON);
    }
}
