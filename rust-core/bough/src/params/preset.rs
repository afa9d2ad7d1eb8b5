//! Named sets of params. A released preset never changes: links and lessons rely on it.

use super::declaration::{PARAMETERS, Params};
use super::species::SPECIES;

/// A plant worth looking at.
#[derive(Clone, Copy, Debug)]
pub struct Preset {
    /// Stable name, also in links: `"figure-8a"`.
    pub id: &'static str,
    /// A short title.
    pub title: &'static str,
    /// A sentence on what to see.
    pub note: &'static str,
    /// The params that differ from the defaults, as path and flat form.
    pub set: &'static [(&'static str, &'static [f64])],
    /// The growth step to show, when it is not the last.
    pub step: Option<u32>,
}

/// Adds what differs from figure to figure to what they share.
macro_rules! set {
    ($($shared:expr),* ; $($own:expr),*) => { &[$($shared,)* $($own),*] };
}

/// The rod of figures 8 and 10, of which the paper states only the elevation: 1.5 m long, q = 15.
macro_rules! figure_8 {
    ($($own:expr),*) => { set!(("axis.elevation", &[50.0]), ("material.youngsModulus", &[3.5316e8]); $($own),*) };
}

/// The organ of figure 2, a drawing: 30 cm long and stiff, it leaves its base at 20 degrees and turns to its
/// set point within a few centimetres.
macro_rules! figure_2 {
    ($sought:literal) => {
        set!(
            ("axis.elevation", &[20.0]), ("axis.segmentLength", &[0.0075]), ("axis.radius", &[0.002]),
            ("material.youngsModulus", &[5e9]), ("tropism.strength", &[30.0]);
            ("tropism.elevation", &[$sought])
        )
    };
}

/// The axis of figure 13, of which the paper states that it seeks 45 degrees: 1.5 m long, full tropism.
macro_rules! figure_13 {
    ($($own:expr),*) => {
        set!(
            ("axis.elevation", &[45.0]), ("tropism.elevation", &[45.0]), ("tropism.strength", &[1e6]);
            $($own),*
        )
    };
}

/// The axis of figure 17, of which the paper states the rest angle of 50 degrees: 1.5 m long, pipes of 2 mm
/// radius that grow to a base of 13 mm, full tropism.
macro_rules! figure_17 {
    ($($own:expr),*) => {
        set!(
            ("axis.elevation", &[50.0]), ("axis.radius", &[0.002]), ("tropism.elevation", &[50.0]),
            ("tropism.strength", &[1e6]), ("growth.thickening", &[1.0]);
            $($own),*
        )
    };
}

/// The bifurcating structures of figures 18 and 21: four generations of ten segments, each shorter by a tenth.
macro_rules! forking {
    ($($own:expr),*) => {
        set!(
            ("axis.segments", &[10.0]), ("axis.segmentLength", &[0.03]), ("axis.radius", &[0.006]),
            ("branching.pattern", &[1.0]), ("branching.generations", &[4.0]), ("branching.lengthRatio", &[0.9]);
            $($own),*
        )
    };
}

/// The structure of figures 21 a and b: three generations of eight segments, the thinner child less than half as
/// thick, so that no branching angles cancel and the strength alone tells the two apart.
macro_rules! figure_21 {
    ($strength:literal) => {
        forking!(
            ("axis.elevation", &[45.0]),
            ("tropism.elevation", &[45.0]),
            ("tropism.strength", &[$strength]),
            ("axis.segments", &[8.0]),
            ("axis.segmentLength", &[0.04]),
            ("branching.generations", &[3.0]),
            ("branching.girthRatio", &[0.45]),
            ("material.youngsModulus", &[3e9])
        )
    };
}

/// The segment of figure 20: 20 cm, weightless, starting at 10 degrees; the vector points straight up.
macro_rules! figure_20 {
    ($strength:literal) => {
        set!(
            ("axis.segments", &[1.0]), ("axis.segmentLength", &[0.2]), ("axis.elevation", &[10.0]),
            ("loads.gravity", &[0.0]), ("tropism.elevation", &[90.0]);
            ("tropism.strength", &[$strength])
        )
    };
}

