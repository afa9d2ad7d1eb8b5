//! The loops, by number: what one round does, with all buffers made before.

use std::cell::RefCell;
use std::hint::black_box;
use std::rc::Rc;

use bough::grow;
use bough::mechanics::{Elimination, Loads, Settings, Workspace, hang, settle};
use bough::params::{Params, Thickening};
use bough::space::{self, Balance, NEUTRAL, Rods};

use crate::euler::Euler;
use crate::{case, floor, tree};

/// Residual that counts as solved where peers are compared, relative to the largest torque.
const TOLERANCE: f64 = 1e-6;

/// `GJ / EI` of round wood whose G is a tenth of its E.
const TWIST_RATIO: f64 = 0.2;

/// Something to time.
pub struct Kernel {
    /// How many segments one round works on.
    pub segments: usize,
    /// One round; returns its iterations.
    pub round: Box<dyn FnMut() -> u64>,
    /// Where the rod ends that it solved, where it solves one.
    pub tip: Option<Box<dyn Fn() -> [f64; 2]>>,
}

impl Kernel {
    fn new(segments: usize, round: impl FnMut() -> u64 + 'static) -> Self {
        Kernel { segments, round: Box::new(round), tip: None }
    }
}

/// The kernel of a number; the numbers are those of `bench/kernels.mjs`.
pub fn kernel(which: u32, size: usize) -> Option<Kernel> {
    let size = size.max(1);
    Some(match which {
        0 => floor_loop(size),
        1 => newton_iteration(size),
        2 => static_solve(size),
        3 => whole_call(&case::params(size)),
        4 => whole_call(&case::growth(size, Thickening::None)),
        5 => whole_call(&case::growth(size, Thickening::Pipes)),
        6 => whole_call(&case::tree(size)),
        7 => whole_call(&case::relaxation(size)),
        8 => one_damping(size),
        9 => tree_solve(size),
        10 => iteration_in_space(size),
        _ => return None,
    })
}

fn floor_loop(segments: usize) -> Kernel {
    let angles: Vec<f64> =
        (0..segments).map(|segment| 0.9 - 1.9 * segment as f64 / segments as f64).collect();
    let mut sums = vec![0.0; segments];
    let round = move || {
        floor::floor(black_box(&angles), black_box(&mut sums));
        1
    };
    Kernel::new(segments, round)
}

/// Torques, residuals and their largest, elimination, increments: all of one iteration, at rest, where it changes nothing.
fn newton_iteration(segments: usize) -> Kernel {
    let (mut linkage, loads) = case::rod(segments);
    hang(&mut linkage, &loads, Settings { tolerance: TOLERANCE });
    let mut state = Elimination::default();
    let round = move || {
        state.evaluate(black_box(&linkage), black_box(&loads));
        black_box(state.largest_residual() + state.largest_torque());
        black_box(state.newton(black_box(&mut linkage)));
        1
    };
    Kernel::new(segments, round)
}

/// From the straight rod to the bent one.
fn static_solve(segments: usize) -> Kernel {
    let (linkage, loads) = case::rod(segments);
    let rod = Rc::new(RefCell::new(linkage));
    let solved = Rc::clone(&rod);
    let mut workspace = Workspace::default();
    let round = move || {
        let (mut linkage, settings) = (rod.borrow_mut(), Settings { tolerance: TOLERANCE });
        linkage.deviation.fill(0.0);
        let none = Loads::none(0);
        settle(black_box(&mut linkage), &none, black_box(&loads), &[], settings, &mut workspace).iterations
    };
    let tip = move || case::tip(&solved.borrow());
    Kernel { tip: Some(Box::new(tip)), ..Kernel::new(segments, round) }
}

/// A tree at rest, to where its weight bends it.
fn tree_solve(segments: usize) -> Kernel {
    let (mut linkage, loads) = tree::tree(segments);
    let segments = linkage.len();
    let mut workspace = Workspace::default();
    let round = move || {
        linkage.deviation.fill(0.0);
        let (none, settings) = (Loads::none(0), Settings { tolerance: TOLERANCE });
        settle(black_box(&mut linkage), &none, black_box(&loads), &[], settings, &mut workspace).iterations
    };
    Kernel::new(segments, round)
}

/// As [`newton_iteration`], of a tree in space whose forks stand crosswise.
fn iteration_in_space(segments: usize) -> Kernel {
    let (linkage, mut shape, force) = tree::tree_in_space(segments);
    let segments = linkage.len();
    let (settings, mut workspace) = (Settings { tolerance: TOLERANCE }, space::Workspace::default());
    let rods = Rods::new(&linkage, TWIST_RATIO);
    space::settle(rods, &mut shape, &[], &force, &[], settings, &mut workspace);
    let mut balance = Balance::default();
    balance.orient(rods, &shape);
    let round = move || {
        let rods = Rods::new(black_box(&linkage), TWIST_RATIO);
        balance.weigh(rods, &shape, black_box(&force), NEUTRAL);
        black_box(balance.advance(rods, black_box(&mut shape), 1.0, f64::INFINITY));
        1
    };
    Kernel::new(segments, round)
}

/// `grow` with everything that a caller gets: params checked, segments made, grown, solved, arrays written.
fn whole_call(params: &Params) -> Kernel {
    let params = params.clone();
    let segments = grow(&params).map_or(0, |plant| plant.segments.length.len());
    let round = move || grow(black_box(&params)).map_or(0, |plant| black_box(plant).report.iterations);
    Kernel::new(segments, round)
}

fn one_damping(segments: usize) -> Kernel {
    let round = move || Euler::new(black_box(segments)).relax(TOLERANCE);
    Kernel::new(segments, round)
}
