//! The table for the terminal, and the files.

use crate::accuracy::Accuracy;
use crate::methods::Method;
use crate::rays::SETS;
use crate::results::{Results, Summary};
use crate::timing::Cost;
use std::fmt::Write;
use testkit::ulp::percentiles;

/// The command that makes the files.
pub const COMMAND: &str = "cargo bench --package bench --bench speed_vs_error";

/// A number in at most 7 characters.
pub fn short(x: f64) -> String {
    match x {
        _ if !x.is_finite() => x.to_string(),
        _ if x < 1000.0 => format!("{x:.1}"),
        _ => format!("{x:.1e}"),
    }
}

fn or_dash(x: Option<f64>) -> String {
    x.map_or_else(|| "-".into(), short)
}

/// Median, 99th percentile and maximum.
fn columns(errors: &[f64]) -> [String; 3] {
    percentiles(errors).map_or_else(|| ["-", "-", "-"].map(Into::into), |errors| errors.map(short))
}

/// The figures of a group, method by method, in 80 columns.
pub fn table(results: &Results) -> String {
    let mut text = String::new();
    for (i, method) in results.methods.iter().enumerate() {
        let rows = results.groups().map(|(group, name)| (name, results.summary(i, group)));
        text += &block(&method.label(), method.inputs.unit, rows);
    }
    text.push_str("\nOther: answers of NaN, panics, and valid rays not taken.\n");
    text
}

/// The figures of a method in 80 columns: a line for each kind of rays.
pub fn block(
    label: &str,
    unit: &str,
    rows: impl Iterator<Item = (&'static str, Summary)>,
) -> String {
    let mut text = String::new();
    let in_unit = [format!("t_in ({unit})"), format!("t_out ({unit})")];
    let _ = writeln!(text, "\n{label:28}{:>9}{:>21}{:>13}", in_unit[0], in_unit[1], "false");
    let _ = writeln!(
        text,
        "{:12}{:>6}{:>7}{:>7}{:>7}{:>7}{:>7}{:>7}{:>7}{:>7}{:>6}",
        "", "time", "p50", "p99", "max", "p50", "p99", "max", "hit", "miss", "other"
    );
    for (name, summary) in rows {
        let Accuracy { errors, false_hits, false_misses, .. } = &summary.accuracy;
        let _ = write!(text, "{name:12}{:>6}", or_dash(summary.ratio));
        for column in errors.iter().flat_map(|errors| columns(errors)) {
            let _ = write!(text, "{column:>7}");
        }
        let other = summary.accuracy.other();
        let _ = writeln!(text, "{false_hits:>7}{false_misses:>7}{other:>6}");
    }
    text
}

/// Every method on every set.
pub fn csv(parts: &[&Results]) -> String {
    let mut text = String::from(
        "set,method,number,unit,rays,judged,ns_per_ray,time_ratio,\
         t_in_p50,t_in_p99,t_in_max,t_out_p50,t_out_p99,t_out_max,\
         false_hits,false_misses,nans,panics,not_taken,point_off_surface_max,\
         t_in_p99_ulps,t_out_p99_ulps\n",
    );
    for (results, row) in parts.iter().flat_map(|part| part.rows.iter().map(move |row| (part, row)))
    {
        let Method { name, number, inputs, .. } = &results.methods[row.method];
        text += &csv_row([row.set.name, name, number, inputs.unit], &row.accuracy, row.cost);
    }
    text
}

/// A method on a set: their names, the number type and the unit come first.
pub fn csv_row(names: [&str; 4], accuracy: &Accuracy, cost: Option<Cost>) -> String {
    let Accuracy { errors, points, asked, judged, .. } = accuracy;
    let Accuracy { false_hits, false_misses, nans, panics, refused, .. } = accuracy;
    let cost = cost.map_or_else(
        || ",".to_string(),
        |cost| format!("{:.2},{:.3}", cost.nanoseconds, cost.ratio),
    );
    let mut text = format!("{},{asked},{judged},{cost}", names.join(","));
    for errors in errors {
        match percentiles(errors) {
            Some([p50, p99, max]) => _ = write!(text, ",{p50:.3e},{p99:.3e},{max:.3e}"),
            None => text.push_str(",,,"),
        }
    }
    let _ = write!(text, ",{false_hits},{false_misses},{nans},{panics},{refused},");
    if let Some([_, _, max]) = percentiles(points) {
        let _ = write!(text, "{max:.3e}");
    }
    for end in 0..2 {
        match percentiles(accuracy.in_ulps(end)) {
            Some([_, p99, _]) => _ = write!(text, ",{p99:.3e}"),
            None => text.push(','),
        }
    }
    text.push('\n');
    text
}

/// Method against method, group by group.
pub fn markdown(results: &Results, spheres: &Results) -> String {
    let mut text = format!(
        "# Speed against error\n\n\
         Made by `{COMMAND}`, which also writes `speed_vs_error.csv` (every set, more figures) and \
         the plot.\n\n\
         ![Time against error of each method](../speed_vs_error.svg)\n\n\
         {} rays in each of {} sets, against a cylinder with caps; in the sets named \"moved\" and \"past\", it \
         stands along any coordinate axis and away from the origin. Time is a multiple of the \
         textbook `f32` formula's in the same run, and differs from machine to machine; this one \
         has `f64` in hardware.\n\n\
         Errors are median / 99th percentile / largest. Floating point's are in **ulps**: units in \
         the last place of an `f32` at the exact parameter, those of `f64` methods too. Fixed \
         point's are in **LSB**: units of 2⁻¹⁶, which are as large everywhere. Near a parameter of \
         4, an LSB is 32 ulps; beyond 256 it is less than one. The last column has the 99th \
         percentile in ulps, of either end, for all methods.\n\n\
         Classes of floating-point methods are counted as wrong where they don't change when the \
         cylinder is 10⁻⁶ larger or smaller; classes of `I16F16` always, grazing or not. \"Other\" \
         is answers of NaN, panics, and valid rays not taken. `I16F16` is asked about the rays that \
         it can hold, rounded to its grid; \"rays\" says how many these are. The sections that begin \
         with \"sphere\" are about spheres, and times there are multiples of the textbook formula's \
         for spheres. Other solids follow below.\n",
        results.rays,
        SETS.len()
    );
    for (results, (group, name)) in
        [results, spheres].iter().flat_map(|part| part.groups().map(move |group| (part, group)))
    {
        let rows = results
            .methods
            .iter()
            .enumerate()
            .map(|(i, method)| (method.label(), method.inputs.unit, results.summary(i, group)));
        text += &section(name, rows);
    }
    text
}

/// Method against method on some rays.
pub fn section(name: &str, rows: impl Iterator<Item = (String, &'static str, Summary)>) -> String {
    let mut text = format!(
        "\n## {name}\n\n\
         | method | rays | time | t_in | t_out | unit | false hits | false misses | other | p99, ulps |\n\
         |---|---:|---:|---:|---:|---|---:|---:|---:|---:|\n"
    );
    for (label, unit, summary) in rows {
        let accuracy = &summary.accuracy;
        let Accuracy { errors, asked, false_hits, false_misses, .. } = accuracy;
        let [t_in, t_out] = [0, 1].map(|end| columns(&errors[end]).join(" / "));
        let other = accuracy.other();
        let _ = writeln!(
            text,
            "| {label} | {asked} | {} | {t_in} | {t_out} | {unit} | {false_hits} | {false_misses} | {other} | {} |",
            or_dash(summary.ratio),
            or_dash(accuracy.p99_ulps()),
        );
    }
    text
}
