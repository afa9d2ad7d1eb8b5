//! Runs the Rust in README and docs as doctests; holds no code of its own.

#[doc = include_str!("../../../README.md")]
pub mod readme {}

#[doc = include_str!("../../bough/README.md")]
pub mod crate_readme {}

#[doc = include_str!("../../../docs/how-it-computes.md")]
pub mod how_it_computes {}
