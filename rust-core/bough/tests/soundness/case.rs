//! From a fuzzer's bytes to params that are worth growing: small plants, values from all over their ranges.

use arbitrary::{Result, Unstructured};
use bough::params::{Kind, PARAMETERS, Parameter, Params, PointForce};

/// How far from ordinary the values are.
#[derive(Clone, Copy, PartialEq)]
pub enum Values {
    /// Mostly defaults, some of anything.
    Mixed,
    /// The ends of the ranges, and what lies beside them.
    Extreme,
}

/// Most growth steps of a main axis: so a plant takes some microseconds, and every combination of values can be had.
const MOST_SEGMENTS: f64 = 9.0;

/// Params within all ranges; combinations that the model does not have may be among them.
pub fn params(bytes: &mut Unstructured, values: Values) -> Result<Params> {
    let mut flat = Vec::new();
    for parameter in PARAMETERS {
        for place in 0..parameter.kind.width() {
            flat.push(value(bytes, parameter, place, values)?);
        }
    }
    let mut params = Params::from_flat(&flat);
    if bytes.ratio(1, 8)? {
        for _ in 0..bytes.int_in_range(1..=2)? {
            let force = [number(bytes, -1e3, 1e3)?, number(bytes, -1e3, 1e3)?, 0.0];
            params.loads.forces.push(PointForce { segment: bytes.int_in_range(0..=12)?, force });
        }
    }
    Ok(params)
}

fn value(bytes: &mut Unstructured, parameter: &Parameter, place: usize, values: Values) -> Result<f64> {
    let (min, max) = (parameter.min, parameter.max);
    let most = match parameter.path {
        "axis.segments" => MOST_SEGMENTS,
        "branching.generations" | "arrangement.count" | "arrangement.interval" => 3.0,
        _ => max,
    };
    match parameter.kind {
        // Two million Euler steps are not for millions of plants.
        _ if parameter.path == "solver.method" => Ok(0.0),
        Kind::Choice(_) | Kind::Flag | Kind::Integer => {
            Ok(f64::from(bytes.int_in_range(min as u32..=most as u32)?))
        }
        Kind::Number | Kind::Vector => match (values, bytes.int_in_range(0_u8..=7)?) {
            (Values::Mixed, 0..=3) => Ok(parameter.default[place]),
            (Values::Mixed, 4) => Ok(parameter.slider_min.max(min)
                + unit(bytes)? * (parameter.slider_max.min(max) - parameter.slider_min.max(min))),
            (Values::Extreme, 0) => Ok(min),
            (Values::Extreme, 1) => Ok(max),
            (Values::Extreme, 2) => Ok(0.0_f64.clamp(min, max)),
            (Values::Extreme, 3) => Ok(beside(min, max, false)),
            (Values::Extreme, 4) => Ok(beside(min, max, true)),
            // Angles: nearly away from what is sought, nearly upright.
            (Values::Extreme, 5) if parameter.unit == "deg" => {
                let right = 90.0 * f64::from(bytes.int_in_range(-2_i8..=2)?);
                Ok((right + [0.0, 1e-13, -1e-13, 1e-7, -1e-7][bytes.choose_index(5)?]).clamp(min, max))
            }
            _ => number(bytes, min, max),
        },
        // Left out: what it means in space is checked there.
        Kind::Optional => Ok(parameter.default[place]),
        Kind::Forces => Ok(0.0),
    }
}

/// The smallest or the largest accepted number but one.
fn beside(min: f64, max: f64, upper: bool) -> f64 {
    if upper { max.next_down() } else { min.next_up() }
}

/// A number from 0 to 1, the ends included.
fn unit(bytes: &mut Unstructured) -> Result<f64> {
    Ok(f64::from(bytes.arbitrary::<u16>()?) / f64::from(u16::MAX))
}

/// A number of any magnitude between the ends.
pub fn number(bytes: &mut Unstructured, min: f64, max: f64) -> Result<f64> {
    let share = unit(bytes)?;
    if min > 0.0 {
        return Ok((min * (max / min).powf(share)).clamp(min, max));
    }
    // Of both signs, over twenty decades below the larger end.
    let largest = max.max(-min);
    let size = largest * 10_f64.powf(-20.0 * share);
    Ok(if min < 0.0 && bytes.arbitrary()? { -size } else { size }.clamp(min, max))
}

/// Params from bytes as they cross into wasm: numbers of eight bytes.
pub fn flat(bytes: &[u8]) -> Vec<f64> {
    bytes.chunks_exact(8).map(|eight| f64::from_le_bytes(eight.try_into().unwrap_or_default())).collect()
}
