//! The plant at any age, without keeping every age.

use alloc::vec;
use alloc::vec::Vec;

use super::pull::Grip;
use super::state::{Growth, STRIDE, State};
use super::stem;
use crate::mechanics::Status;
use crate::params::{Arrangement, ArrangementPattern, BoughError, Params, PointForce, copies_differ};
use crate::plant::Plant;

/// About how many bytes all checkpoints together may take.
const CHECKPOINT_BYTES: usize = 64 << 20;
/// Most checkpoints kept, however small they are.
const MOST_CHECKPOINTS: usize = 64;

/// Grows a plant to its last step.
///
/// # Errors
/// Every problem of the params at once; nothing is computed then.
///
/// # Cost
/// The sum of the segment counts over all growth steps, times two or three Newton iterations of O(1) a segment.
pub fn grow(params: &Params) -> Result<Plant, BoughError> {
    if params.arrangement.pattern == ArrangementPattern::Stem {
        let mut history = History::new(params)?;
        return Ok(history.at(history.steps()));
    }
    let mut growth = Growth::new(params)?;
    let mut unlimited = u64::MAX;
    while growth.work(growth.steps(), &mut unlimited) {}
    Ok(growth.plant())
}

/// The ages of a plant. Any step can be asked for in any order; each is the same to the last bit, whichever way
/// it is reached, because growth goes on from checkpoints of its complete state.
///
/// ```
/// use bough::{History, params::Params};
/// let mut history = History::new(&Params::default())?;
/// let old = history.at(30);
/// let young = history.at(10);
/// assert_eq!(young.segments.length.len(), 10);
/// assert_eq!(history.at(30), old);
/// # Ok::<(), bough::params::BoughError>(())
/// ```
#[derive(Clone, Debug)]
pub struct History {
    growth: Growth,
    /// Number of laid pipes on record after each step, to find the record's end at a checkpoint.
    recorded: Vec<usize>,
    checkpoints: Vec<State>,
    interval: u32,
    grip: Option<Grip>,
    /// Whether the last way ended before its aim.
    is_stopped: bool,
    /// Around a rigid stem, the copies that differ by more than their age and azimuth, each grown alone.
    alone: Vec<History>,
}

impl History {
    /// Prepares the history; nothing is grown yet.
    ///
    /// # Errors
    /// Every problem of the params at once.
    pub fn new(params: &Params) -> Result<Self, BoughError> {
        Ok(Self::of(Growth::new(params)?, params))
    }

    fn of(growth: Growth, params: &Params) -> Self {
        let copies = if copies_differ(params) { params.arrangement.count as usize } else { 0 };
        let copy = |copy| {
            // A force turned out of its axes may leave the range that each of its components has.
            let params = stem::alone(params, copy);
            Self::of(Growth::unchecked(&params), &params)
        };
        let alone = (0..copies).map(copy).collect();
        let state = 16 * size_of::<f64>() * growth.full_grown_segments();
        let kept = (CHECKPOINT_BYTES / state.max(1)).clamp(1, MOST_CHECKPOINTS);
        let interval = growth.steps().div_ceil(kept as u32).next_multiple_of(STRIDE);
        let checkpoints = vec![growth.state.clone()];
        History { growth, recorded: vec![0], checkpoints, interval, grip: None, is_stopped: false, alone }
    }

    /// How many growth steps there are.
    pub fn steps(&self) -> u32 {
        self.growth.steps()
    }

    /// The step that growth stands at now.
    pub fn step(&self) -> u32 {
        self.growth.steps_taken()
    }

    /// The plant at the end of a step; steps outside `1 ..= steps()` are taken as the nearest inside.
    ///
    /// # Cost
    /// Going forward, that of the steps between; going back, that of the steps since the checkpoint before.
    pub fn at(&mut self, step: u32) -> Plant {
        self.seek(step, u64::MAX);
        self.plant()
    }

    /// The plant at the step that growth stands at; around a stem, its copies of all ages up to that.
    pub fn plant(&mut self) -> Plant {
        self.grip = None;
        let is_stopped = self.is_stopped;
        let mut plant = if self.growth.params.arrangement.pattern != ArrangementPattern::Stem {
            self.growth.plant()
        } else {
            let copies = self.copies();
            stem::around(&self.growth.params, &copies)
        };
        if is_stopped {
            plant.report.status = plant.report.status.max(Status::Budget);
            self.is_stopped = true;
        }
        plant
    }

    /// The copies around a stem at the step that growth stands at, from the oldest, lowest one up.
    fn copies(&mut self) -> Vec<Plant> {
        let step = self.growth.steps_taken();
        let Arrangement { count, interval, .. } = self.growth.params.arrangement;
        let younger = |copy: u32| step.checked_sub(copy.saturating_mul(interval));
        let mut ages: Vec<u32> = (0..count).map_while(younger).take_while(|&age| age > 0).collect();
        if !self.alone.is_empty() {
            return self.alone.iter_mut().zip(ages).map(|(copy, age)| copy.at(age)).collect();
        }
        // From the youngest to the oldest, so that growth only goes forward and ends where it stood.
        ages.reverse();
        let mut copies: Vec<Plant> = Vec::with_capacity(ages.len());
        for age in ages {
            match copies.last() {
                Some(last) if last.report.steps == age => copies.push(last.clone()),
                _ => {
                    self.seek(age, u64::MAX);
                    copies.push(self.growth.plant());
                }
            }
        }
        copies.reverse();
        copies
    }

