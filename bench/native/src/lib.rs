//! What `npm run bench` times: the same loops natively (`main.rs`) and in wasm (the exports below).

mod case;
mod euler;
mod floor;
mod kernel;
mod tree;

use std::cell::RefCell;

pub use kernel::{Kernel, kernel};

thread_local! {
    static PRESENT: RefCell<Option<Kernel>> = const { RefCell::new(None) };
}

/// Makes a kernel ready, by its number in `bench/kernels.mjs`; returns how many segments one round works on, 0 if there is no such
/// kernel.
#[unsafe(no_mangle)]
pub extern "C" fn prepare(which: u32, size: u32) -> f64 {
    let made = kernel(which, size as usize);
    let segments = made.as_ref().map_or(0, |made| made.segments);
    PRESENT.set(made);
    segments as f64
}

/// Where the rod ends that the kernel has solved: 0 for x, 1 for y, in lengths of the rod; NaN where it solves none.
#[unsafe(no_mangle)]
pub extern "C" fn tip(coordinate: u32) -> f64 {
    PRESENT.with_borrow(|kernel| {
        let tip = kernel.as_ref().and_then(|kernel| kernel.tip.as_ref()).map(|tip| tip());
        tip.map_or(f64::NAN, |tip| tip[usize::from(coordinate == 1)])
    })
}

/// Runs the kernel that was prepared `rounds` times; returns the iterations of the last round.
#[unsafe(no_mangle)]
pub extern "C" fn run(rounds: u32) -> f64 {
    PRESENT.with_borrow_mut(|kernel| {
        let mut iterations = 0;
        if let Some(kernel) = kernel {
            for _ in 0..rounds {
                iterations = (kernel.round)();
            }
        }
        iterations as f64
    })
}
