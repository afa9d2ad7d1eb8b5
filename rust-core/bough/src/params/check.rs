//! Validation of params against the declaration, and of what they would cost.

use alloc::borrow::ToOwned;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use super::cost::{MAX_SEGMENTS, too_large};
use super::declaration::{
    ArrangementPattern, Branching, BranchingPattern, Method, PARAMETERS, Params, Thickening,
};
use super::issue::{Issue, Sentence};
use super::parameter::{Kind, Parameter};
use super::plane::{copies_differ, is_spatial};
use super::value::FORCE_WIDTH;

/// Least radius of a twig, m: far below an atom's, and its fourth power is still a number.
const THINNEST: f64 = 1e-30;

/// Every problem with these params; empty when a plant can be grown from them. Nothing is thrown.
pub fn check(params: &Params) -> Vec<Issue> {
    check_flat(&params.to_flat())
}

/// As [`check`], on the flat form (see [`Params::to_flat`]).
pub fn check_flat(flat: &[f64]) -> Vec<Issue> {
    let mut issues = Vec::new();
    let mut offset = 0;
    for parameter in PARAMETERS {
        let width = parameter.kind.width();
        for &value in flat.iter().skip(offset).take(width) {
            issues.extend(problem(parameter, value));
        }
        offset += width;
    }
    issues.extend(forces(flat.get(offset..).unwrap_or_default()));
    if issues.is_empty() {
        issues.extend(unsupported(&Params::from_flat(flat)));
    }
    issues
}

/// What is wrong with the list of forces on segments.
fn forces(flat: &[f64]) -> Vec<Issue> {
    let Some(declared) = PARAMETERS.iter().find(|parameter| parameter.kind == Kind::Forces) else {
        return Vec::new();
    };
    let mut issues = Vec::new();
    for numbers in flat.chunks(FORCE_WIDTH) {
        let [segment, components @ ..] = numbers else { continue };
        if libm::floor(*segment) != *segment || !(0.0..MAX_SEGMENTS).contains(segment) {
            issues.push(Issue::new(
                "outOfRange",
                declared.path,
                *segment,
                "loads.forces must name segments by whole numbers from 0 to {}; one is {}.",
                &[MAX_SEGMENTS - 1.0, *segment],
                (Some(0.0), Some(MAX_SEGMENTS - 1.0)),
            ));
        }
        issues.extend(components.iter().filter_map(|&component| problem(declared, component)));
    }
    issues
}

impl Parameter {
    /// The issue of a value that is of another type than the parameter takes, or, if it is the name of an option, of none that there
    /// is. `given` says in words what it is.
    pub fn wrong_type(&self, given: &str, is_text: bool) -> Issue {
        let Parameter { path, min, max, kind, .. } = *self;
        let (mut wanted, range) = wanted(self);
        if kind == Kind::Forces {
            wanted = "a list of {segment, force: [x, y, z]}".to_owned();
        }
        let code = if is_text && matches!(kind, Kind::Choice(_)) { "notAnOption" } else { "wrongType" };
        let pattern = format!("{path} must be {wanted}; it is {}.", given.replace("{}", "{ }"));
        let numbers: &[f64] = if range { &[min, max] } else { &[] };
        let (min, max) = if range { (Some(min), Some(max)) } else { (None, None) };
        Issue { code, path, value: f64::NAN, sentence: Sentence::new(pattern, numbers), min, max }
    }
}

/// What a parameter takes, in words, and whether they have places for the ends of its range.
fn wanted(Parameter { unit, kind, .. }: &Parameter) -> (String, bool) {
    let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
    match kind {
        Kind::Integer => (format!("a whole number from {{}} to {{}}{unit}"), true),
        Kind::Choice(options) => (format!("one of {}", options.join(", ")), false),
        Kind::Flag => ("true or false".to_owned(), false),
        Kind::Number => (format!("a number from {{}} to {{}}{unit}"), true),
        Kind::Optional => (format!("a number from {{}} to {{}}{unit}, or null"), true),
        Kind::Vector | Kind::Forces => (format!("three numbers, each from {{}} to {{}}{unit}"), true),
    }
}

/// What is wrong with one number of one parameter.
fn problem(parameter: &Parameter, value: f64) -> Option<Issue> {
    let Parameter { path, min, max, kind, .. } = *parameter;
    let whole = libm::floor(value) == value;
    let code = match kind {
        Kind::Optional if value.is_nan() => return None,
        _ if !value.is_finite() => "notFinite",
        Kind::Choice(_) | Kind::Flag if !whole || value < min || value > max => "notAnOption",
        _ if value < min || value > max => "outOfRange",
        Kind::Integer if !whole => "notInteger",
        _ => return None,
    };
    let (wanted, range) = wanted(parameter);
    let numbers: &[f64] = if range { &[min, max, value] } else { &[value] };
    let sentence = Sentence::new(format!("{path} must be {wanted}; it is {{}}."), numbers);
    Some(Issue { code, path, value, sentence, min: Some(min), max: Some(max) })
}

/// Combinations that the model, or the memory of the machine, does not have.
fn unsupported(params: &Params) -> Vec<Issue> {
    let mut issues = Vec::new();
    let pulls = &params.loads.forces;
    if (is_spatial(params) || copies_differ(params)) && params.solver.method == Method::Euler {
        issues.push(Issue::new(
            "unsupported",
            "solver.method",
            1.0,
            "solver.method must be newton for a plant that does not lie in one vertical plane: the paper's relaxation is planar.",
            &[],
            (None, None),
        ));
    }
    if !pulls.is_empty() && params.arrangement.pattern == ArrangementPattern::Stem {
        issues.push(Issue::new(
            "unsupported",
            "loads.forces",
            pulls.len() as f64,
            "loads.forces must be empty around a stem; it has {}.",
            &[pulls.len() as f64],
            (None, None),
        ));
    }
    let forks = params.branching.pattern == BranchingPattern::Bifurcation;
    if forks && params.axis.taper == 0.0 && params.growth.thickening == Thickening::None {
        issues.push(Issue::new(
            "unsupported",
            "axis.taper",
            0.0,
            "axis.taper must be above 0 when axes fork: a child cannot grow from a point.",
            &[],
            (Some(f64::MIN_POSITIVE), Some(1.0)),
        ));
    }
    issues.extend(too_thin(params));
    issues.extend(too_large(params));
    issues
}

/// Forks upon forks of very unequal girth, which end in twigs of no thickness that a number can tell.
fn too_thin(params: &Params) -> Option<Issue> {
    let Branching { pattern, generations, exponent, girth_ratio, .. } = params.branching;
    if pattern == BranchingPattern::None {
        return None;
    }
    // Equation 47; pipes make their own taper.
    let thicker = libm::pow(1.0 + libm::pow(girth_ratio, exponent), -1.0 / exponent);
    let taper = if params.growth.thickening == Thickening::Pipes { 1.0 } else { params.axis.taper };
    let thinner = girth_ratio * thicker * taper;
    let radii = core::iter::successors(Some(params.axis.radius), |radius| Some(radius * thinner));
    let most =
        radii.skip(1).take(generations as usize).take_while(|&radius| radius >= THINNEST).count() as u32;
    (most < generations && thinner > 0.0).then(|| {
        Issue::new(
            "unsupported",
            "branching.generations",
            f64::from(generations),
            "branching.generations must be at most {}, or twigs have a radius below {} m; it is {}.",
            &[f64::from(most), THINNEST, f64::from(generations)],
            (Some(0.0), Some(f64::from(most))),
        )
    })
}
