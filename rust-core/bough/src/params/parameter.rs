//! What the declaration says of one parameter.

/// How a slider maps its travel to the value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Equal travel, equal difference.
    Linear,
    /// Equal travel, equal ratio: for ranges that span decades.
    Log,
}

/// What kind of value a parameter takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A real number.
    Number,
    /// A real number, or nothing: NaN in flat form.
    Optional,
    /// A whole number.
    Integer,
    /// One of the named options; its flat form is the option's index.
    Choice(&'static [&'static str]),
    /// True or false; 1 or 0 in flat form.
    Flag,
    /// Three real numbers x, y, z; each within the range.
    Vector,
    /// A list of forces on segments; its flat form is at the end, after all others: segment, x, y, z of each.
    Forces,
}

impl Kind {
    /// How many numbers the value takes in the fixed part of the flat form.
    pub const fn width(self) -> usize {
        match self {
            Kind::Vector => 3,
            Kind::Forces => 0,
            _ => 1,
        }
    }
}

/// One parameter as declared: the single source of validation, form, URL, types and reference table.
#[derive(Clone, Copy, Debug)]
pub struct Parameter {
    /// JSON path, camelCase: `"axis.segmentLength"`.
    pub path: &'static str,
    /// Short key in a link.
    pub key: &'static str,
    /// Symbol used in the equations.
    pub symbol: &'static str,
    /// SI unit, `"deg"` for angles, empty for pure numbers.
    pub unit: &'static str,
    /// The kind of value.
    pub kind: Kind,
    /// Default in flat form: one number, or three for a vector.
    pub default: &'static [f64],
    /// Smallest value that is accepted.
    pub min: f64,
    /// Largest value that is accepted.
    pub max: f64,
    /// Left end of a friendly slider.
    pub slider_min: f64,
    /// Right end of a friendly slider.
    pub slider_max: f64,
    /// The slider's scale.
    pub scale: Scale,
    /// A word or two for a form.
    pub label: &'static str,
    /// A sentence on what it does.
    pub help: &'static str,
    /// Equation or section of Jirasek & Prusinkiewicz (1998), or another source.
    pub source: &'static str,
}
