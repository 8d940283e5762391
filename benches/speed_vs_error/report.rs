//! The table for the terminal, and the files.

use crate::accuracy::{Accuracy, percentiles};
use crate::rays::{Group, SETS};
use crate::results::Results;
use std::fmt::Write;

/// The command that makes the files.
pub const COMMAND: &str = "cargo bench --bench speed_vs_error";

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

/// The figures of a group, method by method, in 94 columns.
pub fn table(results: &Results) -> String {
    let mut text = String::new();
    for (i, method) in results.methods.iter().enumerate() {
        let unit = method.inputs.unit;
        let in_unit = [format!("t_in ({unit})"), format!("t_out ({unit})")];
        let _ = writeln!(
            text,
            "\n{:20}{:>12}{:>24}{:>12}{:>18}",
            method.label(),
            in_unit[0],
            in_unit[1],
            "false",
            "not"
        );
        let _ = writeln!(
            text,
            "{:10}{:>6}{:>8}{:>8}{:>8}{:>8}{:>8}{:>8}{:>6}{:>6}{:>6}{:>6}{:>6}",
            "",
            "time",
            "p50",
            "p99",
            "max",
            "p50",
            "p99",
            "max",
            "hit",
            "miss",
            "NaN",
            "panic",
            "taken"
        );
        for (group, name) in Group::ALL {
            let summary = results.summary(i, group);
            let Accuracy { errors, false_hits, false_misses, nans, panics, refused, .. } =
                &summary.accuracy;
            let _ = write!(text, "{name:10}{:>6}", or_dash(summary.ratio));
            for column in errors.iter().flat_map(|errors| columns(errors)) {
                let _ = write!(text, "{column:>8}");
            }
            let _ =
                writeln!(text, "{false_hits:>6}{false_misses:>6}{nans:>6}{panics:>6}{refused:>6}");
        }
    }
    text
}

/// Every method on every set.
pub fn csv(results: &Results) -> String {
    let mut text = String::from(
        "set,method,number,unit,rays,robust,ns_per_ray,time_ratio,\
         t_in_p50,t_in_p99,t_in_max,t_out_p50,t_out_p99,t_out_max,\
         false_hits,false_misses,nans,panics,not_taken,point_off_surface_max\n",
    );
    for row in &results.rows {
        let method = &results.methods[row.method];
        let Accuracy { errors, points, robust, false_hits, false_misses, nans, panics, refused } =
            &row.accuracy;
        let cost = row.cost.map_or_else(
            || ",".to_string(),
            |cost| format!("{:.2},{:.3}", cost.nanoseconds, cost.ratio),
        );
        let _ = write!(
            text,
            "{},{},{},{},{},{robust},{cost}",
            row.set.name, method.name, method.number, method.inputs.unit, results.rays
        );
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
        text.push('\n');
    }
    text
}

/// Method against method, group by group.
pub fn markdown(results: &Results) -> String {
    let mut text = format!(
        "# Speed against error\n\n\
         Made by `{COMMAND}`, which also writes `speed_vs_error.csv` (every set, more figures) and \
         the plot.\n\n\
         ![Time against error of each method](speed_vs_error.svg)\n\n\
         {} rays in each of {} sets, against a cylinder with caps. Time is a multiple of the \
         textbook `f32` formula's in the same run, and differs from machine to machine; this one has `f64` in \
         hardware. Errors are \
         in units in the last place of an `f32` at the exact parameter (median / 99th percentile / \
         largest), those of `f64` methods too. Classes are counted as wrong where they don't change when the cylinder is 10⁻⁶ \
         larger or smaller. \"Other\" is answers of NaN, panics, and valid rays not taken.\n",
        results.rays,
        SETS.len()
    );
    for (group, name) in Group::ALL {
        let _ = write!(
            text,
            "\n## {name}\n\n\
             | method | time | t_in | t_out | false hits | false misses | other |\n\
             |---|---:|---:|---:|---:|---:|---:|\n"
        );
        for (i, method) in results.methods.iter().enumerate() {
            let summary = results.summary(i, group);
            let Accuracy { errors, false_hits, false_misses, nans, panics, refused, .. } =
                &summary.accuracy;
            let [t_in, t_out] = [0, 1].map(|end| columns(&errors[end]).join(" / "));
            let other = nans + panics + refused;
            let _ = writeln!(
                text,
                "| {} | {} | {t_in} | {t_out} | {false_hits} | {false_misses} | {other} |",
                method.label(),
                or_dash(summary.ratio),
            );
        }
    }
    text
}
