#![no_main]

#[path = "../../bough/tests/soundness/mod.rs"]
mod soundness;

libfuzzer_sys::fuzz_target!(|data: &[u8]| soundness::space(data));
