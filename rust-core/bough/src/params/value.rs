//! The types a parameter can have, and their flat form: a run of numbers, as they cross into wasm.

use alloc::vec::Vec;

use crate::angle::Degrees;

/// A typed parameter value with a flat form of fixed width.
pub(crate) trait Value: Sized {
    /// Reads the value from its run of numbers, which has been checked against the declaration.
    fn read(flat: &[f64]) -> Self;
    /// Appends the value's run of numbers.
    fn write(&self, flat: &mut Vec<f64>);
}

fn first(flat: &[f64]) -> f64 {
    flat.first().copied().unwrap_or_default()
}

impl Value for f64 {
    fn read(flat: &[f64]) -> Self {
        first(flat)
    }
    fn write(&self, flat: &mut Vec<f64>) {
        flat.push(*self);
    }
}

impl Value for u32 {
    fn read(flat: &[f64]) -> Self {
        first(flat) as u32
    }
    fn write(&self, flat: &mut Vec<f64>) {
        flat.push(f64::from(*self));
    }
}

impl Value for bool {
    fn read(flat: &[f64]) -> Self {
        first(flat) != 0.0
    }
    fn write(&self, flat: &mut Vec<f64>) {
        flat.push(f64::from(u8::from(*self)));
    }
}

impl Value for Degrees {
    fn read(flat: &[f64]) -> Self {
        Degrees(first(flat))
    }
    fn write(&self, flat: &mut Vec<f64>) {
        flat.push(self.0);
    }
}

impl Value for Option<Degrees> {
    fn read(flat: &[f64]) -> Self {
        flat.first().filter(|number| !number.is_nan()).map(|&number| Degrees(number))
    }
    fn write(&self, flat: &mut Vec<f64>) {
        flat.push(self.map_or(f64::NAN, |angle| angle.0));
    }
}

impl Value for [f64; 3] {
    fn read(flat: &[f64]) -> Self {
        match flat {
            [x, y, z] => [*x, *y, *z],
            _ => [0.0; 3],
        }
    }
    fn write(&self, flat: &mut Vec<f64>) {
        flat.extend_from_slice(self);
    }
}

/// A force on the distal end of a segment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointForce {
    /// Index of the segment in the result's arrays.
    pub segment: u32,
    /// x, y, z in N.
    pub force: [f64; 3],
}

/// How many numbers a [`PointForce`] takes in flat form.
pub(crate) const FORCE_WIDTH: usize = 4;

impl Value for Vec<PointForce> {
    fn read(flat: &[f64]) -> Self {
        let of =
            |numbers: &[f64]| PointForce { segment: u32::read(numbers), force: Value::read(&numbers[1..]) };
        flat.chunks_exact(FORCE_WIDTH).map(of).collect()
    }
    /// Nothing here: a list has no fixed place. See [`write_forces`].
    fn write(&self, _flat: &mut Vec<f64>) {}
}

/// Appends the forces at the end of the flat form.
pub(crate) fn write_forces(forces: &[PointForce], flat: &mut Vec<f64>) {
    for PointForce { segment, force: [x, y, z] } in forces {
        flat.extend([f64::from(*segment), *x, *y, *z]);
    }
}

/// Declares an enum whose variants are the named options of a choice, in their declared order.
macro_rules! choice {
    ($(#[$doc:meta])* $Name:ident { $($(#[$variant_doc:meta])* $Variant:ident = $name:literal,)+ }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum $Name { $($(#[$variant_doc])* $Variant,)+ }

        impl $Name {
            /// The options' names, in the order of their flat form.
            pub const NAMES: &'static [&'static str] = &[$($name),+];
            const ALL: &'static [Self] = &[$(Self::$Variant),+];
        }

        impl Default for $Name {
            fn default() -> Self {
                Self::ALL[0]
            }
        }

        impl crate::params::value::Value for $Name {
            fn read(flat: &[f64]) -> Self {
                let index = flat.first().map_or(0, |number| *number as usize);
                Self::ALL.get(index).copied().unwrap_or_default()
            }
            fn write(&self, flat: &mut Vec<f64>) {
                flat.push(*self as u8 as f64);
            }
        }
    };
}
pub(crate) use choice;
