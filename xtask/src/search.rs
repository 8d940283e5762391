//! Random tests with other cases than `cargo test` draws, until time is over.

use crate::command::done;
use crate::paths::root;
use std::hash::{BuildHasher, Hasher, RandomState};
use std::process::Command;
use std::time::{Duration, Instant};

/// What has random tests.
const SUITES: [&str; 9] = [
    "--lib",
    "--test conformance",
    "--test exact",
    "--test fixed",
    "--test heavy",
    "--test link",
    "--test programs",
    "--test solids",
    "--test splines",
];

#[derive(Debug, clap::Args)]
pub struct Search {
    /// Only tests with one of these in their names [default: all]
    filter: Vec<String>,

    /// How long to search; what was begun is finished
    #[arg(long, default_value_t = 10)]
    minutes: u64,

    /// One round with this seed, as a finding names it
    #[arg(long)]
    seed: Option<u32>,
}

/// Runs the random tests, each round with a seed of its own. Findings are told when they are made, and
/// are an error at the end.
pub fn run(chosen: &Search) -> Result<(), String> {
    for suite in SUITES {
        println!("{suite}: building");
        done(tests(suite).arg("--no-run"))?;
    }
    let start = Instant::now();
    let is_over = || start.elapsed() >= Duration::from_secs(60 * chosen.minutes);
    let (mut rounds, mut findings) = (0, Vec::new());
    loop {
        let seed = chosen.seed.unwrap_or_else(fresh);
        for suite in SUITES {
            let found = round(suite, &chosen.filter, seed)?;
            findings.extend(found.into_iter().map(|name| format!("--seed {seed} {name}")));
            if chosen.seed.is_none() && is_over() {
                break;
            }
        }
        rounds += 1;
        println!("{rounds} rounds, {} findings, seed {seed}", findings.len());
        if chosen.seed.is_some() || is_over() {
            break;
        }
    }
    if findings.is_empty() {
        return Ok(());
    }
    let again: Vec<_> = findings.iter().map(|it| format!("cargo xtask search {it}")).collect();
    Err(format!("found:\n       {}", again.join("\n       ")))
}

/// A seed that was never tried.
fn fresh() -> u32 {
    RandomState::new().build_hasher().finish() as u32
}

/// The tests of a suite.
fn tests(suite: &str) -> Command {
    let mut command = Command::new("cargo");
    command.args([
        "test",
        "--quiet",
        "--package",
        "scancsg",
        "--package",
        "suites",
        "--package",
        "heavy",
    ]);
    command.args(suite.split(' ')).current_dir(root());
    command
}

/// The names of the tests that fail.
fn round(suite: &str, filter: &[String], seed: u32) -> Result<Vec<String>, String> {
    let mut command = tests(suite);
    command.args(["--", "--format", "pretty"]).args(filter);
    for variable in ["PROPTEST_RNG_SEED", "SCANCSG_SEED"] {
        command.env(variable, seed.to_string());
    }
    let output = command.output().map_err(|error| format!("{command:?}: {error}"))?;
    if output.status.success() {
        return Ok(Vec::new());
    }
    let said = String::from_utf8_lossy(&output.stdout);
    println!("{suite}, seed {seed}: {said}");
    let found = failures(&said);
    if found.is_empty() {
        return Err(format!("{command:?}: {}", String::from_utf8_lossy(&output.stderr)));
    }
    Ok(found)
}

/// The names of failed tests in what a test program prints.
fn failures(said: &str) -> Vec<String> {
    let of_line = |line: &str| {
        let name = line.strip_prefix("test ")?.strip_suffix(" ... FAILED")?;
        Some(name.to_owned())
    };
    said.lines().filter_map(of_line).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn failures_are_named() {
        let said = "running 2 tests\ntest a::b ... ok\ntest a::c ... FAILED\n\nfailures:\n";
        assert_eq!(failures(said), ["a::c"]);
    }

    #[test]
    fn suites_are_there() {
        let tests = root().join("tests");
        for name in SUITES.iter().filter_map(|suite| suite.strip_prefix("--test ")) {
            let places =
                [format!("{name}/main.rs"), format!("{name}/{name}.rs"), format!("{name}.rs")];
            assert!(places.iter().any(|place| tests.join(place).exists()), "{name}");
        }
    }
}
