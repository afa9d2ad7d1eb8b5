//! What a solver says of its result.

/// How an iteration ended, and what the returned shape then is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Status {
    /// The torque residual is within the tolerance at every joint: the shape is an equilibrium.
    #[default]
    Converged,
    /// The work budget of the caller ran out: the shape is that of the last finished growth step.
    Budget,
    /// The iteration limit was reached first: the shape is the last iterate, and not an equilibrium.
    MaxIterations,
    /// A number overflowed: the shape is the last one with finite numbers, and not an equilibrium.
    NonFinite,
}

impl Status {
    /// The name in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Status::Converged => "converged",
            Status::Budget => "budget",
            Status::MaxIterations => "maxIterations",
            Status::NonFinite => "nonFinite",
        }
    }
}

/// Result of one search for equilibrium.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Outcome {
    /// How the iteration ended.
    pub status: Status,
    /// Largest torque left over at a joint, relative to the largest external torque; 0 without load. After a last small step
    /// of Newton's method it is a proven bound instead of being evaluated once more.
    pub residual: f64,
    /// Newton factorizations, or Euler steps.
    pub iterations: u64,
    /// Number of directions in which the energy falls: the Hessian's negative eigenvalues, counted by its
    /// pivots. `None` where the method has no Hessian.
    pub unstable_directions: Option<u32>,
}

/// What a plant's report says.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Report {
    /// How the iteration ended; the worst of all growth steps.
    pub status: Status,
    /// Whether the final equilibrium is a minimum of energy (its Hessian is positive definite); `None` when
    /// the shape is no equilibrium. Planar plants are looked at in their plane; rods in space tell also what would fall over
    /// sideways.
    pub stable: Option<bool>,
    /// Torque residual of the final shape, relative to the largest external torque.
    pub residual: f64,
    /// Largest residual at the end of any growth step.
    pub worst_step_residual: f64,
    /// Iterations of all growth steps together: Newton factorizations, or Euler steps.
    pub iterations: u64,
    /// Growth steps taken.
    pub steps: u32,
    /// First growth step whose equilibrium was not stable, or was not found, if any: the plant at the age before is the last
    /// stable one; from there on the shape depends on chance in a real plant.
    pub unstable_since: Option<u32>,
    /// With extrapolated stepping, the largest distance from the shape of exact stepping that is to be expected, over the
    /// length of the axis; `None` with any other stepping.
    pub stepping_error: Option<f64>,
    /// Of an upright plant, the present loads over those at which it can no longer stand straight: above 1 it is past its
    /// critical height, and leans (to which side: see [`crate::mechanics::LEAN`]). `None` of any other plant.
    pub self_buckling: Option<f64>,
    /// The modulus of rupture over the largest fibre stress: below 1 the plant breaks. `None` where nothing is stressed.
    pub safety_factor: Option<f64>,
    /// The segment with that stress, which breaks first; the lowest of equals.
    pub breaks_first: Option<u32>,
    /// Weight times length squared over flexural rigidity at the base; `q = w L^3 / EI` for a uniform axis.
    pub gravity_number: f64,
}
