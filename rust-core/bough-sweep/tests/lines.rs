//! The binary as a shell has it: lines in, lines out, an exit status.

// In a test, to fail is to panic.
#![allow(clippy::unwrap_used)]

use std::io::Write;
use std::process::{Command, Output, Stdio};

use bough::grow;
use bough::params::Params;
use bough::plant::{MEASURES, measures};
use serde_json::Value;

fn sweep(arguments: &[&str], input: &[u8]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_bough-sweep"));
    let pipes = command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = pipes.spawn().unwrap();
    let mut stdin = child.stdin.take().unwrap();
    std::thread::scope(|scope| {
        // It may close its end before all is written.
        scope.spawn(move || drop(stdin.write_all(input)));
        child.wait_with_output().unwrap()
    })
}

fn rows(output: &Output) -> Vec<Value> {
    let text = std::str::from_utf8(&output.stdout).unwrap();
    text.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

fn errors(output: &Output) -> Vec<(u64, String)> {
    let of = |row: &Value| Some((row["line"].as_u64()?, row["error"].as_str()?.to_owned()));
    rows(output).iter().filter_map(of).collect()
}

/// The error of one line.
fn error(line: &str) -> String {
    let output = sweep(&[], format!("{line}\n").as_bytes());
    assert_eq!(output.status.code(), Some(1), "{line}");
    errors(&output).pop().unwrap().1
}

#[test]
fn a_line_is_the_plant_of_its_params_to_the_last_bit() {
    let input = "{}\n{\"axis\": {\"segments\": 7, \"elevation\": 33.3}, \"loads\": {\"tipForce\": [0.1, -0.2, 0], \
                 \"forces\": [{\"segment\": 3, \"force\": [0, 0.7, 0]}], \"removed\": false}, \
                 \"growth\": {\"thickening\": \"pipes\"}}";
    let output = sweep(&[], input.as_bytes());
    assert_eq!(output.status.code(), Some(0));
    assert!(output.stderr.is_empty());
    let mut params = Params::default();
    params.axis.segments = 7;
    params.axis.elevation.0 = 33.3;
    params.loads.tip_force = [0.1, -0.2, 0.0];
    params.loads.forces = vec![bough::params::PointForce { segment: 3, force: [0.0, 0.7, 0.0] }];
    params.growth.thickening = bough::params::Thickening::Pipes;
    let rows = rows(&output);
    assert_eq!(rows.len(), 2);
    for (row, params) in rows.iter().zip([Params::default(), params]) {
        assert_eq!(row["status"], "converged");
        for (measure, value) in MEASURES.iter().zip(measures(&grow(&params).unwrap())) {
            assert_eq!(row[measure.name].as_f64(), Some(value), "{}", measure.name);
        }
    }
}

#[test]
fn one_bad_row_of_ten_thousand_is_listed_and_all_others_are_done() {
    let line = |number: usize| match number {
        1234 => "this is no JSON".to_owned(),
        7000 => "{\"axis\": {\"segments\": 3, \"radius\": -1}}".to_owned(),
        10_000 => "{\"axis\": {\"segm".to_owned(),
        _ => format!("{{\"axis\": {{\"segments\": 3}}, \"loads\": {{\"gravity\": {}}}}}\n", number % 10),
    };
    let input: String = (1..=10_000)
        .map(line)
        .map(|text| if text.ends_with('\n') || text.ends_with("segm") { text } else { text + "\n" })
        .collect();
    let output = sweep(&[], input.as_bytes());
    assert_eq!(output.status.code(), Some(1));
    let expected = [
        (1234, "The line is not JSON: expected ident at byte 2."),
        (7000, "axis.radius must be a number from 1e-7 to 100 m; it is -1."),
        (10_000, "The input ends in the middle of the line."),
    ];
    assert_eq!(errors(&output), expected.map(|(line, text)| (line, text.to_owned())));
    let rows = rows(&output);
    assert_eq!(rows.len(), 10_000);
    for (index, row) in rows.iter().enumerate() {
        assert_eq!(row["line"], index + 1);
        assert!(row["status"] == "converged" || row["error"].is_string());
    }
    let told = String::from_utf8(output.stderr).unwrap();
    assert!(told.contains("line 7000: axis.radius must be"), "{told}");
    assert!(told.ends_with("3 of 10000 lines are bad.\n"), "{told}");
}

#[test]
fn what_is_wrong_is_said_in_the_words_of_the_package() {
    for (line, expected) in [
        ("{\"axis\": {\"segm", "The line is only the beginning of JSON."),
        ("5", "params must be an object with named values; it is 5."),
        ("[]", "params must be an object with named values; it is a list of 0."),
        ("{\"axis\": null}", "axis must be an object with named values; it is null."),
        (
            "{\"axis\": {\"segments\": \"40\"}}",
            "axis.segments must be a whole number from 1 to 100000; it is the text \"40\".",
        ),
        (
            "{\"axis\": {\"segments\": 1.5}}",
            "axis.segments must be a whole number from 1 to 100000; it is 1.5.",
        ),
        ("{\"loads\": {\"removed\": 1}}", "loads.removed must be true or false; it is 1."),
        (
            "{\"growth\": {\"thickening\": \"{}\"}}",
            "growth.thickening must be one of none, pipes; it is the text \"{ }\".",
        ),
        (
            "{\"loads\": {\"forces\": [{\"segment\": 1}]}}",
            "loads.forces must be a list of {segment, force: [x, y, z]}; it is a list of 1.",
        ),
        ("{\"loads\": {\"graviti\": 3}}", "loads.graviti is not a parameter; loads may hold "),
        (
            "{\"gravity\": 3}",
            "gravity is not a parameter; params have groups, as {\"loads\": {\"gravity\": 3}}.",
        ),
    ] {
        assert!(error(line).starts_with(expected), "{line}: {}", error(line));
    }
    let both = error("{\"axis\": {\"radios\": 1, \"radius\": -1, \"segments\": true}}");
    let (wrong, stray) = (both.find("axis.segments must be"), both.find("axis.radios is not"));
    assert!(both.contains("axis.radius must be") && wrong < stray && wrong.is_some(), "{both}");
}

#[test]
fn anything_at_all_may_stand_in_a_line() {
    let deep = "[".repeat(100_000);
    let long = format!("\"{}\"", "x".repeat(1_000_000));
    for bytes in
        [b"\xff\xfe{}".as_slice(), b"\0", b"{}{}", b"{\"a\":1e999}", deep.as_bytes(), long.as_bytes()]
    {
        let mut input = b"{}\n".to_vec();
        input.extend(bytes);
        input.extend(b"\n{}\n");
        let output = sweep(&[], &input);
        assert_eq!(output.status.code(), Some(1));
        assert_eq!(errors(&output).len(), 1);
        assert_eq!(rows(&output).len(), 3);
    }
}

#[test]
fn blank_lines_carriage_returns_and_a_byte_order_mark_do_no_harm() {
    let output = sweep(&[], b"\xef\xbb\xbf{}\r\n\r\n  \n{\"tropism\": {\"azimuth\": null}}");
    assert_eq!(output.status.code(), Some(0));
    let lines: Vec<_> = rows(&output).iter().map(|row| row["line"].clone()).collect();
    assert_eq!(lines, [1, 4]);
    assert_eq!(sweep(&[], b"").status.code(), Some(0));
}

#[test]
fn a_piece_of_a_larger_file_keeps_its_numbers() {
    let lines: Vec<_> =
        rows(&sweep(&["--first", "7001"], b"{}\n{}")).iter().map(|row| row["line"].clone()).collect();
    assert_eq!(lines, [7001, 7002]);
}

#[test]
fn csv_has_a_header_a_row_a_line_and_errors_in_their_own_column() {
    let output = sweep(&["--csv"], b"{\"axis\": {\"segments\": 3}}\n{\"axis\": 1}\n\"a\"\n");
    assert_eq!(output.status.code(), Some(1));
    let text = String::from_utf8(output.stdout).unwrap();
    let lines: Vec<_> = text.lines().collect();
    assert_eq!(lines.len(), 4);
    assert!(lines[0].starts_with("line,status,tipX,") && lines[0].ends_with(",error"));
    let columns = lines[0].split(',').count();
    assert_eq!(lines[1].split(',').count(), columns);
    assert!(lines[1].starts_with("1,converged,0.0"), "{}", lines[1]);
    let empty = ",".repeat(columns - 1);
    assert_eq!(lines[2], format!("2{empty}\"axis must be an object with named values; it is 1.\""));
    assert_eq!(
        lines[3],
        format!("3{empty}\"params must be an object with named values; it is the text \"\"a\"\".\"")
    );
}

#[test]
fn a_sweep_that_cannot_be_run_says_so_with_another_status() {
    for arguments in [&["--xml"][..], &["--first", "x"], &["no/such/file"], &["a", "b"]] {
        let output = sweep(arguments, b"");
        assert_eq!(output.status.code(), Some(2));
        assert!(output.stdout.is_empty());
        assert!(!output.stderr.is_empty());
    }
    assert_eq!(sweep(&["--help"], b"").status.code(), Some(0));
}
