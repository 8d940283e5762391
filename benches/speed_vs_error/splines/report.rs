//! The tables of splines, and what falls short of a target.

use super::methods::METHODS;
use super::{Results, Row};
use crate::accuracy::percentiles;
use crate::report::short;
use std::fmt::Write;

/// Curves of the orders that are measured.
fn curves(order: usize) -> &'static str {
    if order == 3 { "quadratics" } else { "cubics" }
}

/// Median, 99th percentile and maximum.
fn figures(errors: &[f64]) -> [String; 3] {
    let figure = |x: f64| format!("{x:.2}");
    percentiles(errors).map_or_else(|| ["-", "-", "-"].map(Into::into), |errors| errors.map(figure))
}

/// The rows that have anything to say, set by set.
fn asked(results: &Results) -> impl Iterator<Item = &[Row]> {
    results.rows.chunks(METHODS.len())
}

fn ratio(row: &Row) -> String {
    row.cost.map_or_else(|| "-".into(), |cost| short(cost.ratio))
}

pub fn table(results: &Results) -> String {
    let mut text = String::new();
    for rows in asked(results) {
        let _ = writeln!(
            text,
            "\n{:44}{:>6}{:>5}{:>8}{:>8}{:>8}{:>7}{:>10}",
            format!("{}, {}", curves(rows[0].order), rows[0].set.name),
            "time",
            "",
            "p50",
            "p99",
            "max",
            "taken",
            "answered"
        );
        for row in rows.iter().filter(|row| row.accuracy.asked > 0) {
            let method = &METHODS[row.method];
            let [p50, p99, max] = figures(&row.accuracy.errors);
            let _ = writeln!(
                text,
                "  {:42}{:>6}{:>5}{p50:>8}{p99:>8}{max:>8}{:>7}{:>10}",
                method.label(),
                ratio(row),
                method.kind.unit,
                or_all(row.accuracy.not_taken),
                or_all(row.accuracy.not_answered),
            );
        }
    }
    let _ =
        writeln!(text, "\n{:50}{:>5}{:>8}{:>8}{:>8}", "basis functions", "", "p50", "p99", "max");
    for row in &results.basis {
        let [p50, p99, max] = figures(&row.errors);
        let label = format!("{} {}", row.what, row.number);
        let _ = writeln!(text, "  {label:48}{:>5}{p50:>8}{p99:>8}{max:>8}", row.kind.unit);
    }
    text
}

/// How many are not.
fn or_all(missing: usize) -> String {
    if missing == 0 { "all".into() } else { format!("-{missing}") }
}

pub fn csv(results: &Results) -> String {
    let mut text = String::from(
        "set,order,method,number,unit,points,ns_per_point,time_ratio,p50,p99,max,\
         curves_not_taken,points_not_answered\n",
    );
    for row in results.rows.iter().filter(|row| row.accuracy.asked > 0) {
        let method = &METHODS[row.method];
        let cost = row.cost.map_or_else(
            || ",".to_string(),
            |cost| format!("{:.2},{:.3}", cost.nanoseconds, cost.ratio),
        );
        let _ = write!(
            text,
            "\"{}\",{},{},{},{},{},{cost},",
            row.set.name,
            row.order,
            method.name,
            method.number,
            method.kind.unit,
            row.accuracy.errors.len()
        );
        let _ = writeln!(
            text,
            "{},{},{}",
            scientific(&row.accuracy.errors),
            row.accuracy.not_taken,
            row.accuracy.not_answered
        );
    }
    for row in &results.basis {
        let _ = writeln!(
            text,
            "reference table,1 to 6,{},{},{},{},,,{},,",
            row.what,
            row.number,
            row.kind.unit,
            row.errors.len(),
            scientific(&row.errors)
        );
    }
    text
}

fn scientific(errors: &[f64]) -> String {
    percentiles(errors).map_or_else(
        || ",,".to_string(),
        |[p50, p99, max]| format!("{p50:.3e},{p99:.3e},{max:.3e}"),
    )
}

/// The part of the report that is about splines.
pub fn markdown(results: &Results) -> String {
    let mut text = format!(
        "\n# Splines\n\n\
         At least {} points in space of each kind of curves with eight control points, in \
         `speed_vs_error_splines.csv` with more figures. Time is a multiple of enterpolation's \
         (version 0.3, `f32`) in the same run. Errors are median / 99th percentile / largest, of a \
         point's worst coordinate, against exact fractions: in **ulps** of the largest coordinate of \
         the curve's control points, or in **LSB**, units of 2⁻¹⁶. \"Missing\" is points that are NaN \
         or infinite, and curves not taken. `I16F16` is asked about curves that it can hold, and \
         sweeps about uniform knots.\n",
        results.points,
    );
    for rows in asked(results) {
        let _ = write!(
            text,
            "\n## {}, {}\n\n\
             | method | points | time | error | unit | missing |\n\
             |---|---:|---:|---:|---|---:|\n",
            curves(rows[0].order),
            rows[0].set.name
        );
        for row in rows.iter().filter(|row| row.accuracy.asked > 0) {
            let method = &METHODS[row.method];
            let _ = writeln!(
                text,
                "| {} | {} | {} | {} | {} | {} |",
                method.label(),
                row.accuracy.errors.len(),
                ratio(row),
                figures(&row.accuracy.errors).join(" / "),
                method.kind.unit,
                row.accuracy.not_taken + row.accuracy.not_answered
            );
        }
    }
    text.push_str(
        "\n## basis functions\n\n\
         All rows of `tests/reference/bspline_basis.csv` that the number type can hold, orders 1 to \
         6. Values are in ulps of the value, derivatives in ulps of the sum of their terms' sizes.\n\n\
         | what | number | rows | error | unit |\n\
         |---|---|---:|---:|---|\n",
    );
    for row in &results.basis {
        let _ = writeln!(
            text,
            "| {} | {} | {} | {} | {} |",
            row.what,
            row.number,
            row.errors.len(),
            figures(&row.errors).join(" / "),
            row.kind.unit
        );
    }
    text
}

/// The targets of accuracy that are missed, in words.
pub fn shortfalls(results: &Results) -> Vec<String> {
    let largest = |errors: &[f64]| percentiles(errors).map_or(f64::INFINITY, |[.., max]| max);
    let mut shortfalls = Vec::new();
    for row in results.rows.iter().filter(|row| row.accuracy.asked > 0) {
        let method = &METHODS[row.method];
        let Some(limit) = method.limit else { continue };
        let what = format!("{}, {}, {}", method.label(), curves(row.order), row.set.name);
        let max = largest(&row.accuracy.errors);
        if max > limit {
            shortfalls.push(format!("{what}: {max:.2} > {limit} {}", method.kind.unit));
        }
        let missing = row.accuracy.not_taken + row.accuracy.not_answered;
        if missing > 0 {
            shortfalls.push(format!("{what}: {missing} curves or points missing"));
        }
    }
    for row in &results.basis {
        let max = largest(&row.errors);
        if max > row.limit {
            let unit = row.kind.unit;
            let what = format!("basis functions, {} {}", row.what, row.number);
            shortfalls.push(format!("{what}: {max:.2} > {} {unit}", row.limit));
        }
    }
    shortfalls
}