/// A preset in one line of its own.
pub(super) const fn preset(
    id: &'static str,
    title: &'static str,
    note: &'static str,
    set: &'static [(&'static str, &'static [f64])],
    step: Option<u32>,
) -> Preset {
    Preset { id, title, note, set, step }
}

/// All presets: the paper's figures in their order, then plants that one knows.
pub static PRESETS: &[Preset] = &{
    let mut all = [FIGURES[0]; FIGURES.len() + SPECIES.len()];
    let mut next = 0;
    while next < all.len() {
        all[next] = if next < FIGURES.len() { FIGURES[next] } else { SPECIES[next - FIGURES.len()] };
        next += 1;
    }
    all
};

const FIGURES: &[Preset] = &[
    preset(
        "figure-2a",
        "Straight up",
        "Negative orthogravitropism: wherever it starts, the organ turns until it grows straight up.",
        figure_2!(90.0),
        None,
    ),
    preset(
        "figure-2b",
        "Up at an angle",
        "Negative plagiogravitropism: the organ settles at an angle above the horizontal, as many branches do.",
        figure_2!(45.0),
        None,
    ),
    preset(
        "figure-2c",
        "Horizontal",
        "Diagravitropism: the organ grows level, as runners and rhizomes do.",
        figure_2!(0.0),
        None,
    ),
    preset(
        "figure-2d",
        "Down at an angle",
        "Positive plagiogravitropism: the organ settles at an angle below the horizontal, as side roots do.",
        figure_2!(-45.0),
        None,
    ),
    preset(
        "figure-2e",
        "Straight down",
        "Positive orthogravitropism: the organ turns until it grows straight down, as a main root does.",
        figure_2!(-90.0),
        None,
    ),
    preset(
        "figure-8a",
        "An axis under gravity, young",
        "A short axis hardly feels its weight: it leaves the base at 50 degrees and stays almost straight.",
        figure_8!(),
        Some(10),
    ),
    preset(
        "figure-8b",
        "An axis under gravity, growing",
        "Twice as long is eight times the gravity number (its length cubed): the tip begins to lean over.",
        figure_8!(),
        Some(20),
    ),
    preset(
        "figure-8c",
        "An axis under gravity, arching",
        "The whole axis now arches, and its tip points below the horizontal.",
        figure_8!(),
        Some(30),
    ),
    preset(
        "figure-8d",
        "An axis under gravity, full grown",
        "The tip hangs down: the same wood, only longer. Bending grows with the cube of the length.",
        figure_8!(),
        None,
    ),
    preset(
        "figure-10",
        "The same rod, cut unevenly",
        "Short end and long middle segments make (nearly) the shape of figure 8: the cut does not matter.",
        figure_8!(("axis.lengthProfile", &[3.0])),
        None,
    ),
    preset(
        "figure-13a",
        "A tropism against gravity, young",
        "New wood always starts at 45 degrees; a short axis can hold it there.",
        figure_13!(("material.youngsModulus", &[3.5316e8])),
        Some(13),
    ),
    preset(
        "figure-13b",
        "A tropism against gravity, growing",
        "Old wood sags under what it bears while the tip still seeks 45 degrees: an S begins.",
        figure_13!(("material.youngsModulus", &[3.5316e8])),
        Some(26),
    ),
    preset(
        "figure-13c",
        "A tropism against gravity, full grown",
        "The S-shape of many branches: the old part sags, the young part turns up. There is one inflection.",
        figure_13!(("material.youngsModulus", &[3.5316e8])),
        None,
    ),
    preset(
        "figure-13d",
        "Seeking axes around a stem",
        "The axis of figure 13 at many ages around a stem, each in its own vertical plane; lower ones are older.",
        figure_13!(
            ("material.youngsModulus", &[8e8]),
            ("arrangement.pattern", &[1.0]),
            ("arrangement.count", &[20.0]),
            ("arrangement.spacing", &[0.1])
        ),
        None,
    ),
    preset(
        "figure-17b",
        "Thickening wood",
        "Each step adds a pipe to all older wood. The base grows stiff while the tip stays thin.",
        figure_17!(("material.youngsModulus", &[5e8])),
        None,
    ),
    preset(
        "figure-17c",
        "Thickening wood, softer",
        "The same axis with a quarter of the stiffness sags further, and a part of that stays: take the loads off to see.",
        figure_17!(("material.youngsModulus", &[1.25e8])),
        None,
    ),
    preset(
        "figure-17d",
        "Thickening axes around a stem",
        "The axis of figure 17 at many ages around a stem: the outline of a young conifer.",
        figure_17!(
            ("material.youngsModulus", &[2.5e8]),
            ("arrangement.pattern", &[1.0]),
            ("arrangement.count", &[20.0]),
            ("arrangement.spacing", &[0.1])
        ),
        None,
    ),
    preset(
        "figure-18a",
        "Unequal forks, hanging",
        "It starts 60 degrees down. At each fork the thinner child turns away more, and all hangs.",
        forking!(
            ("axis.elevation", &[-60.0]),
            ("branching.girthRatio", &[0.7]),
            ("material.youngsModulus", &[8e8])
        ),
        None,
    ),
    preset(
        "figure-18b",
        "Equal forks, rising",
        "It starts 60 degrees up. Children of equal girth turn away equally; gravity bends them apart.",
        forking!(
            ("axis.elevation", &[60.0]),
            ("branching.girthRatio", &[1.0]),
            ("material.youngsModulus", &[8e8])
        ),
        None,
    ),
    preset(
        "figure-20a",
        "A segment and a weak tropism",
        "One segment starts at 10 degrees and turns a little towards the vector, which points straight up.",
        figure_20!(4.0),
        None,
    ),
    preset(
        "figure-20b",
        "A segment and a strong tropism",
        "The same segment almost reaches the vector.",
        figure_20!(30.0),
        None,
    ),
    preset(
        "figure-21a",
        "Forks and a weak tropism",
        "All axes seek the direction in which the first one starts, 45 degrees up, but weakly: they spread.",
        figure_21!(0.8),
        None,
    ),
    preset(
        "figure-21b",
        "Forks and a strong tropism",
        "The same with a strong tropism: soon after each fork the children run alongside each other again.",
        figure_21!(18.0),
        None,
    ),
    preset(
        "figure-21c",
        "Forks that seek the horizontal",
        "A tropism of intermediate strength towards the horizontal spreads the plant like a plate.",
        forking!(
            ("axis.elevation", &[0.0]),
            ("tropism.elevation", &[0.0]),
            ("tropism.strength", &[3.0]),
            ("material.youngsModulus", &[3e9])
        ),
        None,
    ),
];

impl Params {
    /// The complete params of a preset.
    pub fn of_preset(preset: &Preset) -> Self {
        let mut flat = Params::default().to_flat();
        let mut offset = 0;
        for parameter in PARAMETERS {
            let width = parameter.kind.width();
            for (_, value) in preset.set.iter().filter(|(path, _)| *path == parameter.path) {
                flat.splice(offset..offset + width, value.iter().copied());
            }
            offset += width;
        }
        Params::from_flat(&flat)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::params::check;

    #[test]
    fn every_preset_is_valid_and_named_once() {
        for preset in PRESETS {
            let params = Params::of_preset(preset);
            assert_eq!(check(&params), [], "{}", preset.id);
            assert!(
                preset.step.is_none_or(
                    |step| step >= 1 && step <= crate::growth::Growth::new(&params).unwrap().steps()
                )
            );
            assert_eq!(PRESETS.iter().filter(|other| other.id == preset.id).count(), 1);
            for (path, _) in preset.set {
                assert!(PARAMETERS.iter().any(|parameter| parameter.path == *path), "{path}");
            }
        }
    }
}
