//! The net under the tests of the physics: everything that is computed for hundreds of plants, to the last bit, as hashes. It says
//! that something changed, not that it is wrong. Who means to change results reads the difference of the other tests, then runs
//! `BOUGH_GOLDEN=write cargo test --test golden` and says in the changelog what changed and why.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may stop")]

mod soundness;

use std::fmt::Debug;
use std::fs;

use bough::growth::iterations;
use bough::params::{
    ArrangementPattern, BranchingPattern, Discretization, Kind, Method, PARAMETERS, PRESETS, Params, Stepping,
};
use bough::{History, Plant, grow, relaxation, sensitivity};

/// The hashes of one kind of cases, a line each, beside what is on record.
struct Ledger {
    kind: &'static str,
    lines: String,
}

impl Ledger {
    fn of(kind: &'static str) -> Self {
        Ledger { kind, lines: String::new() }
    }

    fn note(&mut self, name: &str, cases: &[u64]) {
        let sum = cases.iter().fold(0, |sum: u64, case| sum.rotate_left(7) ^ case);
        self.lines += &format!("{name} {sum:016x}\n");
    }

    fn compare(self) {
        let path = format!("{}/tests/golden/{}.txt", env!("CARGO_MANIFEST_DIR"), self.kind);
        if std::env::var_os("BOUGH_GOLDEN").is_some_and(|wish| wish == "write") {
            return fs::write(path, self.lines).unwrap();
        }
        let recorded = fs::read_to_string(path).unwrap();
        let changed: Vec<&str> =
            self.lines.lines().filter(|&line| !recorded.lines().any(|before| before == line)).collect();
        assert!(changed.is_empty(), "these give other numbers now: {changed:?}");
        assert_eq!(self.lines, recorded);
    }
}