    /// The plant at the step that growth stands at, with the distal end of a segment held at a place (x, y, z in m), as a
    /// pointer does; `params.loads.forces` of the result names the force that holds it. Of the place of a planar plant only
    /// what lies in its plane counts, and out of reach the point comes as near as it can. `None` when there is no
    /// such segment, the stem's included, or no equilibrium was found. The next [`History::plant`] lets go.
    ///
    /// Calls with places near each other are quick: each goes on from the one before.
    ///
    /// ```
    /// use bough::{History, params::Params};
    /// let mut history = History::new(&Params::default())?;
    /// let free = history.at(40);
    /// let [x, y, _] = free.tip(0);
    /// let held = history.hold(39, [x - 0.1, y + 0.2, 0.0]).ok_or("not held")?;
    /// assert!((held.tip(0)[1] - y - 0.2).abs() < 1e-9);
    /// assert!(held.params.loads.forces[0].force != [0.0; 3]);
    /// assert_eq!(history.plant(), free);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn hold(&mut self, segment: u32, place: [f64; 3]) -> Option<Plant> {
        let grip = self.grip.take();
        if self.growth.params.arrangement.pattern != ArrangementPattern::Stem {
            let (plant, grip) = self.growth.hold(segment, place, grip)?;
            self.grip = Some(grip);
            return Some(plant);
        }
        let step = self.growth.steps_taken();
        let mut copies = self.copies();
        // The stem has as many segments as copies, and comes first.
        let mut own = (segment as usize).checked_sub(copies.len())?;
        let copy = copies.iter().position(|copy| {
            let segments = copy.segments.parent.len();
            let found = own < segments;
            own -= if found { 0 } else { segments };
            found
        })?;
        let stand = stem::place(&self.growth.params, copy);
        // A grip counts its segments in the whole arrangement.
        let grip = grip.filter(|grip| grip.segment() == own as u32);
        let held = match self.alone.get(copy) {
            Some(alone) => alone.growth.hold(own as u32, stand.inward(place), grip),
            None => {
                self.seek(copies[copy].report.steps, u64::MAX);
                self.growth.hold(own as u32, stand.inward(place), grip)
            }
        };
        self.seek(step, u64::MAX);
        let (plant, grip) = held?;
        self.grip = Some(grip);
        let pull = plant.params.loads.forces.first().map(|pull| pull.force);
        copies[copy] = plant;
        let mut arranged = stem::around(&self.growth.params, &copies);
        let force = stand.outward(pull.unwrap_or_default());
        arranged.params.loads.forces = vec![PointForce { segment, force }];
        Some(arranged)
    }

    /// Goes towards `step` until it is reached or about `budget` segments have been stepped; returns whether it
    /// was reached. Lets a host stay responsive: call again to go on.
    pub fn seek(&mut self, step: u32, budget: u64) -> bool {
        let step = step.clamp(1, self.steps());
        self.is_stopped = false;
        let taken = self.growth.steps_taken();
        if taken > step || (taken == step && self.growth.is_underway()) {
            let checkpoint = (step / self.interval) as usize;
            let checkpoint = &self.checkpoints[checkpoint.min(self.checkpoints.len() - 1)];
            self.growth.return_to(checkpoint, self.recorded[checkpoint.step as usize]);
        }
        let mut left = budget;
        while self.growth.steps_taken() < step {
            if left == 0 {
                return false;
            }
            if !self.growth.work(step, &mut left) {
                return true;
            }
            self.keep();
        }
        true
    }

    /// As [`History::seek`], but never goes on beyond its `work`, counted in iterations times segments: a step that needs more is
    /// given up, and growth stands at the last finished one, with [`Status::Budget`] in the report of its plant. What is
    /// grown later is the same to the last bit.
    pub fn reach(&mut self, step: u32, work: u64) -> bool {
        let step = step.clamp(1, self.steps());
        // Backwards there is a checkpoint to start from; the rest is forwards.
        if self.growth.steps_taken() > step || self.growth.is_underway() {
            self.seek(step.min(self.growth.steps_taken()), 0);
        }
        let mut left = work;
        while self.growth.steps_taken() < step {
            let (state, laid) = (self.growth.state.clone(), self.growth.laid.len());
            let workspace = self.growth.workspace.clone();
            let taken = self.growth.steps_taken();
            self.growth.workspace.allowance = Some(left);
            let mut steps_left = left;
            let goes_on = self.growth.work(step, &mut steps_left);
            let unspent = self.growth.workspace.allowance.take().unwrap_or_default();
            if !goes_on {
                break;
            }
            // Static stepping begins anew, at no steps taken.
            if self.growth.steps_taken() <= taken {
                self.growth.return_to(&state, laid);
                self.growth.workspace = workspace;
                self.is_stopped = true;
                return false;
            }
            left = u64::min(unspent, steps_left);
            self.keep();
        }
        self.is_stopped = false;
        true
    }

    /// How much of the work of growth it takes again to make the plant of it: the copies around a stem are grown anew.
    pub fn remaking(&self) -> f64 {
        match self.growth.params.arrangement.pattern {
            ArrangementPattern::Single | ArrangementPattern::FlexibleStem => 0.03,
            ArrangementPattern::Stem => 1.0,
        }
    }

    /// Keeps what is new at this step: where the record of pipes ends, and a checkpoint now and then.
    fn keep(&mut self) {
        let step = self.growth.steps_taken();
        // A step that is still underway has been kept before; static stepping starts anew each time.
        if self.recorded.len() == step as usize {
            self.recorded.push(self.growth.laid.len());
            if step % self.interval == 0 {
                self.checkpoints.push(self.growth.state.clone());
            }
        }
    }
}
