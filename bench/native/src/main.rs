//! Answers line by line: `prepare <kernel> <size>` with the number of segments, `run <rounds>` with seconds and iterations, `tip` with
//! x and y.

use std::io::{BufRead, stdin};
use std::time::Instant;

use kernels::{prepare, run, tip};

fn main() {
    for line in stdin().lock().lines().map_while(Result::ok) {
        let words: Vec<&str> = line.split(' ').collect();
        let number = |at: usize| words.get(at).and_then(|word| word.parse::<u32>().ok()).unwrap_or(0);
        match words[0] {
            "prepare" => println!("{}", prepare(number(1), number(2))),
            "tip" => println!("{} {}", tip(0), tip(1)),
            _ => {
                let start = Instant::now();
                let iterations = run(number(1));
                println!("{} {iterations}", start.elapsed().as_secs_f64());
            }
        }
    }
}
