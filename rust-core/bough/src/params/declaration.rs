//! THE declaration: every parameter once. Validation, form, links, TypeScript types, JSON Schema and the
//! reference table in the docs are all made from what stands here.

use alloc::vec::Vec;

use super::parameter::{Kind, Parameter, Scale};
use super::value::{PointForce, Value, choice, write_forces};
use crate::angle::Degrees;

choice! {
    /// How wood thickens.
    Thickening {
        /// Every segment keeps the radius it was formed with.
        None = "none",
        /// Each growth step adds one pipe of equal area to every older segment (section 4.2).
        Pipes = "pipes",
    }
}

choice! {
    /// Whether and how axes branch.
    BranchingPattern {
        /// One axis.
        None = "none",
        /// A full grown axis ends in two children, with the widths and angles of Murray (section 5.1).
        Bifurcation = "bifurcation",
    }
}

choice! {
    /// How several plants stand together.
    ArrangementPattern {
        /// One plant, rooted in the ground.
        Single = "single",
        /// Copies of the plant around a straight, rigid stem, lower ones older (figures 13d and 17d).
        Stem = "stem",
        /// Axes around a stem that grows itself, bends and twists under them.
        FlexibleStem = "flexibleStem",
    }
}

choice! {
    /// How the continuous rod is cut into rigid segments and springs.
    Discretization {
        /// The paper's: mass at a segment's distal end, every joint `EI/s`. First order.
        Paper = "paper",
        /// Half a segment's mass at each of its ends, clamp `2EI/s`, interior joints in series. Second order.
        SecondOrder = "secondOrder",
    }
}

choice! {
    /// How equilibrium is found.
    Method {
        /// Newton's method with the exact Hessian, O(n) an iteration.
        Newton = "newton",
        /// The paper's damped Euler relaxation, equations 15 to 20.
        Euler = "euler",
    }
}

choice! {
    /// How growth is stepped.
    Stepping {
        /// Every growth step ends in equilibrium.
        Exact = "exact",
        /// The finished plant is solved once, its loads raised from zero; it keeps no memory of its growth.
        Static = "static",
        /// The memory that exact growth leaves is extrapolated from coarser cuts of the axis, and its error estimated.
        Extrapolated = "extrapolated",
    }
}

