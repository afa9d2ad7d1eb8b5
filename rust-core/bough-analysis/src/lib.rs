//! WebAssembly bindings of what is computed about a plant beyond its shape: how the shape depends on the parameters, and
//! the ways to equilibrium. A wasm of its own, as few visitors of a page come to want it.

#![cfg_attr(target_arch = "wasm32", no_std)]

extern crate alloc;

use alloc::borrow::ToOwned;
use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;

use bough::growth::{Trajectory, iterations};
use bough::params::{self, Params};
use wasm_bindgen::prelude::*;

/// The standard library's own allocator for wasm.
#[cfg(target_arch = "wasm32")]
#[global_allocator]
static ALLOCATOR: dlmalloc::GlobalDlmalloc = dlmalloc::GlobalDlmalloc;

/// The core does not panic; the standard library's handler, which words a message, would be a tenth of the wasm.
#[cfg(target_arch = "wasm32")]
#[panic_handler]
fn stop(_: &core::panic::PanicInfo) -> ! {
    core::arch::wasm32::unreachable()
}

/// Params that a plant can be grown from; the page has them from a plant that was.
fn checked(flat: &[f64]) -> Result<Params, JsError> {
    let is_good = params::check_flat(flat).is_empty();
    if is_good {
        Ok(Params::from_flat(flat))
    } else {
        Err(JsError::new("these params have not passed check"))
    }
}

/// The plant's points at a step, then their derivatives by the parameters at these places of the flat params; nothing
/// where there are no derivatives.
#[wasm_bindgen]
pub fn sensitivity(flat: &[f64], step: u32, wanted: &[u32]) -> Result<Vec<f64>, JsError> {
    let Ok(found) = bough::sensitivity(&checked(flat)?, step, wanted) else { return Ok(Vec::new()) };
    Ok(found.map_or_else(Vec::new, |found| [found.plant.polylines.points, found.slopes].concat()))
}

/// A way to rest in one growth step, recorded.
#[wasm_bindgen]
pub struct Way(Trajectory);

#[wasm_bindgen]
impl Way {
    /// The paper's relaxation, or Newton's iterations.
    #[wasm_bindgen(constructor)]
    pub fn new(flat: &[f64], step: u32, by_newton: bool) -> Result<Way, JsError> {
        let way = if by_newton { iterations } else { bough::relaxation };
        let too_large = || JsError::new("axis.segments must be at most 2000 where a relaxation is recorded.");
        way(&checked(flat)?, step).map(Way).map_err(|_| too_large())
    }

    /// Time of each moment, or number of each iteration.
    pub fn time(&mut self) -> Vec<f64> {
        core::mem::take(&mut self.0.time)
    }

    /// Direction of every segment at each moment.
    pub fn angle(&mut self) -> Vec<f64> {
        core::mem::take(&mut self.0.angle)
    }

    /// Torque left over at each moment.
    pub fn residuals(&mut self) -> Vec<f64> {
        core::mem::take(&mut self.0.residuals)
    }

    /// How it ended.
    #[wasm_bindgen(getter)]
    pub fn status(&self) -> String {
        self.0.outcome.status.name().to_owned()
    }

    /// Segments, Euler steps or iterations, and 1 if the last shape was reached by raising the load in parts.
    pub fn figures(&self) -> Vec<f64> {
        let Trajectory { segments, outcome, is_led, .. } = &self.0;
        vec![*segments as f64, outcome.iterations as f64, f64::from(u8::from(*is_led))]
    }
}
