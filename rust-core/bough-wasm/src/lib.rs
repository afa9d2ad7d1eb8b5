//! WebAssembly bindings of [`bough`], as thin as they can be: flat params in, typed arrays out.
//!
//! Every array leaves as a copy, so nothing that JavaScript holds refers to wasm memory.

#![cfg_attr(target_arch = "wasm32", no_std)]

extern crate alloc;

use alloc::borrow::ToOwned;
use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;

use bough::mechanics::Report;
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

/// Version of the core.
#[wasm_bindgen]
pub fn version() -> String {
    bough::VERSION.to_owned()
}

/// One problem with one parameter.
#[wasm_bindgen(getter_with_clone, inspectable)]
#[derive(Clone)]
pub struct Issue {
    /// Kind of problem.
    #[wasm_bindgen(readonly)]
    pub code: String,
    /// Path of the parameter.
    #[wasm_bindgen(readonly)]
    pub path: String,
    /// A sentence for a person, with `{}` where a number stands.
    #[wasm_bindgen(readonly)]
    pub pattern: String,
    /// The sentence's numbers.
    #[wasm_bindgen(readonly)]
    pub numbers: Vec<f64>,
    /// The offending number.
    #[wasm_bindgen(readonly)]
    pub value: f64,
    /// Smallest accepted value.
    #[wasm_bindgen(readonly)]
    pub min: Option<f64>,
    /// Largest accepted value.
    #[wasm_bindgen(readonly)]
    pub max: Option<f64>,
}

/// Every problem with these flat params.
#[wasm_bindgen]
pub fn check(flat: &[f64]) -> Vec<Issue> {
    let issues = params::check_flat(flat).into_iter();
    let shown = |issue: params::Issue| Issue {
        code: issue.code.to_owned(),
        path: issue.path.to_owned(),
        pattern: issue.sentence.pattern,
        numbers: issue.sentence.numbers,
        value: issue.value,
        min: issue.min,
        max: issue.max,
    };
    issues.map(shown).collect()
}

/// Params that passed `check`.
fn checked(flat: &[f64]) -> Result<Params, JsError> {
    if params::check_flat(flat).is_empty() { Ok(Params::from_flat(flat)) } else { Err(unchecked()) }
}

/// Callers check first, and word the issues; this is for those that forgot.
fn unchecked() -> JsError {
    JsError::new("these params have not passed check")
}

/// The ages of one plant.
#[wasm_bindgen]
pub struct History(bough::History);

#[wasm_bindgen]
impl History {
    /// From flat params, which must have passed `check`.
    #[wasm_bindgen(constructor)]
    pub fn new(flat: &[f64]) -> Result<History, JsError> {
        let history = bough::History::new(&checked(flat)?);
        history.map(History).map_err(|_| unchecked())
    }

    /// How many growth steps there are.
    #[wasm_bindgen(getter)]
    pub fn steps(&self) -> u32 {
        self.0.steps()
    }

    /// The step that growth stands at.
    #[wasm_bindgen(getter)]
    pub fn step(&self) -> u32 {
        self.0.step()
    }

    /// Goes towards `step` for about `budget` stepped segments; whether it was reached.
    pub fn seek(&mut self, step: u32, budget: f64) -> bool {
        self.0.seek(step, budget as u64)
    }

    /// Goes towards `step`, but never beyond this work, in iterations times segments; whether it was reached.
    pub fn reach(&mut self, step: u32, work: f64) -> bool {
        self.0.reach(step, work as u64)
    }

    /// How much of the work of growth it takes again to make the plant of it.
    #[wasm_bindgen(getter)]
    pub fn remaking(&self) -> f64 {
        self.0.remaking()
    }

    /// The plant at the present step with a segment's end held at a place; nothing when it cannot be.
    pub fn hold(&mut self, segment: u32, x: f64, y: f64, z: f64) -> Option<Plant> {
        self.0.hold(segment, [x, y, z]).map(Plant)
    }

    /// The plant at the present step.
    pub fn plant(&mut self) -> Plant {
        Plant(self.0.plant())
    }
}

/// The arrays of one plant; each can be taken once.
#[wasm_bindgen]
pub struct Plant(bough::Plant);

/// Takes an array out: it is copied to JavaScript and freed here.
macro_rules! arrays {
    ($($doc:literal $name:ident: $Type:ty = $($field:ident).+;)+) => {
        #[wasm_bindgen]
        impl Plant {
            $(
                #[doc = $doc]
                pub fn $name(&mut self) -> $Type {
                    core::mem::take(&mut self.0.$($field).+)
                }
            )+
        }
    };
}

