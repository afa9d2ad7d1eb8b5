//! Replays what the fuzzer found worth keeping: each line of `corpus/<target>.txt` is one input in hexadecimal. To add to
//! them, and for the long runs: `npm run soak -- --only fuzz`.

#![allow(clippy::unwrap_used, reason = "a test may stop")]

mod soundness;

/// Runs every kept input through its target.
fn replay(target: fn(&[u8]), corpus: &str) {
    let inputs: Vec<Vec<u8>> = corpus.lines().map(unhexed).collect();
    assert!(inputs.len() >= 20, "a corpus of {}", inputs.len());
    for input in &inputs {
        target(input);
    }
}

fn unhexed(line: &str) -> Vec<u8> {
    let digits: Vec<u32> = line.chars().map(|digit| digit.to_digit(16).unwrap()).collect();
    digits.chunks(2).map(|two| (16 * two[0] + two[1]) as u8).collect()
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
