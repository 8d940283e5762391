//! The gate: what must hold before a change lands, in steps. The first ones are done alone, and the rest in two
//! lanes beside each other.

mod lanes;
mod tools;

use crate::board::{Board, Number};
use crate::boards::{self, Boards};
use crate::command::done;
use crate::paths::root;
use crate::{c, device, faults, hals, layers, log, pico, python, template, web};
use std::env;
use std::fs;
use std::process::Command;
use std::time::Instant;
use tools::Purpose;

#[derive(Debug, clap::Args)]
pub struct Ci {
    /// Only these steps, one after the other [default: all, most of them in two lanes]
    step: Vec<String>,

    /// Name the steps, and do none
    #[arg(long)]
    list: bool,
}

struct Step {
    name: &'static str,
    what: &'static str,
    run: fn() -> Result<(), String>,
}

/// Alone, one after the other: quick ones first, and what the lanes need.
const ALONE: &[Step] = &[
    Step { name: "format", what: "every file is formatted", run: format },
    Step { name: "layers", what: "files import downwards, and in no circle", run: layers },
    Step { name: "lints", what: "clippy, on all members and all features", run: lints },
    Step { name: "test", what: "README's test command", run: test },
    Step {
        name: "features",
        what: "what features add: other crates' types, the asynchronous link",
        run: features,
    },
    Step { name: "members", what: "tests of the test kit and of the chores", run: members },
    Step {
        name: "tools",
        what: "Debian's packages for the rest are installed",
        run: tools::ensure_all,
    },
];

/// A lane: steps that build for this computer, in `target` itself, and at the end some that build firmware, under
/// names that the other lane builds nothing else under.
const HOST: &[Step] = &[
    Step { name: "docs", what: "documentation without a warning", run: docs },
    Step { name: "accuracy", what: "every target, against exact arithmetic", run: accuracy },
    Step {
        name: "stream",
        what: "README's main command, and the picture that it writes",
        run: stream,
    },
    Step { name: "package", what: "a dependent gets the crate, and nothing else", run: package },
    Step { name: "scad", what: "OpenSCAD's parts have its volumes and outlines", run: scad },
    Step {
        name: "python",
        what: "the Python package receives what was sent",
        run: package_of_python,
    },
    Step { name: "web", what: "the page in a browser has the host's bits", run: page },
    Step { name: "c", what: "programs in C have the host's rows, also on two boards", run: in_c },
    Step { name: "device", what: "parts sent to firmware, and its pictures of them", run: parts },
    Step { name: "template", what: "a firmware of one's own has the host's rows", run: template },
    Step { name: "pico", what: "a Pico in another emulator has the host's picture", run: pico },
];

/// A lane: steps that build firmware, in folders of `target/boards`. `boards`, `log` and `faults` must be in one lane:
/// they build the example `stream` with different features, each over the one before.
const FIRMWARE: &[Step] = &[
    Step { name: "hals", what: "firmware of boards that people own builds", run: all_hals },
    Step {
        name: "boards",
        what: "firmware on five boards: pictures, sizes, instructions",
        run: all_boards,
    },
    Step { name: "log", what: "firmware's log", run: logs },
    Step { name: "faults", what: "firmware on a line with faults", run: with_faults },
];

fn steps() -> impl Iterator<Item = &'static Step> {
    [ALONE, HOST, FIRMWARE].into_iter().flatten()
}

/// Does all steps, or those that were chosen in their order, up to the first that fails.
pub fn run(chosen: &Ci) -> Result<(), String> {
    if chosen.list {
        steps().for_each(|step| println!("{:10}{}", step.name, step.what));
        return Ok(());
    }
    let find = |name: &String| {
        steps()
            .find(|step| step.name == name)
            .ok_or_else(|| format!("there is no step `{name}`; `cargo xtask ci --list` names them"))
    };
    let start = Instant::now();
    if chosen.step.is_empty() {
        all()?;
    } else {
        let steps: Vec<&Step> = chosen.step.iter().map(find).collect::<Result<_, _>>()?;
        steps.into_iter().try_for_each(do_one)?;
    }
    if chosen.step.len() != 1 {
        println!("\n=== all in {:.0} s", start.elapsed().as_secs_f32());
    }
    Ok(())
}

fn all() -> Result<(), String> {
    // Its path, before a step builds it anew.
    let program = env::current_exe().map_err(|error| error.to_string())?;
    ALONE.iter().try_for_each(do_one)?;
    lanes::run(&[HOST, FIRMWARE], |step| lanes::apart(&program, step))
}

fn do_one(step: &Step) -> Result<(), String> {
    println!("\n=== {}: {}", step.name, step.what);
    let begin = Instant::now();
    (step.run)().map_err(|problem| format!("step `{}` failed: {problem}", step.name))?;
    println!("=== {}: {:.0} s", step.name, begin.elapsed().as_secs_f32());
    Ok(())
}

/// A command of words.
fn command(words: &str) -> Command {
    let mut words = words.split_whitespace();
    let mut command = Command::new(words.next().unwrap_or_default());
    command.args(words).current_dir(root()).env("CARGO_TERM_COLOR", "never");
    command
}

fn output(command: &mut Command) -> Result<String, String> {
    let output = command.output().map_err(|error| format!("{command:?}: {error}"))?;
    if output.status.success() {
        Ok(String::from_utf8_lossy(&output.stdout).into_owned())
    } else {
        Err(format!("{command:?}: {}", String::from_utf8_lossy(&output.stderr)))
    }
}

/// README's own words are what is tested, so that they stay true.
fn readme_command(start: &str) -> Result<Command, String> {
    let readme = fs::read_to_string(root().join("README.md")).map_err(|error| error.to_string())?;
    let line = readme.lines().find(|line| line.starts_with(start));
    let line = line.ok_or_else(|| format!("README.md has no command `{start}`"))?;
    let words = line.split('#').next().unwrap_or_default().trim();
    println!("{words}");
    Ok(command(words))
}