arrays! {
    "`polylines.points`" points: Vec<f64> = polylines.points;
    "`polylines.radii`" radii: Vec<f64> = polylines.radii;
    "`polylines.offsets`" offsets: Vec<u32> = polylines.offsets;
    "`segments.parent`" parent: Vec<i32> = segments.parent;
    "`segments.point`" point: Vec<u32> = segments.point;
    "`segments.axis`" axis: Vec<u32> = segments.axis;
    "`segments.order`" order: Vec<u32> = segments.order;
    "`segments.birth`" birth: Vec<u32> = segments.birth;
    "`segments.length`" length: Vec<f64> = segments.length;
    "`segments.radius`" radius: Vec<f64> = segments.radius;
    "`segments.mass`" mass: Vec<f64> = segments.mass;
    "`segments.rotation`" rotation: Vec<f64> = segments.rotation;
    "`segments.moment`" moment: Vec<f64> = segments.moment;
    "`segments.twistMoment`" twist_moment: Vec<f64> = segments.twist_moment;
    "`segments.curvature`" curvature: Vec<f64> = segments.curvature;
    "`segments.restCurvature`" rest_curvature: Vec<f64> = segments.rest_curvature;
    "`segments.stress`" stress: Vec<f64> = segments.stress;
}

#[wasm_bindgen]
impl Plant {
    fn report(&self) -> &Report {
        &self.0.report
    }

    /// `report.status`
    #[wasm_bindgen(getter)]
    pub fn status(&self) -> String {
        self.report().status.name().to_owned()
    }

    /// `report.stable`
    #[wasm_bindgen(getter)]
    pub fn stable(&self) -> Option<bool> {
        self.report().stable
    }

    /// `report.unstableSince`
    #[wasm_bindgen(getter)]
    pub fn unstable_since(&self) -> Option<u32> {
        self.report().unstable_since
    }

    /// `params.loads.forces` in flat form: segment, x, y, z of each.
    pub fn forces(&self) -> Vec<f64> {
        let forces = self.0.params.loads.forces.iter();
        let flat = |pull: &params::PointForce| {
            let [x, y, z] = pull.force;
            [f64::from(pull.segment), x, y, z]
        };
        forces.flat_map(flat).collect()
    }

    /// `report.residual`, `.worstStepResidual`, `.iterations`, `.steps`, `.gravityNumber`, `.steppingError`, `.selfBuckling`,
    /// `.safetyFactor`, `.breaksFirst`; NaN stands for null.
    pub fn figures(&self) -> Vec<f64> {
        let Report { residual, worst_step_residual, iterations, steps, gravity_number, .. } = *self.report();
        let Report { stepping_error, self_buckling, safety_factor, breaks_first, .. } = *self.report();
        let [error, buckling, safety, first] =
            [stepping_error, self_buckling, safety_factor, breaks_first.map(f64::from)]
                .map(|figure| figure.unwrap_or(f64::NAN));
        vec![
            residual,
            worst_step_residual,
            iterations as f64,
            f64::from(steps),
            gravity_number,
            error,
            buckling,
            safety,
            first,
        ]
    }
}

/// The paper's relaxation of one growth step, recorded.
#[wasm_bindgen]
pub struct Trajectory(bough::growth::Trajectory);

#[wasm_bindgen]
impl Trajectory {
    /// From flat params, which must have passed `check`.
    #[wasm_bindgen(constructor)]
    pub fn new(flat: &[f64], step: u32) -> Result<Trajectory, JsError> {
        let trajectory = bough::relaxation(&checked(flat)?, step);
        let too_large = || JsError::new("axis.segments must be at most 2000 where a relaxation is recorded.");
        trajectory.map(Trajectory).map_err(|_| too_large())
    }

    /// Time of each moment.
    pub fn time(&mut self) -> Vec<f64> {
        core::mem::take(&mut self.0.time)
    }

    /// Direction of every segment at each moment.
    pub fn angle(&mut self) -> Vec<f64> {
        core::mem::take(&mut self.0.angle)
    }

    /// Angular velocity of every joint at each moment.
    pub fn velocity(&mut self) -> Vec<f64> {
        core::mem::take(&mut self.0.velocity)
    }

    /// How the iteration ended.
    #[wasm_bindgen(getter)]
    pub fn status(&self) -> String {
        self.0.outcome.status.name().to_owned()
    }

    /// Segments, Euler steps, residual.
    pub fn figures(&self) -> Vec<f64> {
        vec![self.0.segments as f64, self.0.outcome.iterations as f64, self.0.outcome.residual]
    }
}
