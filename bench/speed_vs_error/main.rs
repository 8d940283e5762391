//! Speed against error: methods of casting a ray at a cylinder, a sphere or another solid, on rays that
//! break some of them; and of evaluating a B-spline, on curves that break some.
//!
//! `cargo bench --package bench --bench speed_vs_error -- --help`

mod accuracy;
mod formulas;
mod methods;
mod plot;
mod rays;
mod report;
mod results;
mod solids;
mod spheres;
mod splines;
mod targets;
#[path = "../timing.rs"]
mod timing;

use clap::Parser;
use results::Results;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Measures time and error of several methods of casting a ray at a cylinder, on 37 sets of rays, at a
/// sphere, on 4, at five other solids, on 6 each, and of evaluating B-splines.
///
/// Prints tables and writes docs/speed_vs_error.svg, and in docs/measured speed_vs_error.md,
/// speed_vs_error.csv and speed_vs_error_splines.csv.
#[derive(Parser)]
#[command(
    name = "speed_vs_error",
    bin_name = "cargo bench --package bench --bench speed_vs_error --"
)]
struct Args {
    /// Fewer rays, shorter timing; the files go to the target directory instead of docs/
    #[arg(long)]
    quick: bool,

    /// So many rays a set, instead of 20,000, or of 2,000 if quick
    #[arg(long, value_name = "N")]
    rays: Option<usize>,

    /// Fail if a shipped method, f32 or I16F16, or a spline misses a target of accuracy; times are never judged
    #[arg(long)]
    check: bool,

    /// Passed by `cargo bench`, and not by `cargo test --all-targets`, which must be quick
    #[arg(long, hide = true)]
    bench: bool,
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let args = Args::parse();
    let checked = testkit::cylinder_table::check_oracle()?;
    println!("The oracle agrees with all {checked} reference rays.");
    let checked = solids::check_references()?;
    println!("References of cones and tori are exact on all {checked} rays that were checked.");

    let quick = args.quick || !args.bench;
    let (count, rounds) = if quick { (2000, 9) } else { (20_000, 51) };
    let count = args.rays.unwrap_or(count);
    let results = Results::measure(methods::methods(), rays::SETS, count, rounds);
    let spheres = Results::measure(spheres::methods(), spheres::SETS, count, rounds);
    let solids = solids::measure(count, rounds);
    println!("{count} rays a set; time as a multiple of the textbook f32 formula's.");
    print!("{}", report::table(&results));
    println!("\nSpheres; time as a multiple of the textbook formula's for spheres.");
    print!("{}", report::table(&spheres));
    println!("\nOther solids; time as a multiple of each one's textbook method's.");
    print!("{}", solids::table(&solids));

    let curves = if quick { 20 } else { 400 };
    let splines = splines::Results::measure(curves, rounds)?;
    println!(
        "\nAt least {} points of each kind of curves; time by enterpolation's.",
        splines.points
    );
    print!("{}", splines::table(&splines));

    let folder = if quick {
        PathBuf::from(env!("CARGO_TARGET_TMPDIR"))
    } else {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs")
    };
    let measured = folder.join("measured");
    fs::create_dir_all(&measured)?;
    let rows = report::csv(&[&results, &spheres]) + &solids::csv(&solids);
    fs::write(measured.join("speed_vs_error.csv"), rows)?;
    let markdown = [
        report::markdown(&results, &spheres),
        solids::markdown(&solids, count),
        splines::markdown(&splines),
    ];
    fs::write(measured.join("speed_vs_error.md"), markdown.concat())?;
    fs::write(measured.join("speed_vs_error_splines.csv"), splines::csv(&splines))?;
    plot::write(&results, &solids, &splines, &folder.join("speed_vs_error.svg"))?;

    let mut failed = false;
    for shipped in methods::SHIPPED {
        let shortfalls = [&results, &spheres].map(|part| shortfalls(part, shipped)).concat();
        println!("\nTargets missed by {}: {}", shipped.join(" "), shortfalls.len());
        shortfalls.iter().for_each(|shortfall| println!("  {shortfall}"));
        failed |= args.check && !shortfalls.is_empty();
    }
    let shortfalls: Vec<String> = solids.iter().flat_map(solids::shortfalls).collect();
    println!("\nTargets missed by other solids: {}", shortfalls.len());
    shortfalls.iter().for_each(|shortfall| println!("  {shortfall}"));
    failed |= args.check && !shortfalls.is_empty();
    let shortfalls = splines::shortfalls(&splines);
    println!("\nTargets missed by splines: {}", shortfalls.len());
    shortfalls.iter().for_each(|shortfall| println!("  {shortfall}"));
    failed |= args.check && !shortfalls.is_empty();
    Ok(if failed { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}

fn shortfalls(results: &Results, shipped: [&str; 2]) -> Vec<String> {
    let method = |row: &results::Row| &results.methods[row.method];
    let is_shipped = |row: &&results::Row| [method(row).name, method(row).number] == shipped;
    let rows = results.rows.iter().filter(is_shipped);
    rows.flat_map(|row| targets::shortfalls(row.set, method(row).inputs, &row.accuracy)).collect()
}
