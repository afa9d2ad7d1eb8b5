//! Replays what the fuzzer found worth keeping: each line of `corpus/<target>.txt` is one input in hexadecimal. To add to
//! them, and for the long runs: `npm run soak -- --only fuzz`.

#![allow(clippy::unwrap_used, reason = "a test may stop")]

mod soundness;

/// Runs every kept input through its target.
fn replay(target: fn(&[u8]), corpus: &str) {
    let inputs: Vec<Vec<u8>> = corpus.lines().map(soundness::unhexed).collect();
    assert!(inputs.len() >= 20, "a corpus of {}", inputs.len());
    for input in &inputs {
        target(input);
    }
}

macro_rules! replays {
    ($($target:ident)+) => {
        $(
            #[test]
            fn $target() {
                replay(soundness::$target, include_str!(concat!("corpus/", stringify!($target), ".txt")));
            }
        )+
    };
}

replays! { bytes values extremes forks ages mirror grips space }
