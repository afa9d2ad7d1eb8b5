//! Grows a plant for every line of params: JSON lines in, JSON lines or CSV out, in the same order. A bad line is a line of the
//! output like any other, and all others are done.

mod format;
mod input;
mod params;
mod text;

use std::fs::File;
use std::io::{self, BufRead, BufReader, BufWriter, Read, Write};
use std::process::ExitCode;

use bough::plant::{Plant, measures};

use crate::format::Format;
use crate::input::Line;
use crate::params::Problem;

const USAGE: &str = "\
bough-sweep: grows a plant for every line of params, and writes a line of measures for each.

    bough-sweep [--csv] [--first NUMBER] [FILE]

FILE has one JSON object of params a line; without it, standard input is read. `{}` is the default plant. The output has a JSON
object a line, or CSV with a header. Lines are numbered from 1, or from
NUMBER where FILE is a piece of a larger one; lines with nothing in them are left out. A line that no plant can
be grown from has an error instead of measures. Everything else about the params is in the docs.

Exit status: 0 all lines are plants, 1 some are not (they are listed on standard error), 2 the sweep could not be run.
";

/// Most bad lines that are listed one by one at the end.
const MOST_LISTED: usize = 20;

fn main() -> ExitCode {
    match run(std::env::args().skip(1).collect()) {
        Ok(status) => status,
        Err(error) => {
            eprintln!("bough-sweep: {error}");
            ExitCode::from(2)
        }
    }
}

fn run(arguments: Vec<String>) -> io::Result<ExitCode> {
    let mut format = Format::Json;
    let mut first = 1;
    let mut file = None;
    let mut arguments = arguments.into_iter();
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--csv" => format = Format::Csv,
            "--first" => {
                let number = arguments.next().and_then(|number| number.parse().ok());
                first = number.ok_or_else(|| io::Error::other("--first takes the number of a line"))?;
            }
            "--help" | "-h" => {
                print!("{USAGE}");
                return Ok(ExitCode::SUCCESS);
            }
            option if option.starts_with('-') && option != "-" => {
                return Err(io::Error::other(format!("there is no option {option}\n\n{USAGE}")));
            }
            _ if file.is_some() => return Err(io::Error::other("it takes one file")),
            _ => file = Some(argument),
        }
    }
    let input: Box<dyn Read> = match file.as_deref() {
        None | Some("-") => Box::new(io::stdin().lock()),
        Some(path) => {
            Box::new(File::open(path).map_err(|error| io::Error::other(format!("{path}: {error}")))?)
        }
    };
    let mut output = BufWriter::new(io::stdout().lock());
    let bad = sweep(&mut BufReader::new(input), &mut output, format, first)?;
    output.flush()?;
    Ok(if bad == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Writes a line for every line, and returns how many were bad.
fn sweep(input: &mut impl BufRead, output: &mut impl Write, format: Format, first: u64) -> io::Result<usize> {
    format.begin(output)?;
    let (mut plants, mut bad) = (0, 0);
    for number in first.. {
        let Some(line) = input::next(input)? else { break };
        if line.is_blank() {
            continue;
        }
        match grown(&line) {
            Ok(plant) => {
                plants += 1;
                format.plant(output, number, plant.report.status.name(), &measures(&plant))?;
            }
            Err(problem) => {
                bad += 1;
                if bad <= MOST_LISTED {
                    eprintln!("line {number}: {}", problem.message);
                }
                format.problem(output, number, &problem)?;
            }
        }
    }
    if bad > 0 {
        let more = bad.saturating_sub(MOST_LISTED);
        let rest = if more > 0 { format!(" {more} more are in the output only.") } else { String::new() };
        eprintln!("{bad} of {} lines are bad.{rest}", bad + plants);
    }
    Ok(bad)
}

fn grown(line: &Line) -> Result<Plant, Problem> {
    let params = params::read(&line.json()?)?;
    bough::grow(&params).map_err(Problem::from)
}