/// The texts for people are left out of the wasm: JavaScript has them from the printed declaration.
const fn texts(text: &'static str) -> &'static str {
    if cfg!(feature = "texts") { text } else { "" }
}

/// Turns the declaration below into the typed structs and the table.
macro_rules! declare {
    ($(
        $(#[$group_doc:meta])*
        $group:ident: $Group:ident {
            $($field:ident: $Type:ty {
                path: $path:literal, key: $key:literal, symbol: $symbol:literal, unit: $unit:literal,
                kind: $kind:expr, default: $default:expr, range: $min:literal..=$max:literal,
                slider: $scale:ident $slider_min:literal..=$slider_max:literal,
                label: $label:literal,
                help: $help:literal,
                source: $source:literal,
            })+
        }
    )+) => {
        $(
            $(#[$group_doc])*
            #[derive(Clone, Debug, PartialEq)]
            pub struct $Group {
                $(
                    #[doc = $help]
                    #[doc = ""]
                    #[doc = concat!(
                        "Symbol: `", $symbol, "`. Unit: ", $unit, ". Range: ", stringify!($min), " to ",
                        stringify!($max), ". Source: ", $source, "."
                    )]
                    pub $field: $Type,
                )+
            }
        )+

        /// Everything that determines a plant. `Params::default()` is valid.
        #[derive(Clone, Debug, PartialEq)]
        pub struct Params {
            $(
                $(#[$group_doc])*
                pub $group: $Group,
            )+
        }

        /// The declaration as a table, in the order of the flat form.
        pub static PARAMETERS: &[Parameter] = &[
            $($(
                Parameter {
                    path: $path, key: $key, symbol: $symbol, unit: $unit, kind: $kind, default: &$default,
                    min: $min as f64, max: $max as f64,
                    slider_min: $slider_min as f64, slider_max: $slider_max as f64, scale: Scale::$scale,
                    label: texts($label), help: texts($help), source: texts($source),
                },
            )+)+
        ];

        impl Params {
            /// Reads the flat form: the numbers of each parameter in declared order. Numbers that are
            /// missing at the end take their defaults. The values are not checked: see [`super::check_flat`].
            pub fn from_flat(flat: &[f64]) -> Self {
                let mut rest = flat;
                let mut table = PARAMETERS.iter();
                let mut params = Params {
                    $($group: $Group { $($field: take(&mut rest, &mut table),)+ },)+
                };
                params.loads.forces = Value::read(rest);
                params
            }

            /// The flat form of these params.
            pub fn to_flat(&self) -> Vec<f64> {
                let mut flat = Vec::with_capacity(super::flat_length());
                $($(self.$group.$field.write(&mut flat);)+)+
                write_forces(&self.loads.forces, &mut flat);
                flat
            }
        }
    };
}

fn take<'a, T: Value>(rest: &mut &[f64], table: &mut impl Iterator<Item = &'a Parameter>) -> T {
    let Some(parameter) = table.next() else { return T::read(&[]) };
    match rest.split_at_checked(parameter.kind.width()) {
        Some((own, others)) => {
            *rest = others;
            T::read(own)
        }
        None => {
            *rest = &[];
            T::read(parameter.default)
        }
    }
}

impl Default for Params {
    fn default() -> Self {
        Params::from_flat(&[])
    }
}

declare! {
    /// The main axis.
    axis: Axis {
        segments: u32 {
            path: "axis.segments", key: "n", symbol: "n", unit: "",
            kind: Kind::Integer, default: [40.0], range: 1..=100_000, slider: Linear 1..=120,
            label: "Segments",
            help: "How many segments an axis grows to; the main axis gains one in each growth step.",
            source: "section 3.4",
        }
        segment_length: f64 {
            path: "axis.segmentLength", key: "l", symbol: "l", unit: "m",
            kind: Kind::Number, default: [0.0375], range: 1e-6..=1e3, slider: Log 0.005..=0.2,
            label: "Segment length",
            help: "Mean length of a segment.",
            source: "section 3.5",
        }
        length_profile: f64 {
            path: "axis.lengthProfile", key: "lp", symbol: "p", unit: "",
            kind: Kind::Number, default: [1.0], range: 1e-2..=1e2, slider: Log 0.2..=5,
            label: "Length profile",
            help: "Length of the middle segments over that of the end ones: 1 makes all equal, more makes the middle ones longer.",
            source: "section 3.5, figure 10",
        }
        radius: f64 {
            path: "axis.radius", key: "r", symbol: "R", unit: "m",
            kind: Kind::Number, default: [0.005], range: 1e-7..=1e2, slider: Log 0.0005..=0.05,
            label: "Radius",
            help: "Radius of a newly formed segment (one pipe); with a taper, the radius at the base.",
            source: "section 4.2, equation 42",
        }
        taper: f64 {
            path: "axis.taper", key: "tp", symbol: "t", unit: "",
            kind: Kind::Number, default: [1.0], range: 0..=1, slider: Linear 0..=1,
            label: "Taper",
            help: "Radius at the tip over radius at the base, linear along the finished axis: 1 is uniform, 0 a cone. Has no effect when wood thickens by pipes, which make their own taper.",
            source: "Greenhill 1881",
        }
        elevation: Degrees {
            path: "axis.elevation", key: "e", symbol: "\u{3b5}", unit: "deg",
            kind: Kind::Number, default: [50.0], range: -180..=180, slider: Linear -90..=90,
            label: "Elevation",
            help: "Direction in which the axis leaves its base, above the horizontal; negative points down.",
            source: "section 3.4, figure 8",
        }
        azimuth: Degrees {
            path: "axis.azimuth", key: "az", symbol: "\u{3b1}_0", unit: "deg",
            kind: Kind::Number, default: [0.0], range: -360..=360, slider: Linear -180..=180,
            label: "Azimuth",
            help: "Compass direction of the axis's vertical plane: its turn about the vertical, counter-clockwise seen from above.",
            source: "past the paper: three dimensions",
        }
        rest_curvature: f64 {
            path: "axis.restCurvature", key: "rc", symbol: "\u{3ba}_0", unit: "1/m",
            kind: Kind::Number, default: [0.0], range: -1e6..=1e6, slider: Linear -10..=10,
            label: "Built-in curvature",
            help: "Bend of new wood before any load: the curvature that it would keep in free fall; positive bends to the upper side.",
            source: "past the paper: three dimensions",
        }
        rest_curvature_roll: Degrees {
            path: "axis.restCurvatureRoll", key: "rr", symbol: "", unit: "deg",
            kind: Kind::Number, default: [0.0], range: -360..=360, slider: Linear -180..=180,
            label: "Roll of the built-in curvature",
            help: "Direction about the axis to which new wood is bent: 0 is its upper side, 90 the side that is to the right for who looks along the axis.",
            source: "past the paper: three dimensions",
        }
        rest_twist: f64 {
            path: "axis.restTwist", key: "rt", symbol: "\u{3c4}_0", unit: "1/m",
            kind: Kind::Number, default: [0.0], range: -1e6..=1e6, slider: Linear -20..=20,
            label: "Built-in twist",
            help: "Twist of new wood, radians per metre, as in spiral grain: with a built-in curvature the axis grows into a helix, of radius c/(c^2 + t^2) and pitch 2 pi t/(c^2 + t^2).",
            source: "past the paper: three dimensions",
        }
    }

    /// What the wood is made of.
    material: Material {
        youngs_modulus: f64 {
            path: "material.youngsModulus", key: "ym", symbol: "E", unit: "Pa",
            kind: Kind::Number, default: [1e9], range: 1e-3..=1e15, slider: Log 1e7..=2e10,
            label: "Young's modulus",
            help: "Stiffness of the wood against bending: green wood has 1 to 15 GPa, soft shoots a hundredth of that.",
            source: "equation 26",
        }
        density: f64 {
            path: "material.density", key: "rho", symbol: "\u{3c1}", unit: "kg/m3",
            kind: Kind::Number, default: [1000.0], range: 1e-6..=1e9, slider: Linear 100..=2000,
            label: "Density",
            help: "Mass of the wood per volume; fresh wood is close to water.",
            source: "equations 21 to 24",
        }
        shear_modulus_ratio: f64 {
            path: "material.shearModulusRatio", key: "gr", symbol: "G/E", unit: "",
            kind: Kind::Number, default: [0.1], range: 1e-6..=1e3, slider: Log 0.01..=1,
            label: "Shear modulus ratio",
            help: "Shear modulus over Young's modulus, which resists twisting: GJ/EI of a round section is twice this. Wood has about 0.06 to 0.12, rubber 0.33.",
            source: "past the paper: three dimensions",
        }
        modulus_of_rupture: f64 {
            path: "material.modulusOfRupture", key: "mor", symbol: "\u{3c3}_r", unit: "Pa",
            kind: Kind::Number, default: [5e7], range: 1e-3..=1e15, slider: Log 1e6..=2e8,
            label: "Modulus of rupture",
            help: "Fibre stress at which the wood breaks: green wood stands 30 to 80 MPa, soft shoots a tenth of that.",
            source: "Costes et al. 2008",
        }
    }

    /// The direction that growth seeks.
    tropism: Tropism {
        elevation: Degrees {
            path: "tropism.elevation", key: "te", symbol: "\u{3b5}_T", unit: "deg",
            kind: Kind::Number, default: [90.0], range: -180..=180, slider: Linear -90..=90,
            label: "Preferred direction",
            help: "The direction the axis seeks to grow in, above the horizontal: 90 is straight up, 0 horizontal, -90 straight down.",
            source: "sections 4.1 and 5.2",
        }
        azimuth: Option<Degrees> {
            path: "tropism.azimuth", key: "ta", symbol: "\u{3b1}_T", unit: "deg",
            kind: Kind::Optional, default: [f64::NAN], range: -360..=360, slider: Linear -180..=180,
            label: "Azimuth of the preferred direction",
            help: "Compass direction of what is sought, the same for all axes, as light from one side; without it every axis seeks in its own vertical plane.",
            source: "section 5.2 in three dimensions",
        }
        strength: f64 {
            path: "tropism.strength", key: "tk", symbol: "k", unit: "1/m",
            kind: Kind::Number, default: [0.0], range: 0..=1e9, slider: Linear 0..=10,
            label: "Tropism strength",
            help: "How fast new wood turns to the preferred direction, per metre of growth: 0 is off, 1e6 and more is full. New wood that points exactly away from the preferred direction has no side to turn to and keeps its direction.",
            source: "equations 57 and 73",
        }
    }

    /// How wood is added.
    growth: Growth {
        thickening: Thickening {
            path: "growth.thickening", key: "th", symbol: "", unit: "",
            kind: Kind::Choice(Thickening::NAMES), default: [0.0], range: 0..=1, slider: Linear 0..=1,
            label: "Thickening",
            help: "Whether older wood thickens: with pipes every older segment gains one pipe of equal area in each growth step, laid down unstressed.",
            source: "section 4.2",
        }
    }

    /// How axes fork.
    branching: Branching {
        pattern: BranchingPattern {
            path: "branching.pattern", key: "b", symbol: "", unit: "",
            kind: Kind::Choice(BranchingPattern::NAMES), default: [0.0], range: 0..=1, slider: Linear 0..=1,
            label: "Branching",
            help: "Whether a full grown axis ends in a fork: with bifurcation in two children of unequal girth, which are new axes.",
            source: "section 5.1",
        }
        generations: u32 {
            path: "branching.generations", key: "bg", symbol: "", unit: "",
            kind: Kind::Integer, default: [3.0], range: 0..=30, slider: Linear 0..=8,
            label: "Generations",
            help: "How often each path forks.",
            source: "section 5.1",
        }
        length_ratio: f64 {
            path: "branching.lengthRatio", key: "bl", symbol: "", unit: "",
            kind: Kind::Number, default: [1.0], range: 1e-3..=10, slider: Linear 0.4..=1.2,
            label: "Length ratio",
            help: "Segments of a child axis over those of its parent, rounded, at least one.",
            source: "section 5.1",
        }
        exponent: f64 {
            path: "branching.exponent", key: "ba", symbol: "\u{3b1}", unit: "",
            kind: Kind::Number, default: [2.49], range: 2..=100, slider: Linear 2..=4,
            label: "Murray's exponent",
            help: "Exponent of the widths at a fork: 2 keeps the area (da Vinci) and both children go straight on, 2.49 is the paper's, 3 is Murray's law for vessels; more spreads the children further.",
            source: "equation 47",
        }
        girth_ratio: f64 {
            path: "branching.girthRatio", key: "br", symbol: "r", unit: "",
            kind: Kind::Number, default: [0.8], range: 1e-9..=1, slider: Linear 0.2..=1,
            label: "Girth ratio",
            help: "Width of the thinner child over that of the thicker; the thinner one turns away more.",
            source: "equations 47 to 50",
        }
        roll: Degrees {
            path: "branching.roll", key: "bo", symbol: "", unit: "deg",
            kind: Kind::Number, default: [0.0], range: -180..=180, slider: Linear -180..=180,
            label: "Roll of the forks",
            help: "Turn of each fork's plane about its parent, from the plane of the fork before: at 0 all lie in one plane and the thicker child turns counter-clockwise, at 90 forks stand crosswise; beyond, the children change sides, so that 180 is the mirror image of 0.",
            source: "section 5.1",
        }
    }

    /// How plants stand together.
    arrangement: Arrangement {
        pattern: ArrangementPattern {
            path: "arrangement.pattern", key: "a", symbol: "", unit: "",
            kind: Kind::Choice(ArrangementPattern::NAMES), default: [0.0], range: 0..=2, slider: Linear 0..=2,
            label: "Arrangement",
            help: "One plant; or copies of it around a straight, rigid stem, each in its own vertical plane, lower ones older; or axes on a stem that grows itself, and bends and twists under them.",
            source: "figures 13d and 17d",
        }
        count: u32 {
            path: "arrangement.count", key: "ac", symbol: "", unit: "",
            kind: Kind::Integer, default: [16.0], range: 1..=10_000, slider: Linear 1..=40,
            label: "Axes on the stem",
            help: "How many axes the stem bears once all have begun to grow.",
            source: "figures 13d and 17d",
        }
        spacing: f64 {
            path: "arrangement.spacing", key: "as", symbol: "", unit: "m",
            kind: Kind::Number, default: [0.08], range: 1e-6..=1e3, slider: Log 0.01..=0.5,
            label: "Spacing on the stem",
            help: "Length of stem between an axis and the next.",
            source: "figures 13d and 17d",
        }
        trunk: f64 {
            path: "arrangement.trunk", key: "at", symbol: "", unit: "m",
            kind: Kind::Number, default: [0.0], range: 0..=1e3, slider: Linear 0..=5,
            label: "Bare trunk",
            help: "Length of bare stem below; above it the first spacing begins.",
            source: "chosen",
        }
        divergence: Degrees {
            path: "arrangement.divergence", key: "ad", symbol: "", unit: "deg",
            kind: Kind::Number, default: [137.5], range: -180..=180, slider: Linear 0..=180,
            label: "Divergence angle",
            help: "Turn about the stem from an axis to the next; 137.5 is the golden angle of spiral phyllotaxis, 180 makes two rows.",
            source: "figures 13d and 17d; phyllotaxis",
        }
        interval: u32 {
            path: "arrangement.interval", key: "ai", symbol: "", unit: "",
            kind: Kind::Integer, default: [2.0], range: 0..=100_000, slider: Linear 0..=10,
            label: "Interval",
            help: "Growth steps from the start of an axis to the start of the next one above it; an axis whose time has not come is not there yet.",
            source: "figures 13d and 17d; plastochron",
        }
        stem_radius: f64 {
            path: "arrangement.stemRadius", key: "ar", symbol: "", unit: "m",
            kind: Kind::Number, default: [0.01], range: 1e-7..=1e2, slider: Log 0.001..=0.1,
            label: "Radius of the stem",
            help: "Radius of a newly formed segment of a flexible stem (one pipe); a rigid stem is as thick as the axes above need.",
            source: "past the paper: three dimensions",
        }
        stem_elevation: Degrees {
            path: "arrangement.stemElevation", key: "ae", symbol: "", unit: "deg",
            kind: Kind::Number, default: [90.0], range: -180..=180, slider: Linear 0..=90,
            label: "Elevation of the stem",
            help: "Direction in which a flexible stem leaves the ground, above the horizontal; its axes lean with it.",
            source: "past the paper: three dimensions",
        }
    }

    /// What pulls at the plant.
    loads: Loads {
        gravity: f64 {
            path: "loads.gravity", key: "g", symbol: "g", unit: "m/s2",
            kind: Kind::Number, default: [9.81], range: 0..=1e6, slider: Linear 0..=30,
            label: "Gravity",
            help: "Acceleration of gravity: 9.81 on Earth, 1.62 on the Moon, 0 in free fall.",
            source: "equation 9",
        }
        tip_mass: f64 {
            path: "loads.tipMass", key: "tm", symbol: "M", unit: "kg",
            kind: Kind::Number, default: [0.0], range: 0..=1e9, slider: Linear 0..=0.5,
            label: "Mass at the tip",
            help: "A fruit or flower at each tip, carried from the first growth step on.",
            source: "equations 1 to 9",
        }
        foliage: f64 {
            path: "loads.foliage", key: "fo", symbol: "", unit: "kg/m",
            kind: Kind::Number, default: [0.0], range: 0..=1e6, slider: Linear 0..=0.5,
            label: "Foliage",
            help: "Mass of the leaves per metre of young wood, carried in every growth step.",
            source: "loads along the axis, as equation 9 has them",
        }
        foliage_age: u32 {
            path: "loads.foliageAge", key: "fa", symbol: "", unit: "",
            kind: Kind::Integer, default: [20.0], range: 1..=100_000, slider: Linear 1..=60,
            label: "Age of the foliage",
            help: "For how many growth steps a segment bears leaves: that is what counts as young wood.",
            source: "chosen",
        }
        foliage_area: f64 {
            path: "loads.foliageArea", key: "fs", symbol: "", unit: "m2/kg",
            kind: Kind::Number, default: [4.0], range: 0..=1e3, slider: Linear 0..=8,
            label: "Area of the foliage",
            help: "Area of the leaves, of one side, per mass: what wind and snow meet. Fresh broad leaves have 3 to 6, needles 1 to 2.",
            source: "chosen",
        }
        snow: f64 {
            path: "loads.snow", key: "sn", symbol: "", unit: "kg/m2",
            kind: Kind::Number, default: [0.0], range: 0..=1e4, slider: Linear 0..=40,
            label: "Snow or rain",
            help: "Mass that lies on the grown plant, per area of its wood seen from above and of its leaves: 0.2 for rain, 5 to 40 for snow.",
            source: "chosen",
        }
        wind: f64 {
            path: "loads.wind", key: "w", symbol: "v", unit: "m/s",
            kind: Kind::Number, default: [0.0], range: 0..=1e3, slider: Linear 0..=30,
            label: "Wind",
            help: "Speed of a steady wind on the grown plant. It pushes at wood across it by the square of the speed that meets it at right angles, and at leaves in its own direction.",
            source: "Hoerner 1965, cross-flow principle",
        }
        wind_azimuth: Degrees {
            path: "loads.windAzimuth", key: "wa", symbol: "", unit: "deg",
            kind: Kind::Number, default: [0.0], range: -180..=180, slider: Linear -180..=180,
            label: "Direction of the wind",
            help: "Where the wind blows to, turned about the vertical: 0 is to the right, 180 to the left.",
            source: "chosen",
        }
        drag_coefficient: f64 {
            path: "loads.dragCoefficient", key: "cd", symbol: "C_d", unit: "",
            kind: Kind::Number, default: [1.0], range: 0..=1e3, slider: Linear 0..=2,
            label: "Drag of the wood",
            help: "Drag coefficient of the wood on its diameter; a round rod has about 1.",
            source: "Hoerner 1965",
        }
        foliage_drag: f64 {
            path: "loads.foliageDrag", key: "fd", symbol: "", unit: "",
            kind: Kind::Number, default: [0.2], range: 0..=1e3, slider: Linear 0..=1,
            label: "Drag of the foliage",
            help: "Drag coefficient of the leaves on their area in still air; leaves fold in the wind, so it is far below that of a plate.",
            source: "Vollsinger et al. 2005",
        }
        tip_force: [f64; 3] {
            path: "loads.tipForce", key: "tf", symbol: "F", unit: "N",
            kind: Kind::Vector, default: [0.0, 0.0, 0.0], range: -1e12..=1e12, slider: Linear -5..=5,
            label: "Force at the tip",
            help: "A force x, y, z on the tip of the main axis, acting in every growth step on the tip of that age. Around a stem, x points away from it.",
            source: "equations 1 to 8",
        }
        forces: Vec<PointForce> {
            path: "loads.forces", key: "", symbol: "F", unit: "N",
            kind: Kind::Forces, default: [], range: -1e12..=1e12, slider: Linear -5..=5,
            label: "Forces on segments",
            help: "Forces that pull at the distal ends of segments after growth, as a pointer does: a list of {segment, force: [x, y, z]}. Kept out of links.",
            source: "equations 1 to 8",
        }
        picked: bool {
            path: "loads.picked", key: "pk", symbol: "", unit: "",
            kind: Kind::Flag, default: [0.0], range: 0..=1, slider: Linear 0..=1,
            label: "Pick the fruit",
            help: "After growth, take the masses at the tips off and show how far the plant rises again.",
            source: "section 4.2",
        }
        removed: bool {
            path: "loads.removed", key: "rm", symbol: "", unit: "",
            kind: Kind::Flag, default: [0.0], range: 0..=1, slider: Linear 0..=1,
            label: "Take the loads off",
            help: "After growth, take every load off and show what stays bent: the shape the wood remembers.",
            source: "section 4.2",
        }
    }

    /// How the shape is computed.
    solver: Solver {
        discretization: Discretization {
            path: "solver.discretization", key: "d", symbol: "", unit: "",
            kind: Kind::Choice(Discretization::NAMES), default: [1.0], range: 0..=1, slider: Linear 0..=1,
            label: "Discretization",
            help: "How the continuous rod is cut: the paper's way is first order, the other second order, so that few segments are enough.",
            source: "section 3, and half masses at both ends of a segment",
        }
        method: Method {
            path: "solver.method", key: "m", symbol: "", unit: "",
            kind: Kind::Choice(Method::NAMES), default: [0.0], range: 0..=1, slider: Linear 0..=1,
            label: "Method",
            help: "How equilibrium is found: Newton's method with the exact Hessian, or the paper's damped Euler relaxation, which is far slower.",
            source: "equations 15 to 20",
        }
        tolerance: f64 {
            path: "solver.tolerance", key: "tol", symbol: "", unit: "",
            kind: Kind::Number, default: [1e-10], range: 1e-15..=0.1, slider: Log 1e-12..=1e-3,
            label: "Tolerance",
            help: "Largest torque that may be left over at any joint, relative to the largest torque in the plant.",
            source: "equation 14",
        }
        stepping: Stepping {
            path: "solver.stepping", key: "st", symbol: "", unit: "",
            kind: Kind::Choice(Stepping::NAMES), default: [0.0], range: 0..=2, slider: Linear 0..=2,
            label: "Stepping",
            help: "Exact brings every growth step to equilibrium; static solves the finished plant at once, its loads raised from zero, without memory of how it grew; extrapolated foresees that memory from coarser cuts of an evenly cut single axis, and says how far off that may be (other plants are grown exactly).",
            source: "section 3.4",
        }
        space: bool {
            path: "solver.space", key: "sp", symbol: "", unit: "",
            kind: Kind::Flag, default: [0.0], range: 0..=1, slider: Linear 0..=1,
            label: "Always in space",
            help: "Computes plants that lie in one vertical plane with rods in space, too: the same shape, more slowly. All others are computed so anyway.",
            source: "past the paper: three dimensions",
        }
    }
}