/// Numbers print so that the same bits are read again: equal texts are equal bits.
fn hash(result: &impl Debug) -> u64 {
    format!("{result:?}")
        .bytes()
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

fn plant_hash(plant: &Plant) -> u64 {
    plant.fingerprint() ^ hash(&plant.report)
}

/// The plant of the params, or what is said against them.
fn grown(params: &Params) -> u64 {
    grow(params).map_or_else(|error| hash(&error), |plant| plant_hash(&plant))
}

/// Plants that grow in some milliseconds.
fn small_presets() -> impl Iterator<Item = (&'static str, Params)> {
    PRESETS.iter().map(|preset| {
        let mut params = Params::of_preset(preset);
        params.axis.segments = params.axis.segments.min(12);
        params.branching.generations = params.branching.generations.min(3);
        params.arrangement.count = params.arrangement.count.min(3);
        params.arrangement.interval = params.arrangement.interval.min(4);
        params.solver.method = Method::Newton;
        (preset.id, params)
    })
}

fn with(params: &Params, change: impl Fn(&mut Params)) -> Params {
    let mut params = params.clone();
    change(&mut params);
    params
}

fn ways_to_grow(params: &Params) -> [u64; 6] {
    [
        grown(params),
        grown(&with(params, |params| params.solver.discretization = Discretization::Paper)),
        grown(&with(params, |params| params.solver.space = true)),
        grown(&with(params, |params| params.solver.stepping = Stepping::Static)),
        grown(&with(params, |params| {
            params.loads.wind = 12.0;
            params.loads.tip_force = [0.02, -0.01, 0.0];
        })),
        grown(&with(params, |params| {
            params.loads.wind = 20.0;
            params.loads.wind_azimuth.0 = 70.0;
        })),
    ]
}

#[test]
fn presets_however_they_are_grown() {
    let mut ledger = Ledger::of("presets");
    for (id, params) in small_presets() {
        ledger.note(id, &ways_to_grow(&params));
    }
    ledger.compare();
}

#[test]
fn presets_after_the_growth() {
    let mut ledger = Ledger::of("aftermath");
    for (id, params) in small_presets() {
        let fruitful = with(&params, |params| params.loads.tip_mass = 0.05);
        let picked = with(&fruitful, |params| params.loads.picked = true);
        let removed = with(&fruitful, |params| params.loads.removed = true);
        let leafy = with(&params, |params| params.loads.foliage = 0.2);
        ledger.note(id, &[&fruitful, &picked, &removed, &leafy].map(grown));
    }
    ledger.compare();
}

/// Every value at the ends of its slider, on an axis, on forks, and in space.
#[test]
fn every_parameter() {
    let axis = with(&Params::default(), |params| params.axis.segments = 6);
    let forks = with(&axis, |params| {
        params.branching.pattern = BranchingPattern::Bifurcation;
        params.branching.generations = 2;
        params.axis.segments = 3;
    });
    let blown = with(&axis, |params| {
        params.solver.space = true;
        params.loads.wind = 8.0;
        params.loads.wind_azimuth.0 = 50.0;
    });
    let stem = with(&axis, |params| {
        params.arrangement.pattern = ArrangementPattern::Stem;
        params.arrangement.count = 3;
    });
    let mut ledger = Ledger::of("parameters");
    let mut offset = 0;
    for parameter in PARAMETERS {
        let mut cases = Vec::new();
        let most = match parameter.path {
            "axis.segments" => 8.0,
            "branching.generations" | "arrangement.count" => 3.0,
            // Millions of steps.
            "solver.method" => 0.0,
            _ => parameter.slider_max,
        };
        let values: Vec<f64> = match parameter.kind {
            Kind::Choice(_) | Kind::Flag => {
                (parameter.min as u32..=most.min(parameter.max) as u32).map(f64::from).collect()
            }
            _ => vec![parameter.slider_min.max(parameter.min), most.min(parameter.max)],
        };
        for base in [&axis, &forks, &blown, &stem] {
            for &value in &values {
                let mut flat = base.to_flat();
                if parameter.kind.width() > 0 && offset < flat.len() {
                    flat[offset] = value;
                }
                cases.push(grown(&Params::from_flat(&flat)));
            }
        }
        offset += parameter.kind.width();
        ledger.note(parameter.path, &cases);
    }
    ledger.compare();
}

#[test]
fn what_is_held() {
    let mut ledger = Ledger::of("holds");
    for (id, params) in small_presets() {
        let mut cases = Vec::new();
        for space in [false, true] {
            let params = with(&params, |params| params.solver.space = space);
            let Ok(mut history) = History::new(&params) else { continue };
            let free = history.at(params.axis.segments);
            let last = free.segments.parent.len() as u32;
            // Around a stem, the ends of every copy are among them.
            let is_around = params.arrangement.pattern != ArrangementPattern::Single;
            for segment in (0..last).filter(|segment| is_around || segment % (last / 3).max(1) == 0) {
                let [x, y, z] = free.tip(0);
                for place in [[0.8 * x, 1.1 * y, z], [-0.5 * x, 0.3 * y + 0.1, 0.2 * x]] {
                    let held = history.hold(segment, place);
                    cases.push(held.map_or(1, |held| plant_hash(&held) ^ hash(&held.params.loads.forces)));
                }
            }
        }
        ledger.note(id, &cases);
    }
    ledger.compare();
}

#[test]
fn how_shapes_depend_on_params() {
    let every: Vec<u32> = (0..Params::default().to_flat().len() as u32).collect();
    let mut ledger = Ledger::of("sensitivities");
    for (id, params) in small_presets() {
        let found = sensitivity(&with(&params, |params| params.axis.azimuth.0 = 0.0), 9, &every);
        ledger.note(id, &[hash(&found.map(|found| found.map(|found| found.slopes)))]);
    }
    ledger.compare();
}

#[test]
fn how_plants_come_to_rest() {
    let mut ledger = Ledger::of("paths");
    for (id, params) in small_presets() {
        let relaxed = relaxation(&params, 4);
        let iterated = iterations(&params, 4);
        ledger.note(id, &[hash(&relaxed), hash(&iterated)]);
    }
    ledger.compare();
}

/// There, back, in slices, with little work, and foreseen.
#[test]
fn ages_in_any_order() {
    let mut ledger = Ledger::of("ages");
    for (id, params) in small_presets() {
        let pulled = with(&params, |params| params.loads.tip_force = [0.02, -0.05, 0.01]);
        let Ok(mut history) = History::new(&pulled) else { continue };
        let mut cases = Vec::new();
        for step in [7, 3, 12, 5] {
            let arrived = history.seek(step, 20);
            cases.extend([plant_hash(&history.plant()), u64::from(arrived), history.step().into()]);
            let arrived = history.reach(step, 60);
            cases.extend([plant_hash(&history.plant()), u64::from(arrived), history.step().into()]);
        }
        cases.push(hash(&history.remaking()));
        ledger.note(id, &cases);
    }
    ledger.compare();
}

/// Axes cut finely enough that their memory is extrapolated, grown and foreseen.
#[test]
fn what_is_extrapolated() {
    let mut ledger = Ledger::of("extrapolated");
    for (id, params) in small_presets().step_by(3) {
        let params = with(&params, |params| {
            params.axis.segments = 300;
            params.axis.segment_length /= 25.0;
            params.arrangement.pattern = ArrangementPattern::Single;
            params.branching.pattern = BranchingPattern::None;
            params.solver.stepping = Stepping::Extrapolated;
        });
        let Ok(mut history) = History::new(&params) else { continue };
        let ages = [300, 260, 140].map(|step| plant_hash(&history.at(step)));
        ledger.note(id, &ages);
    }
    ledger.compare();
}

/// Those that the fuzzer kept because they came by other code.
#[test]
fn what_the_fuzzer_kept() {
    let mut ledger = Ledger::of("kept");
    for (name, corpus, params_of) in soundness::CASES {
        for (number, line) in corpus.lines().enumerate() {
            let input = soundness::unhexed(line);
            if let Some(params) = params_of(&input) {
                ledger.note(&format!("{name}-{number}"), &[grown(&params)]);
            }
        }
    }
    ledger.compare();
}