fn format() -> Result<(), String> {
    done(&mut command("cargo fmt --all --check"))
}

fn layers() -> Result<(), String> {
    let problems = layers::problems(&root().join("src"))?;
    if problems.is_empty() { Ok(()) } else { Err(problems.join("\n       ")) }
}

fn lints() -> Result<(), String> {
    done(&mut command("cargo clippy --workspace --all-targets --all-features -- -D warnings"))
}

fn test() -> Result<(), String> {
    done(&mut readme_command("cargo test")?)
}

/// What README's test command leaves out, which has no features.
fn features() -> Result<(), String> {
    done(&mut command(
        "cargo test --package suites --all-features --test embedded_graphics --test serde --test stream_async",
    ))?;
    done(&mut command("cargo test --package scancsg --all-features --doc -- interop cookbook"))
}

fn members() -> Result<(), String> {
    done(&mut command("cargo test --package testkit --package xtask --package display"))
}

fn docs() -> Result<(), String> {
    let mut command =
        command("cargo doc --no-deps --all-features --package scancsg --package testkit");
    done(command.env("RUSTDOCFLAGS", "-D warnings"))
}

fn accuracy() -> Result<(), String> {
    done(&mut command("cargo bench --package bench --bench speed_vs_error -- --quick --check"))
}

fn stream() -> Result<(), String> {
    let picture = root().join("tee.png");
    match fs::remove_file(&picture) {
        Err(error) if picture.exists() => return Err(format!("{}: {error}", picture.display())),
        _ => {}
    }
    done(&mut readme_command("cargo run --release --example stream")?)?;
    let mut test = command("cargo test --package examples --test written_png -- --ignored");
    done(test.env("SCANCSG_PNG", &picture))
}

fn package() -> Result<(), String> {
    let list = "cargo package --package scancsg --locked --allow-dirty --no-verify --list";
    let list = output(&mut command(list))?;
    let strange: Vec<&str> = list.lines().filter(|path| !is_packaged(path)).collect();
    let count = list.lines().count();
    println!("{count} files");
    match strange[..] {
        [] if count > 0 => Ok(()),
        _ => Err(format!("the package holds more than the crate: {}", strange.join(", "))),
    }
}

/// Whether a file belongs to what a dependent gets.
fn is_packaged(path: &str) -> bool {
    let page = path.strip_prefix("docs/").filter(|name| !name.contains('/'));
    let ends = [".md", ".png", ".svg"];
    path.starts_with("src/")
        || page.is_some_and(|name| ends.iter().any(|end| name.ends_with(end)))
        || ["README.md", "CHANGELOG.md", ".cargo_vcs_info.json"].contains(&path)
        || path.starts_with("LICENSE-")
        || path.starts_with("Cargo.")
}

fn scad() -> Result<(), String> {
    tools::ensure(&[Purpose::Scad])?;
    done(&mut command("cargo test --package scancsg-scad -- --include-ignored"))
}

fn package_of_python() -> Result<(), String> {
    tools::ensure(&[Purpose::Python])?;
    python::check()
}

fn pico() -> Result<(), String> {
    tools::ensure(&[Purpose::Boards, Purpose::Node])?;
    pico::check()
}

fn all_hals() -> Result<(), String> {
    tools::ensure(&[Purpose::Boards])?;
    hals::check()
}

fn template() -> Result<(), String> {
    tools::ensure(&[Purpose::Boards])?;
    template::check()
}

fn page() -> Result<(), String> {
    tools::ensure(&[Purpose::Browser])?;
    web::run(&web::Web { test: true })
}

fn in_c() -> Result<(), String> {
    tools::ensure(&[Purpose::Boards, Purpose::C])?;
    c::check()
}

fn all_boards() -> Result<(), String> {
    tools::ensure(&[Purpose::Boards])?;
    boards::measure(&Boards::default())
}

fn parts() -> Result<(), String> {
    tools::ensure(&[Purpose::Boards])?;
    device::check(&device::SHORT)
}

fn logs() -> Result<(), String> {
    tools::ensure(&[Purpose::Boards])?;
    Board::SHORT.iter().try_for_each(|board| log::check(*board, Number::I16f16))
}

fn with_faults() -> Result<(), String> {
    tools::ensure(&[Purpose::Boards])?;
    faults::check(&Board::SHORT, Number::I16f16)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_package_is_the_crate() {
        let held =
            ["src/solid/mod.rs", "docs/tee.png", "README.md", "LICENSE-MIT", "Cargo.toml.orig"];
        assert!(held.iter().all(|path| is_packaged(path)));
        let kept = [
            "docs/measured/speed_vs_error.csv",
            "docs/measured/boards.md",
            "tests/golden.rs",
            "memory.x",
            ".ci/run",
        ];
        assert!(!kept.iter().any(|path| is_packaged(path)));
    }

    #[test]
    fn readme_has_the_commands() {
        for start in ["cargo test", "cargo run --release --example stream"] {
            assert_eq!(
                readme_command(start).map(|command| format!("{command:?}").len() > 9),
                Ok(true)
            );
        }
    }

    #[test]
    fn steps_have_different_names() {
        let mut names: Vec<&str> = steps().map(|step| step.name).collect();
        names.sort_unstable();
        assert!(names.windows(2).all(|pair| pair[0] != pair[1]));
    }

    #[test]
    fn a_step_that_is_not_there_is_an_error() {
        let chosen = Ci { step: vec!["nothing".to_owned()], list: false };
        assert!(run(&chosen).is_err_and(|problem| problem.contains("nothing")));
    }
}
